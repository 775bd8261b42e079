#include "panels/controller_section.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "models/controller_names.h"
#include "panels/form_grid.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr int kSettingUnitWidth = 42;
enum SettingPart { kLabel, kField, kUnit };

/// What a section's settings are called: "[printer] max_accel" stands below "[printer]" as "max_accel".
QString word_of(const std::string& key) {
  const auto end = key.find("] ");
  return QString::fromStdString(end == std::string::npos ? key : key.substr(end + 2));
}

std::string section_of(const std::string& key) { return key.starts_with('[') ? key.substr(0, key.find(']') + 1) : ""; }

/// So that a long name goes on in a second line.
QString breakable(QString name) { return name.replace("_", QString("_") + QChar(0x200B)); }

bool is_given(const ControllerSettings& settings, const std::string& key) {
  return std::find(settings.used.begin(), settings.used.end(), key) != settings.used.end();
}

/// Those that there is something to say of, in the order of their sections. An axis without any limit is none of the machine's.
std::vector<ControllerParameter> shown_parameters(ControllerSettings& settings) {
  std::vector<ControllerParameter> list = parameters(settings);
  std::erase_if(list, [&](const ControllerParameter& p) {
    return p.key.starts_with("[AXIS_") && std::isinf(*p.value) && !is_given(settings, p.key);
  });
  std::vector<std::string> sections;
  for (const auto& p : list) {
    if (std::find(sections.begin(), sections.end(), section_of(p.key)) == sections.end())
      sections.push_back(section_of(p.key));
  }
  const auto rank = [&](const ControllerParameter& p) {
    return std::find(sections.begin(), sections.end(), section_of(p.key)) - sections.begin();
  };
  std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return list;
}

}  // namespace

ControllerSection::ControllerSection(ControllerModel& model, QWidget* parent)
    : QWidget(parent), model_(model), title_(new QLabel(this)), save_(new QToolButton(this)) {
  setObjectName("controllerSection");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 4);
  column->setSpacing(3);
  auto* head = new QHBoxLayout;
  head->setSpacing(4);
  title_->setObjectName("controllerTitle");
  title_->setProperty("role", "heading");
  title_->setWordWrap(true);
  save_->setObjectName("saveSettingsButton");
  head->addWidget(title_, 1);
  head->addWidget(save_);
  column->addLayout(head);
  connect(save_, &QToolButton::clicked, this, &ControllerSection::saveRequested);
  connect(&model_, &ControllerModel::changed, this, &ControllerSection::showSettings);
  retranslate();
}

void ControllerSection::setModified(bool modified) {
  modified_ = modified;
  save_->setEnabled(modified);
  retranslate();
}

void ControllerSection::showSettings() {
  const SharedControllerText& text = model_.text();
  setVisible(text != nullptr);
  if (!text) return;
  ControllerSettings settings = text->settings;
  const auto shown = shown_parameters(settings);
  const bool same = std::equal(shown.begin(), shown.end(), rows_.begin(), rows_.end(),
                               [](const ControllerParameter& p, const Row& row) { return p.key == row.key; });
  if (!same) rebuild(shown);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ControllerParameter& p = shown[i];
    Row& row = rows_[i];
    row.field->setValue(*p.value / p.size);
    const bool given = is_given(settings, p.key);
    row.label->setToolTip(setting_title(p.title) +
                          (given ? QString() : "\n" + tr("Not in the file: what the controller takes without it")));
  }
  retranslate();
  if (!same) emit resized();
}

void ControllerSection::rebuild(const std::vector<ControllerParameter>& shown) {
  rows_.clear();
  if (body_) {
    body_->setParent(nullptr);  // one of its fields may be the one that asks
    body_->deleteLater();
  }
  body_ = new QWidget(this);
  grid_ = new QGridLayout(body_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(4);
  grid_->setVerticalSpacing(3);
  grid_->setColumnStretch(kLabel, 1);
  grid_->setColumnMinimumWidth(kUnit, kSettingUnitWidth);
  std::string section;
  for (const ControllerParameter& p : shown) {
    if (section_of(p.key) != section) addHeading(QString::fromStdString(section = section_of(p.key)));
    addRow(p);
  }
  layout()->addWidget(body_);
  body_->show();
}

void ControllerSection::addHeading(const QString& text) {
  grid_->addWidget(secondary_label(text, body_), grid_->rowCount(), kLabel, 1, 3);
}

void ControllerSection::addRow(const ControllerParameter& p) {
  const QString unit = setting_unit(p.unit);
  const bool is_switch = *p.unit == '\0';
  auto* label = new QLabel(body_);
  label->setWordWrap(true);
  auto* field = new NumberField("setting " + QString::fromStdString(p.key), {}, Quantity::length,
                                {p.least, p.most, false, is_switch}, body_);
  field->setUnit({1.0, unit});
  label->setBuddy(field);
  const int row = grid_->rowCount();
  rows_.push_back({p.key, label, secondary_label(unit, body_), field});
  grid_->addWidget(label, row, kLabel);
  grid_->addWidget(field, row, kField);
  grid_->addWidget(rows_.back().unit, row, kUnit);
  connect(field, &NumberField::gestureStarted, &model_, &ControllerModel::beginGesture);
  connect(field, &NumberField::gestureFinished, &model_, &ControllerModel::endGesture);
  connect(field, &NumberField::edited, this, [this, key = p.key](double value) { edit(key, value); });
}

void ControllerSection::edit(const std::string& key, double value) {
  const auto done = model_.edit(tr("Setting %1").arg(QString::fromStdString(key)), key, value);
  if (done) return;
  showSettings();  // as it was
  emit refused(done.error());
}

void ControllerSection::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) showSettings(), retranslate();
  QWidget::changeEvent(event);
}

void ControllerSection::retranslate() {
  const SharedControllerText& text = model_.text();
  save_->setText(tr("Save"));
  name_control(save_, tr("Save the settings"), tr("Write what was changed into the controller's settings file"));
  if (!text) return;
  const auto controller = controller_title(text->settings.controller);
  title_->setText(QString::fromUtf8(controller.data(), static_cast<qsizetype>(controller.size())) + " · " +
                  QFileInfo(text->path).fileName() + (modified_ ? "*" : ""));
  title_->setToolTip(text->path);
  ControllerSettings settings = text->settings;
  const auto list = shown_parameters(settings);
  for (std::size_t i = 0; i < rows_.size() && i < list.size(); ++i) {
    const QString name = setting_name(list[i].key, list[i].title);
    const bool in_section = list[i].key.starts_with('[');
    rows_[i].label->setText(in_section ? breakable(word_of(list[i].key)) : name);
    rows_[i].field->setAccessibleName(in_section ? name + "  " + setting_title(list[i].title) : name);
    rows_[i].unit->setText(setting_unit(list[i].unit));
  }
}

}  // namespace toolpace::ui
