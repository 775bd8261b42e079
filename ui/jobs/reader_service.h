#pragma once
/// Reads programs in a worker.

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "jobs/background.h"
#include "models/document.h"
#include "toolpace/base/result.h"

namespace toolpace::ui {

/// The latest request wins: an older one that still runs is cancelled and dropped.
class ReaderService : public QObject {
  Q_OBJECT

 public:
  explicit ReaderService(QObject* parent = nullptr);

  void readFile(const QString& path);
  /// @param name  its extension chooses the format
  /// @param path  file that the text stands for, may be empty
  void readText(const QByteArray& text, const QString& name, const QString& path = {});
  /// Reads a document again with another text in one of its lines, which must be there.
  void readEdited(std::shared_ptr<const Document> document, int line, const QString& text);
  void cancel();
  bool isBusy() const { return worker_.isBusy(); }

 signals:
  void read(std::shared_ptr<const toolpace::ui::Document> document);
  void failed(const toolpace::Error& error, const QString& path);
  void progressed(double fraction);
  void busyChanged(bool busy);

 private:
  using Request = std::function<Background::Delivery(const Monitor&)>;
  void submit(Request request);
  Background::Delivery deliver(Result<std::shared_ptr<const Document>> result, const QString& path, quint64 number);

  Background worker_;
  Request pending_;
  quint64 latest_ = 0;
};

}  // namespace toolpace::ui
