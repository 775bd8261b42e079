#pragma once
/// Largest derivatives of a curve, by samples.

#include "toolpace/limits/curve_bounds.h"
#include "toolpace/path/curve_math.h"

namespace toolpace {

/// Largest magnitudes of sampled functions. Between equal steps a function rises above the line through two samples by an
/// eighth of its second difference at most, as far as that is constant; its change is added. Stretches in which a function
/// may rise above its largest sample by more than a small part are halved, the others are done.
/// @tparam rows     axes: X Y Z, or all
/// @tparam Sampler  at_share<rows>(share): derivatives at a share 0 … 1 of the curve
template <int rows, class Sampler>
class PeakSearch {
 public:
  using Values = Eigen::Array<double, rows, 3>;  // first, second and third derivative

  PeakSearch(const Sampler& curve, double length)
      : curve_(curve), least_(0.0, kNoTurn / length, kNoTurn / (length * length)) {}

  /// @param begin, end  of the whole curve
  CurveBounds run(const ParameterDerivatives& begin, const ParameterDerivatives& end, int stretches) {
    const double width = 1.0 / stretches;
    Values from = values(begin);
    for (int k = 0; k < stretches; ++k) {
      const Values to = k + 1 == stretches ? values(end) : sample((k + 1) * width);
      search({k * width, width, from, sample((k + 0.5) * width), to}, kMostHalvings);
      from = to;
    }
    return bounds();
  }

 private:
  static constexpr int kMostHalvings = 6;          // of a stretch: enough but where the curve has a cusp
  static constexpr double kRise = 0.05;            // between samples, that is added rather than looked for
  static constexpr double kMinorRise = 0.01;       // as a part of the axis that has most
  static constexpr double kNoTurn = 1e-9;          // change of direction over a segment that is rounding
  static constexpr double kCuspRise = 0.1;         // added where halving does not settle it
  static constexpr double kSampledMargin = 1.004;  // for derivatives that change faster than second differences tell

  struct Stretch {
    double from, width;
    Values begin, middle, end;
  };

  CurveBounds bounds() const {
    CurveBounds b;
    b.first.head<rows>() = upper_.col(0) * kSampledMargin;
    b.second.head<rows>() = upper_.col(1) * kSampledMargin;
    b.third.head<rows>() = upper_.col(2) * kSampledMargin;
    return b;
  }

  template <int all>
  static Values values(const CurveDerivatives<all>& d) {
    Values v;
    v.col(0) = d.first.template head<rows>();
    v.col(1) = d.second.template head<rows>();
    v.col(2) = d.third.template head<rows>();
    return v;
  }
  Values sample(double share) const { return values(curve_.template at_share<rows>(share)); }

  void search(const Stretch& s, int halvings) {
    const Values left = sample(s.from + s.width / 4), right = sample(s.from + 3 * s.width / 4);
    const Values most = s.begin.abs().max(s.end.abs()).max(s.middle.abs()).max(left.abs()).max(right.abs());
    largest_ = largest_.max(most);
    const Values bend[] = {s.begin - 2 * left + s.middle, left - 2 * s.middle + right, s.middle - 2 * right + s.end};
    const Values high = bend[0].max(bend[1]).max(bend[2]), low = bend[0].min(bend[1]).min(bend[2]);
    const Values top = most + (high.max(-low) + (high - low)) / 8;
    if ((top <= allowed()).all()) {
      upper_ = upper_.max(top);
    } else if (halvings == 0) {
      upper_ = upper_.max(top.min((1 + kCuspRise) * most));
    } else {
      search({s.from, s.width / 2, s.begin, left, s.middle}, halvings - 1);
      search({s.from + s.width / 2, s.width / 2, s.middle, right, s.end}, halvings - 1);
    }
  }

  /// What a stretch may reach without being halved.
  Values allowed() const {
    Values a = (1 + kRise) * largest_;
    for (Eigen::Index order = 0; order < 3; ++order) {
      for (Eigen::Index axis = 0; axis < rows; axis += 3) {
        const auto most = largest_.template block<3, 1>(axis, order);
        const double minor = std::max(kMinorRise * most.maxCoeff(), least_[order]);
        a.template block<3, 1>(axis, order) = a.template block<3, 1>(axis, order).max(most + minor);
      }
    }
    return a;
  }

  const Sampler& curve_;
  Eigen::Vector3d least_;
  Values largest_ = Values::Zero();  // of the samples
  Values upper_ = Values::Zero();    // of the stretches that are done
};

}  // namespace toolpace
