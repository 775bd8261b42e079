#pragma once
/// What an unknown function may be where it was not asked yet: a Gaussian process over the places of knobs.

#include <Eigen/Core>
#include <vector>

#include "toolpace/tune/tuning_space.h"

namespace toolpace {

/// Where a position is, knob by knob: coordinates of numbers, indices of choices.
using Features = std::array<double, kKnobCount>;
Features features_of(const TuningSpace& space, const Position& position);

struct Guess {
  double mean, deviation;
};

/// Kriging with a Matérn kernel (ν = 5/2) of a length of its own along each knob; two different choices are one apart. The scale of
/// the values and their mean are estimated with it.
///
/// @source Rasmussen, Williams, "Gaussian Processes for Machine Learning", 2006, eqs. (2.25), (2.26), (4.17), (5.8).
class Surrogate {
 public:
  using Lengths = std::array<double, kKnobCount>;

  /// Lengths that explain the values best, looked for around `start` by coordinate steps: deterministic, bounded.
  static Lengths fit(const std::vector<Features>& at, const std::vector<double>& values, const Lengths& start);
  static Lengths first_lengths();

  /// @param candidates  where it will be asked
  Surrogate(const std::vector<Features>& at, const std::vector<double>& values, const Lengths& lengths,
            const std::vector<Features>& candidates);

  Guess at_candidate(std::size_t i) const;
  /// As if the function had been asked there and had its mean: others near by are known better.
  void believe(std::size_t candidate);

 private:
  Lengths lengths_;
  std::vector<Features> candidates_;
  Eigen::Index size_ = 0;
  double mean_ = 0, scale_ = 0;  ///< of the values; of their variance
  Eigen::VectorXd whitened_;     ///< L⁻¹·(values − mean)
  Eigen::MatrixXd solved_;       ///< L⁻¹·kernel(known, candidates), a column a candidate
  Eigen::VectorXd explained_, estimate_;
};

}  // namespace toolpace
