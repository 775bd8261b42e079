#include "panels/tune_settings_panel.h"

#include <QVBoxLayout>
#include <algorithm>

#include "models/controller_names.h"
#include "models/problem_model.h"
#include "panels/figure_table.h"
#include "panels/form_grid.h"
#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "theme/role.h"

namespace toolpace::ui {
namespace {

enum BestColumn { kName, kNow, kBest, kBestColumns };
constexpr int kDigits = 6;

QTableWidgetItem* figure(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

QString seconds(double time) { return QString::number(time, 'f', 3) + QStringLiteral(" s"); }

}  // namespace

TuneSettingsPanel::TuneSettingsPanel(ControllerModel& model, const TuningModel& machine, QWidget* parent)
    : QWidget(parent),
      model_(model),
      machine_(machine),
      button_(new QPushButton(this)),
      take_(new QPushButton(this)),
      within_(new QCheckBox(this)),
      verdict_(new QLabel(this)),
      table_(figure_table("tuneControllerSettings", kBestColumns, this)) {
  setObjectName("tuneSettingsPanel");
  button_->setObjectName("tuneSettingsButton");
  take_->setObjectName("tuneSettingsTake");
  within_->setObjectName("tuneSettingsWithin");
  within_->setChecked(true);
  verdict_->setObjectName("tuneSettingsVerdict");
  verdict_->setWordWrap(true);
  build();
  connectParts();
  retranslate();
}

void TuneSettingsPanel::build() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* head = new QWidget(this);
  auto* row = new FlowLayout(head);
  row->setSpacing(8);
  for (QWidget* part : {static_cast<QWidget*>(within_), static_cast<QWidget*>(button_), static_cast<QWidget*>(take_)})
    row->addWidget(part);
  row->addWidget(verdict_);
  column->addWidget(head);
  column->addWidget(table_, 1);
}

void TuneSettingsPanel::connectParts() {
  connect(button_, &QPushButton::clicked, this, [this] {
    if (!isSearching()) return search();
    service_.cancel();
    showState();
  });
  connect(take_, &QPushButton::clicked, this, &TuneSettingsPanel::take);
  connect(&service_, &TuneService::settingsTuned, this, [this](const TunedSettings& tuned) {
    tuned_ = tuned;
    taken_ = nullptr;
    fill();
  });
  connect(&service_, &TuneService::progressed, this,
          [this](double fraction) { verdict_->setText(tr("searching… %1 %").arg(static_cast<int>(fraction * 100))); });
  connect(&service_, &TuneService::failed, this,
          [this](const Error& error) { trouble_ = message_text(error.code, error.message); });
  connect(&service_, &TuneService::finished, this, [this] {
    showState();
    emit searched();
  });
}

void TuneSettingsPanel::showController(const ControllerView& view) {
  run_ = view.is_stale ? nullptr : view.found;
  fill();
  showState();
}

void TuneSettingsPanel::search() {
  if (!run_ || isSearching()) return;
  SettingsSearch search;
  search.turned = ticked();
  if (within_->isChecked()) search.allowed = Setup{machine_.value().machine, machine_.value().options};
  trouble_.clear();
  asked_ = run_;
  service_.searchSettings(run_, search);
  showState();
}

bool TuneSettingsPanel::isStale() const {
  const SharedControllerText& now = model_.text();
  return tuned_ && (!asked_ || (now != asked_->asked && now != taken_));
}

/// All changes at once.
void TuneSettingsPanel::take() {
  SharedControllerText text = model_.text();
  if (!tuned_ || !text || isStale()) return;
  for (const SettingChange& change : tuned_->changes) {
    auto next = with_setting(*text, change.setting, change.to);
    if (!next) {
      trouble_ = message_text(next.error().code, next.error().message);
      return showState();
    }
    text = std::move(*next);
  }
  taken_ = text;
  model_.replace(tr("Best settings"), text);
}

/// Those that are ticked; a list that is new has all of them ticked.
std::vector<std::string> TuneSettingsPanel::ticked() const {
  std::vector<std::string> keys;
  for (int row = 0; row < table_->rowCount(); ++row) {
    if (table_->item(row, kName)->checkState() == Qt::Checked)
      keys.push_back(table_->item(row, kName)->data(Qt::UserRole).toString().toStdString());
  }
  return keys;
}

void TuneSettingsPanel::fill() {
  const SharedControllerText& text = model_.text();
  if (!text) return table_->setRowCount(0);
  const std::vector<std::string> keys = tunable_settings(text->settings), before = ticked();
  const bool had_rows = table_->rowCount() > 0;
  ControllerSettings settings = text->settings;
  const auto list = parameters(settings);
  set_heads(table_, {tr("Setting"), tr("Now"), tr("Best")});
  table_->setRowCount(static_cast<int>(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto p =
        std::find_if(list.begin(), list.end(), [&](const ControllerParameter& q) { return q.key == keys[i]; });
    const bool was_ticked = std::find(before.begin(), before.end(), keys[i]) != before.end();
    const int row = static_cast<int>(i);
    auto* name = new QTableWidgetItem(setting_name(p->key, p->title));
    name->setData(Qt::UserRole, QString::fromStdString(p->key));
    name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    name->setCheckState(!had_rows || was_ticked ? Qt::Checked : Qt::Unchecked);
    const QString unit = *p->unit == '1' ? QString() : " " + setting_unit(p->unit);
    const auto value = [&](double number) { return QString::number(number, 'g', kDigits) + unit; };
    table_->setItem(row, kName, name);
    table_->setItem(row, kNow, figure(value(*p->value / p->size)));
    table_->setItem(row, kBest, figure({}));
    if (!tuned_ || isStale()) continue;
    for (const SettingChange& change : tuned_->changes) {
      if (change.setting == p->key) table_->item(row, kBest)->setText(value(change.to));
    }
  }
}

QString TuneSettingsPanel::verdict() const {
  if (!trouble_.isEmpty()) return trouble_;
  if (!tuned_) return tr("The settings by which this program is fastest on its controller, by that one's own model");
  if (isStale()) return tr("Of another program or other settings: search again");
  const QString times = tr("%1 now, %2 at best").arg(seconds(tuned_->before), seconds(tuned_->after));
  return tuned_->changes.empty() ? tr("nothing that may change helps") : times;
}

void TuneSettingsPanel::showState() {
  button_->setText(isSearching() ? tr("Cancel") : tr("Search"));
  name_control(button_, button_->text(),
               isSearching() ? tr("Leave it") : tr("Try other values of the settings that are ticked"));
  button_->setEnabled(run_ != nullptr || isSearching());
  take_->setEnabled(!isSearching() && tuned_ && !tuned_->changes.empty() && asked_ && model_.text() == asked_->asked);
  if (isSearching()) return;
  set_role(verdict_, (tuned_ && isStale()) || !trouble_.isEmpty() ? "warning" : "secondary");
  verdict_->setText(verdict());
}

void TuneSettingsPanel::retranslate() {
  within_->setText(tr("Up to the machine's limits"));
  name_control(within_, within_->text(),
               tr("No setting goes beyond what the machine of the page Limits can do; else beyond what it has now"));
  take_->setText(tr("Take"));
  name_control(take_, tr("Take the best settings"), tr("All changes at once; undo gives the settings back"));
  name_control(table_, tr("Settings of the controller"), tr("Those that are ticked may change"));
  fill();
  showState();
}

}  // namespace toolpace::ui
