// What a view shows of a line: what lies in the volume, behind the front and within the box.
#include "processing/viewpoint/shown_stretch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace echolucent {
namespace {

VolumeGeometry cube() {
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    return geometry;
}

Vec3 beginOf(const Viewpoint& view, const Vec3& point) {
    return point + frameOf(view).forward * ShownStretches(view, cube()).of(point)->begin;
}
Vec3 endOf(const Viewpoint& view, const Vec3& point) {
    return point + frameOf(view).forward * ShownStretches(view, cube()).of(point)->end;
}

TEST(ShownStretches, ReachThroughTheVolumesBox) {
    const ShownStretches shown({}, cube());
    EXPECT_EQ(shown.of({3, 4, 5}), (CutSurface::Stretch{-5.5, 34.5}));
    EXPECT_EQ(shown.of({3, 4, -7}), (CutSurface::Stretch{6.5, 46.5}));
    EXPECT_FALSE(shown.of({40, 4, 5})) << "beside the volume";
    const Viewpoint turned{.azimuthDegrees = 45};
    EXPECT_NEAR(beginOf(turned, {10, 4, 5})[2], -0.5, 1e-12);
    EXPECT_NEAR(endOf(turned, {10, 4, 5})[0], 39.5, 1e-12);
}

TEST(ShownStretches, LieBehindAFlatFront) {
    Viewpoint view = withFrontAcross({}, 10.5);  // the plane z = 10
    EXPECT_EQ(ShownStretches(view, cube()).of({3, 4, 5}), (CutSurface::Stretch{5.0, 34.5}));
    view.azimuthDegrees = 30;  // forward is (1/2, 0, sqrt(3)/2)
    for (const Vec3& point : {Vec3(3, 4, 5), Vec3(20, 0, 30), Vec3(20, 1, -7)})
        EXPECT_NEAR(beginOf(view, point)[2], 10.0, 1e-12);
    view.azimuthDegrees = 120;  // comes from behind
    EXPECT_NEAR(beginOf(view, {5, 4, 20})[0], -0.5, 1e-12);
    EXPECT_NEAR(endOf(view, {5, 4, 20})[2], 10.0, 1e-12);
    view.azimuthDegrees = 90;  // runs along it
    EXPECT_TRUE(ShownStretches(view, cube()).of({3, 4, 11}));
    EXPECT_FALSE(ShownStretches(view, cube()).of({3, 4, 9}));
    EXPECT_FALSE(ShownStretches(withFrontAcross({}, 60), cube()).of({3, 4, 5})) << "nothing is left";
}

TEST(ShownStretches, LieBehindABowedFrontAndWithinTheBox) {
    Viewpoint view;
    view.cutSurface = CutSurface{.frame = frameOf(Viewpoint{}),
                                 .firstRightMm = 0,
                                 .firstDownMm = 0,
                                 .spacingMm = 20,
                                 .columns = 2,
                                 .rows = 2,
                                 .depthMm = {8.0f, 18.0f, 8.0f, 18.0f}};  // deeper to the right
    EXPECT_NEAR(beginOf(view, {4, 5, 0})[2], 10.0, 1e-6);
    EXPECT_NEAR(beginOf(view, {16, 5, 30})[2], 16.0, 1e-6);
    view.box = OrientedBox{.centreMm = {20, 20, 15}, .sizeMm = {40, 40, 8}};  // from 11 to 19 along z
    EXPECT_NEAR(beginOf(view, {4, 5, 0})[2], 11.0, 1e-6);
    EXPECT_NEAR(beginOf(view, {16, 5, 0})[2], 16.0, 1e-6);
    EXPECT_NEAR(endOf(view, {16, 5, 0})[2], 19.0, 1e-12);
    view.box->centreMm[2] = 5;  // ends at 9, before the front
    EXPECT_FALSE(ShownStretches(view, cube()).of({16, 5, 0}));
}

}  // namespace
}  // namespace echolucent
