// Which pixel of a pane shows which place of the grid.
#pragma once

#include <QPointF>
#include <QSize>
#include <algorithm>

#include "processing/scene/planes.h"

namespace echolucent {

/// A plane's picture in a pane. Pixels are logical, from the pane's upper left corner.
struct PlaneMapping {
    PlaneView view{};
    QSize size;

    [[nodiscard]] double mmPerPixel() const { return view.heightMm / std::max(1, size.height()); }
    /// The pixel of a place of the grid, mm. A place beside the plane is projected onto it.
    [[nodiscard]] QPointF seenAt(const Vec3& gridMm) const {
        const Vec3 from = (gridMm - view.centreMm) * (1.0 / mmPerPixel());
        return {size.width() / 2.0 + view.frame.right.dot(from), size.height() / 2.0 + view.frame.down.dot(from)};
    }
    /// The place in the plane at a pixel, grid mm.
    [[nodiscard]] Vec3 gridAt(const QPointF& pixel) const {
        return view.centreMm + view.frame.right * ((pixel.x() - size.width() / 2.0) * mmPerPixel()) +
               view.frame.down * ((pixel.y() - size.height() / 2.0) * mmPerPixel());
    }
    /// The vector in the picture, in pixels, of a vector in the grid, mm.
    [[nodiscard]] QPointF wayOf(const Vec3& gridMm) const {
        return QPointF(view.frame.right.dot(gridMm), view.frame.down.dot(gridMm)) / mmPerPixel();
    }
};

}  // namespace echolucent
