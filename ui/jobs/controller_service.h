#pragma once
/// Runs a program as a real controller would, in a worker.

#include <QObject>
#include <memory>
#include <optional>

#include "drawing/controlled.h"
#include "jobs/background.h"
#include "models/document.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::ui {

/// Finishes what runs, then takes the latest request: a drag shows every run that gets done.
class ControllerService : public QObject {
  Q_OBJECT

 public:
  explicit ControllerService(QObject* parent = nullptr);

  /// @param options  how the program is read, but for its dialect, which is the controller's
  /// @param supply   how its blocks come
  /// @return the request's generation; results of older ones are marked stale by isLatest
  quint64 submit(std::shared_ptr<const Document> document, SharedControllerText settings, const ReadOptions& options,
                 const PredictOptions& supply);
  /// Drops what waits and stops what runs.
  void cancel();
  bool isBusy() const { return worker_.isBusy(); }
  bool isLatest(quint64 generation) const { return generation == latest_; }

 signals:
  void driven(std::shared_ptr<const toolpace::ui::Controlled> found, quint64 generation);
  void failed(const toolpace::Error& error, quint64 generation);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  struct Request {
    std::shared_ptr<const Document> document;
    SharedControllerText settings;
    ReadOptions options;
    PredictOptions supply;
  };
  /// A program as it was last read, for the next run to take over.
  struct Read {
    std::shared_ptr<const Document> document;
    Dialect dialect = Dialect::automatic;
    std::shared_ptr<const Reading> reading;
    std::shared_ptr<const toolpace::ProgramText> text;
  };
  static Result<Read> read(const Request& request, const Read& before, const Monitor& monitor);
  void start(const Request& request, quint64 generation);

  Background worker_;
  std::optional<Request> pending_;
  Read last_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
