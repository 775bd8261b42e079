#include <algorithm>

#include "toolpace/machine/edit_modes.h"
#include "toolpace/machine/key_text.h"
#include "toolpace/machine/setup.h"
#include "toolpace/machine/setup_proof.h"
#include "toolpace/machine/toml_editor.h"

namespace toolpace {
namespace {

/// Brings one text to the values of a setup.
class SetupEditor {
 public:
  SetupEditor(TomlEditor& editor, const Setup& had, const Setup& wanted)
      : editor_(editor), had_(texts_of(had)), wanted_(texts_of(wanted)), absent_(texts_of_absent_keys(wanted)) {}

  void edit() {
    share_servo_keys();
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      for (std::size_t k = 0; k < wanted_[s].keys.size(); ++k) edit_key(s, k);
    }
  }

 private:
  void edit_key(std::size_t s, std::size_t k) {
    const KeyText &had = had_[s].keys[k], &wanted = wanted_[s].keys[k], &absent = absent_[s].keys[k];
    const TomlPath section = path_of(wanted_[s].name);
    if (wanted.name == kModesKey) return;  // a list of sections
    const TomlEntry* entry = editor_.find(section, wanted.name);
    if (!entry) {
      if (wanted != absent) editor_.insert(section, wanted);
    } else if (wanted == had) {
      return;
    } else if (wanted == absent && is_none(wanted)) {
      editor_.remove(*entry, wanted);
    } else {
      editor_.replace(*entry, had, wanted);
    }
  }

  /// A key of [servo] holds for the axes that have none of their own, and changes where these agree on another value.
  void share_servo_keys() {
    std::vector<std::string> done;
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      if (!wanted_[s].name.starts_with("servo.")) continue;
      for (const KeyText& key : wanted_[s].keys) {
        if (std::find(done.begin(), done.end(), key.name) != done.end()) continue;
        done.push_back(key.name);
        if (const TomlEntry* shared = editor_.find({"servo"}, key.name)) share(*shared, key.name);
      }
    }
  }

  void share(const TomlEntry& entry, const std::string& name) {
    struct Follower {
      const KeyText *had, *wanted;
      KeyText* absent;
    };
    std::vector<Follower> followers;
    for (std::size_t s = 0; s < wanted_.size(); ++s) {
      if (!wanted_[s].name.starts_with("servo.") || editor_.find(path_of(wanted_[s].name), name)) continue;
      for (std::size_t k = 0; k < wanted_[s].keys.size(); ++k) {
        if (wanted_[s].keys[k].name != name) continue;
        followers.push_back({&had_[s].keys[k], &wanted_[s].keys[k], &absent_[s].keys[k]});
      }
    }
    if (followers.empty()) return;
    const KeyText had = *followers.front().had, first = *followers.front().wanted;
    const bool agree =
        std::all_of(followers.begin(), followers.end(), [&](const Follower& f) { return *f.wanted == first; });
    if (agree && first != had) editor_.replace(entry, had, first);
    for (const Follower& f : followers) *f.absent = agree ? first : had;
  }

  TomlEditor& editor_;
  std::vector<SectionText> had_, wanted_, absent_;
};

}  // namespace

Result<std::string> edit_setup(std::string_view text, const std::string& name, const Setup& setup) {
  const auto had = parse_setup(text, name, UnknownKeys::pass_over);
  if (!had) return tl::unexpected(had.error());
  const bool is_marked = text.starts_with(kUtf8Mark);
  const std::string_view body = text.substr(is_marked ? kUtf8Mark.size() : 0);
  auto layout = lay_out_toml(body);
  if (!layout) {
    return tl::unexpected(Error{ErrorKind::usage,
                                "machine-unwritable",
                                "this file is laid out in a way that cannot be edited",
                                "save the machine under another name",
                                {name, 0, 0},
                                {}});
  }
  TomlEditor editor(body, std::move(*layout));
  SetupEditor(editor, *had, setup).edit();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis)
    detail::edit_modes(editor, axis, had->machine.servo[axis].modes, setup.machine.servo[axis].modes);
  return proven_text(std::string(text.substr(0, text.size() - body.size())) + editor.result(), setup,
                     UnknownKeys::pass_over);
}

}  // namespace toolpace
