#include "rewrite_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "models/problem_model.h"
#include "panels/figure_table.h"
#include "panels/form_grid.h"
#include "panels/number_field.h"
#include "panels/supply_fields.h"
#include "preview/contour_canvas.h"
#include "theme/control_name.h"
#include "theme/role.h"
#include "toolpace/machine/controller_settings.h"
#include "toolpace/nc/dialect.h"

namespace toolpace::studio {
namespace {

constexpr QSize kRewriteSize = {960, 640};
constexpr int kFormWidth = 330;
constexpr double kLeastTolerance = 1e-6, kMostTolerance = 100;  // [mm]
constexpr std::array kFactors = {1, 10, 100, 1000, 10'000};
const ui::DisplayUnit kPlain = {1.0, {}};

}  // namespace

RewriteDialog::RewriteDialog(RewriteStart start, QWidget* parent)
    : QDialog(parent),
      start_(std::move(start)),
      controller_(new QComboBox(this)),
      dialect_(new QComboBox(this)),
      enlargement_(new QComboBox(this)),
      tolerance_(nullptr),
      arcs_(new QCheckBox(this)),
      feeds_(new QCheckBox(this)),
      summary_(ui::figure_table("rewriteSummary", 4, this)),
      ranges_(ui::figure_table("rewriteRanges", 4, this)),
      notes_(new QLabel(this)),
      state_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      again_(new QPushButton(this)),
      canvas_(new ui::ContourCanvas(this)) {
  setObjectName("rewriteDialog");
  setWindowTitle(tr("Program for this controller"));
  auto* body = new QHBoxLayout;
  body->setSpacing(12);
  body->addWidget(buildForm());
  body->addWidget(buildResults(), 1);
  auto* buttons = new QDialogButtonBox(this);
  save_ = buttons->addButton(tr("Save as…"), QDialogButtonBox::AcceptRole);
  save_->setObjectName("rewriteSave");
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole)->setObjectName("rewriteClose");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* foot = new QHBoxLayout;
  foot->addWidget(state_, 1);
  foot->addWidget(progress_);
  foot->addWidget(again_);
  foot->addWidget(buttons);
  auto* column = new QVBoxLayout(this);
  column->addLayout(body, 1);
  column->addLayout(foot);
  state_->setObjectName("rewriteState");
  state_->setWordWrap(true);
  progress_->setObjectName("rewriteProgress");
  progress_->setTextVisible(false);
  progress_->setFixedWidth(120);
  ui::name_control(progress_, tr("Progress"));
  again_->setObjectName("rewriteAgain");
  again_->setAutoDefault(false);
  connect(again_, &QPushButton::clicked, this, [this] {
    if (!service_.isRunning()) return work();
    service_.cancel();
    trouble_ = tr("stopped");
  });
  connect(&service_, &ui::RewriteService::rewritten, this, &RewriteDialog::take);
  connect(&service_, &ui::RewriteService::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(fraction * 100)); });
  connect(&service_, &ui::RewriteService::failed, this,
          [this](const Error& error) { trouble_ = ui::message_text(error.code, error.message); });
  connect(&service_, &ui::RewriteService::finished, this, &RewriteDialog::showState);
  resize(kRewriteSize);
  showFound();
  work();
}

RewriteDialog::~RewriteDialog() = default;

QWidget* RewriteDialog::buildForm() {
  auto* page = new QWidget(this);
  page->setFixedWidth(kFormWidth);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  auto* grid = new ui::FormGrid(page);
  buildFields(*grid);
  column->addWidget(grid);
  column->addWidget(arcs_);
  column->addWidget(feeds_);
  arcs_->setObjectName("rewriteArcs");
  arcs_->setText(tr("arcs and helices"));
  arcs_->setChecked(true);
  ui::name_control(arcs_, arcs_->text(), tr("Else lines alone"));
  feeds_->setObjectName("rewriteFeeds");
  feeds_->setText(tr("lower feeds that cannot be held"));
  ui::name_control(feeds_, feeds_->text(),
                   tr("Where axes could not follow, or blocks would come too late; never above the program's"));
  for (QCheckBox* box : {arcs_, feeds_}) connect(box, &QCheckBox::toggled, this, &RewriteDialog::work);
  summary_->setSelectionMode(QAbstractItemView::NoSelection);
  ui::set_heads(summary_, {tr("Result"), tr("Before"), tr("After"), tr("Change")});
  summary_->setAccessibleName(tr("What comes of it"));
  column->addWidget(summary_, 1);
  notes_->setObjectName("rewriteNotes");
  notes_->setWordWrap(true);
  notes_->setProperty("role", "secondary");
  column->addWidget(notes_);
  return page;
}

void RewriteDialog::buildFields(ui::FormGrid& grid) {
  using ui::NumberField;
  using ui::Quantity;
  controller_->setObjectName("rewriteController");
  dialect_->setObjectName("rewriteDialect");
  fillControllers();
  for (const Dialect dialect : all_dialects()) {
    const auto name = dialect_name(dialect);
    dialect_->addItem(dialect == Dialect::automatic ? tr("as the controller reads it")
                                                    : QString::fromUtf8(name.data(), static_cast<int>(name.size())),
                      static_cast<int>(dialect));
  }
  dialect_->setCurrentIndex(dialect_->findData(static_cast<int>(Dialect::automatic)));
  tolerance_ = new NumberField("rewriteTolerance", {}, Quantity::length, {kLeastTolerance, kMostTolerance}, this);
  tolerance_->setUnits(start_.units);
  tolerance_->setValue(std::max(start_.setup.options.corner.tolerance, kLeastTolerance));
  supply_ = new ui::SupplyFields("rewrite", this);
  supply_->setValue(start_.supply);
  grid.addWide(0, controller_)->setText(tr("Runs on"));
  grid.addWide(1, dialect_)->setText(tr("Read as"));
  grid.add(2, 0, tolerance_)->setText(tr("Tolerance"));
  grid.add(3, 0, supply_->baud())->setText(ui::SupplyFields::baudTitle());
  grid.add(4, 0, supply_->blockTime())->setText(ui::SupplyFields::blockTimeTitle());
  ui::name_control(controller_, tr("Runs on"),
                   tr("Whose times count; parts that would take it longer stay as they are"));
  ui::name_control(dialect_, tr("Read as"), tr("The dialect that the program is read in"));
  ui::name_control(tolerance_, tr("Tolerance"), tr("How far the new path may be from the old one"));
  connect(controller_, &QComboBox::activated, this, &RewriteDialog::chooseController);
  connect(dialect_, &QComboBox::activated, this, &RewriteDialog::work);
  connect(tolerance_, &NumberField::edited, this, &RewriteDialog::work);
  connect(supply_, &ui::SupplyFields::edited, this, &RewriteDialog::work);
}

QWidget* RewriteDialog::buildResults() {
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  auto* head = new QHBoxLayout;
  auto* key = ui::secondary_label(tr("Blue: the program. Red: what is written instead, its deviation enlarged"), page);
  key->setWordWrap(true);
  head->addWidget(key, 1);
  head->addWidget(enlargement_);
  enlargement_->setObjectName("rewriteEnlargement");
  for (const int factor : kFactors) enlargement_->addItem(QStringLiteral("×%1").arg(factor), factor);
  ui::name_control(enlargement_, tr("Enlargement of the deviation"));
  connect(enlargement_, &QComboBox::currentIndexChanged, this, &RewriteDialog::setEnlargement);
  column->addLayout(head);
  canvas_->setObjectName("rewriteCanvas");
  canvas_->setTheme(start_.theme);
  canvas_->setUnit(start_.units);
  ui::name_control(canvas_, tr("The program and what is written instead"));
  column->addWidget(canvas_, 3);
  ui::set_heads(ranges_, {tr("Lines"), tr("Blocks"), tr("Time") + "  s", tr("Saves") + "  s"});
  ranges_->setAccessibleName(tr("Where the gain is"));
  ranges_->setSortingEnabled(true);
  column->addWidget(ranges_, 2);
  return page;
}

void RewriteDialog::fillControllers() {
  controller_->clear();
  controller_->addItem(tr("Toolpace's plan"));
  if (controllers_.empty() && start_.controller) {
    controllers_.emplace_back(QFileInfo(start_.controller->path).fileName(), start_.controller->settings);
    chosen_ = 1;
  }
  for (const auto& [name, settings] : controllers_) {
    const auto title = controller_title(settings.controller);
    controller_->addItem(QString::fromUtf8(title.data(), static_cast<int>(title.size())) + " · " + name);
  }
  controller_->addItem(tr("Other settings…"));
  controller_->setCurrentIndex(chosen_);
}

void RewriteDialog::chooseController() {
  if (controller_->currentIndex() < controller_->count() - 1) {
    chosen_ = controller_->currentIndex();
    return work();
  }
  controller_->setCurrentIndex(chosen_);
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Settings of the controller"), {}, tr("Settings (*.ini *.txt *.cfg *.nc *.gcode *.log);;All files (*)"));
  if (!path.isEmpty() && takeSettings(path)) work();
}

bool RewriteDialog::takeSettings(const QString& path) {
  auto settings = read_controller_settings(path.toStdString(), std::nullopt, {});
  if (!settings) {
    trouble_ = ui::message_text(settings.error().code, settings.error().message);
    showState();
    return false;
  }
  controllers_.emplace_back(QFileInfo(path).fileName(), std::move(*settings));
  chosen_ = static_cast<int>(controllers_.size());
  fillControllers();
  return true;
}

ui::RewriteRequest RewriteDialog::request() const {
  ui::RewriteRequest request{start_.document, start_.read_options, {}};
  RewriteTarget& target = request.target;
  target.setup = start_.setup;
  target.setup.options.corner.tolerance = tolerance_->value();
  target.wants_arcs = arcs_->isChecked();
  target.plans_feeds = feeds_->isChecked();
  if (chosen_ > 0) target.settings = controllers_[static_cast<std::size_t>(chosen_ - 1)].second;
  target.predict = supply_->value();
  const auto dialect = static_cast<Dialect>(dialect_->currentData().toInt());
  if (dialect != Dialect::automatic) {
    request.read_options.dialect = dialect;
  } else if (target.settings) {
    request.read_options.dialect = dialect_of(target.settings->controller);
  }
  return request;
}

void RewriteDialog::work() {
  found_.reset();
  trouble_.clear();
  progress_->setValue(0);
  supply_->setEnabled(chosen_ > 0);
  service_.rewrite(request());
  showState();
}

void RewriteDialog::take(std::shared_ptr<const ui::RewriteFound> found) {
  found_ = std::move(found);
  showFound();
}

void RewriteDialog::setEnlargement(int index) { canvas_->setEnlargement(enlargement_->itemData(index).toDouble()); }

void RewriteDialog::showState() {
  const bool works = service_.isRunning();
  save_->setEnabled(found_ && !works);
  progress_->setVisible(works);
  again_->setVisible(works || !found_);
  again_->setText(works ? tr("Stop") : tr("Try again"));
  ui::name_control(again_, again_->text());
  ui::set_role(state_, trouble_.isEmpty() ? "secondary" : "error");
  state_->setText(works                 ? tr("writing the program anew…")
                  : !trouble_.isEmpty() ? trouble_
                                        : tr("Everything but runs of plain G1, G2 and G3 lines stays byte for byte."));
}

}  // namespace toolpace::studio
