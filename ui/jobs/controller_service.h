#pragma once
/// Runs a program as a real controller would, in a worker.

#include <QObject>
#include <memory>
#include <optional>

#include "drawing/planned.h"
#include "jobs/background.h"
#include "models/document.h"
#include "toolpace/nc/read_options.h"

namespace toolpace::ui {

/// The latest request wins: an older one that still runs is cancelled and dropped.
class ControllerService : public QObject {
  Q_OBJECT

 public:
  explicit ControllerService(QObject* parent = nullptr);

  /// @param settings  file of the controller, as it writes it itself; whose it is, is told by what stands in it
  /// @param options   how the program is read, but for its dialect, which is the controller's
  void run(std::shared_ptr<const Document> document, const QString& settings, const ReadOptions& options);
  void cancel();
  bool isBusy() const { return worker_.isBusy(); }

 signals:
  /// @param warnings  what of the settings was not given or not used
  void driven(const toolpace::ui::Planned& motion, const toolpace::Diagnostics& warnings);
  void failed(const toolpace::Error& error, const QString& settings);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  struct Request {
    std::shared_ptr<const Document> document;
    QString settings;
    ReadOptions options;
  };
  void start(const Request& request);

  Background worker_;
  std::optional<Request> pending_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
