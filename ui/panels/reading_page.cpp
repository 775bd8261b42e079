#include "panels/reading_page.h"

#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QSignalBlocker>
#include <cmath>
#include <limits>

#include "panels/form_grid.h"
#include "theme/control_name.h"

namespace toolpace::ui {
namespace {

constexpr double kLeastArcTolerance = 1e-6, kWidestArcTolerance = 1000;  // mm
constexpr int kFoldersHeight = 72;

}  // namespace

ReadingPage::ReadingPage(QWidget* parent) : QWidget(parent) {
  setObjectName("readingPage");
  setProperty("role", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 8);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(8);
  grid->setColumnStretch(1, 1);
  const auto label = [this, grid](int row, QWidget* of) {
    auto* result = new QLabel(this);
    result->setBuddy(of);
    grid->addWidget(result, row, 0);
    return result;
  };
  dialect_ = new QComboBox(this);
  dialect_->setObjectName("readingDialect");
  for (const Dialect dialect : all_dialects()) dialect_->addItem({}, static_cast<int>(dialect));
  grid->addWidget(dialect_, 0, 1, 1, 2);
  dialect_label_ = label(0, dialect_);
  integers_ = new QComboBox(this);
  integers_->setObjectName("readingIntegers");
  for (int i = 0; i < 3; ++i) integers_->addItem({}, i);
  grid->addWidget(integers_, 1, 1, 1, 2);
  integers_label_ = label(1, integers_);
  arc_tolerance_ = new NumberField("readingArcTolerance", {}, Quantity::length,
                                   {kLeastArcTolerance, kWidestArcTolerance, true}, this);
  arc_tolerance_->setValue(std::numeric_limits<double>::infinity());
  grid->addWidget(arc_tolerance_, 2, 1);
  auto* unit = secondary_label(arc_tolerance_->unitText(), this);
  connect(arc_tolerance_, &NumberField::unitChanged, unit, [this, unit] { unit->setText(arc_tolerance_->unitText()); });
  grid->addWidget(unit, 2, 2);
  arc_label_ = label(2, arc_tolerance_);
  buildFiles(grid);
  buildFolders(grid);
  connect(dialect_, &QComboBox::activated, this, [this](int index) {
    options_.dialect = static_cast<Dialect>(dialect_->itemData(index).toInt());
    emit optionsChanged();
  });
  connect(integers_, &QComboBox::activated, this, [this](int index) {
    options_.integers = static_cast<IntegerWords>(integers_->itemData(index).toInt());
    emit optionsChanged();
  });
  connect(arc_tolerance_, &NumberField::edited, this, [this](double tolerance) {
    options_.arc_tolerance = std::isfinite(tolerance) ? std::optional(tolerance) : std::nullopt;
    emit optionsChanged();
  });
  retranslate();
}

void ReadingPage::buildFiles(QGridLayout* grid) {
  tools_ = makeFile(grid, 3, "readingTools", &options_.tools);
  parameters_ = makeFile(grid, 4, "readingParameters", &options_.parameters);
  connect(tools_.choose, &QToolButton::clicked, this, &ReadingPage::chooseTools);
  connect(parameters_.choose, &QToolButton::clicked, this, &ReadingPage::chooseParameters);
}

ReadingPage::FileField ReadingPage::makeFile(QGridLayout* grid, int row, const char* name,
                                             std::filesystem::path* target) {
  FileField field{new QLabel(this), new QLineEdit(this), new QToolButton(this), target};
  field.label->setBuddy(field.path);
  field.path->setObjectName(name);
  field.path->setClearButtonEnabled(true);
  field.choose->setObjectName(QString(name) + "Choose");
  field.choose->setText("…");
  grid->addWidget(field.label, row, 0);
  grid->addWidget(field.path, row, 1);
  grid->addWidget(field.choose, row, 2);
  connect(field.path, &QLineEdit::textChanged, this, [this, path = field.path, target](const QString& text) {
    if (!path->hasFocus() || text.isEmpty()) {  // chosen, or cleared; what is typed counts once it is whole
      *target = text.toStdString();
      emit optionsChanged();
    }
  });
  connect(field.path, &QLineEdit::editingFinished, this, [this, path = field.path, target] {
    if (*target == path->text().toStdString()) return;
    *target = path->text().toStdString();
    emit optionsChanged();
  });
  return field;
}

void ReadingPage::buildFolders(QGridLayout* grid) {
  folders_ = new QListWidget(this);
  folders_->setObjectName("readingFolders");
  folders_->setMinimumHeight(kFoldersHeight);
  folders_label_ = new QLabel(this);
  folders_label_->setBuddy(folders_);
  folders_label_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  grid->addWidget(folders_label_, 5, 0);
  grid->addWidget(folders_, 5, 1, 1, 2);
  add_folder_ = new QPushButton(this);
  add_folder_->setObjectName("readingAddFolder");
  remove_folder_ = new QPushButton(this);
  remove_folder_->setObjectName("readingRemoveFolder");
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_folder_);
  buttons->addWidget(remove_folder_);
  buttons->addStretch(1);
  grid->addLayout(buttons, 6, 1, 1, 2);
  block_delete_ = new QCheckBox(this);
  block_delete_->setObjectName("readingBlockDelete");
  strict_ = new QCheckBox(this);
  strict_->setObjectName("readingStrict");
  grid->addWidget(block_delete_, 7, 1, 1, 2);
  grid->addWidget(strict_, 8, 1, 1, 2);
  grid->setRowStretch(9, 1);
  connect(add_folder_, &QPushButton::clicked, this, &ReadingPage::chooseFolder);
  connect(remove_folder_, &QPushButton::clicked, this, [this] {
    delete folders_->currentItem();
    takeFolders();
  });
  connect(block_delete_, &QCheckBox::toggled, this, [this](bool on) {
    options_.block_delete = on;
    emit optionsChanged();
  });
  connect(strict_, &QCheckBox::toggled, this, [this](bool on) {
    options_.strict = on;
    emit optionsChanged();
  });
}

void ReadingPage::setOptions(const ReadOptions& options) {
  const QSignalBlocker quiet(this);
  dialect_->setCurrentIndex(dialect_->findData(static_cast<int>(options.dialect)));
  integers_->setCurrentIndex(integers_->findData(static_cast<int>(options.integers)));
  arc_tolerance_->setValue(options.arc_tolerance.value_or(std::numeric_limits<double>::infinity()));
  tools_.path->setText(QString::fromStdString(options.tools.string()));
  parameters_.path->setText(QString::fromStdString(options.parameters.string()));
  folders_->clear();
  for (const auto& folder : options.sub_paths) folders_->addItem(QString::fromStdString(folder.string()));
  block_delete_->setChecked(options.block_delete);
  strict_->setChecked(options.strict);
  options_ = options;
}

void ReadingPage::setUnits(Units unit) { arc_tolerance_->setUnits(unit); }

void ReadingPage::takeFolders() {
  options_.sub_paths.clear();
  for (int i = 0; i < folders_->count(); ++i) options_.sub_paths.push_back(folders_->item(i)->text().toStdString());
  emit optionsChanged();
}

void ReadingPage::setFile(FileField& field, const QString& path) {
  const QSignalBlocker quiet(field.path);
  field.path->setText(path);
  *field.target = path.toStdString();
  emit optionsChanged();
}

void ReadingPage::choose(FileField& field, const QString& title) {
  const QString path = QFileDialog::getOpenFileName(this, title, folder_);
  if (!path.isEmpty()) setFile(field, path);
}

void ReadingPage::chooseTools() { choose(tools_, tr("Choose the tool table")); }
void ReadingPage::chooseParameters() { choose(parameters_, tr("Choose the parameter file")); }

void ReadingPage::chooseFolder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Choose a folder with sub-programs"), folder_);
  if (path.isEmpty() || !folders_->findItems(path, Qt::MatchExactly).isEmpty()) return;
  folders_->addItem(path);
  takeFolders();
}

void ReadingPage::focusArcTolerance() {
  arc_tolerance_->setFocus(Qt::OtherFocusReason);
  arc_tolerance_->selectAll();
}

void ReadingPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ReadingPage::retranslate() {
  setAccessibleName(tr("Reading the program"));
  const auto name = [](QLabel* label, QWidget* field, const QString& title, const QString& tip) {
    label->setText(title);
    name_control(field, title, tip);
  };
  name(dialect_label_, dialect_, tr("Dialect"), tr("Whose way of writing programs this is"));
  for (int i = 0; i < dialect_->count(); ++i) {
    const auto dialect = static_cast<Dialect>(dialect_->itemData(i).toInt());
    const std::string_view id = dialect_name(dialect);
    dialect_->setItemText(i, dialect == Dialect::automatic
                                 ? tr("as the text suggests")
                                 : QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())));
  }
  name(integers_label_, integers_, tr("Without a point"), tr("What X100 means on controllers of Fanuc's kind"));
  const QStringList integers = {tr("as the text suggests"), tr("X100 is 100 mm"), tr("X100 is 0.1 mm")};
  for (int i = 0; i < integers.size(); ++i) integers_->setItemText(i, integers[i]);
  name(arc_label_, arc_tolerance_, tr("Arc tolerance"),
       tr("How far an arc may end off its radius; empty = as the dialect has it"));
  arc_tolerance_->setUnlimitedText(tr("dialect"));
  name(tools_.label, tools_.path, tr("Tool table"), tr("As LinuxCNC writes it; empty = none"));
  name(parameters_.label, parameters_.path, tr("Parameters"), tr("Numbered parameters, as LinuxCNC writes them"));
  for (auto* field : {&tools_, &parameters_}) {
    name_control(field->choose, tr("Choose: %1").arg(field->label->text()));
  }
  name(folders_label_, folders_, tr("Sub-programs"), tr("Folders that are searched besides the program's own"));
  add_folder_->setText(tr("Add a folder…"));
  remove_folder_->setText(tr("Remove"));
  add_folder_->setAccessibleName(add_folder_->text());
  remove_folder_->setAccessibleName(tr("Remove the folder"));
  block_delete_->setText(tr("Skip lines that begin with /"));
  strict_->setText(tr("Take every warning for an error"));
}

}  // namespace toolpace::ui
