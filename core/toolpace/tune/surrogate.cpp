#include "toolpace/tune/surrogate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace toolpace {
namespace {

constexpr double kNugget = 1e-5;  // of the variance: what no smooth function explains
constexpr double kShortest = 0.05, kLongest = 20;
constexpr double kStep = 1.7;
constexpr int kRounds = 2;
constexpr std::size_t kMostBelieved = 64;  // rows that are kept free for believe()

double kernel(const Features& a, const Features& b, const Surrogate::Lengths& lengths) {
  double square = 0;
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    const bool is_choice = TuningSpace::is_choice(static_cast<Knob>(k));
    const double apart = is_choice ? (a[k] == b[k] ? 0.0 : 1.0) : a[k] - b[k];
    square += apart * apart / (lengths[k] * lengths[k]);
  }
  const double r = std::sqrt(5 * square);
  return (1 + r + r * r / 3) * std::exp(-r);
}

Eigen::LLT<Eigen::MatrixXd> factored(const std::vector<Features>& at, const Surrogate::Lengths& lengths) {
  const auto n = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = j; i < n; ++i)
      k(i, j) = kernel(at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)], lengths);
    k(j, j) += kNugget;
  }
  return k.llt();
}

Eigen::VectorXd centred(const std::vector<double>& values, double mean) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())).array() - mean;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// −2·log of the likelihood, the scale of the variance taken at its best, plus what holds lengths back from extremes.
double misfit(const std::vector<Features>& at, const Eigen::VectorXd& values, const Surrogate::Lengths& lengths) {
  const auto llt = factored(at, lengths);
  if (llt.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const auto n = static_cast<double>(at.size());
  const double square = llt.matrixL().solve(values).squaredNorm();
  double sum = n * std::log(square / n + 1e-300);
  for (Eigen::Index i = 0; i < values.size(); ++i) sum += 2 * std::log(llt.matrixLLT()(i, i));
  for (const double length : lengths) sum += 0.5 * std::pow(std::log(length), 2);
  return sum;
}

}  // namespace

Features features_of(const TuningSpace& space, const Position& position) {
  Features features;
  for (std::size_t k = 0; k < kKnobCount; ++k) {
    const auto knob = static_cast<Knob>(k);
    features[k] = TuningSpace::is_choice(knob) ? static_cast<double>(position[k]) : space.coordinate(knob, position[k]);
  }
  return features;
}

Surrogate::Lengths Surrogate::first_lengths() {
  Lengths lengths;
  for (std::size_t k = 0; k < kKnobCount; ++k) lengths[k] = TuningSpace::is_choice(static_cast<Knob>(k)) ? 1.5 : 0.7;
  return lengths;
}

Surrogate::Lengths Surrogate::fit(const std::vector<Features>& at, const std::vector<double>& values,
                                  const Lengths& start) {
  Lengths best = start;
  const Eigen::VectorXd apart = centred(values, mean_of(values));
  double least = misfit(at, apart, best);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < kKnobCount; ++k) {
      const bool is_used = std::any_of(at.begin(), at.end(), [&](const Features& f) { return f[k] != at[0][k]; });
      if (!is_used) continue;
      for (const double factor : {kStep, 1 / kStep}) {
        Lengths tried = best;
        tried[k] = std::clamp(best[k] * factor, kShortest, kLongest);
        const double value = misfit(at, apart, tried);
        if (value >= least) continue;
        least = value;
        best = tried;
        break;
      }
    }
  }
  return best;
}

Surrogate::Surrogate(const std::vector<Features>& at, const std::vector<double>& values, const Lengths& lengths,
                     const std::vector<Features>& candidates)
    : lengths_(lengths), candidates_(candidates), size_(static_cast<Eigen::Index>(at.size())), mean_(mean_of(values)) {
  const auto llt = factored(at, lengths);
  const auto count = static_cast<Eigen::Index>(candidates.size());
  const Eigen::Index room = size_ + static_cast<Eigen::Index>(kMostBelieved);
  Eigen::MatrixXd across(size_, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    for (Eigen::Index i = 0; i < size_; ++i)
      across(i, j) = kernel(at[static_cast<std::size_t>(i)], candidates[static_cast<std::size_t>(j)], lengths);
  }
  solved_ = Eigen::MatrixXd::Zero(room, count);
  whitened_ = Eigen::VectorXd::Zero(room);
  solved_.topRows(size_) = llt.matrixL().solve(across);
  whitened_.head(size_) = llt.matrixL().solve(centred(values, mean_));
  scale_ = std::max(whitened_.squaredNorm() / static_cast<double>(size_), 1e-300);
  explained_ = solved_.colwise().squaredNorm();
  estimate_ = solved_.transpose() * whitened_;
}

Guess Surrogate::at_candidate(std::size_t i) const {
  const auto c = static_cast<Eigen::Index>(i);
  return {mean_ + estimate_[c], std::sqrt(scale_ * std::max(kNugget, 1 + kNugget - explained_[c]))};
}

void Surrogate::believe(std::size_t candidate) {
  const auto c = static_cast<Eigen::Index>(candidate);
  if (size_ >= solved_.rows()) return;
  // One more row of the factor: its own mean adds nothing to the estimate of others.
  const double pivot = std::sqrt(std::max(kNugget, 1 + kNugget - explained_[c]));
  const Eigen::VectorXd row = solved_.col(c).head(size_);
  for (Eigen::Index j = 0; j < solved_.cols(); ++j) {
    const double covariance = kernel(candidates_[candidate], candidates_[static_cast<std::size_t>(j)], lengths_);
    const double entry = (covariance - row.dot(solved_.col(j).head(size_))) / pivot;
    solved_(size_, j) = entry;
    explained_[j] += entry * entry;
  }
  ++size_;
}

}  // namespace toolpace
