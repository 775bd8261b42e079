/// Machine files of every layout, edited at random: they hold what was meant, and every comment.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "case_count.h"
#include "random_setup.h"
#include "toolpace/machine/key_text.h"
#include "toolpace/machine/toml_layout.h"

namespace toolpace {
namespace {

std::vector<std::string> comments_of(const std::string& text) {
  std::vector<std::string> comments;
  const auto layout = lay_out_toml(text);
  EXPECT_TRUE(layout) << text;
  if (!layout) return comments;
  for (const TextSpan& c : layout->comments) comments.push_back(text.substr(c.begin, c.end - c.begin));
  return comments;
}

/// Writes some keys of a setup as people write them: in any order of sections, indented, dotted, in braces, commented.
class RandomFile {
 public:
  explicit RandomFile(std::uint64_t seed) : random_(seed) { newline_ = random_.one_in(4) ? "\r\n" : "\n"; }

  std::string write(const Setup& setup) {
    auto sections = texts_of(setup);
    std::shuffle(sections.begin(), sections.end(), std::mt19937_64(random_.below(1000)));
    std::string dotted, headed;
    comment_lines(dotted);
    if (random_.one_in(3)) shared_servo(headed);
    for (const SectionText& section : sections) {
      if (random_.one_in(2)) continue;
      switch (random_.below(4)) {
        case 0: write_dotted(section, dotted); break;
        case 1: write_braces(section, dotted); break;
        default: write_headed(section, headed);
      }
    }
    std::string text = dotted + headed;
    if (random_.one_in(4) && text.ends_with(newline_)) text.resize(text.size() - newline_.size());
    return text;
  }

 private:
  std::string comment() { return "# no. " + std::to_string(++comments_) + (random_.one_in(3) ? " [path] = \"'{" : ""); }

  void comment_lines(std::string& text) {
    for (std::size_t n = random_.below(3); n > 0; --n) text += (random_.one_in(2) ? "  " : "") + comment() + newline_;
    if (random_.one_in(3)) text += newline_;
  }

  void end_line(std::string& text) {
    if (random_.one_in(3)) text += "  " + comment();
    text += newline_;
  }

  std::string value_of(const KeyText& key, bool may_break) {
    if (key.parts.size() == 1 || !may_break || random_.one_in(2)) return key.text();
    return "[ " + comment() + newline_ + "  " + key.parts[0] + " , " + comment() + newline_ + " " + key.parts[1] +
           "\t]";
  }

  std::vector<KeyText> some(const SectionText& section) {
    std::vector<KeyText> keys;
    for (const KeyText& key : section.keys) {
      if (!random_.one_in(3)) keys.push_back(key);
    }
    std::shuffle(keys.begin(), keys.end(), std::mt19937_64(random_.below(1000)));
    return keys;
  }

  void write_dotted(const SectionText& section, std::string& text) {
    for (const KeyText& key : some(section)) {
      text += section.name + " . \"" + key.name + "\"=" + value_of(key, true);
      end_line(text);
    }
  }

  void write_braces(const SectionText& section, std::string& text) {
    std::string body;
    for (const KeyText& key : some(section))
      body += (body.empty() ? "" : ", ") + key.name + " = " + value_of(key, false);
    text += section.name + " = {" + body + " }";
    end_line(text);
  }

  void write_headed(const SectionText& section, std::string& text) {
    const std::string indent = random_.one_in(3) ? "\t" : "";
    comment_lines(text);
    text += indent + "[" + section.name + "]";
    end_line(text);
    for (const KeyText& key : some(section)) {
      text += indent + key.name + (random_.one_in(2) ? " = " : "\t=") + value_of(key, true);
      end_line(text);
      comment_lines(text);
    }
  }

  void shared_servo(std::string& text) {
    text += "[servo]" + newline_ + "kv_1_s = 33.0 " + comment() + newline_ + "backlash_mm = 0.01" + newline_;
  }

  test::RandomSetup random_;
  std::string newline_;
  int comments_ = 0;
};

TEST(MachineFiles, EditedAtRandomHoldWhatWasMeantAndEveryComment) {
  std::size_t edited_files = 0;
  for (std::uint64_t seed = 1; seed <= test::case_count(500); ++seed) {
    test::RandomSetup random(seed);
    toolpace::Setup first;
    random.change(first, random.below(40));
    const std::string text = RandomFile(seed).write(first);
    auto setup = parse_setup(text, "random.toml");
    // A dotted key and a header may not speak of one table both; such a file is none.
    if (!setup) continue;
    ++edited_files;
    ASSERT_EQ(edit_setup(text, "random.toml", *setup).value_or("refused"), text) << "seed " << seed;
    random.change(*setup, 1 + random.below(12));
    const auto edited = edit_setup(text, "random.toml", *setup);
    ASSERT_TRUE(edited) << "seed " << seed << ": " << edited.error().message << "\n" << text;
    const auto again = parse_setup(*edited, "random.toml");
    ASSERT_TRUE(again) << "seed " << seed << ": " << again.error().message << "\n" << *edited;
    ASSERT_EQ(first_difference(*again, *setup), std::nullopt) << "seed " << seed << "\n" << *edited;
    ASSERT_EQ(comments_of(*edited), comments_of(text)) << "seed " << seed << "\n" << text << "----\n" << *edited;
    ASSERT_EQ(edit_setup(*edited, "random.toml", *setup).value_or("refused"), *edited) << "seed " << seed;
  }
  EXPECT_GT(edited_files, test::case_count(500) / 2);
}

TEST(MachineFiles, WhateverTheRangesAllowIsWrittenAndReadBack) {
  for (std::uint64_t seed = 1; seed <= test::case_count(500); ++seed) {
    test::RandomSetup random(seed);
    toolpace::Setup setup;
    random.change(setup, 60);
    const auto text = format_setup(setup);
    ASSERT_TRUE(text) << "seed " << seed << ": " << text.error().message;
    ASSERT_EQ(first_difference(*parse_setup(*text, "random.toml"), setup), std::nullopt) << "seed " << seed << *text;
  }
}

}  // namespace
}  // namespace toolpace
