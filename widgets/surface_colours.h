// The colours of shown depths: what a picture does with the surfaces that are known.
#pragma once

#include <QColor>
#include <QString>

#include "processing/comparison/shown_depth.h"
#include "widgets/theme_colours.h"

namespace echolucent {

/// "right", "early", "late", "never".
[[nodiscard]] QString wordOf(ShownSurface shown);
/// The colour over pictures: blue-green, amber, violet, dark grey. Eyes that lack a kind of cone tell them apart too.
[[nodiscard]] QColor surfaceColour(ShownSurface shown);
/// The colour of a pixel over a picture of this grey level, [0,255]. Its brightness follows the picture, and a pattern
/// of darker lines tells the colours apart a second time: none, rising, level and dense falling ones.
[[nodiscard]] QRgb surfaceShade(ShownSurface shown, int grey, int column, int row);
/// Light that is held back early, on plots and panels of a theme: 3 : 1 at least (WCAG 2.1, 1.4.11).
[[nodiscard]] QColor earlyLightColour(Theme theme);
/// What the colours mean.
[[nodiscard]] QString surfaceColoursSentence();

}  // namespace echolucent
