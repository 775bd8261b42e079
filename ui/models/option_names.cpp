#include "models/option_names.h"

#include <QCoreApplication>
#include <QStringList>

#include "models/units.h"
#include "toolpace/sample/shaper.h"

namespace toolpace::ui {

QString corner_title(CornerRule rule) {
  switch (rule) {
    case CornerRule::stop: return QCoreApplication::translate("OptionNames", "exact stop");
    case CornerRule::servo: return QCoreApplication::translate("OptionNames", "servo step (a·Ts)");
    case CornerRule::junction: return QCoreApplication::translate("OptionNames", "junction deviation");
    case CornerRule::blend: return QCoreApplication::translate("OptionNames", "blend in tolerance");
    case CornerRule::smooth: break;
  }
  return QCoreApplication::translate("OptionNames", "smooth in tolerance");
}

QString ramps_title(Ramps ramps) {
  return ramps == Ramps::block ? QCoreApplication::translate("OptionNames", "end inside their block")
                               : QCoreApplication::translate("OptionNames", "run across blocks");
}

QString shaper_title(ShaperKind kind) {
  switch (kind) {
    case ShaperKind::none: return QCoreApplication::translate("OptionNames", "none");
    case ShaperKind::two_hump: return QStringLiteral("2-hump EI");
    default:
      return QString::fromLatin1(shaper_name(kind).data(), static_cast<qsizetype>(shaper_name(kind).size())).toUpper();
  }
}

QString modes_text(const std::vector<AxisMode>& modes) {
  QStringList texts;
  for (const AxisMode& m : modes) {
    const QString share = m.share == 1 ? QString() : QString(", %1 %").arg(number_text(100 * m.share, 3));
    texts << QString("%1 Hz (ζ %2%3)").arg(number_text(m.frequency, 5), number_text(m.damping, 3), share);
  }
  return texts.isEmpty() ? QString("–") : texts.join(", ");
}

QString knob_title(Knob knob) {
  switch (knob) {
    case Knob::law: return QCoreApplication::translate("OptionNames", "velocity law");
    case Knob::corner: return QCoreApplication::translate("OptionNames", "corners");
    case Knob::ramps: return QCoreApplication::translate("OptionNames", "ramps");
    case Knob::acceleration: return QCoreApplication::translate("OptionNames", "acceleration");
    case Knob::jerk: return QCoreApplication::translate("OptionNames", "jerk");
    case Knob::ramp_time: return QCoreApplication::translate("OptionNames", "times of ramps");
    case Knob::tolerance: return QCoreApplication::translate("OptionNames", "tolerance");
    case Knob::lookahead: break;
  }
  return QCoreApplication::translate("OptionNames", "look-ahead");
}

}  // namespace toolpace::ui
