#pragma once
/// Which of a job's settings a motion has use for.

#include <cstdint>
#include <initializer_list>

namespace toolpace {

enum class Setting : std::uint8_t {
  law,
  t_acc,
  t_dec,
  jerk,  ///< along the path
  lookahead,
  ramps,
  corner,  ///< the corner rule
  tolerance,
  junction_deviation
};
inline constexpr std::size_t kSettingCount = 9;

/// A set of settings.
class Settings {
 public:
  constexpr Settings() = default;
  constexpr Settings(std::initializer_list<Setting> list) {
    for (const Setting s : list) include(s);
  }

  constexpr void include(Setting s) { bits_ |= bit(s); }
  constexpr void include(const Settings& others) { bits_ |= others.bits_; }
  constexpr bool has(Setting s) const { return (bits_ & bit(s)) != 0; }
  constexpr bool operator==(const Settings&) const = default;

 private:
  static constexpr std::uint32_t bit(Setting s) { return 1u << static_cast<unsigned>(s); }
  std::uint32_t bits_ = 0;
};

}  // namespace toolpace
