// Text over a picture that is legible over black and over bright tissue.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

class QPainter;

namespace echolucent {

/// Paints a text with a dark rim in the painter's font, from the left end of its baseline. `rim` is the rim's width in
/// the painter's units, above 0. The GUI thread keeps texts from one painting to the next. Other threads make them
/// anew.
void paintRimmedText(QPainter& painter, const QPointF& baseline, const QString& text, const QColor& colour,
                     double rim = 1.5);

}  // namespace echolucent
