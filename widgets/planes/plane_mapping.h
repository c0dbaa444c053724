// Which pixel of a pane shows which place of the grid.
#pragma once

#include <QPointF>
#include <QSize>
#include <algorithm>

#include "processing/document/planes.h"

namespace echolucent {

/// A plane's picture in a pane; pixels are logical, from the pane's upper left corner.
struct PlaneMapping {
    PlaneView view{};
    QSize size;

    [[nodiscard]] double mmPerPixel() const { return view.heightMm / std::max(1, size.height()); }
    /// Where a place of the grid, mm, is seen; places beside the plane where their foot in it is.
    [[nodiscard]] QPointF seenAt(const Vec3& gridMm) const {
        const Vec3 from = (gridMm - view.centreMm) * (1.0 / mmPerPixel());
        return {size.width() / 2.0 + view.frame.right.dot(from), size.height() / 2.0 + view.frame.down.dot(from)};
    }
    /// What is seen there, in the plane.
    [[nodiscard]] Vec3 gridAt(const QPointF& pixel) const {
        return view.centreMm + view.frame.right * ((pixel.x() - size.width() / 2.0) * mmPerPixel()) +
               view.frame.down * ((pixel.y() - size.height() / 2.0) * mmPerPixel());
    }
    /// The way in the picture of a way in the grid, mm; pixels.
    [[nodiscard]] QPointF wayOf(const Vec3& gridMm) const {
        return QPointF(view.frame.right.dot(gridMm), view.frame.down.dot(gridMm)) / mmPerPixel();
    }
};

}  // namespace echolucent
