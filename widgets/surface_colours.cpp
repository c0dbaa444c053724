#include "widgets/surface_colours.h"

#include <QCoreApplication>

namespace echolucent {

namespace {

constexpr ColourOfThemes early{QColor(0xf5, 0xa3, 0x00), QColor(0xa8, 0x62, 0x00)};

QString translated(const char* text) { return QCoreApplication::translate("surface colours", text); }

bool onLine(ShownSurface shown, int column, int row) {
    switch (shown) {
        case ShownSurface::right: return false;
        case ShownSurface::early: return (column + row) % 6 == 0;
        case ShownSurface::late: return row % 4 == 0;
        case ShownSurface::never: break;
    }
    return (column - row) % 3 == 0;
}

}  // namespace

QString wordOf(ShownSurface shown) {
    switch (shown) {
        case ShownSurface::right: return translated("right");
        case ShownSurface::early: return translated("early");
        case ShownSurface::late: return translated("late");
        case ShownSurface::never: break;
    }
    return translated("never");
}

QColor surfaceColour(ShownSurface shown) {
    switch (shown) {
        case ShownSurface::right: return {0x2f, 0xd0, 0xc8};
        case ShownSurface::early: return earlyLightColour(Theme::dark);
        case ShownSurface::late: return {0x9a, 0x5c, 0xf0};
        case ShownSurface::never: break;
    }
    return {0x6a, 0x6f, 0x76};
}

QRgb surfaceShade(ShownSurface shown, int grey, int column, int row) {
    // Black parts of the picture keep their colour too: there nothing is shown, and that is what is told.
    constexpr double ofBlack = 0.45, ofLine = 0.7, levels = 255.0;
    const double share = (ofBlack + (1.0 - ofBlack) * grey / levels) * (onLine(shown, column, row) ? ofLine : 1.0);
    return mixed(Qt::black, surfaceColour(shown), share).rgb();
}

QColor earlyLightColour(Theme theme) { return early.in(theme); }

QString surfaceColoursSentence() {
    return translated(
        "Colours over the picture in grey say what it does with each surface that is measured. Right, blue-green: half "
        "of the light is held back within 2 units of it. Early, amber with rising lines: before that, by haze or a "
        "wall. Late, violet with level lines: behind that. Never, dark grey with dense lines: less than half of the "
        "light is held back, and the ray shows little or nothing.");
}

}  // namespace echolucent
