/// What comes of a program that is written anew: figures, both paths, and where the gain is.

#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <cmath>

#include "panels/figure_table.h"
#include "preview/contour_canvas.h"
#include "rewrite_dialog.h"

namespace toolpace::studio {
namespace {

constexpr double kSeenShare = 0.01;  // of the picture, that the deviation is to fill

QTableWidgetItem* figure(const QString& text, double value) { return new ui::NumberItem(text, value); }

QString per_cent(double before, double after) {
  if (!(before > 0)) return {};
  const double change = (after / before - 1) * 100;
  if (std::abs(change) < 0.05) return "0 %";
  return QString("%1%2 %").arg(change < 0 ? "−" : "+").arg(std::abs(change), 0, 'f', 1);
}

/// Without a sign where it rounds to nothing.
QString seconds_text(double seconds) {
  const QString text = QString::number(std::abs(seconds), 'f', 3);
  return seconds < 0 && text.toDouble() > 0 ? "−" + text : text;
}

QString size_of(double bytes) {
  if (bytes < 1e3) return ui::number_text(bytes) + " B";
  return bytes < 1e6 ? ui::number_text(bytes / 1e3, 4) + " kB" : ui::number_text(bytes / 1e6, 4) + " MB";
}

}  // namespace

void RewriteDialog::showFound() {
  summary_->setRowCount(0);
  showRanges();
  showNotes();
  if (!found_) return;
  fillSummary();
  showPaths();
}

void RewriteDialog::fillSummary() {
  const ui::RewriteFound& f = *found_;
  const auto add = [this](const QString& title, const QString& before, const QString& after, const QString& change) {
    const int row = summary_->rowCount();
    summary_->insertRow(row);
    summary_->setItem(row, 0, new QTableWidgetItem(title));
    int column = 1;
    for (const QString& text : {before, after, change}) summary_->setItem(row, column++, figure(text, 0));
  };
  const auto count = [](std::size_t n) { return ui::number_text(static_cast<double>(n), 12); };
  const auto bytes = static_cast<double>(f.rewritten.text.size()), bytes_before = static_cast<double>(f.bytes_before);
  const double before = *f.rewritten.time_before, after = *f.rewritten.time_after;
  const ui::DisplayUnit unit = ui::error_unit(start_.units);
  add(tr("Blocks"), count(f.blocks_before), count(f.blocks_after),
      per_cent(static_cast<double>(f.blocks_before), static_cast<double>(f.blocks_after)));
  add(tr("Size"), size_of(bytes_before), size_of(bytes), per_cent(bytes_before, bytes));
  add(tr("Time"), ui::duration_text(before), ui::duration_text(after), per_cent(before, after));
  add(tr("Deviation") + "  " + unit.text, {}, ui::number_text(f.rewritten.max_deviation * unit.factor, 4),
      tr("of %1").arg(ui::number_text(f.tolerance * unit.factor, 4)));
}

/// The deviation is enlarged until it is seen.
void RewriteDialog::showPaths() {
  const ui::RewriteFound& f = *found_;
  canvas_->setScene(f.scene);
  canvas_->setView(ui::opening_view(*f.scene, ui::View::xy));
  canvas_->fit();
  const ui::Box& box = f.scene->geometry->box;
  const double extent = f.scene->is_empty() ? 0 : (box.high - box.low).norm();
  int index = 0;
  while (index + 1 < enlargement_->count() && f.rewritten.max_deviation > 0 &&
         f.rewritten.max_deviation * enlargement_->itemData(index).toDouble() < kSeenShare * extent) {
    ++index;
  }
  enlargement_->setCurrentIndex(index);
  setEnlargement(index);
}

void RewriteDialog::showRanges() {
  ranges_->setSortingEnabled(false);
  ranges_->setRowCount(0);
  if (found_) {
    for (const ui::RewrittenRange& range : found_->ranges) {
      const int row = ranges_->rowCount();
      ranges_->insertRow(row);
      auto* lines = figure(QString("%1–%2").arg(range.first_line).arg(range.last_line), range.first_line);
      lines->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
      ranges_->setItem(row, 0, lines);
      ranges_->setItem(row, 1,
                       figure(QString("%1 → %2").arg(range.blocks_before).arg(range.blocks_after),
                              static_cast<double>(range.blocks_before) - static_cast<double>(range.blocks_after)));
      ranges_->setItem(row, 2,
                       figure(QString("%1 → %2").arg(range.time_before, 0, 'f', 3).arg(range.time_after, 0, 'f', 3),
                              range.time_before));
      ranges_->setItem(row, 3, figure(seconds_text(range.saved()), range.saved()));
    }
  }
  ranges_->setSortingEnabled(true);
  ranges_->sortByColumn(3, Qt::DescendingOrder);
}

void RewriteDialog::showNotes() {
  QStringList notes;
  if (found_) {
    const Rewritten& r = found_->rewritten;
    if (r.replaced == 0)
      notes << tr("Nothing gains by being written otherwise: the file would be the program as it is.");
    if (r.slower > 0) notes << tr("%1 blocks stay as they are: otherwise they would take longer.").arg(r.slower);
    if (r.unproven > 0) notes << tr("%1 stretches stay as they are: their proof did not hold.").arg(r.unproven);
    if (!found_->scene->trace) notes << tr("The deviation is not drawn.");
  }
  notes_->setText(notes.join('\n'));
  notes_->setVisible(!notes.isEmpty());
}

}  // namespace toolpace::studio
