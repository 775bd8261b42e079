#include "preview/contour_view.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QStandardItemModel>
#include <QToolButton>

#include "preview/contour_legend.h"
#include "theme/control_name.h"
#include "theme/flow_layout.h"
#include "theme/line_key.h"

namespace toolpace::ui {
namespace {

constexpr std::array kEnlargements = {1, 10, 100, 1000};
constexpr int kIcon = 16;  // decides how high a button is

}  // namespace

ContourView::ContourView(QWidget* parent) : QWidget(parent) {
  setObjectName("contourView");
  canvas_ = new ContourCanvas(this);
  legend_ = new ContourLegend(*canvas_, this);
  buildHeader();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(canvas_, 1);
  column->addWidget(legend_);
  connect(canvas_, &ContourCanvas::cursorTimeRequested, this, &ContourView::cursorTimeRequested);
  connect(canvas_, &ContourCanvas::hoverChanged, legend_, qOverload<>(&QWidget::update));
  retranslate();
  updateChoices();
  legend_->refresh();
}

void ContourView::buildHeader() {
  header_ = new QWidget(this);
  auto* row = new FlowLayout(header_);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(8);
  const auto combo = [&](const char* name) {
    auto* box = new QComboBox(header_);
    box->setObjectName(name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row->addWidget(box);
    return box;
  };
  colour_by_ = combo("colourBy");
  colour_map_ = combo("colourMap");
  enlargement_ = combo("errorEnlargement");
  for (const int factor : kEnlargements) enlargement_->addItem(QStringLiteral("×%1").arg(factor), factor);
  band_ = new QToolButton(header_);
  band_->setObjectName("showBand");
  band_->setCheckable(true);
  band_->setChecked(true);
  band_->setAutoRaise(true);
  band_->setIconSize({kIcon, kIcon});
  row->addWidget(band_);
  key_ = new LineKey("contourKey", header_);
  row->addWidget(key_);
  connect(band_, &QToolButton::toggled, this, &ContourView::setBandShown);
  views_ = new QButtonGroup(this);
  auto* group = new QWidget(header_);
  auto* buttons = new QHBoxLayout(group);
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->setSpacing(0);
  buttons->addStretch(1);
  const std::pair<View, const char*> views[] = {
      {View::xy, "viewXY"}, {View::xz, "viewXZ"}, {View::yz, "viewYZ"}, {View::zx, "viewZX"}, {View::iso, "viewIso"}};
  for (const auto& [view, name] : views) {
    auto* button = new QToolButton(header_);
    button->setObjectName(name);
    button->setCheckable(true);
    button->setAutoRaise(true);
    button->setIconSize({kIcon, kIcon});
    views_->addButton(button, static_cast<int>(view));
    buttons->addWidget(button);
  }
  connect(canvas_, &ContourCanvas::turned, this, &ContourView::showView);
  showView(View::xy);
  fit_ = new QToolButton(header_);
  fit_->setObjectName("viewFit");
  fit_->setAutoRaise(true);
  fit_->setIconSize({kIcon, kIcon});
  buttons->addWidget(fit_);
  row->addWidget(group);

  connect(colour_by_, &QComboBox::activated, this,
          [this] { setColourBy(static_cast<ColourBy>(colour_by_->currentData().toInt())); });
  connect(colour_map_, &QComboBox::activated, this,
          [this] { setColourMap(static_cast<ColourMap>(colour_map_->currentIndex())); });
  connect(enlargement_, &QComboBox::activated, this, [this] { setEnlargement(enlargement_->currentData().toInt()); });
  connect(views_, &QButtonGroup::idClicked, this, [this](int id) { setView(static_cast<View>(id)); });
  connect(fit_, &QToolButton::clicked, this, &ContourView::fit);
}

void ContourView::retranslate() {
  setAccessibleName(tr("Contour"));
  canvas_->setAccessibleName(tr("Contour preview"));
  legend_->setAccessibleName(tr("Legend of the contour preview"));
  name_control(colour_by_, tr("Colour by"), tr("What the colours of the path show"));
  name_control(enlargement_, tr("Error enlargement"), tr("How much contour error and tolerance band are enlarged"));
  band_->setText(tr("Band"));
  name_control(band_, tr("Tolerance band"),
               tr("Programmed path, tolerance band, and the plan inside it; off: the simulated drives"));
  if (colour_by_->count() == 0) {
    for (int i = 0; i < static_cast<int>(kColourings); ++i) colour_by_->addItem({}, i);
    for (int i = 0; i < 3; ++i) colour_map_->addItem({});
  }
  for (int i = 0; i < colour_by_->count(); ++i) colour_by_->setItemText(i, colour_by_title(static_cast<ColourBy>(i)));
  colour_map_->setItemText(0, tr("cividis"));
  colour_map_->setItemText(1, tr("viridis"));
  colour_map_->setItemText(2, tr("turbo"));

  const std::array<std::pair<QString, QString>, 5> views = {
      {{tr("XY"), tr("Look from above (Z)")},
       {tr("XZ"), tr("Look from the front (Y)")},
       {tr("YZ"), tr("Look from the right (X)")},
       {tr("Iso"), tr("Isometric view (I)")},
       {tr("ZX"), tr("As at a lathe: Z to the right, X upwards (L)")}}};
  for (int i = 0; i < static_cast<int>(views.size()); ++i) {
    auto* button = static_cast<QToolButton*>(views_->button(i));
    button->setText(views[static_cast<std::size_t>(i)].first);
    name_control(button, views[static_cast<std::size_t>(i)].first, views[static_cast<std::size_t>(i)].second);
  }
  fit_->setText(tr("Fit"));
  name_control(fit_, tr("Fit"), tr("Show the whole path (F)"));
}

void ContourView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    updateChoices();
    legend_->refresh();
  }
  QWidget::changeEvent(event);
}

void ContourView::fillKey() {
  const Theme& theme = canvas_->theme();
  const auto dashed = [](const QColor& colour) {
    QPen pen(colour, 1.4);
    pen.setDashPattern({4, 3});
    return pen;
  };
  std::vector<KeySample> samples;
  const auto& scene = canvas_->scene();
  if (scene && scene->outcome && scene->outcome->summary.rapid_time > 0 && canvas_->areRapidsShown()) {
    samples.push_back({tr("rapids"), dashed(theme.secondary)});
  }
  if (canvas_->hasGhost()) samples.push_back({QStringLiteral("B"), dashed(theme.plan_b)});
  if (canvas_->showsTrace()) samples.push_back({tr("drives"), QPen(theme.error, 1.4)});
  if (canvas_->showsMeasured()) samples.push_back({tr("measured"), QPen(theme.text, 1.4)});
  key_->setTextColour(theme.secondary);
  key_->setSamples(std::move(samples));
  name_control(key_, tr("Lines of the preview"),
               tr("Dashed: rapids, and the plan that is pinned as B. Red: where the simulated drives go, enlarged"));
  key_->setVisible(!key_->samples().empty());
}

void ContourView::updateChoices() {
  fillKey();
  auto* items = qobject_cast<QStandardItemModel*>(colour_by_->model());
  const auto& scene = canvas_->scene();
  for (int i = 0; i < colour_by_->count(); ++i) {
    items->item(i)->setEnabled(!scene || scene->is_empty() || scene->can_colour_by(static_cast<ColourBy>(i)));
  }
  items->item(static_cast<int>(ColourBy::contour_error))->setEnabled(scene && scene->trace);
  enlargement_->setVisible(canvas_->showsMeasured() || (scene && scene->trace));
  band_->setVisible(has_tube_ || tolerance_ > 0);
  const ColourBy by = canvas_->colourBy();
  colour_map_->setEnabled(by != ColourBy::limit && !is_signed(by));
  name_control(colour_map_, tr("Colour map"),
               colour_map_->isEnabled() ? tr("Colour map; all are safe for colour-blind eyes")
               : is_signed(by)          ? tr("Values with a sign have colours of their own: grey is zero")
                                        : tr("Limits have colours of their own"));
}

void ContourView::setScene(std::shared_ptr<const ContourScene> scene) {
  const bool first = !canvas_->scene() || canvas_->scene()->is_empty();
  canvas_->setScene(std::move(scene));
  if (first && canvas_->scene() && !canvas_->scene()->is_empty()) {
    const View suited = opening_view(*canvas_->scene(), view_);
    if (suited != view_) setView(suited);
  }
  updateChoices();
  legend_->refresh();
  setHighlightedLine(highlighted_);
}

void ContourView::setGhost(std::shared_ptr<const ContourScene> scene) {
  canvas_->setGhost(std::move(scene));
  fillKey();
}

void ContourView::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
  legend_->refresh();
  fillKey();
}

void ContourView::showPlans(const Planned& plan, const Planned& pinned) {
  const auto& scene = plan.proof ? plan.proof->scene : plan.scene;
  if (scene != canvas_->scene()) {
    setScene(scene);
    setTube(plan.proof ? plan.proof->tube : nullptr);
  }
  setTolerance(plan && scene && scene->tolerance ? *scene->tolerance : 0);
  setGhost(pinned.scene);
}

void ContourView::showTrace(const std::shared_ptr<const MeasuredTrace>& trace) {
  canvas_->setMeasured(trace ? trace->actual : nullptr);
  updateChoices();
}

void ContourView::showInstant(const std::optional<Instant>& instant) {
  setCursorTime(instant ? std::optional(instant->time) : std::nullopt);
  if (instant && instant->line > 0) setHighlightedLine(instant->line);
}

void ContourView::setUnits(Units unit) {
  canvas_->setUnit(unit);
  legend_->refresh();
}

void ContourView::setTolerance(double tolerance) {
  tolerance_ = tolerance;
  canvas_->setTolerance(tolerance);
  updateChoices();
}
void ContourView::setTube(std::shared_ptr<const TubeTrace> tube) {
  has_tube_ = tube != nullptr;
  canvas_->setTube(std::move(tube));
  updateChoices();
}

void ContourView::setRapidsShown(bool shown) {
  canvas_->setRapidsShown(shown);
  fillKey();
}

void ContourView::setBandShown(bool shown) {
  band_->setChecked(shown);
  canvas_->setBandShown(shown);
  fillKey();
}

void ContourView::setCursorTime(std::optional<double> time) { canvas_->setCursorTime(time); }

void ContourView::setHighlightedLine(std::uint32_t line) {
  highlighted_ = line;
  const auto& scene = canvas_->scene();
  const bool known = line > 0 && scene && scene->outcome;
  canvas_->setHighlight(known ? time_of_line(*scene->outcome, line, canvas_->cursorTime().value_or(0.0))
                              : std::nullopt);
}

void ContourView::setColourBy(ColourBy by) {
  colour_by_->setCurrentIndex(static_cast<int>(by));
  if (canvas_->colourBy() == by) return;
  canvas_->setColourBy(by);
  updateChoices();
  legend_->refresh();
  emit colourByChanged(by);
}

ColourBy ContourView::colourBy() const { return canvas_->colourBy(); }
ColourMap ContourView::colourMap() const { return static_cast<ColourMap>(colour_map_->currentIndex()); }

void ContourView::setColourMap(ColourMap map) {
  colour_map_->setCurrentIndex(static_cast<int>(map));
  canvas_->setColourMap(map);
  legend_->refresh();
  emit colourMapChanged(map);
}

void ContourView::setEnlargement(double factor) {
  const int index = enlargement_->findData(static_cast<int>(factor));
  if (index >= 0) enlargement_->setCurrentIndex(index);
  canvas_->setEnlargement(factor);
  fillKey();
  emit enlargementChanged(factor);
}

void ContourView::setView(View view) { canvas_->setView(view); }

void ContourView::showView(std::optional<View> view) {
  if (view) {
    view_ = *view;
    views_->button(static_cast<int>(*view))->setChecked(true);
  } else if (QAbstractButton* lit = views_->checkedButton()) {
    views_->setExclusive(false);
    lit->setChecked(false);
    views_->setExclusive(true);
  }
}

void ContourView::fit() { canvas_->fit(); }

}  // namespace toolpace::ui
