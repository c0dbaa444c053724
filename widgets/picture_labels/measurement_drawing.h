// Draws measurements over a picture: alike in planes, saved pictures and exports.
#pragma once

#include <QColor>
#include <QSizeF>
#include <vector>

#include "processing/scene/shown_measurement.h"

class QPainter;

namespace echolucent {

inline constexpr QColor measurementColour{0xf2, 0xe3, 0x5c};

/// In pixels of a plain screen.
inline constexpr double measurementLineWidth = 1.5, measurementMarkRadius = 3.0, measurementTextGap = 9.0;
inline constexpr double measurementDash = 7.0, measurementDashGap = 5.0;
inline constexpr int measurementFontPixels = 14;

/// Paints measurements over a picture at the painter's origin: a mark at each place, a line through them, an angle's
/// arc, and the value beside it. Lines of a dashed one are dashed. `picture` is its size in the painter's units.
/// `scale` is the number of these units in a pixel of a plain screen, above 0 (on a widget 1; for device pixels on a
/// screen of ratio 2: 2). Works in any thread that may paint on the device.
void paintMeasurements(QPainter& painter, const std::vector<PlacedMeasurement>& measurements, const QSizeF& picture,
                       double scale = 1.0);

}  // namespace echolucent
