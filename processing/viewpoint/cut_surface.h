// A curved cut: a smooth surface before which nothing is rendered and no tube core is read.
#pragma once

#include <optional>
#include <string>

#include "processing/shared_list.h"
#include "processing/viewpoint/view_frame.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// A smooth surface that is cut along: what lies before it is not rendered. It is a height field over a grid of nodes,
/// bilinear between them, and fixed to the volume: it stays where it is while the view turns. Places and depths are mm
/// from the grid origin (the centre of voxel (0,0,0)).
struct CutSurface {
    ViewFrame frame{};  ///< depth is along frame.forward, columns lie along frame.right, rows along frame.down
    double firstRightMm = 0.0, firstDownMm = 0.0;  ///< place of node (0,0) along frame.right and frame.down
    double spacingMm = 1.0;                        ///< between nodes, > 0
    int columns = 0, rows = 0;                     ///< of nodes, at least 2 each
    SharedList<float> depthMm{};                   ///< of node (column, row) at row * columns + column; finite

    /// The depth of the surface over (or under) a point. Beyond the outermost nodes it goes on at their depth.
    [[nodiscard]] double depthAt(const Vec3& gridMm) const;
    /// Whether a point lies before the surface.
    [[nodiscard]] bool cutsAway(const Vec3& gridMm) const { return frame.forward.dot(gridMm) < depthAt(gridMm); }

    /// A stretch of a line, mm from its point along its direction; begin <= end.
    struct Stretch {
        double begin, end;
        friend bool operator==(const Stretch&, const Stretch&) = default;
    };
    /// The first part of the stretch of a line that the surface leaves: where a ray or a tube core begins, and where it
    /// leaves it again through the surface (a dip through it and back within one patch of nodes counts as left).
    /// `direction` has length 1. The result is empty where all is cut away.
    [[nodiscard]] std::optional<Stretch> firstLeft(const Vec3& pointMm, const Vec3& direction,
                                                   const Stretch& within) const;

    friend bool operator==(const CutSurface&, const CutSurface&) = default;
};

/// What is wrong with a surface that was read from a file, lower case, no full stop ("has fewer than 2 columns"); an
/// empty text where nothing is. All else that takes a surface expects a right one.
[[nodiscard]] std::string problemOf(const CutSurface& surface);

}  // namespace echolucent
