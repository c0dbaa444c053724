// The curved cut: its depth, what it cuts away, where rays and tube cores begin behind it.
#include "processing/viewpoint/cut_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "processing/sampling/sampler.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {
namespace {

/// A surface whose depth is a function of the places along right and down, mm.
template <typename Depth>
CutSurface surfaceOf(const Viewpoint& view, const Depth& depth) {
    CutSurface surface{frameOf(view), -3.0, -7.0, 2.5, 17, 21, {}};
    for (int row = 0; row < surface.rows; ++row)
        for (int column = 0; column < surface.columns; ++column)
            surface.depthMm.push_back(static_cast<float>(depth(surface.firstRightMm + column * surface.spacingMm,
                                                               surface.firstDownMm + row * surface.spacingMm)));
    return surface;
}

double bowl(double right, double down) { return 14.0 + 3.0 * std::sin(right / 4.0) - 2.0 * std::cos(down / 5.0); }

const Viewpoint obliqueView{
    .beamAxis = BeamAxis::minusY, .azimuthDegrees = 20, .elevationDegrees = -35, .rollDegrees = 10};

TEST(CutSurface, IsExactForWhatIsBilinear) {
    const auto depth = [](double right, double down) { return 5.0 + 0.5 * right - 0.25 * down + 0.125 * right * down; };
    const CutSurface surface = surfaceOf(obliqueView, depth);
    const ViewFrame& frame = surface.frame;
    for (double right = -3.0; right <= 37.0; right += 1.3)
        for (double down = -7.0; down <= 43.0; down += 1.7) {
            const Vec3 place = frame.right * right + frame.down * down;
            EXPECT_NEAR(surface.depthAt(place + frame.forward * 100.0), depth(right, down), 1e-4);
            EXPECT_TRUE(surface.cutsAway(place + frame.forward * (depth(right, down) - 0.01)));
            EXPECT_FALSE(surface.cutsAway(place + frame.forward * (depth(right, down) + 0.01)));
        }
}

TEST(CutSurface, GoesOnAtTheDepthOfItsEdges) {
    const CutSurface surface = surfaceOf({}, bowl);
    EXPECT_EQ(surface.depthAt({-50, -50, 0}), surface.depthMm.front());
    EXPECT_EQ(surface.depthAt({500, 500, 0}), surface.depthMm.back());
    EXPECT_EQ(surface.depthAt({-50, -7.0 + 2 * 2.5, 0}), surface.depthMm[2 * 17]);
}

/// Marches along a line in small steps: the first stretch of places that are not cut away.
std::optional<CutSurface::Stretch> marched(const CutSurface& surface, const Vec3& point, const Vec3& direction,
                                           const CutSurface::Stretch& within, double step) {
    std::optional<CutSurface::Stretch> found;
    for (double mm = within.begin; mm <= within.end; mm += step) {
        const bool away = surface.cutsAway(point + direction * mm);
        if (!found && !away) found = {mm, within.end};
        if (found && away) {
            found->end = mm;
            break;
        }
    }
    return found;
}

TEST(CutSurface, LinesFromAnywhereBeginWhereMarchingFindsIt) {
    const CutSurface surface = surfaceOf(obliqueView, bowl);
    const Vec3 middle =
        surface.frame.right * 17.0 + surface.frame.down * 18.0 + surface.frame.forward * bowl(17.0, 18.0);
    constexpr double step = 0.02;
    int begun = 0, ended = 0, missed = 0;
    for (double azimuth = -180; azimuth < 180; azimuth += 23)
        for (double elevation = -85; elevation <= 85; elevation += 17) {
            const ViewFrame view = frameOf({.azimuthDegrees = azimuth, .elevationDegrees = elevation});
            for (const double aside : {-9.0, 0.0, 6.0}) {
                const Vec3 point = middle + view.right * aside;
                const CutSurface::Stretch within{-40.0, 45.0};
                const auto left = surface.firstLeft(point, view.forward, within);
                const auto expected = marched(surface, point, view.forward, within, step);
                ASSERT_EQ(left.has_value(), expected.has_value());
                if (!left) {
                    ++missed;
                    continue;
                }
                // A line that touches the surface for less than a step is seen by one of the two only.
                EXPECT_NEAR(left->begin, expected->begin, 2 * step) << azimuth << " " << elevation << " " << aside;
                EXPECT_NEAR(left->end, expected->end, 2 * step) << azimuth << " " << elevation << " " << aside;
                begun += left->begin > within.begin;
                ended += left->end < within.end;
            }
        }
    EXPECT_GT(begun, 50);
    EXPECT_GT(ended, 50);
    EXPECT_EQ(surface.firstLeft(middle, surface.frame.forward, {-40.0, -0.5}), std::nullopt);
    std::printf("%d begin at the surface, %d end at it, %d miss what is left\n", begun, ended, missed);
}

VolumeGeometry boxGeometry() {
    VolumeGeometry geometry;
    geometry.size = {60, 70, 50};
    geometry.spacing = {0.5, 0.5, 0.5};
    return geometry;
}

double behindMm(const CutSurface& surface, const Vec3& place) {
    return surface.frame.forward.dot(place) - surface.depthAt(place);
}

TEST(CutSurface, TubeCoresBeginBehindItWhicheverWayTheyLook) {
    const VolumeGeometry geometry = boxGeometry();
    for (const Viewpoint& along :
         {Viewpoint{}, Viewpoint{.azimuthDegrees = 15}, Viewpoint{.beamAxis = BeamAxis::minusZ}}) {
        Viewpoint view = along;
        view.cutSurface = surfaceOf({}, bowl);
        const auto axes = tubeAxes(geometry, view, {}, 5), uncut = tubeAxes(geometry, along, {}, 5);
        const auto samples = samplesOf(axes, geometry, view, 5);
        int cut = 0;
        for (std::size_t t = 0; t < axes.size(); ++t) {
            if (samples[t].slabs == 0) continue;
            const Vec3 last = samples[t].onAxis(samples[t].slabs - 1);
            for (const Vec3& end : {samples[t].first, last})
                EXPECT_GE(behindMm(*view.cutSurface, geometry.gridMmFromVoxel(end)), -1e-6);
            const bool seenFromBehind = along.beamAxis == BeamAxis::minusZ;
            const Vec3 beyond = samples[t].onAxis(seenFromBehind ? samples[t].slabs : -1);
            if (inBox(geometry, beyond)) {
                EXPECT_LE(behindMm(*view.cutSurface, geometry.gridMmFromVoxel(beyond)), 1e-6) << "a sample is left out";
            }
            cut += *axes[t].lengthUnits < *uncut[t].lengthUnits;
        }
        EXPECT_GT(cut, 100);
    }
}

TEST(CutSurface, OfTwoCutsTheDeeperCounts) {
    const VolumeGeometry geometry = boxGeometry();
    Viewpoint view = withFrontAcross({}, 14.25);
    const auto flat = tubeAxes(geometry, view, {}, 5);
    view.cutSurface = surfaceOf({}, bowl);
    const auto both = tubeAxes(geometry, view, {}, 5);
    int curvedIsDeeper = 0;
    for (std::size_t t = 0; t < both.size(); ++t) {
        if (!both[t].entryVoxel) continue;
        const double surface = view.cutSurface->depthAt(both[t].pointMm), plane = 14.0;  // the box begins at -0.25 mm
        EXPECT_NEAR(geometry.gridMmFromVoxel(*both[t].entryVoxel)[2], std::max(surface, plane), 1e-9);
        curvedIsDeeper += *both[t].entryVoxel != *flat[t].entryVoxel;
    }
    EXPECT_GT(curvedIsDeeper, 20);
    EXPECT_LT(curvedIsDeeper, 100);
}

TEST(CutSurface, SaysWhatIsWrongWithIt) {
    const CutSurface right = surfaceOf(obliqueView, bowl);
    EXPECT_EQ(problemOf(right), "");
    const auto wrong = [&](const auto& change) {
        CutSurface surface = right;
        change(surface);
        return problemOf(surface);
    };
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(problemOf(CutSurface{}), "has a frame that is not right-handed and orthonormal");
    EXPECT_EQ(wrong([](CutSurface& s) { s.frame.right = -s.frame.right; }),
              "has a frame that is not right-handed and orthonormal");
    EXPECT_EQ(wrong([&](CutSurface& s) { s.firstDownMm = infinite; }), "has a first node whose place is not finite");
    EXPECT_EQ(wrong([](CutSurface& s) { s.spacingMm = 0; }), "has a spacing that is not above 0");
    EXPECT_EQ(wrong([](CutSurface& s) { s.spacingMm = std::nan(""); }), "has a spacing that is not above 0");
    EXPECT_EQ(wrong([](CutSurface& s) { s.columns = 1; }), "has fewer than 2 columns");
    EXPECT_EQ(wrong([](CutSurface& s) { s.rows = -4; }), "has fewer than 2 rows");
    EXPECT_EQ(wrong([](CutSurface& s) { s.rows = 5000; }), "has more than 4096 columns or rows");
    EXPECT_EQ(wrong([](CutSurface& s) { s.depthMm = {1, 2, 3}; }), "does not have one depth for each node");
    EXPECT_EQ(wrong([](CutSurface& s) { s.depthMm.change([](auto& depths) { depths[3] = std::nanf(""); }); }),
              "has a depth that is not finite");
}

}  // namespace
}  // namespace echolucent
