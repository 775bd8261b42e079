#pragma once
/// Writes a program anew for a machine or a controller, in a worker.

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "drawing/contour_scene.h"
#include "jobs/background.h"
#include "models/document.h"
#include "toolpace/rewrite/rewrite_job.h"

namespace toolpace::ui {

struct RewriteRequest {
  std::shared_ptr<const Document> document;
  ReadOptions read_options;  ///< with the dialect that it is read in
  RewriteTarget target;
};

/// Lines of the program that were written anew, with what became of them.
struct RewrittenRange {
  std::uint32_t first_line = 0, last_line = 0;
  std::size_t blocks_before = 0, blocks_after = 0;
  double time_before = 0, time_after = 0;  ///< [s]

  double saved() const { return time_before - time_after; }
};

struct RewriteFound {
  Rewritten rewritten;
  std::size_t blocks_before = 0, blocks_after = 0, bytes_before = 0;
  double tolerance = 0;                       ///< [mm]
  std::vector<RewrittenRange> ranges;         ///< in the order of the program
  std::shared_ptr<const ContourScene> scene;  ///< the program's path, with the new one as its trace
};

/// A newer request replaces an older one, whose result never arrives.
class RewriteService : public QObject {
  Q_OBJECT

 public:
  explicit RewriteService(QObject* parent = nullptr);

  void rewrite(const RewriteRequest& request);
  void save(std::shared_ptr<const RewriteFound> found, const QString& file);
  void cancel();
  bool isRunning() const { return worker_.isBusy() || next_; }

 signals:
  void rewritten(std::shared_ptr<const toolpace::ui::RewriteFound> found);
  void saved(const QString& file);
  void failed(const toolpace::Error& error, const QString& file);  ///< the latter empty where nothing was to be saved
  void progressed(double fraction);
  void finished();

 private:
  void submit(Background::Task task, const QString& file);

  Background worker_;
  std::function<void()> next_;
  quint64 latest_ = 0;
};

/// Both paths and the ranges of it; pure, for the worker. Errors: those of read_text() and rewrite_for().
Result<std::shared_ptr<const RewriteFound>> rewrite_document(const RewriteRequest& request, const Monitor& monitor);

}  // namespace toolpace::ui
