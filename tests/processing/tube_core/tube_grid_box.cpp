// Which tube cores, and how much of them, lie in a view's box.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/scene/box.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

TEST(TubeGridBox, CoversTheSideOfTheBoxThatFacesTheView) {
    const auto geometry = gridOf({100, 100, 100}, {0.5, 0.5, 0.5});
    for (const double azimuth : {0.0, 17.0}) {
        // Straight onto the box's top, and onto its near side with the top up.
        const Box box{
            .on = true, .direction = {.azimuth = azimuth, .roll = 8}, .centreMm = {22, 26, 30}, .sizeMm = {30, 15, 20}};
        const ViewFrame axesOfBox = orientedBoxOf(box, BeamAxis::plusZ).axes;
        for (const bool ontoTop : {true, false}) {
            Viewpoint view = ontoTop ? viewpointOf(BeamAxis::plusZ, box.direction)
                                     : viewAlong(-axesOfBox.down, axesOfBox.forward, BeamAxis::plusZ);
            view.box = orientedBoxOf(box, BeamAxis::plusZ);
            const double down = ontoTop ? 15 : 20, deep = ontoTop ? 20 : 15;
            const TubeGrid grid{.columns = 5, .rows = 3};
            const auto spacing = tubeSpacingUnits(geometry, view, grid, 4);
            EXPECT_EQ(spacing[0], 12.0) << "30 mm are 60 units";
            EXPECT_EQ(spacing[1], std::floor(2 * down / 3));
            const auto axes = tubeAxes(geometry, view, grid, 4);
            for (const TubeAxis& axis : axes) {
                ASSERT_TRUE(axis.entryVoxel);
                EXPECT_NEAR(*axis.lengthUnits, 2 * deep, 1e-9);
                const Vec3 entry = view.box->inBox(geometry.gridMmFromVoxel(*axis.entryVoxel));
                EXPECT_TRUE(view.box->contains(geometry.gridMmFromVoxel(*axis.entryVoxel) + axis.directionMm * 1e-9));
                EXPECT_NEAR(std::abs(ontoTop ? entry[2] : entry[1]), 0.5 * deep, 1e-9);
            }
            // Its middle axis passes through the box's centre (voxels are not moved to where axes are oblique).
            if (azimuth != 0.0) {
                const Vec3 across = axes[7].pointMm - view.box->centreMm;
                EXPECT_NEAR(length(across), 0.0, 1e-12);
            }
        }
    }
}

TEST(TubeGridBox, AnObliqueBoxGivesTheChordsOfItsOwnFrame) {
    const auto geometry = gridOf({90, 80, 70}, {0.5, 0.6, 0.7});
    Viewpoint view{.azimuthDegrees = 14, .elevationDegrees = -9};
    view.box =
        OrientedBox{geometry.centreMm(), frameOf(Viewpoint{.azimuthDegrees = 40, .elevationDegrees = 25}), {12, 16, 9}};
    int in = 0, out = 0;
    for (const TubeAxis& axis : tubeAxes(geometry, view, {.columns = 21, .rows = 21, .spacing = 2}, 4)) {
        // The chord by small steps.
        int inside = 0;
        constexpr double step = 0.005;
        for (double along = -20; along < 20; along += step)
            inside += view.box->contains(axis.pointMm + axis.directionMm * along) ? 1 : 0;
        const double length = axis.entryVoxel ? *axis.lengthUnits * geometry.unit() : 0.0;
        EXPECT_NEAR(length, inside * step, 2.1 * step);
        (axis.entryVoxel ? in : out) += 1;
    }
    EXPECT_GT(in, 50);
    EXPECT_GT(out, 50);
}

TEST(TubeGridBox, SamplesOfACoreStayWithinTheBoxAlongIt) {
    const auto geometry = gridOf({60, 60, 60}, {0.5, 0.5, 0.5});
    for (const double turn : {0.0, 21.0}) {
        Viewpoint view{.azimuthDegrees = turn};
        view.box = OrientedBox{{15, 14, 16}, frameOf(view), {14, 13, 7.3}};
        const auto axes = tubeAxes(geometry, view, {}, 5);
        const auto samples = samplesOf(axes, geometry, view, 5);
        int read = 0;
        for (std::size_t t = 0; t < axes.size(); ++t) {
            if (!axes[t].entryVoxel) continue;
            ASSERT_GE(samples[t].slabs, 14);
            for (const int slab : {0, samples[t].slabs - 1}) {
                const Vec3 place = view.box->inBox(geometry.gridMmFromVoxel(samples[t].onAxis(slab)));
                EXPECT_LE(std::abs(place[2]), 0.5 * 7.3 + 0.25) << "half a unit at most";
            }
            ++read;
        }
        EXPECT_GT(read, 20);
    }
}

TEST(TubeGridBox, ABoxOfTheWholeVolumeChangesNoBitOfTheAdaptiveOtf) {
    const Volume volume = *makePhantom(defaultPhantom(PhantomScene::fetus));
    for (const double azimuth : {0.0, 20.0}) {
        Viewpoint open, boxed;
        open.azimuthDegrees = boxed.azimuthDegrees = azimuth;
        boxed.box = orientedBoxOf(DataBox(volume.geometry()));
        const auto one = adaptOpacity(volume, open, {}), other = adaptOpacity(volume, boxed, {});
        ASSERT_GT(one->tubesWithWeight, 10);
        EXPECT_EQ(one->curve, other->curve);
        EXPECT_EQ(one->logOpacity, other->logOpacity);
        ASSERT_EQ(one->tubes.size(), other->tubes.size());
        for (std::size_t t = 0; t < one->tubes.size(); ++t)
            EXPECT_EQ(one->tubes[t].cellMeans, other->tubes[t].cellMeans);
    }
}

TEST(TubeGridBox, ABoxThatMissesEverythingIsMetByNoTubeCoreAndSaysSo) {
    const Volume volume = *makePhantom(defaultPhantom(PhantomScene::fetus));
    Viewpoint view;
    view.box = OrientedBox{{-500, 0, 0}, frameOf(Viewpoint{}), {5, 5, 5}};
    const auto otf = adaptOpacity(volume, view, {});
    EXPECT_EQ(otf->tubesMeetingVolume, 0);
    EXPECT_EQ(otf->message, "No tube core meets the volume's data: the initial function is used.");
}

}  // namespace
}  // namespace echolucent
