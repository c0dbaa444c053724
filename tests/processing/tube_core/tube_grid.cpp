#include "processing/tube_core/slabs/tube_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/processing/grids.h"

namespace echolucent {
namespace {

TEST(TubeGrid, FindsThePapersSpacingForThePapersVolume) {
    const auto geometry = gridOf({199, 197, 199}, {0.5, 0.5, 0.5});
    const auto spacing = tubeSpacingUnits(geometry, Viewpoint{}, {}, 5);
    EXPECT_EQ(spacing[0], 13.0);
    EXPECT_EQ(spacing[1], 13.0);
}

TEST(TubeGrid, SharesTheExtentInUnitsNotInVoxelsAndKeepsItWhileTheViewTurns) {
    // 90 mm across y at a unit of 0.5 mm are 180 units, although there are 60 voxels.
    const auto geometry = gridOf({120, 60, 200}, {0.5, 1.5, 0.5});
    const Viewpoint straight, turned{.azimuthDegrees = 40, .elevationDegrees = -20, .rollDegrees = 10};
    for (const Viewpoint& view : {straight, turned}) {
        const auto spacing = tubeSpacingUnits(geometry, view, {}, 5);
        EXPECT_EQ(spacing[0], 8.0);
        EXPECT_EQ(spacing[1], 12.0);
    }
    EXPECT_EQ(tubeSpacingUnits(geometry, straight, {.spacing = 7.5}, 5)[0], 7.5);
    EXPECT_EQ(tubeSpacingUnits(gridOf({20, 20, 20}, {1, 1, 1}), straight, {}, 5)[0], 5.0) << "never less than a cell";
}

TEST(TubeGrid, LiesAcrossTheViewThroughTheCentreRowByRow) {
    const auto geometry = gridOf({100, 80, 60}, {0.4, 0.6, 0.9});
    const Viewpoint view{.beamAxis = BeamAxis::plusY, .azimuthDegrees = 25, .elevationDegrees = 15};
    const auto axes = tubeAxes(geometry, view, {.columns = 4, .rows = 3, .spacing = 10}, 5);
    ASSERT_EQ(axes.size(), 12u);
    const ViewFrame frame = frameOf(view);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        EXPECT_EQ(axes[i].column, static_cast<int>(i % 4));
        EXPECT_EQ(axes[i].row, static_cast<int>(i / 4));
        const Vec3 fromCentre = axes[i].pointMm - geometry.centreMm();
        EXPECT_NEAR(fromCentre.dot(frame.right), (axes[i].column - 1.5) * 10 * 0.4, 1e-12);
        EXPECT_NEAR(fromCentre.dot(frame.down), (axes[i].row - 1.0) * 10 * 0.4, 1e-12);
        EXPECT_NEAR(fromCentre.dot(frame.forward), 0.0, 1e-12);
        EXPECT_NEAR(length(axes[i].directionMm - frame.forward), 0.0, 1e-15);
    }
}

TEST(TubeGrid, AxisViewsOfCubicVoxelsRunThroughVoxelCentres) {
    for (const std::int64_t size : {50, 51}) {
        for (const int cellSize : {5, 4}) {
            const auto axes = tubeAxes(gridOf({size, size, size}, {0.3, 0.3, 0.3}), Viewpoint{}, {}, cellSize);
            for (const TubeAxis& axis : axes) {
                if (!axis.entryVoxel) continue;
                const double outermost = (*axis.entryVoxel)[0] - (cellSize - 1) / 2.0;
                EXPECT_NEAR(outermost, std::round(outermost), 1e-9);
                EXPECT_NEAR((*axis.entryVoxel)[2], -0.5, 1e-9);
                EXPECT_NEAR(*axis.lengthUnits, static_cast<double>(size), 1e-9);
            }
        }
    }
}

TEST(TubeGrid, EntersWhereThePictureBegins) {
    const auto geometry = gridOf({100, 100, 100}, {0.5, 0.5, 0.5});
    const Viewpoint cut = withFrontAcross({}, 10.0);
    for (const TubeAxis& axis : tubeAxes(geometry, cut, {}, 5)) {
        ASSERT_TRUE(axis.entryVoxel);
        EXPECT_NEAR((*axis.entryVoxel)[2], 19.5, 1e-9) << "20 voxels of 0.5 mm are cut off";
        EXPECT_NEAR(*axis.lengthUnits, 80.0, 1e-9);
    }
    const Viewpoint beyond = withFrontAcross({}, 60.0);
    for (const TubeAxis& axis : tubeAxes(geometry, beyond, {}, 5)) EXPECT_FALSE(axis.entryVoxel);
}

TEST(TubeGrid, ObliqueAxesEnterAndLeaveTheBox) {
    const auto geometry = gridOf({60, 80, 40}, {0.7, 0.5, 1.0});
    const Viewpoint view{.azimuthDegrees = 30, .elevationDegrees = 20};
    int inside = 0;
    for (const TubeAxis& axis : tubeAxes(geometry, view, {}, 5)) {
        if (!axis.entryVoxel) continue;
        ++inside;
        const Vec3 entryMm = geometry.gridMmFromVoxel(*axis.entryVoxel);
        const Vec3 exitMm = entryMm + axis.directionMm * (*axis.lengthUnits * geometry.unit());
        for (const Vec3& end : {entryMm, exitMm}) {
            double toFace = 1e9;
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(end[i], geometry.boxMinMm()[i] - 1e-9);
                EXPECT_LE(end[i], geometry.boxMaxMm()[i] + 1e-9);
                toFace = std::min({toFace, end[i] - geometry.boxMinMm()[i], geometry.boxMaxMm()[i] - end[i]});
            }
            EXPECT_NEAR(toFace, 0.0, 1e-9);
        }
        EXPECT_NEAR(length((entryMm - axis.pointMm).cross(axis.directionMm)), 0.0, 1e-9) << "on the axis";
    }
    EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace echolucent
