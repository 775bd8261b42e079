#pragma once
/// A dialect is a table of differences: what its controllers start in, what their words mean, what they refuse.
///
/// One file a dialect; nothing else in the reader asks which dialect it is.

#include <optional>

#include "toolpace/nc/dialect.h"
#include "toolpace/nc/text/words.h"

namespace toolpace::nc {

/// What a dialect does with a code.
template <class Group>
struct CodeUse {
  Group group;
  bool by_dialect = true;  ///< false: the code exists, but not in this dialect
  Code means = kNoCode;    ///< the code of LinuxCNC that does the same, where it is another one
};

/// How far the end of an arc may lie off the circle through its start.
struct ArcTolerance {
  double metric = 0.0;        ///< [mm] less is always accepted
  double inch = 0.0;          ///< [mm] the same in inch programs
  double relative = 0.0;      ///< of the radius: less is accepted
  double most = 0.0;          ///< more than so many times the tolerance never is
  double least_radius = 0.0;  ///< [mm]
};

struct DialectRules {
  Dialect dialect;

  // What a program begins in.
  Code first_motion = 0;
  Code first_retract = 990;
  Code first_plane = 170;
  Code first_feed_mode = 940;
  Code first_lathe_diameter = 80;
  double first_feed = 0.0;  ///< [mm/min] 0 = none: it has to be programmed

  // Text.
  bool refuses_doubtful = false;  ///< what means nothing is an error, as it is for LinuxCNC, and no warning
  bool macro_statements = false;  ///< IF [] GOTO, WHILE [] DO … END, ":" for O, vacant variables, alarms
  bool sender_lines = false;      ///< "$…" lines and the real-time characters ? ! ~
  bool line_checksums = false;    ///< "*82" at the end of a line
  bool extruder = false;          ///< E moves the extruder of a printer; settings take axis letters, texts no quotes
  bool acts_by_comment = false;   ///< (abort, …)
  bool corner_words = false;      ///< ",C" and ",R" at the end of a move
  bool last_code_wins = false;    ///< of codes of one group and of words that come twice in a block
  bool texts_without_quotes = false;  ///< lines of settings and macros of printers: SET_… A=1, M117 hello
  bool ends_with_text = false;        ///< programs are streamed: they need no end

  // Words.
  bool dwells_in_milliseconds = false;  ///< P of G4 and of cycles without a decimal point
  bool dwells_by_size = false;          ///< from 100 on, without a decimal point, P is in ms: a guess, with a warning
  bool dwells_by_axis_words = false;    ///< G4 X, G4 U, G4 S in s
  bool repeats_by_k = false;            ///< cycles repeat K times
  bool repeats_within_p = false;        ///< M98 P00021000 is twice O1000
  bool g80_keeps_motion = false;        ///< G80 ends cycles alone
  bool motion_beside_home = false;      ///< G0 G28 in one block
  bool rapids_at_feed = false;          ///< G0 is G1
  bool machine_moves_rapid = false;     ///< G53 goes as fast as G0 does under G1, but not beside it
  bool machine_moves_incremental = false;  ///< G53 counts from the machine's zero under G91, too
  bool ignores_centre_off_plane = false;   ///< K in G17
  bool linuxcnc_cycles = false;            ///< tapping cycles feed out to the level that they leave at
  bool incremental_g10 = false;            ///< G10 adds under G91, and needs no L
  bool lathe_words = false;                ///< U V W H are increments of X Y Z C, T0101 is tool 1 with offset 1
  bool scales_in_thousandths = false;      ///< G51 P2000 is twice
  bool scales_by_axis_words = false;       ///< G51 X2 Y2 scales about the zero
  bool pecks_shrink = false;             ///< G83 I J K: the first peck is I, each one J less than the last, K at least
  bool pockets_straight = false;         ///< G12 and G13 reach their circle along X, and not along half a circle
  bool centres_may_be_absolute = false;  ///< I J K of arcs may be places without G90.1, where they fit as such alone
  bool integers_may_count = false;       ///< X1000 may be 1000 least increments

  ArcTolerance arc;

  std::optional<CodeUse<GGroup>> (*g_code)(Code tenths);
  std::optional<CodeUse<MGroup>> (*m_code)(int number);
  /// What a code does that the dialect has and this reader does not follow; null if there is no such code.
  const char* (*unfollowed)(Code tenths);
};

/// @pre not automatic
const DialectRules& rules_of(Dialect dialect);

/// How a text is read that nothing marks: as LinuxCNC's, but what means nothing is a warning.
const DialectRules& rules_of_unmarked_text();

// One a file.
extern const DialectRules kLinuxcncRules, kUnmarkedRules, kFanucRules, kFanucLatheRules, kFanucLatheBRules, kHaasRules,
    kMach3Rules, kGrblRules, kMarlinRules;

/// As the source of LinuxCNC 2.9 has it: 2√2·0.01 mm, 2√2·0.001 in.
inline constexpr ArcTolerance kLinuxcncArcs{.metric = 0.02828427124746190,
                                            .inch = 0.002828427124746190 * 25.4,
                                            .relative = 0.001,
                                            .most = 100.0,
                                            .least_radius = 0.00127};

/// The same, but however small: what CAM systems round is no error on other controllers.
inline constexpr ArcTolerance kSmallArcs{.metric = kLinuxcncArcs.metric,
                                         .inch = kLinuxcncArcs.inch,
                                         .relative = kLinuxcncArcs.relative,
                                         .most = kLinuxcncArcs.most,
                                         .least_radius = 0.0001};

// What several dialects share.
std::optional<GGroup> common_g_group(Code tenths);
std::optional<CodeUse<GGroup>> fanuc_g_code(Code tenths);
/// What a code of Fanuc's kind does, for dialects that do not have it.
std::optional<CodeUse<GGroup>> foreign_g_code(Code tenths);
std::optional<CodeUse<GGroup>> fanuc_lathe_g_code(Code tenths);
const char* fanuc_lathe_unfollowed(Code tenths);
/// What TinyG and its kin have beside grbl's.
std::optional<CodeUse<GGroup>> tinyg_g_code(Code tenths);
std::optional<CodeUse<GGroup>> sender_g_code(Code tenths);
std::optional<CodeUse<MGroup>> fanuc_m_code(int number);
std::optional<CodeUse<MGroup>> sender_m_code(int number);
std::optional<MGroup> common_m_group(int number);
const char* fanuc_unfollowed(Code tenths);
const char* nothing_unfollowed(Code tenths);

/// What all of Fanuc's kind have in common: a dialect of it tells what is otherwise.
constexpr DialectRules fanuc_kind(Dialect dialect) {
  DialectRules rules{.dialect = dialect,
                     .arc = kSmallArcs,
                     .g_code = fanuc_g_code,
                     .m_code = fanuc_m_code,
                     .unfollowed = fanuc_unfollowed};
  rules.first_retract = 980;
  rules.macro_statements = rules.corner_words = rules.last_code_wins = true;
  rules.dwells_in_milliseconds = rules.dwells_by_axis_words = true;
  rules.repeats_by_k = rules.repeats_within_p = true;
  rules.g80_keeps_motion = rules.motion_beside_home = true;
  rules.machine_moves_rapid = rules.machine_moves_incremental = true;
  rules.ignores_centre_off_plane = rules.incremental_g10 = true;
  rules.scales_in_thousandths = rules.integers_may_count = true;
  return rules;
}

/// Of these, the lathes.
constexpr DialectRules fanuc_lathe_kind(Dialect dialect, std::optional<CodeUse<GGroup>> (*g_code)(Code tenths)) {
  DialectRules rules = fanuc_kind(dialect);
  rules.first_plane = 180;
  rules.first_feed_mode = 950;
  rules.first_lathe_diameter = 70;
  rules.lathe_words = true;
  rules.g_code = g_code;
  rules.unfollowed = fanuc_lathe_unfollowed;
  return rules;
}
bool is_listed(int code, std::initializer_list<int> list);

}  // namespace toolpace::nc
