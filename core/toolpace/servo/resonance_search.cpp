#include "toolpace/servo/resonance_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

namespace toolpace::detail {
namespace {

constexpr double kFrequencyRatio = 1.03;  // of the frequencies that are looked at
constexpr double kOfNyquist = 0.9;        // that is looked at
constexpr std::size_t kCandidates = 3;

struct Explained {
  double squares;    // of what is left of the trace, that a mode there would take off
  double frequency;  // [Hz]
};

/// An orthonormal basis of what the drive's own values can change.
Eigen::MatrixXd reach_of(const ServoFit& fit, const FitState& state) {
  const Eigen::MatrixXd j = fit.jacobian(state);
  std::vector<int> index;
  for (int p = 0; p < kFitParameters; ++p) {
    if (state.free[static_cast<std::size_t>(p)] && j.col(p).squaredNorm() > 0) index.push_back(p);
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(j(Eigen::all, index));
  return qr.householderQ() * Eigen::MatrixXd::Identity(j.rows(), static_cast<Eigen::Index>(index.size()));
}

/// Highest first.
std::vector<Explained> peaks_of(const std::vector<Explained>& curve) {
  std::vector<Explained> peaks;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool rises = i == 0 || curve[i].squares >= curve[i - 1].squares;
    const bool falls = i + 1 == curve.size() || curve[i].squares > curve[i + 1].squares;
    if (rises && falls && curve[i].squares > 0) peaks.push_back(curve[i]);
  }
  std::sort(peaks.begin(), peaks.end(), [](const Explained& a, const Explained& b) {
    return std::pair(a.squares, a.frequency) > std::pair(b.squares, b.frequency);
  });
  return peaks;
}

}  // namespace

std::vector<double> resonance_frequencies(const ServoFit& fit, const FitState& from) {
  const Eigen::MatrixXd reach = reach_of(fit, from);
  const Eigen::VectorXd left = fit.residuals(from), open = left - reach * (reach.transpose() * left);
  const double most = kOfNyquist * std::min(nyquist_of(fit.data()), 0.5 / fit.data().period);
  std::vector<Explained> curve;
  for (double f = kLeastFrequency; f < most; f *= kFrequencyRatio) {
    FitState state = from;
    state.axis.resonance = f;
    state.axis.resonance_damping = kLookedAtDamping;
    Eigen::VectorXd shape = left - fit.residuals(state);
    shape -= reach * (reach.transpose() * shape);
    const double size = shape.squaredNorm(), along = shape.dot(open);
    curve.push_back({along > 0 && size > 0 ? along * along / size : 0.0, f});
  }
  std::vector<double> best;
  for (const Explained& peak : peaks_of(curve)) {
    if (best.size() < kCandidates) best.push_back(peak.frequency);
  }
  return best;
}

}  // namespace toolpace::detail
