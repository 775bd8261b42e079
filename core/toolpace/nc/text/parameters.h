#pragma once
/// Parameters of NC programs: numbered, named local, named global, and those that the controller keeps.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace toolpace::nc {

inline constexpr int kParameterCount = 5602;       ///< #1 … #5601
inline constexpr int kParameterNumbers = 1000000;  ///< no dialect has a higher number
inline constexpr int kMacroVariables = 150000;     ///< the same of Fanuc's kind
inline constexpr int kLinuxcncLocals = 30;         ///< #1 … #30 belong to the call
inline constexpr int kFanucLocals = 33;            ///< #1 … #33 belong to the macro call
inline constexpr std::size_t kMostNames = 100000;  ///< named parameters of one program, all calls together

// Numbers that the controller itself uses (LinuxCNC's numbering).
inline constexpr int kProbedPosition = 5061;
inline constexpr int kProbeSucceeded = 5070;
inline constexpr int kHomeG28 = 5161;
inline constexpr int kHomeG30 = 5181;
inline constexpr int kG92Applied = 5210;
inline constexpr int kG92Offset = 5211;
inline constexpr int kActiveSystem = 5220;
inline constexpr int kFirstSystem = 5221;  ///< 20 numbers a system, X … W, then R
inline constexpr int kSystemStride = 20;
inline constexpr int kSystemCount = 9;
inline constexpr int kFurtherSystems = 300;  ///< of Fanuc: G54.1 P1 …
inline constexpr int kNearSystems = 48;      ///< of them have their numbers in the first block
inline constexpr int kFirstFurtherSystem = 7001;
inline constexpr int kFirstOfManySystems = 14001;
inline constexpr int kRotationWithinSystem = 9;
inline constexpr int kHighestKept = kFirstOfManySystems + kFurtherSystems * kSystemStride;  ///< in every dialect

/// A vacant variable (Fanuc #0) is a NaN that no calculation makes.
double vacant();
inline bool is_vacant(double value) { return value != value; }
inline double number_or_zero(double value) { return is_vacant(value) ? 0.0 : value; }

class Parameters {
 public:
  /// Answers for parameters that mirror the state of the machine; none = not such a parameter.
  std::function<std::optional<double>(int)> numbered_state;
  std::function<std::optional<double>(std::string_view)> named_state;

  Parameters();

  /// As Fanuc's macros have them: kFanucLocals of them belong to a call, and begin vacant; numbers go further.
  void use_macro_variables();

  double numbered(int index) const;
  void set_numbered(int index, double value) {
    (index < kFirstDistant ? numbered_[static_cast<std::size_t>(index)] : distant_[index]) = value;
  }
  bool has_number(int index) const {
    return index >= (vacant_locals_ ? 0 : 1) && (index < count() || (vacant_locals_ && is_distant(index)));
  }
  int count() const { return count_; }
  bool is_read_only(int index) const;

  /// Names of variables (Fanuc's SETVN): they stand for their number, as #[NAME]. Folded as those below.
  void name_numbered(const std::string& name, int index) { names_of_numbers_.insert_or_assign(name, index); }
  bool has_named_numbers() const { return !names_of_numbers_.empty(); }
  std::optional<int> number_of(const std::string& name) const {
    const auto found = names_of_numbers_.find(name);
    return found == names_of_numbers_.end() ? std::nullopt : std::optional(found->second);
  }

  /// `name` is folded: lower case without blanks. Names that begin with '_' are global.
  std::optional<double> named(std::string_view name) const;
  /// @return false if there are too many names
  bool set_named(const std::string& name, double value);
  bool is_state_name(std::string_view name) const { return named_state && named_state(name).has_value(); }

  /// Begins a call: fresh local names; #1… take `arguments`, the rest 0 (vacant in Fanuc macros).
  void enter_call(const std::vector<double>& arguments);
  /// Begins a call that shares #1… with its caller (M98 in Fanuc programs).
  void enter_shared_call();
  void leave_call();

 private:
  struct Frame {
    std::array<double, kFanucLocals> saved{};
    bool owns_numbers = true;
    std::unordered_map<std::string, double> names;
  };

  static constexpr int kFirstDistant = 900000;  ///< of builders' macros: few of them are used
  static bool is_distant(int index) { return index >= kFirstDistant && index < kParameterNumbers; }

  std::unordered_map<int, double> distant_;
  std::vector<double> numbered_;  ///< more than programs may use: the systems of G54.1 have room in every dialect
  int count_ = kParameterCount;
  std::vector<Frame> frames_;
  std::unordered_map<std::string, double> globals_;
  std::unordered_map<std::string, int> names_of_numbers_;
  std::size_t name_count_ = 0;
  int local_count_ = kLinuxcncLocals;
  bool vacant_locals_ = false;
};

}  // namespace toolpace::nc
