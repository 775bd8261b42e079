#include "toolpace/io/block_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "toolpace/base/axis_unit.h"
#include "toolpace/base/numbers.h"
#include "toolpace/io/output_file.h"
#include "toolpace/path/spline.h"

namespace toolpace {
namespace {

constexpr std::size_t kFlushBytes = std::size_t{1} << 16;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kNoMove = 1e-9;  // [mm], [deg]

const char* kind_name(MoveKind kind) {
  switch (kind) {
    case MoveKind::rapid: return "rapid";
    case MoveKind::feed:
    case MoveKind::spline: return "feed";
    case MoveKind::arc: return "arc";
    case MoveKind::probe: return "probe";
    case MoveKind::tap: return "tap";
    case MoveKind::dwell: return "dwell";
    case MoveKind::tool: return "tool";
    case MoveKind::stop: return "stop";
    case MoveKind::end: return "end";
  }
  return "";
}

const char* feed_mode_name(std::uint8_t mode) {
  // Inverse-time feeds are converted to a feed a minute already.
  if (mode == 95) return "G95";
  return mode == kSynchronisedFeed ? "sync" : "G94";
}

const char* plane_name(std::uint8_t plane) { return plane == 18 ? "G18" : plane == 19 ? "G19" : "G17"; }

const char* control_name(PathControl control) {
  if (control == PathControl::exact_path) return "G61";
  return control == PathControl::exact_stop ? "G61.1" : "G64";
}

bool moves_rotary_alone(const AxisVector& from, const AxisVector& to) {
  const AxisVector step = (to - from).cwiseAbs();
  return step.head<3>().maxCoeff() <= kNoMove && step.tail<3>().maxCoeff() > kNoMove * kRadiansPerDegree;
}

class BlockTable {
 public:
  BlockTable(OutputFile& file, const Reading& reading) : file_(file), moves_(reading.moves), reading_(reading) {}

  Result<void> write() {
    text_ = "n,line,kind,x,y,z,a,b,c,feed,fmode,plane,cx,cy,cz,nx,ny,nz,sweep,path,tol,nct,dwell,curve,note\n";
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      write_move(i);
      if (text_.size() >= kFlushBytes) {
        if (auto done = flush(); !done) return done;
      }
    }
    write_error();
    return flush();
  }

 private:
  void write_move(std::size_t i) {
    const MoveKind kind = moves_.kind[i];
    if (kind == MoveKind::tap && moves_.detail[i] == kTapReturn) return;  // a tap row implies its return
    if (kind == MoveKind::spline) {
      ++splines_;
      for (const auto& point : spline_chords(moves_.begin_of(i), moves_.end[i], moves_.splines[moves_.detail[i]])) {
        write_row(i, point, 's' + std::to_string(splines_));
      }
      return;
    }
    write_row(i, moves_.end[i], {});
  }

  void write_row(std::size_t i, const AxisVector& end, const std::string& curve) {
    const MoveKind kind = moves_.kind[i];
    const MoveMode& mode = moves_.modes[moves_.mode[i]];
    begin_row(moves_.line[i], kind_name(kind), end);
    const bool has_feed = is_motion(kind) && kind != MoveKind::rapid && std::isfinite(moves_.feed[i]);
    const bool rotary =
        has_feed && kind != MoveKind::arc && curve.empty() && moves_rotary_alone(moves_.begin_of(i), end);
    // Twelve digits: the feed went from a minute to a second and back.
    if (has_feed)
      text_ += fmt::format("{:.12g}", moves_.feed[i] * kSecondsPerMinute / (rotary ? kRadiansPerDegree : 1.0));
    cell(has_feed ? feed_mode_name(mode.feed_mode) : "");
    cell(plane_name(mode.plane));
    text_ += ',';
    write_arc(kind == MoveKind::arc ? &moves_.arcs[moves_.detail[i]] : nullptr);
    text_ += control_name(mode.control);
    number_cell(mode.tolerance);
    number_cell(mode.naive_tolerance);
    text_ += ',';
    if (kind == MoveKind::dwell) append_text(text_, moves_.dwells[moves_.detail[i]]);
    cell(curve);
    text_ += ',';
    if (!is_motion(kind) && kind != MoveKind::dwell) quote(moves_.notes[moves_.detail[i]]);
    text_ += '\n';
  }

  void begin_row(std::size_t line, const char* kind, const AxisVector& end) {
    text_ += std::to_string(++row_);
    cell(std::to_string(line));
    cell(kind);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const double value = end[static_cast<Eigen::Index>(axis)];
      number_cell(value / axis_unit(axis).size);
    }
    text_ += ',';
  }

  void write_arc(const ArcDetail* arc) {
    if (arc == nullptr) {
      text_ += ",,,,,,,";
      return;
    }
    for (const Eigen::Vector3d& v : {arc->centre, Eigen::Vector3d(arc->normal)}) {
      for (int k = 0; k < 3; ++k) {
        append_text(text_, v[k] == 0.0 ? 0.0 : v[k]);
        text_ += ',';
      }
    }
    append_text(text_, arc->sweep / kRadiansPerDegree);
    text_ += ',';
  }

  void write_error() {
    if (!reading_.refused) return;
    for (const auto& d : reading_.diagnostics) {
      if (d.severity != Severity::error) continue;
      begin_row(d.where.line, "error", moves_.empty() ? moves_.start : moves_.end.back());
      text_ += ",,,,,,,,,,,,,,,";
      quote(d.message);
      text_ += '\n';
      return;
    }
  }

  void cell(std::string_view content) {
    text_ += ',';
    text_ += content;
  }
  void number_cell(double value) {
    text_ += ',';
    append_text(text_, value == 0.0 ? 0.0 : value);  // no "-0"
  }
  void quote(const std::string& content) {
    if (content.find_first_of(",\"\n\r") == std::string::npos) {
      text_ += content;
      return;
    }
    text_ += '"';
    for (const char c : content) {
      if (c == '"') text_ += '"';
      text_ += c;
    }
    text_ += '"';
  }
  Result<void> flush() {
    auto done = file_.write(text_);
    text_.clear();
    return done;
  }

  OutputFile& file_;
  const Moves& moves_;
  const Reading& reading_;
  std::string text_;
  std::size_t row_ = 0;
  std::size_t splines_ = 0;
};

}  // namespace

std::vector<AxisVector> spline_chords(const AxisVector& begin, const AxisVector& end, const SplineDetail& spline) {
  const SplineCurve curve = make_spline(begin, end, spline);
  std::vector<AxisVector> points;
  const std::size_t chords = kChordsPerControlPoint * spline.points.size();
  const double first = spline.knots.front(), last = spline.knots.back();
  for (std::size_t k = 1; k < chords; ++k) {
    points.push_back(
        spline_point(curve, first + (last - first) * static_cast<double>(k) / static_cast<double>(chords)));
  }
  points.push_back(end);
  return points;
}

Result<void> write_blocks(const std::filesystem::path& file, const Reading& reading, const Monitor& monitor) {
  auto output = OutputFile::create(file, OutputFile::Access::forward, monitor);
  if (!output) return tl::unexpected(output.error());
  if (auto done = BlockTable(*output, reading).write(); !done) return done;
  return output->commit();
}

}  // namespace toolpace
