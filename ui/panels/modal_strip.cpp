#include "panels/modal_strip.h"

#include <QEvent>
#include <utility>
#include <vector>

#include "models/units.h"
#include "theme/appearance.h"

namespace toolpace::ui {
namespace {

constexpr qreal kStripFontPoints = 8.5;
constexpr int kMargin = 8;

/// A code in force and the one that holds before a program says anything.
struct Group {
  QString title;
  std::int16_t code, usual;
  bool always;  ///< shown even where it is as usual
};

std::vector<Group> groups_of(const ModalSnapshot& s) {
  const ModalSnapshot usual;
  const auto system = [](const ModalSnapshot& of) {
    return static_cast<std::int16_t>(of.system <= 6 ? 530 + 10 * of.system : 590 + of.system - 6);
  };
  return {{ModalStrip::tr("Motion"), s.motion, s.motion, true},
          {ModalStrip::tr("Plane"), s.plane, usual.plane, true},
          {ModalStrip::tr("Units"), s.units, usual.units, true},
          {ModalStrip::tr("Distances"), s.distance, usual.distance, true},
          {ModalStrip::tr("Feed mode"), s.feed_mode, usual.feed_mode, true},
          {ModalStrip::tr("Work offset"), system(s), system(usual), true},
          {ModalStrip::tr("Path control"), s.path_control, usual.path_control, true},
          {ModalStrip::tr("Arc centres"), s.arc_distance, usual.arc_distance, false},
          {ModalStrip::tr("Cutter compensation"), s.compensation, usual.compensation, false},
          {ModalStrip::tr("Tool length"), s.tool_length, usual.tool_length, false},
          {ModalStrip::tr("Spindle mode"), s.spindle_mode, usual.spindle_mode, false},
          {ModalStrip::tr("Return of cycles"), s.retract, usual.retract, false},
          {ModalStrip::tr("Lathe"), s.lathe_diameter, usual.lathe_diameter, false}};
}

QString meaning_of(std::int16_t code) {
  switch (code) {
    case 0: return ModalStrip::tr("rapid");
    case 10: return ModalStrip::tr("straight, at the feed");
    case 20: return ModalStrip::tr("arc, clockwise");
    case 30: return ModalStrip::tr("arc, counter-clockwise");
    case 170: return QStringLiteral("XY");
    case 180: return QStringLiteral("XZ");
    case 190: return QStringLiteral("YZ");
    case 200: return ModalStrip::tr("inches");
    case 210: return ModalStrip::tr("millimetres");
    case 400: return ModalStrip::tr("off");
    case 410: return ModalStrip::tr("left of the path");
    case 420: return ModalStrip::tr("right of the path");
    case 490: return ModalStrip::tr("no offset");
    case 610: return ModalStrip::tr("exact path");
    case 611: return ModalStrip::tr("exact stop");
    case 640: return ModalStrip::tr("continuous");
    case 800: return ModalStrip::tr("none");
    case 900: return ModalStrip::tr("absolute");
    case 901: return ModalStrip::tr("absolute");
    case 910: return ModalStrip::tr("incremental");
    case 911: return ModalStrip::tr("incremental");
    case 930: return ModalStrip::tr("inverse time");
    case 940: return ModalStrip::tr("per minute");
    case 950: return ModalStrip::tr("per revolution");
    case 960: return ModalStrip::tr("constant surface speed");
    case 970: return ModalStrip::tr("revolutions per minute");
    case 980: return ModalStrip::tr("to the first height");
    case 990: return ModalStrip::tr("to the plane R");
    default: return {};
  }
}

/// " P0.05" in the program's units; nothing where G64 names no tolerance.
QString tolerance_text(const ModalSnapshot& s) {
  constexpr double kMmPerInch = 25.4;
  if (!(s.tolerance > 0)) return {};
  return QStringLiteral("&nbsp;P") + number_text(s.units == 200 ? s.tolerance / kMmPerInch : s.tolerance, 6);
}

QString feed_unit(const ModalSnapshot& s) {
  const QString length = s.units == 200 ? "in" : "mm";
  if (s.feed_mode == 930) return "1/min";
  return length + (s.feed_mode == 950 ? "/rev" : "/min");
}

}  // namespace

QString code_text(std::int16_t tenths) {
  const QString whole = "G" + QString::number(tenths / 10);
  return tenths % 10 == 0 ? whole : whole + "." + QString::number(tenths % 10);
}

ModalStrip::ModalStrip(QWidget* parent) : QLabel(parent) {
  setObjectName("modalStrip");
  setProperty("role", "hint");
  setFont(monospace_font(kStripFontPoints));
  setTextFormat(Qt::RichText);
  setWordWrap(true);
  setContentsMargins(kMargin, 4, kMargin, 4);
  hide();
}

void ModalStrip::setSnapshot(const std::optional<ModalSnapshot>& snapshot) {
  if (snapshot == snapshot_ && snapshot.has_value() == isVisibleTo(parentWidget())) return;
  snapshot_ = snapshot;
  showSnapshot();
}

void ModalStrip::setTheme(const Theme& theme) {
  theme_ = theme;
  showSnapshot();
}

QString ModalStrip::codes() const {
  QStringList texts;
  for (const Group& group : groups_of(*snapshot_)) {
    const bool stands_out = group.code != group.usual;
    if (!group.always && !stands_out) continue;
    const bool motion = texts.isEmpty();  // what the line does comes first
    QString code = code_text(group.code);
    if (group.code == 640) code += tolerance_text(*snapshot_);
    texts << (stands_out || motion ? QString("<span style='color:%1'>%2</span>").arg(theme_.text.name(), code) : code);
  }
  return texts.join(' ');
}

QString ModalStrip::words() const {
  const ModalSnapshot& s = *snapshot_;
  QStringList texts = {QString("T%1").arg(s.tool)};
  texts << (s.feed > 0 ? "F" + number_text(s.feed, 6) + " " + feed_unit(s) : QString("F –"));
  const QString turning = s.spindle_direction > 0 ? "M3" : s.spindle_direction < 0 ? "M4" : "M5";
  texts << "S" + number_text(s.spindle_speed, 6) + " " + turning;
  if (s.mist) texts << "M7";
  if (s.flood) texts << "M8";
  return texts.join(QStringLiteral("&nbsp; "));
}

QString ModalStrip::meanings() const {
  QString rows;
  for (const Group& group : groups_of(*snapshot_)) {
    rows += QString("<tr><td>%1&nbsp;&nbsp;</td><td>%2&nbsp;&nbsp;</td><td>%3</td></tr>")
                .arg(code_text(group.code) + (group.code == 640 ? tolerance_text(*snapshot_) : QString()), group.title,
                     meaning_of(group.code));
  }
  return "<table>" + rows + "</table>";
}

void ModalStrip::showSnapshot() {
  setVisible(snapshot_.has_value());
  setAccessibleName(tr("Modal state at the cursor line"));
  if (!snapshot_) return clear();
  setText(codes() + "<br>" + words());
  setToolTip(meanings());
  setAccessibleDescription(QString::fromStdString(snapshot_->codes()));
}

void ModalStrip::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) showSnapshot();
  QLabel::changeEvent(event);
}

}  // namespace toolpace::ui
