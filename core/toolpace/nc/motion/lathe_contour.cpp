#include "toolpace/nc/motion/lathe_contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "toolpace/nc/motion/arcs.h"
#include "toolpace/nc/motion/corner_geometry.h"
#include "toolpace/nc/motion/corners.h"
#include "toolpace/nc/motion/motion.h"

namespace toolpace::nc {
namespace {

bool is_plain_motion(Code code) { return code == 0 || code == 10 || code == 20 || code == 30; }

}  // namespace

LatheContourReader::LatheContourReader(Context& context, const Position& start)
    : context_(context), at_{start[2], start[0]}, motion_(context.state.modal.motion) {}

bool LatheContourReader::find_motion(const Block& block) {
  if (block.has(GGroup::motion)) motion_ = block.code(GGroup::motion);
  if (is_plain_motion(motion_) || !block.has_any(word_bit('x') | word_bit('z') | word_bit('u') | word_bit('w')))
    return true;
  return context_.faults.fail("lathe-contour-motion",
                              fmt::format("{} in the contour of a lathe cycle", code_text('G', motion_)),
                              "a contour is made of G0, G1, G2 and G3", block.column_of(GGroup::motion));
}

void LatheContourReader::warn_of_unused(const Block& block) {
  constexpr std::uint32_t kUsed = word_bit('x') | word_bit('z') | word_bit('u') | word_bit('w') | word_bit('i') |
                                  word_bit('k') | word_bit('r') | word_bit('a') | word_bit('c');
  constexpr std::uint32_t kMotionGroup = 1u << static_cast<unsigned>(GGroup::motion);
  if (unused_told_) return;
  if ((block.words & ~kUsed) == 0 && (block.g_groups & ~kMotionGroup) == 0 && block.m_groups == 0) return;
  unused_told_ = true;
  context_.faults.warn("lathe-contour-unused", "what a contour says besides its shape has no effect",
                       "give feed, speed and other codes before the lathe cycle");
}

bool LatheContourReader::find_relative(const Block& block, char letter, char axis, double& value) {
  if (!block.has(letter)) return true;
  const char shown = static_cast<char>(letter - 32), shown_axis = static_cast<char>(axis - 32);
  if (context_.state.modal.incremental()) {
    return context_.faults.fail("lathe-contour-words", fmt::format("{} of a contour under G91", shown),
                                fmt::format("use {}, or G90", shown_axis), block.column_of(letter));
  }
  if (block.has(axis)) {
    return context_.faults.fail("lathe-contour-words", fmt::format("both {} and {} in a block", shown_axis, shown),
                                "give one of them", block.column_of(letter));
  }
  value += length_of(context_.state, block, letter);
  return true;
}

bool LatheContourReader::find_end(const Block& block, Point& end) {
  const Modal& modal = context_.state.modal;
  const double radius = modal.lathe_diameter == 70 ? 0.5 : 1.0;
  end = at_;
  double by_x = 0.0, by_z = 0.0;
  if (!find_relative(block, 'u', 'x', by_x) || !find_relative(block, 'w', 'z', by_z)) return false;
  const Point base = modal.incremental() ? at_ : Point{};
  if (block.has('x')) end.y = base.y + length_of(context_.state, block, 'x') * radius;
  if (block.has('z')) end.x = base.x + length_of(context_.state, block, 'z');
  end = end + Point{by_z, by_x * radius};
  if (std::fabs(end.x) <= kFarthest && std::fabs(end.y) <= kFarthest) return true;
  return context_.faults.fail("coordinate-too-large", fmt::format("a contour more than {:g} mm away", kFarthest),
                              "check the numbers and the offsets");
}

bool LatheContourReader::find_centre_by_radius(const Block& block, ContourElement& arc) {
  const double radius = length_of(context_.state, block, 'r');
  const Point chord = arc.end - arc.start;
  const double half = norm(chord) / 2.0;
  if (!(radius >= half)) {
    return context_.faults.fail(
        "arc-radius-too-small",
        fmt::format("radius {:.4f} mm cannot reach the end point {:.4f} mm away", radius, 2 * half),
        fmt::format("the radius must be at least {:.4f} mm", half), block.column_of('r'));
  }
  const double beside = std::sqrt((radius - half) * (radius + half));
  arc.centre = arc.start + chord * 0.5 + turned(chord, arc.turn) * (beside / (2.0 * half));
  return true;
}

bool LatheContourReader::find_centre(const Block& block, ContourElement& arc) {
  const bool by_centre = block.has('i') || block.has('k');
  if (by_centre == block.has('r')) {
    return context_.faults.fail(
        by_centre ? "arc-radius-and-centre" : "arc-incomplete",
        by_centre ? "an arc with both a radius and a centre" : "an arc without radius and centre",
        by_centre ? "give R, or I K, not both" : "give R, or I K", block.column_of(GGroup::motion));
  }
  if (block.has('r')) return find_centre_by_radius(block, arc);
  arc.centre = Point{block.of('k', 0.0), block.of('i', 0.0)} * unit();
  if (context_.state.modal.arc_distance != 901) arc.centre = arc.centre + arc.start;
  const double r1 = norm(arc.start - arc.centre), r2 = norm(arc.end - arc.centre);
  return check_radii(context_, r1, r2, block.column_of(block.has('i') ? 'i' : 'k'));
}

bool LatheContourReader::find_corner(const Block& block, Corner& corner) {
  if (block.has_any(kCornerBits)) {
    const bool legs = block.has_any(1u << kChamferWord);
    corner = {legs ? CornerKind::legs : CornerKind::fillet, block.value[legs ? kChamferWord : kFilletWord] * unit()};
    return true;
  }
  if (context_.rules.lathe_words) return true;
  if (!block.has('a') && !block.has('c')) return true;
  const char letter = block.has('a') ? 'a' : 'c';
  corner = {letter == 'a' ? CornerKind::fillet : CornerKind::chamfer, block.of(letter) * unit()};
  if (block.has('a') && block.has('c')) {
    return context_.faults.fail("lathe-contour-words", "both A and C at a corner", "A rounds it, C breaks it: give one",
                                block.column_of('c'));
  }
  if (corner.size >= 0.0 && corner.size <= kFarthest) return true;
  return context_.faults.fail("lathe-contour-words", fmt::format("a corner of {:g}", block.of(letter)),
                              "the size of a corner is not below 0", block.column_of(letter));
}

// ,A: one coordinate tells the other; a line with its angle alone ends where the next one meets it.
bool LatheContourReader::find_end_by_angle(const Block& block, std::uint32_t line, const Corner& corner, Point& end) {
  const double angle = block.value[kLineAngleWord];
  const bool x = names_axis(context_, block, 0), z = names_axis(context_, block, 2);
  if (open_) {
    Point meeting;
    if (!x || !z || !find_meeting_of_lines(at_, open_->angle, end, angle, meeting)) return fail_open();
    ContourElement before;
    before.line = open_->line;
    before.start = at_;
    before.end = meeting;
    before.feed = feed_;
    push(before, open_->corner);
    open_.reset();
    return true;
  }
  if (x != z) {
    Position from{}, to{};
    from[2] = at_.x;
    from[0] = at_.y;
    to = from;
    to[2] = end.x;
    to[0] = end.y;
    if (!find_end_on_line(context_, block, from, to)) return false;
    end = {to[2], to[0]};
  }
  if (!x && !z) open_ = OpenLine{angle, corner, line};
  return true;
}

bool LatheContourReader::fail_open() {
  return context_.faults.fail("line-angle-open",
                              fmt::format("the line of line {} has an angle, but no end", open_ ? open_->line : 0),
                              "give one of its coordinates, or in the next block both coordinates and an angle");
}

void LatheContourReader::push(const ContourElement& element, const Corner& corner) {
  elements_.push_back(element);
  corners_.push_back(corner);
  at_ = element.end;
}

bool LatheContourReader::add(const Block& given, std::uint32_t line) {
  if (!find_motion(given)) return false;
  const bool has_corner_words = context_.rules.lathe_words && motion_ <= 10 && may_mean_corner(given);
  return has_corner_words ? add_plain(with_corner_words(context_, given, motion_), line) : add_plain(given, line);
}

bool LatheContourReader::add_plain(const Block& block, std::uint32_t line) {
  ContourElement element;
  element.line = line;
  Corner corner;
  if (!find_end(block, element.end) || !find_corner(block, corner)) return false;
  const bool has_angle = block.has_any(kLineAngleBit);
  if (open_ && !has_angle) return fail_open();
  if (has_angle && !find_end_by_angle(block, line, corner, element.end)) return false;
  element.start = at_;
  if (block.has('f')) feed_ = block.of('f');
  element.rapid = motion_ == 0;
  element.feed = feed_;
  if (!context_.rules.lathe_words) warn_of_unused(block);
  if (norm(element.end - element.start) == 0.0) return true;
  if (motion_ == 20 || motion_ == 30) {
    element.turn = motion_ == 30 ? 1 : -1;
    if (!find_centre(block, element)) return false;
  }
  push(element, corner);
  State& state = context_.state;
  state.position[0] = state.compensation.programmed[0] = at_.y;
  state.position[2] = state.compensation.programmed[2] = at_.x;
  return true;
}

// A circle that touches both elements, on the side that the corner is open to; a chamfer joins where it touches.
bool LatheContourReader::finish_corner(ContourElement& before, ContourElement& after, const Corner& corner,
                                       ContourElement& between) {
  if (corner.size == 0.0 || !is_corner(before, after)) return false;
  between.rapid = false;
  between.feed = before.feed;
  if (corner.kind == CornerKind::legs && break_corner(before, after, corner.size, between)) {
    between.line = before.line;
    return true;
  }
  if (corner.kind != CornerKind::legs && round_corner(before, after, corner.size, between)) {
    if (corner.kind != CornerKind::fillet) between.turn = 0;
    between.line = before.line;
    return true;
  }
  context_.faults.fail("lathe-corner-too-large",
                       fmt::format("a corner of {:g} mm does not fit between the elements beside it in line {}",
                                   corner.size, before.line),
                       "give a smaller A or C");
  return false;
}

bool LatheContourReader::finish(std::vector<ContourElement>& contour) {
  contour.clear();
  if (open_) return fail_open();
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    contour.push_back(elements_[i]);
    if (corners_[i].kind == CornerKind::none || i + 1 == elements_.size()) continue;
    ContourElement between;
    if (finish_corner(contour.back(), elements_[i + 1], corners_[i], between)) contour.push_back(between);
    if (!context_.faults.empty()) return false;
  }
  std::erase_if(contour, [&](const ContourElement& e) {
    return &e != &contour.front() && norm(e.end - e.start) < kVanishing * unit();
  });
  for (std::size_t i = 1; i < contour.size(); ++i) contour[i - 1].end = contour[i].start;
  elements_.clear();
  corners_.clear();
  return true;
}

}  // namespace toolpace::nc
