#include "toolpace/servo/axis_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toolpace {
namespace {

constexpr double kLooksARadian = 4;  // at the displacement, for turns of it
constexpr double kMostLooks = 1 << 16;
constexpr int kRootRounds = 60;

}  // namespace

AxisModes::AxisModes(const ServoAxis& axis) : modes_(modes_of(axis)) {
  for (const AxisMode& m : modes_) {
    states_.emplace_back(m.frequency, m.damping);
    fastest_ = std::max(fastest_, states_.back().omega());
  }
}

ModeState AxisModes::at(const std::vector<ModePiece>& pieces, double t) const {
  ModeState sum;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ModeState s = pieces[i].at(t);
    sum.place += modes_[i].share * s.place;
    sum.speed += modes_[i].share * s.speed;
  }
  return sum;
}

double AxisModes::displacement(const AccelerationPolynomial& acceleration, double t) const {
  double sum = 0;
  for (std::size_t i = 0; i < modes_.size(); ++i) sum += modes_[i].share * states_[i].piece(acceleration).at(t).place;
  return sum;
}

double AxisModes::displacement() const {
  double sum = 0;
  for (std::size_t i = 0; i < modes_.size(); ++i) sum += modes_[i].share * states_[i].displacement();
  return sum;
}

double AxisModes::amplitude() const {
  double sum = 0;
  for (std::size_t i = 0; i < modes_.size(); ++i) sum += amplitude(i);
  return sum;
}

void AxisModes::step(double speed) {
  for (Mode& m : states_) m.step(speed);
}

void AxisModes::run(const AccelerationPolynomial& a, double duration) {
  if (!(duration > 0)) return;
  pieces_.clear();
  for (const Mode& m : states_) pieces_.push_back(m.piece(a));
  // A vibration that is left alone only decays: what is largest of a single one comes in its first round.
  const bool is_free = std::all_of(a.begin(), a.end(), [](double c) { return c == 0; });
  const double round = 2 * std::numbers::pi / fastest_;
  if (!is_free || amplitude() > peak_)
    look_for_peak(pieces_, is_free && modes_.size() == 1 ? std::min(duration, round) : duration);
  for (std::size_t i = 0; i < states_.size(); ++i) states_[i].set(pieces_[i].at(duration));
  time_ += duration;
}

void AxisModes::keep(double t, double place) {
  if (std::abs(place) <= peak_) return;
  peak_ = std::abs(place);
  peak_time_ = time_ + t;
}

void AxisModes::look_for_peak(const std::vector<ModePiece>& pieces, double length) {
  const double looks = std::clamp(std::ceil(kLooksARadian * fastest_ * length), 4.0, kMostLooks);
  ModeState before = at(pieces, 0);
  double from = 0;
  for (double k = 1; k <= looks; ++k) {
    const double to = length * k / looks;
    const ModeState here = at(pieces, to);
    keep(to, here.place);
    if ((here.speed > 0) != (before.speed > 0)) {
      double low = from, high = to;
      for (int i = 0; i < kRootRounds && high - low > 1e-15 * to; ++i) {
        const double middle = (low + high) / 2;
        ((at(pieces, middle).speed > 0) == (before.speed > 0) ? low : high) = middle;
      }
      keep(low, at(pieces, low).place);
    }
    before = here;
    from = to;
  }
}

}  // namespace toolpace
