#include "drawing/cause_style.h"

#include <QCoreApplication>

namespace toolpace::ui {
namespace {

struct CauseStyle {
  const char* title;
  QRgb on_light, on_dark;
};

// After Okabe and Ito 2008, with greys for the states in which nothing holds the tool back.
constexpr std::array<CauseStyle, kCauseCount> kStyles = {{
    {QT_TRANSLATE_NOOP("Cause", "programmed feed"), 0xff8d97a3, 0xff76808d},
    {QT_TRANSLATE_NOOP("Cause", "rapid"), 0xffaab2bc, 0xff5c6571},
    {QT_TRANSLATE_NOOP("Cause", "path speed"), 0xff5fb4a2, 0xff7fd8c4},
    {QT_TRANSLATE_NOOP("Cause", "axis speed"), 0xff3a9fdc, 0xff6cc1f2},
    {QT_TRANSLATE_NOOP("Cause", "axis acceleration"), 0xff0061a8, 0xff2f8fe0},
    {QT_TRANSLATE_NOOP("Cause", "path acceleration"), 0xff00815f, 0xff18b88c},
    {QT_TRANSLATE_NOOP("Cause", "jerk"), 0xffbf5a95, 0xffe08fbe},
    {QT_TRANSLATE_NOOP("Cause", "corner"), 0xffd55e00, 0xfff07a1f},
    {QT_TRANSLATE_NOOP("Cause", "curvature"), 0xffdc9600, 0xfff2b632},
    {QT_TRANSLATE_NOOP("Cause", "look-ahead"), 0xff7c7a00, 0xfff0e442},
    {QT_TRANSLATE_NOOP("Cause", "stop"), 0xff30363d, 0xffe2e6ea},
    {QT_TRANSLATE_NOOP("Cause", "dwell"), 0xff882255, 0xffc0608f},
    {QT_TRANSLATE_NOOP("Cause", "limit of the program"), 0xff5a4fcf, 0xffa79bff},
    {QT_TRANSLATE_NOOP("Cause", "near the pole of the rotary axes"), 0xffb3261e, 0xffff8a80},
}};

}  // namespace

QColor cause_colour(Cause cause, Ground ground) {
  const auto& style = kStyles[index_of(cause)];
  return QColor::fromRgb(ground == Ground::light ? style.on_light : style.on_dark);
}

QString cause_title(Cause cause) { return QCoreApplication::translate("Cause", kStyles[index_of(cause)].title); }

}  // namespace toolpace::ui
