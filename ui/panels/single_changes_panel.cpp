#include "panels/single_changes_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <cmath>

#include "models/problem_model.h"
#include "models/setting_differences.h"
#include "panels/figure_table.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr int kLeastFigureWidth = 84;  // px
constexpr double kShownTime = 5e-4;    // [s]; less is nothing to a person
constexpr double kShownError = 5e-6;   // [mm], nor is this
enum ChangeColumn { kChangeTitle, kChangeSaved, kChangeAdded, kChangeColumns };

bool matters(const SingleChange& change) {
  return std::abs(change.saved) >= kShownTime || std::abs(change.contour_added) >= kShownError;
}

QString signed_figure(double value, int decimals) {
  const QString text = QString::number(std::abs(value), 'f', decimals);
  return text.toDouble() == 0 ? text : (value < 0 ? "−" : "+") + text;
}

}  // namespace

SingleChangesPanel::SingleChangesPanel(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      hint_(new QLabel(this)),
      button_(new QPushButton(this)),
      table_(figure_table("changesTable", kChangeColumns, this)) {
  setObjectName("singleChangesPanel");
  table_->horizontalHeader()->setMinimumSectionSize(kLeastFigureWidth);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* row = new QHBoxLayout;
  title_->setProperty("role", "heading");
  row->addWidget(title_, 1);
  button_->setObjectName("changesButton");
  row->addWidget(button_);
  column->addLayout(row);
  column->addWidget(table_, 1);
  hint_->setObjectName("changesHint");
  hint_->setProperty("role", "secondary");
  hint_->setWordWrap(true);
  column->addWidget(hint_);
  connect(button_, &QPushButton::clicked, this, [this] { isComputing() ? service_.cancel() : compute(); });
  connect(table_, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) { take(item->row()); });
  connect(&service_, &TuneService::changesTried, this, &SingleChangesPanel::show);
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { hint_->setText(tr("planning… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { trouble_ = message_text(error.code, error.message); });
  connect(&service_, &TuneService::finished, this, [this] {
    showState();
    emit computed();
  });
  retranslate();
}

void SingleChangesPanel::setJob(std::shared_ptr<const Job> job) {
  job_ = std::move(job);
  const auto is_other = [this](const auto& other) { return other && !(job_ && has_same_settings(*other, *job_)); };
  if (isComputing() && is_other(trying_)) service_.cancel();
  const bool another = is_other(tried_);
  if (another != stale_) {
    stale_ = another;
    fill();
  }
  showState();
}

void SingleChangesPanel::compute() {
  if (!job_) return;
  trouble_.clear();
  trying_ = job_;
  service_.trySingleChanges(job_);
  showState();
}

void SingleChangesPanel::show(const SingleChanges& found) {
  found_ = found;
  tried_ = trying_;
  stale_ = false;
  fill();
}

void SingleChangesPanel::fill() {
  rows_.clear();
  for (std::size_t i = 0; i < found_.changes.size(); ++i) {
    if (matters(found_.changes[i])) rows_.push_back(i);
  }
  table_->setRowCount(static_cast<int>(rows_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) fillRow(row, found_.changes[rows_[static_cast<std::size_t>(row)]]);
  showState();
}

void SingleChangesPanel::fillRow(int row, const SingleChange& change) {
  QStringList words, shorter;
  for (const SettingDifference& d : setting_differences(*tried_, *change.job, units_)) {
    words << QString("%1: %2 → %3").arg(d.title, d.a, d.b);
    shorter << d.title + ": " + d.b;  // what it is now stands in the tip
  }
  const DisplayUnit unit = error_unit(units_);
  const auto colour = [this](double good) {
    return stale_ || good == 0 ? theme_.secondary : good > 0 ? theme_.good : theme_.error;
  };
  const auto shown = [](double value, double least) { return std::abs(value) < least ? 0.0 : value; };
  const double saved = shown(change.saved, kShownTime), added = shown(change.contour_added, kShownError);
  auto* title = new QTableWidgetItem(shorter.join("; "));
  title->setToolTip(words.join('\n'));
  title->setForeground(stale_ ? theme_.secondary : theme_.text);
  auto* seconds = new NumberItem(signed_figure(saved, 3), change.saved);
  seconds->setForeground(colour(saved));
  auto* error = new NumberItem(signed_figure(added * unit.factor, 2), change.contour_added);
  error->setForeground(colour(-added));
  table_->setItem(row, kChangeTitle, title);
  table_->setItem(row, kChangeSaved, seconds);
  table_->setItem(row, kChangeAdded, error);
}

void SingleChangesPanel::showState() {
  button_->setText(isComputing() ? tr("Cancel") : tr("Try each"));
  name_control(button_, button_->text(),
               tr("Plan again with each limit 10 % up and down and with every other choice, each alone"));
  button_->setEnabled(job_ != nullptr);
  if (isComputing()) return;
  const std::size_t idle = found_.changes.size() - rows_.size();
  if (!trouble_.isEmpty()) return hint_->setText(trouble_);
  if (found_.changes.empty()) return hint_->setText(tr("Each setting alone: what it saves, what error it adds"));
  if (stale_) return hint_->setText(tr("Of other settings: try again"));
  const QString others = idle > 0 ? " " + tr("%1 others make no difference.").arg(idle) : QString();
  hint_->setText(tr("Double click or Enter takes a change.") + others);
}

void SingleChangesPanel::take(int row) {
  if (!stale_ && !isComputing()) emit chosen(found_.changes[rows_[static_cast<std::size_t>(row)]].job);
}

void SingleChangesPanel::setUnits(Units units) {
  units_ = units;
  retranslate();
}

void SingleChangesPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  fill();
}

void SingleChangesPanel::retranslate() {
  title_->setText(tr("What helps most"));
  set_heads(table_, {tr("One change"), tr("Saves") + "  s", tr("Error") + "  " + error_unit(units_).text});
  name_control(table_, tr("What each change alone saves, and the contour error that it adds"),
               tr("Double click or Enter takes a change"));
  fill();
}

}  // namespace toolpace::ui
