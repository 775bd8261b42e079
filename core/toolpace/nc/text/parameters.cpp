#include "toolpace/nc/text/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toolpace::nc {

double vacant() { return std::numeric_limits<double>::quiet_NaN(); }

Parameters::Parameters() : numbered_(kHighestKept, 0.0), frames_(1) { numbered_[kActiveSystem] = 1.0; }

void Parameters::use_macro_variables() {
  local_count_ = kFanucLocals;
  vacant_locals_ = true;
  count_ = kMacroVariables;
  numbered_.resize(kMacroVariables, 0.0);
  std::fill_n(numbered_.begin() + 1, kFanucLocals, vacant());
  std::fill(numbered_.begin() + 100, numbered_.begin() + 200, vacant());
}

double Parameters::numbered(int index) const {
  if (vacant_locals_ && index == 0) return vacant();
  if (index >= 3000 && numbered_state) {
    if (const auto value = numbered_state(index)) return *value;
  }
  if (index < kFirstDistant) return numbered_[static_cast<std::size_t>(index)];
  const auto found = distant_.find(index);
  return found == distant_.end() ? vacant() : found->second;
}

bool Parameters::is_read_only(int index) const {
  if (vacant_locals_) return index == 0;
  return index == 0 || (index >= 5400 && index <= 5413) || (index >= 5420 && index <= 5428) || index > 5599;
}

std::optional<double> Parameters::named(std::string_view name) const {
  const std::string key(name);
  if (!name.empty() && name.front() == '_') {
    if (const auto found = globals_.find(key); found != globals_.end()) return found->second;
    return named_state ? named_state(name) : std::nullopt;
  }
  const auto& names = frames_.back().names;
  if (const auto found = names.find(key); found != names.end()) return found->second;
  return std::nullopt;
}

bool Parameters::set_named(const std::string& name, double value) {
  auto& names = !name.empty() && name.front() == '_' ? globals_ : frames_.back().names;
  const auto [entry, is_new] = names.insert_or_assign(name, value);
  name_count_ += is_new ? 1 : 0;
  return name_count_ <= kMostNames;
}

void Parameters::enter_call(const std::vector<double>& arguments) {
  Frame frame;
  std::copy_n(numbered_.begin() + 1, kFanucLocals, frame.saved.begin());
  frames_.push_back(std::move(frame));
  for (int i = 0; i < local_count_; ++i) {
    const auto argument = static_cast<std::size_t>(i);
    const double absent = vacant_locals_ ? vacant() : 0.0;
    set_numbered(i + 1, argument < arguments.size() ? arguments[argument] : absent);
  }
}

void Parameters::enter_shared_call() {
  Frame frame;
  frame.owns_numbers = false;
  frames_.push_back(std::move(frame));
}

void Parameters::leave_call() {
  if (frames_.size() < 2) return;
  const Frame& frame = frames_.back();
  if (frame.owns_numbers) std::copy_n(frame.saved.begin(), local_count_, numbered_.begin() + 1);
  name_count_ -= std::min(name_count_, frame.names.size());
  frames_.pop_back();
}

}  // namespace toolpace::nc
