#include "models/parameter_tips.h"

#include <QCoreApplication>
#include <array>

namespace toolpace::ui {
namespace {

struct Tip {
  const char* field;
  const char* text;
};

constexpr std::array kTips = {
    Tip{"lawBox",
        QT_TRANSLATE_NOOP("ParameterTips", "How a ramp changes the speed: its duration T(Δv), and v = v₀ + Δv·f(t/T)")},
    Tip{"taccEdit",
        QT_TRANSLATE_NOOP("ParameterTips",
                          "A ramp up lasts as long, whatever the change of speed: its peak acceleration is 2·Δv/Tacc")},
    Tip{"tdecEdit", QT_TRANSLATE_NOOP(
                        "ParameterTips",
                        "A ramp down lasts as long, whatever the change of speed: its peak deceleration is 2·Δv/Tdec")},
    Tip{"amEdit", QT_TRANSLATE_NOOP("ParameterTips", "The path is never sped up harder: dv/dt ≤ Am")},
    Tip{"dmEdit", QT_TRANSLATE_NOOP("ParameterTips", "The path is never slowed down harder: −dv/dt ≤ Dm")},
    Tip{"jmEdit", QT_TRANSLATE_NOOP("ParameterTips",
                                    "The acceleration changes no faster while the path is sped up: |da/dt| ≤ Jm")},
    Tip{"jdEdit", QT_TRANSLATE_NOOP("ParameterTips",
                                    "The acceleration changes no faster while the path is slowed down: |da/dt| ≤ Jd")},
    Tip{"vmaxEdit", QT_TRANSLATE_NOOP("ParameterTips", "No block is run faster, whatever its feed: v ≤ Vmax")},
    Tip{"periodEdit",
        QT_TRANSLATE_NOOP(
            "ParameterTips",
            "Time between two setpoints; on an arc of radius r the chord between them is (v·Ts)²/(8·r) off")},
    Tip{"lookaheadField", QT_TRANSLATE_NOOP("ParameterTips",
                                            "So many blocks are known ahead: v ≤ reach(0, Σ L), from which the tool "
                                            "comes to rest at the end of the last one")},
    Tip{"rampsBox",
        QT_TRANSLATE_NOOP(
            "ParameterTips",
            "Whether a ramp has to fit its block, (v₀ + v₁)/2·T(|v₁ − v₀|) ≤ L, or may go on in the next ones")},
    Tip{"cornerBox",
        QT_TRANSLATE_NOOP("ParameterTips",
                          "How a corner of angle α is passed: at rest, v = 0; servo step, v·|Δu| ≤ a·Ts; junction "
                          "deviation, v² ≤ a·δ·cos(α/2)/(1 − cos(α/2)); or rounded inside the tolerance")},
    Tip{"holdEdit",
        QT_TRANSLATE_NOOP("ParameterTips",
                          "From this time on the path is slowed down to rest, and stays there: v → 0 under Dm and Jd")},
    Tip{"toleranceEdit", QT_TRANSLATE_NOOP("ParameterTips",
                                           "Rounded corners stay this close to the programmed path: distance ≤ "
                                           "tolerance; a G64 P of the program comes first")},
    Tip{"deviationEdit",
        QT_TRANSLATE_NOOP(
            "ParameterTips",
            "Passing a corner of angle α as if on a circle this far from it: v² ≤ a·δ·cos(α/2)/(1 − cos(α/2))")},
    Tip{"feedOverrideEdit",
        QT_TRANSLATE_NOOP("ParameterTips", "Programmed feeds are multiplied by it: v ≤ F · override")},
    Tip{"rapidOverrideEdit",
        QT_TRANSLATE_NOOP("ParameterTips", "Rapid traverse is multiplied by it: v ≤ rapid · override")}};

}  // namespace

QString parameter_tip(const QString& field) {
  for (const Tip& tip : kTips) {
    if (field == QLatin1String(tip.field)) return QCoreApplication::translate("ParameterTips", tip.text);
  }
  return {};
}

}  // namespace toolpace::ui
