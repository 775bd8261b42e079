#include "setting_flags.h"

#include <algorithm>

#include "toolpace/base/numbers.h"
#include "toolpace/machine/key_text.h"

namespace toolpace::cli {
namespace {

struct FlagOfKey {
  const char *flag, *section, *key;
};
constexpr FlagOfKey kFlagsOfKeys[] = {{"--law", "law", "kind"},
                                      {"--tacc-ms", "law", "tacc_ms"},
                                      {"--tdec-ms", "law", "tdec_ms"},
                                      {"--lookahead", "lookahead", "blocks"},
                                      {"--ramps", "lookahead", "ramps"},
                                      {"--corner", "lookahead", "corner"},
                                      {"--tolerance-mm", "lookahead", "tolerance_mm"},
                                      {"--junction-deviation-mm", "lookahead", "junction_deviation_mm"},
                                      {"--shaper", "lookahead", "shaper"}};

/// A limit and that of slowing down, whose flag follows the other's where it is not given.
struct FlagPair {
  const char *flag, *key, *twin_flag, *twin_key;
};
constexpr FlagPair kLimitPairs[] = {{"--am", "max_acceleration_mm_s2", "--dm", "max_deceleration_mm_s2"},
                                    {"--jm", "max_jerk_mm_s3", "--jd", "max_jerk_deceleration_mm_s3"}};

class FlagList {
 public:
  void set(const char* flag, std::string text) {
    remove(flag);
    Json value = text;
    const auto number = parse_number(text);
    const bool is_depth = std::string_view(flag) == "--lookahead";  // read as a whole number: "4.0" is none
    if (number && *number < kUnlimited) value = is_depth ? Json(static_cast<std::int64_t>(*number)) : Json(*number);
    list_.push_back({flag, std::move(value), std::move(text)});
  }
  void remove(const char* flag) {
    std::erase_if(list_, [&](const SettingFlag& f) { return f.flag == flag; });
  }
  std::vector<SettingFlag> take() { return std::move(list_); }

 private:
  std::vector<SettingFlag> list_;
};

void add_given(const JobFlags& given, FlagList& list) {
  const std::pair<const char*, const std::string*> words[] = {
      {"--law", &given.law}, {"--lookahead", &given.lookahead}, {"--ramps", &given.ramps}, {"--corner", &given.corner}};
  for (const auto& [flag, word] : words) {
    if (!word->empty()) list.set(flag, *word);
  }
  const std::pair<const char*, std::optional<double>> numbers[] = {
      {"--vmax", given.vmax},
      {"--am", given.am},
      {"--dm", given.dm},
      {"--jm", given.jm},
      {"--jd", given.jd},
      {"--tacc-ms", given.tacc_ms},
      {"--tdec-ms", given.tdec_ms},
      {"--corner-step-mm-s", given.corner_step},
      {"--tolerance-mm", given.tolerance},
      {"--junction-deviation-mm", given.junction_deviation},
      {"--override-percent", given.override_percent},
      {"--rapid-percent", given.rapid_percent},
      {"--period-ms", given.period_ms},
      {"--hold-at-s", given.hold_at}};
  for (const auto& [flag, number] : numbers) {
    if (number) list.set(flag, toolpace::to_text(*number));
  }
}

/// Without the quotation marks of words.
std::string text_of(const std::vector<SectionText>& texts, std::string_view section, std::string_view key) {
  for (const SectionText& s : texts) {
    if (s.name != section) continue;
    for (const KeyText& k : s.keys) {
      if (k.name != key) continue;
      const std::string text = k.text();
      return text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
    }
  }
  return {};
}

}  // namespace

std::vector<SettingFlag> setting_flags(const JobFlags& given, const Setup& from, const Setup& to) {
  const auto had = texts_of(from), wanted = texts_of(to);
  FlagList list;
  add_given(given, list);
  for (const FlagOfKey& f : kFlagsOfKeys) {
    const std::string text = text_of(wanted, f.section, f.key);
    if (text != text_of(had, f.section, f.key)) list.set(f.flag, text);
  }
  for (const FlagPair& pair : kLimitPairs) {
    const std::string limit = text_of(wanted, "path", pair.key), twin = text_of(wanted, "path", pair.twin_key);
    if (limit == text_of(had, "path", pair.key) && twin == text_of(had, "path", pair.twin_key)) continue;
    list.set(pair.flag, limit);
    list.remove(pair.twin_flag);
    if (twin != limit) list.set(pair.twin_flag, twin);
  }
  return list.take();
}

Json to_json(const std::vector<SettingFlag>& flags) {
  Json json = Json::object();
  for (const SettingFlag& f : flags) json[f.flag] = f.value;
  return json;
}

std::string to_text(const std::vector<SettingFlag>& flags) {
  std::string text;
  for (const SettingFlag& f : flags) text += (text.empty() ? "" : " ") + f.flag + ' ' + f.text;
  return text;
}

}  // namespace toolpace::cli
