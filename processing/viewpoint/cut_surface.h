// A curved cut: a smooth surface. Rays and tube cores see nothing before it.
#pragma once

#include <optional>
#include <string>

#include "processing/shared_list.h"
#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// A smooth surface to cut along: the picture leaves out all that lies before it. It is a height field over a grid of
/// nodes, bilinear between them. It is fixed to the volume and stays in place while the view turns. Places and depths
/// are mm from the grid origin (the centre of voxel (0,0,0)).
struct CutSurface {
    ViewFrame frame{};  ///< depth is along frame.forward, columns lie along frame.right, rows along frame.down
    double firstRightMm = 0.0, firstDownMm = 0.0;  ///< place of node (0,0) along frame.right and frame.down
    double spacingMm = 1.0;                        ///< between nodes, > 0
    int columns = 0, rows = 0;                     ///< of nodes, at least 2 each
    SharedList<float> depthMm{};                   ///< of node (column, row) at row * columns + column; finite

    /// The depth of the surface at a point's place along frame.right and frame.down. Beyond the outermost nodes the
    /// surface goes on at their depth.
    [[nodiscard]] double depthAt(const Vec3& gridMm) const;
    /// Whether a point lies before the surface.
    [[nodiscard]] bool cutsAway(const Vec3& gridMm) const { return frame.forward.dot(gridMm) < depthAt(gridMm); }

    /// A stretch of a line, in mm along the line's direction from the line's point; begin <= end.
    struct Stretch {
        double begin, end;
        friend bool operator==(const Stretch&, const Stretch&) = default;
    };
    /// The first part of the stretch `within` of a line that the surface does not cut away. A ray or a tube core begins
    /// and ends there. The part ends if the line passes through the surface again. A dip into the surface and back
    /// within one patch of nodes does not end it. `direction` has length 1. Empty if the surface cuts the whole stretch
    /// away, or if the stretch has length 0.
    [[nodiscard]] std::optional<Stretch> firstLeft(const Vec3& pointMm, const Vec3& direction,
                                                   const Stretch& within) const;

    friend bool operator==(const CutSurface&, const CutSurface&) = default;
};

/// What is wrong with a surface read from a file, lower case, no full stop ("has fewer than 2 columns"). Empty if
/// nothing is wrong. All other functions expect a surface without problems.
[[nodiscard]] std::string problemOf(const CutSurface& surface);

}  // namespace echolucent
