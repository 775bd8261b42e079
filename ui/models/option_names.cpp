#include "models/option_names.h"

#include <QCoreApplication>

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

}  // namespace toolpace::ui
