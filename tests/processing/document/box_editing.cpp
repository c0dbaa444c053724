// What a person's hand makes of the render box, of slabs and of the surface that the picture begins at.
#include "processing/document/box_editing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "processing/viewpoint/box_section.h"
#include "tests/processing/scene/places.h"

namespace echolucent {
namespace {

Volume even() {
    VolumeGeometry geometry;
    geometry.size = {40, 30, 80};
    return {geometry, Voxels(std::vector<std::uint8_t>(40 * 30 * 80, 90)), 255.0};
}

OrientedBox oblique() {
    return orientedBoxOf({.on = true, .direction = {25, -35, 15}, .centreMm = {1, 2, 3}, .sizeMm = {40, 50, 60}},
                         BeamAxis::plusX);
}

TEST(BoxSection, EveryCornerLiesInThePlaneAndOnTwoFaces) {
    const OrientedBox box = oblique();
    for (const Vec3& normal : {normalized({1, 2, 3}), normalized({-3, 1, 0.2}), box.axes.down}) {
        const BoxSection section = sectionOf(box, {4, 5, 6}, normal);
        const std::size_t count = section.corners.size();
        ASSERT_GE(count, 3u);
        ASSERT_EQ(section.faces.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(normal.dot(section.corners[i] - Vec3(4, 5, 6)), 0.0, 1e-9);
            for (const std::size_t corner : {i, (i + 1) % count}) {
                const BoxFace& face = section.faces[i];
                EXPECT_NEAR(outwardNormal(box, face).dot(section.corners[corner] - middleOf(box, face)), 0.0, 1e-9);
            }
        }
    }
    EXPECT_TRUE(sectionOf(box, {500, 0, 0}, {1, 0, 0}).corners.empty());
    EXPECT_EQ(sectionOf(box, box.centreMm, box.axes.forward).corners.size(), 4u);
}

TEST(BoxSection, AMovedFaceLeavesTheOppositeOneInPlaceAndTheBoxThickEnough) {
    const OrientedBox box = oblique();
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const BoxFace face{axis, sign}, opposite{axis, -sign};
            const OrientedBox larger = withFaceMoved(box, face, 7, 1);
            EXPECT_LT(apart(middleOf(larger, opposite), middleOf(box, opposite)), 1e-12);
            EXPECT_LT(apart(middleOf(larger, face), middleOf(box, face) + outwardNormal(box, face) * 7), 1e-12);
            const OrientedBox least = withFaceMoved(box, face, -1000, 1);
            EXPECT_NEAR(least.sizeMm[axis], 1.0, 1e-12);
            EXPECT_LT(apart(middleOf(least, opposite), middleOf(box, opposite)), 1e-12);
        }
}

TEST(BoxEditing, ATurnKeepsTheCentreAndAMoveKeepsTheBitsOfTheTurn) {
    const Box box{.on = true, .direction = {25, -35, 15}, .centreMm = {1, 2, 3}, .sizeMm = {40, 50, 60}};
    OrientedBox shifted = orientedBoxOf(box, BeamAxis::minusY);
    shifted.centreMm += Vec3(1, 0, 0);
    EXPECT_TRUE(movedBox(box, shifted, BeamAxis::minusY).direction == box.direction);
    const OrientedBox turned = turnedAbout(oblique(), oblique().axes.right, 30);
    EXPECT_EQ(problemOf(turned.axes), "");
    EXPECT_LT(apart(turned.centreMm, oblique().centreMm), 1e-12);
    EXPECT_LT(apart(turned.axes.right, oblique().axes.right), 1e-12);
    EXPECT_NEAR(turned.axes.down.dot(oblique().axes.down), std::cos(30 * M_PI / 180), 1e-12);
    EXPECT_NEAR(turned.axes.down.dot(oblique().axes.forward), 0.5, 1e-12) << "from down towards forward";
    const Box told = movedBox(Box{.on = true}, turned, BeamAxis::plusX);
    EXPECT_LT(apart(orientedBoxOf(told, BeamAxis::plusX).axes.down, turned.axes.down), 1e-9);
}

TEST(BoxEditing, ABoxOnlyLimits) {
    Document document;
    document.scene.side = {.azimuth = 90};
    document.scene.pose.direction = {.elevation = 20};
    const Document on = withBoxSwitched(document, true, dataOfPlaces);
    EXPECT_TRUE(on.scene.box.on);
    Document rest = on;
    rest.scene.box = document.scene.box;
    EXPECT_TRUE(rest == document) << "tube cores and picture look as before";
    EXPECT_TRUE(withBoxSwitched(on, false, dataOfPlaces).scene.side == document.scene.side);
}

TEST(BoxEditing, ASwitchedOffBoxKeepsItsPlace) {
    Document document;
    document.scene.box = {.on = true, .centreMm = {9, 8, 7}, .sizeMm = {3, 4, 5}};
    const Document off = withBoxSwitched(document, false, dataOfPlaces);
    EXPECT_FALSE(otfViewpointOf(off, firstPane).box);
    EXPECT_TRUE(withBoxSwitched(off, true, dataOfPlaces) == withBoxSwitched(document, true, dataOfPlaces));
}

TEST(BoxEditing, ASlabLiesAroundItsPlaneAndIsSeenAsThePlaneIs) {
    Document document;
    document.beam.axis = BeamAxis::plusX;
    document.scene.planes = {.direction = {10, 20, 30}, .offsetMm = {1, 2, 3}};
    document.scene.front.depthMm = 9;
    for (const PlaneName plane : allPlaneNames) {
        const Document next = withSlab(document, plane, 4, dataOfPlaces);
        const OrientedBox box = orientedBoxOf(next.scene.box, BeamAxis::plusX);
        const ViewFrame seen = frameOf(plane, document.scene.planes, BeamAxis::plusX);
        EXPECT_EQ(box.sizeMm[2], 4.0);
        EXPECT_NEAR(seen.forward.dot(box.centreMm - referencePointOf(document.scene.planes, dataOfPlaces)), 0.0, 1e-9);
        EXPECT_LT(apart(frameOf(viewpointOf(next)).forward, seen.forward), 1e-9);
        EXPECT_LT(apart(frameOf(viewpointOf(next)).down, seen.down), 1e-9);
        EXPECT_EQ(next.scene.front.depthMm, 0.0) << "a slab behind a cut would be cut away";
    }
}

TEST(BoxEditing, TheSurfaceOfAFlatFrontLiesWhereTheFrontDoes) {
    Document document;
    const Volume volume = even();
    const auto depthAtCentre = [&](const Document& of) {
        const CutSurface surface = surfaceOfFront(of, volume);
        EXPECT_EQ(problemOf(surface), "");
        return surface.depthAt(volume.geometry().centreMm());
    };
    document.scene.front = frontAcross({}, 12);
    EXPECT_NEAR(depthAtCentre(document), 11.5, 1e-6);
    Document boxed = withBoxSwitched(document, true, volume.dataBox());
    boxed.scene.box.sizeMm[2] = 20;
    EXPECT_NEAR(depthAtCentre(boxed), 11.5, 1e-6) << "also if the box begins behind it";
    document.scene.side = {40, 0, 0};
    EXPECT_EQ(surfaceOfFront(document, volume).frame.forward, Vec3(0, 0, 1)) << "whatever the side";
    const CutSurface own = bowed(surfaceOfFront(document, volume), 3);
    document.scene.front = {.surface = own};
    EXPECT_TRUE(surfaceOfFront(document, volume) == own);
}

TEST(BoxEditing, ABowIsDeepestInTheMiddleAndLeavesTheBorder) {
    Document document;
    document.scene.front = frontAcross({}, 3);
    const Volume volume = even();
    const CutSurface flat = surfaceOfFront(document, volume), surface = bowed(flat, 5);
    const Vec3 centre = volume.geometry().centreMm();
    EXPECT_NEAR(surface.depthAt(centre) - flat.depthAt(centre), 5 * bowAt(flat, centre), 0.05);
    EXPECT_GT(bowAt(flat, centre), 0.99);
    const Vec3 border = centre + surface.frame.right * (surface.spacingMm * (surface.columns - 1) / 2.0);
    EXPECT_NEAR(surface.depthAt(border), flat.depthAt(border), 1e-6);
    EXPECT_TRUE(bowed(surface, -5).frame == flat.frame);
}

TEST(BoxSection, BoxesMeetWhereTheyHaveAPlaceInCommon) {
    const DataBox scan({0, 0, 0}, {10, 8, 6});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-8, 18), size(0.5, 9), angle(-180, 180);
    int together = 0, apart = 0;
    for (int i = 0; i < 400; ++i) {
        const OrientedBox box{{place(random), place(random), place(random)},
                              frameOf(Viewpoint{BeamAxis::plusZ, angle(random), angle(random) / 2, angle(random)}),
                              {size(random), size(random), size(random)}};
        // Places all through the box, and all through a box a hair larger: the truth lies between the two.
        const auto hasPlaceInData = [&](double factor) {
            OrientedBox scaled = box;
            scaled.sizeMm = box.sizeMm * factor;
            constexpr int steps = 24;
            for (int n = 0; n < steps * steps * steps; ++n) {
                const int column = n % steps, row = n / steps % steps, slice = n / steps / steps;
                const Vec3 share(column, row, slice);
                const Vec3 at = scaled.inGrid((share * (1.0 / (steps - 1)) - Vec3(0.5, 0.5, 0.5)).mul(scaled.sizeMm));
                if (at[0] >= 0 && at[0] <= 10 && at[1] >= 0 && at[1] <= 8 && at[2] >= 0 && at[2] <= 6) return true;
            }
            return false;
        };
        if (hasPlaceInData(1.0)) {
            EXPECT_TRUE(meets(box, scan));
            ++together;
        } else if (!hasPlaceInData(1.2)) {
            EXPECT_FALSE(meets(box, scan));
            ++apart;
        }
    }
    EXPECT_GT(together, 50);
    EXPECT_GT(apart, 50);
}

TEST(BoxEditing, AnotherBeamLeavesTheFrontInItsPlace) {
    Document document;
    document.scene.front = frontAcross({15, -20, 0}, 9);
    const Document turned = withBeam(document, {BeamAxis::minusY, BeamSource::person});
    EXPECT_LT(
        length(forwardOf(turned.scene.front, BeamAxis::minusY) - forwardOf(document.scene.front, BeamAxis::plusZ)),
        1e-12);
    EXPECT_EQ(turned.scene.front.depthMm, 9);
}

}  // namespace
}  // namespace echolucent
