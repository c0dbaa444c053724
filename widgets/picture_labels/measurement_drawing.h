// How measurements are drawn over a picture: alike in planes, saved pictures and whatever else is handed over.
#pragma once

#include <QColor>
#include <QSizeF>
#include <vector>

#include "processing/document/shown_measurement.h"

class QPainter;

namespace echolucent {

/// The one colour of measurements.
inline constexpr QColor measurementColour{0xf2, 0xe3, 0x5c};

/// Sizes of what is drawn, in pixels of a plain screen.
inline constexpr double measurementLineWidth = 1.5, measurementMarkRadius = 3.0, measurementTextGap = 9.0;
inline constexpr int measurementFontPixels = 14;

/// Paints measurements over a picture that lies at the painter's origin and is as large as said, in the painter's
/// units: a mark at each place, a line through them, an angle's arc, and the value beside it. `scale` is the number of
/// these units in a pixel of a plain screen (1 on a widget; device pixels of an image on a screen of ratio 2: 2), above
/// 0. Works on any paint device, in any thread that may paint on it.
void paintMeasurements(QPainter& painter, const std::vector<PlacedMeasurement>& measurements, const QSizeF& picture,
                       double scale = 1.0);

}  // namespace echolucent
