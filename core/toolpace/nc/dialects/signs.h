#pragma once
/// What in a line speaks for a dialect, or against it.

#include <string>
#include <string_view>
#include <vector>

#include "toolpace/nc/dialect.h"

namespace toolpace::nc {

struct Sign {
  Dialect dialect = Dialect::automatic;
  int weight = 0;    ///< 3 alone decides, 1 is a hint, below 0 speaks against it
  std::string what;  ///< for people
};

class SignReader {
 public:
  /// True for lines of plain moves, which most programs consist of and which say nothing but their axes.
  bool is_plain(std::string_view line);
  /// The signs of a line that is not plain; lines are looked at in their order.
  const std::vector<Sign>& look_at(std::string_view line);
  /// What the axes of all lines together say. LinuxCNC's lathes may begin in any plane.
  const std::vector<Sign>& look_at_axes(bool may_be_linuxcnc);

 private:
  struct Word {
    char letter;
    std::string_view number;
  };

  void look_at_comments(std::string_view line);
  void look_at_o_word();
  void look_at_words();
  void look_at_haas_words();
  void look_at_sender_words();
  void look_at_lathe_words();
  void note_feed(std::string_view number);
  void add(Dialect dialect, int weight, std::string_view what);
  bool has(char letter) const;
  bool has(char letter, std::string_view number) const;

  std::vector<Sign> signs_;
  std::string text_;  ///< the line in small letters, without blanks and comments
  std::vector<Word> words_;
  bool seen_block_ = false;
  bool has_extruder_ = false;  ///< the line's word E stands by itself
  bool incremental_ = false;
  bool has_x_ = false, has_y_ = false, has_z_ = false;
  bool has_plane_ = false, turns_in_xz_ = false;
  bool has_small_feed_ = false, has_large_feed_ = false;
};

}  // namespace toolpace::nc
