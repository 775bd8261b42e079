#pragma once
/// Changes of speed of one smooth form: v(t) = speed + rate·σ(t/duration), σ from 0 to 1, point-symmetric about its middle.
///
/// A form is a type with these static members; a new one is such a type, a value of PhaseShape and a line in visit_form(),
/// and whoever evaluates, bounds, explains or names phases follows.
///   kShape                 its value
///   kName                  in files
///   kSteepest              largest σ′, at τ = 1/2
///   kSharpest, kSharpestAt largest |σ″|, and where: at this τ and at 1 − τ
///   mean(dv, u)            dv times the mean of σ over [0, u]
///   value, slope, bend     dv times σ, σ′ and σ″ at u

#include <cstdint>
#include <numbers>
#include <utility>

namespace toolpace {

enum class PhaseShape : std::uint8_t {
  constant_jerk,  ///< no form: speed + acceleration·t + rate·t²/2
  quintic
};

/// σ(τ) = 10τ³ − 15τ⁴ + 6τ⁵: jerk is continuous and zero at both ends.
/// @source Ning et al. 2014, eqs. (2)–(4)
struct QuinticForm {
  static constexpr PhaseShape kShape = PhaseShape::quintic;
  static constexpr const char* kName = "quintic";
  static constexpr double kSteepest = 15.0 / 8;
  static constexpr double kSharpest = 10.0 * std::numbers::inv_sqrt3;
  static constexpr double kSharpestAt = 0.21132486540518713;  // (3 − √3)/6

  static double mean(double dv, double u) { return dv * u * u * u * (2.5 + u * (-3 + u)); }
  static double value(double dv, double u) { return dv * u * u * u * (10 + u * (-15 + 6 * u)); }
  static double slope(double dv, double u) { return dv * 30 * u * u * (1 - u) * (1 - u); }
  static double bend(double dv, double u) { return dv * 60 * u * (1 - u) * (1 - 2 * u); }
};

/// Calls f with the form of a shape that has one. @pre shape is not constant_jerk
template <class F>
decltype(auto) visit_form(PhaseShape /*shape*/, F&& f) {
  return std::forward<F>(f)(QuinticForm{});
}

/// "constant_jerk" or the form's name.
inline const char* shape_name(PhaseShape shape) {
  if (shape == PhaseShape::constant_jerk) return "constant_jerk";
  return visit_form(shape, []<class Form>(Form) { return Form::kName; });
}

}  // namespace toolpace
