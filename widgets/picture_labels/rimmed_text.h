// Words over a picture that are read over black and over bright tissue.
#pragma once

#include <QColor>
#include <QPointF>
#include <QString>

class QPainter;

namespace echolucent {

/// Paints a text with a dark rim in the painter's font, from its baseline's left end on. `rim` is the rim's width in
/// the painter's units, above 0. In the GUI thread texts are kept from one painting to the next; elsewhere they are
/// made anew.
void paintRimmedText(QPainter& painter, const QPointF& baseline, const QString& text, const QColor& colour,
                     double rim = 1.5);

}  // namespace echolucent
