#include "toolpace/servo/identify_axis.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "toolpace/servo/axis_servo.h"
#include "toolpace/servo/resonance_search.h"
#include "toolpace/servo/servo_fit.h"

namespace toolpace {
namespace {

using detail::FitData;
using detail::FitResult;
using detail::FitState;
using detail::ServoFit;

constexpr int kFirstRounds = 12, kRounds = 60;
constexpr double kFinest = 1e-6;      // [mm, deg] of measured positions
constexpr double kStill = 0.05;       // [mm, deg] an axis that moves less tells nothing
constexpr double kReverses = 0.02;    // [mm, deg] of way on either side of a turn
constexpr double kForBacklash = 16;   // by how much squares / noise² have to fall for one more thing in the model:
constexpr double kForResonance = 30;  //   χ² of one and of two parameters, the second looked for all over the band
constexpr std::size_t kFinalists = 3;
constexpr double kUsualDamping = 0.7, kUsualBandwidth = 80;  // [Hz] of a drive that is set well
constexpr double kSmallPlay = 0.004;                         // [mm, deg] that a search begins with
constexpr double kRelativeError = 0.25, kShareError = 0.1, kFrequencyError = 0.05;  // beyond it a value is not told
constexpr double kClear = 3;                                                        // standard errors
constexpr double kMostLeft = 0.2;                                                   // of the RMS following error

Error identify_error(const char* code, const char* message, const char* remedy) {
  return {ErrorKind::input, code, message, remedy, {}, {}};
}

/// Whether the command turns back anywhere.
bool reverses(const std::vector<double>& r, double least) {
  double low = r.front(), high = r.front();
  for (const double p : r) {
    low = std::min(low, p), high = std::max(high, p);
    if (high - low < least) continue;
    if (p > low + least && p < high - least) return true;  // away from one end, and from the other again
  }
  return false;
}

class AxisFit {
 public:
  AxisFit(const IdentificationData& data, const ServoAxis& known, const Monitor& monitor)
      : data_(data),
        known_(known),
        monitor_(monitor),
        fit_data_{data.commanded, data.period, data.time, data.actual, kFinest * data.unit},
        fit_(fit_data_),
        reverses_(reverses(data.commanded, kReverses * data.unit)) {}

  Result<AxisIdentification> run() {
    if (!data_.clock_error) held_clock_ = data_.same_clock;
    FitResult best = search();
    if (held_clock_ && !is_one_clock(best)) {
      held_clock_.reset();
      best = search();
    }
    if (!is_done(best)) look_along_the_valley(best);
    if (monitor_.is_cancelled()) return tl::unexpected(cancelled_error());
    fit_.judge(best);
    return report(best);
  }

 private:
  /// Whether nothing is left that a trace could show.
  bool is_done(const FitResult& r) const {
    return fit_data_.noise_of(r.squares) <= fit_data_.finest * fit_data_.finest;
  }

  /// Gain and feed-forward make up for each other: the squares lie in a long valley at the same lag, with more than one bottom.
  void look_along_the_valley(FitResult& best) const {
    const ServoAxis found = best.state.axis;
    const double lag = (1 - found.velocity_feed_forward) / found.position_gain;
    FitResult other;
    other.squares = std::numeric_limits<double>::infinity();
    for (const double forward : {0.0, 0.25, 0.5, 0.75, 0.9}) {
      if (monitor_.is_cancelled()) return;
      FitState state = best.state;
      state.axis.velocity_feed_forward = forward;
      state.axis.position_gain = (1 - forward) / lag;
      state.axis.damping = kUsualDamping;
      state.axis.bandwidth = kUsualBandwidth;
      const FitResult tried = fit_.fit(state, kFirstRounds);
      if (tried.squares < other.squares) other = tried;
    }
    other = fit_.fit(other.state, kRounds);
    if (other.squares < best.squares) best = other;
  }

  /// Takes what explains more, by the noise that is left.
  void prefer(FitResult& best, const FitResult& other, double by) const {
    if (other.squares + by * fit_data_.noise_of(other.squares) < best.squares) best = other;
  }

  /// The simplest drive that explains the trace.
  FitResult search() const {
    const FitResult stiff = rigid();
    FitResult best = stiff;
    if (is_done(best)) return best;
    if (reverses_) prefer(best, fit_.fit(with_backlash(stiff).state, kRounds), kForBacklash);
    prefer(best, with_resonance({&stiff, &best}), kForResonance);
    if (best.state.axis.resonance > 0) settle_backlash(best);
    return best;
  }

  /// From each of some stiff drives, and from a well damped one beside it: a weakly damped drive can look like a resonance.
  FitResult with_resonance(const std::array<const FitResult*, 2>& stiff) const {
    std::vector<FitResult> found;
    for (const FitResult* drive : stiff) {
      FitState damped = drive->state;
      damped.axis.damping = kUsualDamping;
      damped.axis.bandwidth = std::max(damped.axis.bandwidth, kUsualBandwidth);
      damped.free[detail::kDamping] = false;
      const FitResult other = fit_.fit(damped, kFirstRounds);
      std::vector<double> looked_at = detail::resonance_frequencies(fit_, other.state);
      if (drive->state.axis.damping < kUsualDamping) looked_at.push_back(drive->state.axis.bandwidth);
      for (const double f : detail::resonance_frequencies(fit_, drive->state)) try_resonance(drive->state, f, found);
      for (const double f : looked_at) {
        try_resonance(other.state, f, found);
        FitState usual = other.state;  // as if nothing of the drive were known yet
        usual.axis = ServoAxis{};
        usual.axis.position_gain = drive->state.axis.position_gain;
        usual.axis.velocity_feed_forward = drive->state.axis.velocity_feed_forward;
        try_resonance(usual, f, found);
      }
      if (stiff[0]->state.axis == stiff[1]->state.axis) break;
    }
    std::sort(found.begin(), found.end(), [](const FitResult& a, const FitResult& b) { return a.squares < b.squares; });
    FitResult best;
    best.squares = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(kFinalists, found.size()) && !monitor_.is_cancelled(); ++i) {
      const FitResult final = fit_.fit(found[i].state, kRounds);
      if (is_sound(final) && final.squares < best.squares) best = final;
    }
    return best;
  }

  /// A few rounds, with all that may be there.
  void try_resonance(FitState state, double frequency, std::vector<FitResult>& found) const {
    if (monitor_.is_cancelled()) return;
    state.axis.resonance = frequency;
    state.axis.resonance_damping = detail::kLookedAtDamping;
    for (const int p : {detail::kResonance, detail::kResonanceDamping, detail::kDamping})
      state.free[static_cast<std::size_t>(p)] = true;
    if (reverses_) {
      state.free[detail::kBacklash] = true;
      state.axis.backlash = std::max(state.axis.backlash, kSmallPlay * data_.unit);
    }
    FitResult result = fit_.fit(state, kFirstRounds);
    if (std::isfinite(result.squares)) found.push_back(std::move(result));
  }

  /// Without play and resonance, from several drives; near usual ones, as both may be there.
  FitResult rigid() const {
    FitResult best;
    best.squares = std::numeric_limits<double>::infinity();
    for (const double gain : {15.0, 40.0, 100.0}) {
      for (const double bandwidth : {40.0, 120.0}) {
        for (const double forward : {0.0, 0.8}) {
          FitState state;
          state.axis = {};
          state.axis.position_gain = gain;
          state.axis.bandwidth = bandwidth;
          state.axis.velocity_feed_forward = forward;
          for (const int p : {detail::kGain, detail::kVelocityForward, detail::kAccelerationForward, detail::kBandwidth,
                              detail::kDamping, detail::kZero})
            state.free[static_cast<std::size_t>(p)] = true;
          // Nothing held, alignment took the lag for a clock's.
          if (!data_.clock_error) state.clock = held_clock_.value_or((1 - forward) / gain);
          state.free[detail::kClock] = data_.clock_error ? *data_.clock_error > 0 : !held_clock_;
          if (data_.clock_error && *data_.clock_error > 0) state.clock_error = data_.clock_error;
          const FitResult found = fit_.fit(state, kFirstRounds);
          if (found.squares < best.squares) best = found;
        }
      }
    }
    return fit_.fit(best.state, kRounds);
  }

  FitResult with_backlash(const FitResult& from) const {
    FitResult best = from;
    for (const double play : {0.002, 0.01, 0.05}) {
      FitState state = from.state;
      state.axis.backlash = play * data_.unit;
      state.free[detail::kBacklash] = true;
      const FitResult found = fit_.fit(state, kRounds);
      if (found.squares < best.squares) best = found;
    }
    return best;
  }

  /// The other way about, once the resonance is known: play where there was none, none where there was some.
  void settle_backlash(FitResult& best) const {
    if (best.state.axis.backlash > 0) {
      FitState state = best.state;
      state.axis.backlash = 0;
      state.free[detail::kBacklash] = false;
      const FitResult without = fit_.fit(state, kRounds);
      if (without.squares <= best.squares + kForBacklash * fit_data_.noise_of(best.squares)) best = without;
    } else if (reverses_) {
      prefer(best, fit_.fit(with_backlash(best).state, kRounds), kForBacklash);
    }
  }

  /// Whether a resonance that was found is one: in the band, and not all damping.
  bool is_sound(const FitResult& r) const {
    return r.state.axis.resonance < detail::nyquist_of(fit_data_) &&
           r.state.axis.resonance > detail::kLeastFrequency / 2 && r.state.axis.resonance_damping < 0.7;
  }

  /// Whether another clock would explain the trace no better than the one that is held.
  bool is_one_clock(const FitResult& held) const {
    FitState state = held.state;
    state.free[detail::kClock] = true;
    const FitResult other = fit_.fit(state, kRounds);
    return held.squares - other.squares <= kClear * kClear * fit_data_.noise_of(other.squares);
  }

  Result<AxisIdentification> report(const FitResult& best) const {
    const Eigen::VectorXd left = fit_.residuals(best.state);
    double following = 0;
    for (std::size_t i = 0; i < data_.time.size(); ++i) {
      const double row = (data_.time[i] + best.state.clock) / data_.period;
      const auto k = static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(data_.commanded.size() - 1)));
      following += std::pow(data_.actual[i] - best.state.zero - data_.commanded[k], 2);
    }
    const bool explains = left.squaredNorm() <= kMostLeft * kMostLeft * following;
    const double few =
        2e-3 * data_.unit;  // what is left may be as much as the following error where both are this small
    if (!explains && best.noise > few) {
      return tl::unexpected(
          identify_error("identify-no-fit", "the model of the drive does not describe what the axis did",
                         "check that the trace is of these setpoints, of the slide, and not filtered"));
    }
    AxisIdentification found;
    found.noise = best.noise;
    found.largest = left.cwiseAbs().maxCoeff();
    found.clock = best.state.clock;
    found.clock_error = best.error[detail::kClock];
    found.rows = data_.time.size();
    fill(best, found);
    return found;
  }

  void fill(const FitResult& best, AxisIdentification& found) const {
    const ServoAxis& a = best.state.axis;
    const auto& e = best.error;
    const auto relative = [&](double value, double error, double most) {
      const bool is_told = error > 0 && error < most;
      return IdentifiedValue{value, value * error, is_told, is_told ? "" : "the motion does not excite it enough"};
    };
    const auto share = [&](double value, double error) {
      const bool is_told = error > 0 && error < kShareError;
      return IdentifiedValue{std::clamp(value, 0.0, 1.0), error, is_told,
                             is_told ? "" : "the motion does not excite it enough"};
    };
    auto& v = found.values;
    v[0] = relative(a.position_gain, e[detail::kGain], kRelativeError);
    v[1] = share(a.velocity_feed_forward, e[detail::kVelocityForward]);
    v[2] = share(a.acceleration_feed_forward, e[detail::kAccelerationForward]);
    v[3] = relative(a.bandwidth, e[detail::kBandwidth], kRelativeError);
    v[4] = relative(a.damping, e[detail::kDamping], kRelativeError);
    v[5] = backlash(best);
    v[6] = relative(a.resonance, e[detail::kResonance], kFrequencyError);
    v[7] = relative(a.resonance_damping, e[detail::kResonanceDamping], 2 * kRelativeError);
    if (a.resonance == 0) {
      v[6] = v[7] = {0, 0, false, "no resonance shows in the trace"};
    } else if (!v[6].is_told) {
      v[7].is_told = false;
      v[7].verdict = v[6].verdict;
    }
    found.axis = known_;
    double* const target[] = {&found.axis.position_gain,
                              &found.axis.velocity_feed_forward,
                              &found.axis.acceleration_feed_forward,
                              &found.axis.bandwidth,
                              &found.axis.damping,
                              &found.axis.backlash,
                              &found.axis.resonance,
                              &found.axis.resonance_damping};
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (v[i].is_told) *target[i] = v[i].value;
    }
    // A gain that was told may swing up with a drive that was not: then the drive is the one that it was found with.
    if (!AxisServo::create(found.axis, data_.period)) {
      found.axis.bandwidth = a.bandwidth;
      found.axis.damping = a.damping;
    }
  }

  /// None is told, too, with the error that some would have been found with.
  IdentifiedValue backlash(const FitResult& best) const {
    if (!reverses_) return {0, 0, false, "the axis never turns back"};
    if (best.state.axis.backlash > 0) return {best.state.axis.backlash, best.error[detail::kBacklash], true, ""};
    FitResult some = with_small_play(best);
    fit_.judge(some);
    return {0, some.error[detail::kBacklash], true, ""};
  }

  FitResult with_small_play(const FitResult& best) const {
    FitResult some = best;
    some.state.axis.backlash = 1e-4 * data_.unit;
    some.state.free[detail::kBacklash] = true;
    return some;
  }

  const IdentificationData& data_;
  const ServoAxis& known_;
  const Monitor& monitor_;
  FitData fit_data_;
  ServoFit fit_;
  bool reverses_;
  std::optional<double> held_clock_ = {};  ///< [s] that is tried first where nothing is known of it
};

}  // namespace

Result<AxisIdentification> identify_axis(const IdentificationData& data, const ServoAxis& known,
                                         const Monitor& monitor) {
  const auto [least, most] = std::minmax_element(data.commanded.begin(), data.commanded.end());
  if (*most - *least < kStill * data.unit) {
    return tl::unexpected(identify_error("identify-still", "the axis hardly moves", "record a program that moves it"));
  }
  return AxisFit(data, known, monitor).run();
}

}  // namespace toolpace
