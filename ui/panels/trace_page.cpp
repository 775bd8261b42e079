#include "panels/trace_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>
#include <numbers>

#include "panels/figure_table.h"
#include "theme/control_name.h"
#include "theme/role.h"

namespace toolpace::ui {
namespace {

constexpr std::size_t kMostTracedLines = 2000;  // in the table, the worst ones
constexpr int kTraceColumnWidth = 96;           // px, at least
enum TraceAxisColumn { kTraceAxisName, kAxisLag, kAxisMost, kAxisRms, kAxisLine, kTraceAxisColumns };
enum TraceLineColumn { kTracedLine, kTracedContour, kTracedContourRms, kTracedMost, kTracedRms, kTracedColumns };

}  // namespace

TracePage::TracePage(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel(this)),
      open_(new QPushButton(this)),
      columns_(new QPushButton(this)),
      close_(new QPushButton(this)),
      axes_(figure_table("traceAxes", kTraceAxisColumns, this)),
      lines_(figure_table("traceLines", kTracedColumns, this)) {
  setObjectName("tracePage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  verdict_->setObjectName("traceVerdict");
  verdict_->setWordWrap(true);
  open_->setObjectName("traceOpen");
  columns_->setObjectName("traceColumns");
  close_->setObjectName("traceClose");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  column->addWidget(verdict_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (auto* button : {open_, columns_, close_}) row->addWidget(button);
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(axes_);
  column->addWidget(lines_, 1);
  for (auto* table : {axes_, lines_}) table->horizontalHeader()->setMinimumSectionSize(kTraceColumnWidth);
  lines_->setSortingEnabled(true);
  connect(open_, &QPushButton::clicked, this, &TracePage::openRequested);
  connect(columns_, &QPushButton::clicked, this, &TracePage::columnsRequested);
  connect(close_, &QPushButton::clicked, this, &TracePage::closeRequested);
  const auto go = [this](QTableWidgetItem* item) {
    const auto* table = item->tableWidget();
    int place = kTracedLine;
    if (table == axes_) place = kAxisLine;
    const int line = table->item(item->row(), place)->data(Qt::UserRole).toInt();
    if (line > 0) emit lineRequested(line);
  };
  for (auto* table : {axes_, lines_}) {
    connect(table, &QTableWidget::itemClicked, this, go);
    connect(table, &QTableWidget::itemActivated, this, go);
  }
  retranslate();
}

void TracePage::showTrace(const std::shared_ptr<const MeasuredTrace>& trace) {
  trace_ = trace;
  trouble_.clear();
  fillAxes();
  fillLines();
  showVerdict();
}

void TracePage::setBusy(bool busy) {
  busy_ = busy;
  showVerdict();
}

void TracePage::showFailure(const QString& why) {
  showTrace(nullptr);
  trouble_ = why;
  showVerdict();
}

QString TracePage::errorText(double mm) const { return number_text(mm * error_unit(units_).factor, 4); }

void TracePage::showVerdict() {
  columns_->setEnabled(trace_ || !trouble_.isEmpty());
  close_->setEnabled(trace_ || busy_ || !trouble_.isEmpty());
  const bool doubtful = !trouble_.isEmpty() || (trace_ && trace_->comparison.alignment.is_ambiguous);
  set_role(verdict_, doubtful ? "warning" : "secondary");
  if (busy_) return verdict_->setText(tr("comparing…"));
  if (!trouble_.isEmpty()) return verdict_->setText(trouble_);
  if (!trace_) return verdict_->setText(tr("Open what a scope recorded while the program ran"));
  const Comparison& c = trace_->comparison;
  QString text =
      tr("%1: %2 rows, the program starts at %3 s of the trace, correlation %4")
          .arg(trace_->name, number_text(static_cast<double>(c.rows), 12),
               QString::number(c.alignment.clock_offset(), 'f', 4), QString::number(c.alignment.correlation, 'f', 4));
  if (c.alignment.drift != 0) text += " · " + tr("clocks drift by %1 ppm").arg(c.alignment.drift * 1e6, 0, 'f', 1);
  text += "\n" + tr("Contour error %1 %3 at most, %2 %3 RMS")
                     .arg(errorText(c.max_contour), errorText(c.rms_contour), error_unit(units_).text);
  if (!c.alignment.by_commanded) text += " · " + tr("a lag that all axes share does not show");
  if (c.alignment.is_ambiguous) text += "\n" + tr("It fits at another place of the program nearly as well");
  for (const std::string& axis : c.unmeasured)
    text += "\n" + tr("Axis %1 moves, and is not in the trace").arg(QString::fromStdString(axis));
  verdict_->setText(text);
}

void TracePage::fillAxes() {
  axes_->setRowCount(0);
  for (std::size_t axis = 0; trace_ && axis < kAxisCount; ++axis) {
    const AxisComparison& a = trace_->comparison.axis[axis];
    if (!a.is_measured) continue;
    const double size = is_rotary(axis) ? 180 / std::numbers::pi : 1;  // a degree counts as 1 mm
    const int row = axes_->rowCount();
    axes_->insertRow(row);
    axes_->setItem(row, kTraceAxisName, new QTableWidgetItem(QString(QLatin1Char(kAxisNames[axis]))));
    axes_->setItem(row, kAxisLag,
                   new NumberItem(QString::number(a.lag * 1e3, 'f', 3).replace('-', QChar(0x2212)), a.lag));
    axes_->setItem(row, kAxisMost, new NumberItem(errorText(a.max_error * size), a.max_error));
    axes_->setItem(row, kAxisRms, new NumberItem(errorText(a.rms_error * size), a.rms_error));
    auto* line = new NumberItem(QString::number(a.worst_line), a.worst_line);
    line->setData(Qt::UserRole, a.worst_line);
    axes_->setItem(row, kAxisLine, line);
  }
  // As high as its rows, so that the lines below have the rest.
  const int rows = axes_->verticalHeader()->defaultSectionSize() * std::max(axes_->rowCount(), 1);
  axes_->setFixedHeight(axes_->horizontalHeader()->sizeHint().height() + rows + 4);
}

void TracePage::fillLines() {
  lines_->setSortingEnabled(false);
  lines_->setRowCount(0);
  std::vector<LineComparison> worst;
  if (trace_) worst = trace_->comparison.lines;
  std::stable_sort(worst.begin(), worst.end(),
                   [](const LineComparison& a, const LineComparison& b) { return a.max_contour > b.max_contour; });
  worst.resize(std::min(worst.size(), kMostTracedLines));
  lines_->setRowCount(static_cast<int>(worst.size()));
  for (int row = 0; row < lines_->rowCount(); ++row) {
    const LineComparison& l = worst[static_cast<std::size_t>(row)];
    auto* line = new NumberItem(QString::number(l.line), l.line);
    line->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    line->setData(Qt::UserRole, l.line);
    lines_->setItem(row, kTracedLine, line);
    lines_->setItem(row, kTracedContour, new NumberItem(errorText(l.max_contour), l.max_contour));
    lines_->setItem(row, kTracedContourRms, new NumberItem(errorText(l.rms_contour), l.rms_contour));
    lines_->setItem(row, kTracedMost, new NumberItem(errorText(l.max_following), l.max_following));
    lines_->setItem(row, kTracedRms, new NumberItem(errorText(l.rms_following), l.rms_following));
  }
  lines_->setSortingEnabled(true);
  lines_->sortByColumn(kTracedContour, Qt::DescendingOrder);
}

void TracePage::setUnits(Units units) {
  units_ = units;
  retranslate();
}

void TracePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void TracePage::retranslate() {
  const QString unit = "  " + error_unit(units_).text;
  set_heads(axes_, {tr("Axis"), tr("Lag") + "  ms", tr("Following") + unit, tr("RMS") + unit, tr("Worst line")});
  set_heads(lines_, {tr("Line"), tr("Contour") + unit, tr("RMS") + unit, tr("Following") + unit, tr("RMS") + unit});
  name_control(axes_, tr("Lag and following error of each axis"), tr("Click on a row to go to its worst line"));
  name_control(lines_, tr("Contour and following error of each NC line"), tr("Click on a row to go there"));
  open_->setText(tr("Open trace…"));
  name_control(open_, tr("Open a trace"), tr("Open what a scope recorded while the program ran"));
  columns_->setText(tr("Columns…"));
  name_control(columns_, tr("Columns of the trace"), tr("Say anew what the columns mean"));
  close_->setText(tr("Close"));
  name_control(close_, tr("Close the trace"));
  fillAxes();
  fillLines();
  showVerdict();
}

}  // namespace toolpace::ui
