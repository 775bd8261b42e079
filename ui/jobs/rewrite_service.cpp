#include "jobs/rewrite_service.h"

#include <QFileInfo>
#include <algorithm>

#include "drawing/deviation_trace.h"
#include "toolpace/io/output_file.h"
#include "toolpace/nc/reader.h"
#include "toolpace/path/build_path.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kMostRanges = 60;  // about so many in the table
constexpr double kWriting = 0.9;         // of the progress

std::size_t moving_rows(const Moves& moves, std::size_t first, std::size_t last) {
  std::size_t count = 0;
  for (std::size_t row = first; row < std::min(last, moves.size()); ++row) count += is_motion(moves.kind[row]) ? 1 : 0;
  return count;
}

double time_of(const ProgramTime& time, std::size_t first, std::size_t last) {
  double sum = 0;
  for (std::size_t row = first; row < std::min(last, time.row.size()); ++row) sum += time.row[row];
  return sum;
}

/// Stretches that follow each other are told together until they are long enough to count.
std::vector<RewrittenRange> ranges_of(const RewrittenFor& found, const Moves& before) {
  const Moves& after = found.rewritten.reading.moves;
  const std::size_t least = before.size() / kMostRanges;
  std::vector<RewrittenRange> ranges;
  std::size_t told = 0;
  for (const RewrittenPart& part : found.rewritten.parts) {
    const std::uint32_t first = before.line[part.first], last = before.line[part.last - 1];
    const bool joins = !ranges.empty() && told < least && first == ranges.back().last_line + 1;
    if (!joins) {
      ranges.push_back({first, last, 0, 0, 0, 0});
      told = 0;
    }
    RewrittenRange& range = ranges.back();
    range.last_line = last;
    range.blocks_before += moving_rows(before, part.first, part.last);
    range.blocks_after += moving_rows(after, part.new_first, part.new_last);
    range.time_before += time_of(found.before, part.first, part.last);
    range.time_after += time_of(found.after, part.new_first, part.new_last);
    told += part.last - part.first;
  }
  return ranges;
}

std::shared_ptr<const ContourScene> both_paths(const RewriteRequest& request, std::shared_ptr<const Reading> before,
                                               const Moves& after, const Monitor& monitor) {
  const Monitor quiet{monitor.stop, {}};
  auto path = build_path(before->moves, 0, quiet);
  const auto other = build_path(after, 0, quiet);
  auto outcome = std::make_shared<Outcome>();
  auto job = std::make_shared<Job>();
  job->program = std::move(before);
  job->machine = request.target.setup.machine;
  job->options = request.target.setup.options;
  outcome->job = job;
  if (!path || !other) return make_contour_scene(outcome);
  outcome->path = std::make_shared<const Path>(std::move(*path));
  const auto trace = make_deviation_trace(*outcome->path, *other, request.target.setup.options.corner.tolerance, quiet);
  return make_contour_scene(outcome, trace);
}

}  // namespace

Result<std::shared_ptr<const RewriteFound>> rewrite_document(const RewriteRequest& request, const Monitor& monitor) {
  const Document& document = *request.document;
  const QByteArray bytes = document.text.bytes();
  const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  const std::string name = document.name.toStdString();
  ReadOptions options = request.read_options;
  if (!document.path.isEmpty()) options.sub_paths.push_back(QFileInfo(document.path).absolutePath().toStdString());
  auto reading = read_text(text, name, options, {monitor.stop, {}});
  if (!reading) return tl::unexpected(reading.error());
  const auto before = std::make_shared<const Reading>(std::move(*reading));
  Monitor part{monitor.stop, {}};
  if (monitor.progress) part.progress = [&](double fraction) { monitor.report(kWriting * fraction); };
  auto done = rewrite_for(request.target, text, name, before, options, part);
  if (!done) return tl::unexpected(done.error());
  auto found = std::make_shared<RewriteFound>();
  found->blocks_before = motion_rows(before->moves);
  found->blocks_after = motion_rows(done->rewritten.reading.moves);
  found->bytes_before = text.size();
  found->tolerance = request.target.setup.options.corner.tolerance;
  found->ranges = ranges_of(*done, before->moves);
  found->scene = both_paths(request, before, done->rewritten.reading.moves, monitor);
  found->rewritten = std::move(done->rewritten);
  if (monitor.is_cancelled()) return tl::unexpected(cancelled_error());
  return found;
}

RewriteService::RewriteService(QObject* parent) : QObject(parent) {
  connect(&worker_, &Background::progressed, this, &RewriteService::progressed);
  connect(&worker_, &Background::finished, this, [this] {
    if (!next_) return emit finished();
    std::exchange(next_, nullptr)();
  });
}

void RewriteService::rewrite(const RewriteRequest& request) {
  submit(
      [this, request, number = ++latest_](const Monitor& monitor) -> Background::Delivery {
        auto found = rewrite_document(request, monitor);
        return [this, number, found = std::move(found)] {
          if (number != latest_) return;
          if (found) {
            emit rewritten(*found);
          } else {
            emit failed(found.error(), {});
          }
        };
      },
      {});
}

void RewriteService::save(std::shared_ptr<const RewriteFound> found, const QString& file) {
  submit(
      [this, found = std::move(found), file, number = ++latest_](const Monitor& monitor) -> Background::Delivery {
        const auto written = write_whole_file(file.toStdString(), found->rewritten.text, monitor);
        return [this, number, written, file] {
          if (number != latest_) return;
          if (written) {
            emit saved(file);
          } else {
            emit failed(written.error(), file);
          }
        };
      },
      file);
}

void RewriteService::cancel() {
  ++latest_;
  next_ = nullptr;
  worker_.cancel();
}

void RewriteService::submit(Background::Task task, const QString& file) {
  const auto start = [this, file, number = latest_, task = std::move(task)] {
    worker_.start(task, [this, file, number](const Error& error) {
      if (number == latest_) emit failed(error, file);
    });
  };
  if (!worker_.isBusy()) return start();
  next_ = start;
  worker_.cancel();
}

}  // namespace toolpace::ui
