#pragma once
/// NC programs of random blocks, every kind of motion among them.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "random_numbers.h"

namespace toolpace::testing {

/// Writes a program block by block; every number is written to 1e-4, and that is where the next block begins.
class ProgramText {
 public:
  ProgramText(Random& random, bool rotary) : random_(random), rotary_(rotary), size_(spread(random, 0.1, 30)) {
    text_ = "G21 G90 G94 G17\nF1200\n";
  }

  void add_block() {
    heading_ += between(random_, -1, 1) * (one_in(random_, 4) ? 3 : 0.3);
    switch (random_() % 24) {
      case 0: text_ += fmt::format("G4 P{:.3f}\n", between(random_, 0, 0.02)); return;
      case 1: text_ += one_in(random_, 2) ? "M0\n" : "T1 M6\n"; return;
      case 2: change_mode(); return;
      case 3: text_ += fmt::format("G0 {}\n", step(3)); return;
      case 4:
      case 5:
      case 6:
      case 7: arc(); return;
      case 8:
      case 9: spline(); return;
      case 10: inverse_time(); return;
      case 11:
        if (rotary_) turn();
        return;
      default: break;
    }
    const std::string target = step(1);
    text_ += fmt::format("G1 {}{} F{:.1f}\n", target, rotary_ && one_in(random_, 3) ? rotary_words() : "", feed());
  }

  std::string finish() const { return text_ + "M2\n"; }

 private:
  double feed() { return spread(random_, 60, 24000); }  // mm/min
  static double rounded(double v) { return std::round(v * 1e4) / 1e4; }

  std::string step(double scale) {
    const double length = scale * size_ * spread(random_, 0.05, 2);
    x_ = rounded(x_ + length * std::cos(heading_));
    y_ = rounded(y_ + length * std::sin(heading_));
    if (one_in(random_, 5)) z_ = rounded(between(random_, -2, 2));
    return fmt::format("X{:.4f} Y{:.4f} Z{:.4f}", x_, y_, z_);
  }
  std::string rotary_words() {
    a_ = rounded(a_ + between(random_, -60, 60));
    c_ = rounded(c_ + between(random_, -10, 10));
    return fmt::format(" A{:.4f} C{:.4f}", a_, c_);
  }
  void turn() { text_ += fmt::format("G1{} F{:.1f}\n", rotary_words(), feed()); }

  void change_mode() {
    constexpr const char* kModes[] = {"G61", "G61.1", "G64"};
    if (one_in(random_, 2)) {
      text_ += fmt::format("{}\n", kModes[random_() % std::size(kModes)]);
      return;
    }
    const double tolerance = spread(random_, 0.001, 0.3);
    text_ +=
        fmt::format("G64 P{:.4f}{}\n", tolerance, one_in(random_, 3) ? fmt::format(" Q{:.4f}", tolerance / 2) : "");
  }

  // By centre and end point, both rounded: the radii differ by 1e-4 at most.
  void arc() {
    const double radius = size_ * spread(random_, 0.1, 3), side = one_in(random_, 2) ? 1 : -1;
    const double along = one_in(random_, 2) ? heading_ : between(random_, -3, 3);
    const double sweep = side * spread(random_, 0.05, 6.2);
    const double i = rounded(-side * radius * std::sin(along)), j = rounded(side * radius * std::cos(along));
    if (std::hypot(i, j) < 0.01) return;
    const double cx = x_ + i, cy = y_ + j, c = std::cos(sweep), s = std::sin(sweep);
    x_ = rounded(cx - c * i + s * j);
    y_ = rounded(cy - s * i - c * j);
    if (one_in(random_, 3)) z_ = rounded(z_ + between(random_, -1, 1));
    heading_ = along + sweep;
    text_ += fmt::format("G{} X{:.4f} Y{:.4f} Z{:.4f} I{:.4f} J{:.4f} F{:.1f}\n", side > 0 ? 3 : 2, x_, y_, z_, i, j,
                         feed());
  }

  void spline() {
    const double length = size_ * spread(random_, 0.3, 2), reach = length / 3;
    const double leave = heading_, arrive = heading_ + between(random_, -1.5, 1.5);
    const double middle = (leave + arrive) / 2;
    x_ = rounded(x_ + length * std::cos(middle));
    y_ = rounded(y_ + length * std::sin(middle));
    heading_ = arrive;
    text_ +=
        fmt::format("G5 X{:.4f} Y{:.4f} I{:.4f} J{:.4f} P{:.4f} Q{:.4f} F{:.1f}\n", x_, y_, reach * std::cos(leave),
                    reach * std::sin(leave), -reach * std::cos(arrive), -reach * std::sin(arrive), feed());
  }

  void inverse_time() {
    text_ += fmt::format("G93 G1 {} F{:.2f}\nG94 F{:.1f}\n", step(1), spread(random_, 20, 2000), feed());
  }

  Random& random_;
  bool rotary_;
  double size_, heading_ = 0.0;
  double x_ = 0, y_ = 0, z_ = 0, a_ = 0, c_ = 0;
  std::string text_;
};

}  // namespace toolpace::testing
