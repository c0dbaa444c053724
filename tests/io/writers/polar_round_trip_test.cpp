// Simulated scans that are sampled along beams, written, read and converted: the scene comes back where it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "kretz_files.h"
#include "processing/phantom/phantom.h"
#include "processing/phantom/polar_sampling.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

/// By how much a position lies within the insonified region, as differences of mm and of tangents; below 0 outside.
/// Written for fields that are symmetric and narrower than half a turn, with tangents instead of angles.
double insideBy(const EvenPolar& even, double rangeEndMm, const Vec3& mm) {
    const auto degrees = [](double angle) { return angle * std::numbers::pi / 180; };
    double margin = 1e9, along = mm[2], range = 0;
    if (turnsPlanes(even.kind)) {
        const double depth = mm[2] + even.planeRadiusMm;
        margin = std::min(margin, depth * std::tan(degrees(even.planes[1])) - std::abs(mm[1]));
        along = std::sqrt(mm[1] * mm[1] + depth * depth) - even.planeRadiusMm;
    } else {
        margin = std::min(margin, even.planes[1] - std::abs(mm[1]));
    }
    range = along;
    if (turnsLines(even.kind)) {
        const double depth = along + even.lineRadiusMm;
        margin = std::min(margin, depth * std::tan(degrees(even.lines[1])) - std::abs(mm[0]));
        range = std::sqrt(mm[0] * mm[0] + depth * depth) - even.lineRadiusMm;
    } else {
        margin = std::min(margin, even.lines[1] - std::abs(mm[0]));
    }
    return std::min({margin, range - even.rangeStartMm, rangeEndMm - range});
}

/// Every third voxel along z under a sanitizer.
template <typename Use>
void forEachVoxel(const std::array<std::int64_t, 3>& size, const Use& use) {
    for (std::int64_t z = 0; z < size[2]; z += takesSomeInputs ? 3 : 1)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) use(std::array{x, y, z});
}

Vec3 vectorOf(const std::array<std::int64_t, 3>& voxel) {
    return {static_cast<double>(voxel[0]), static_cast<double>(voxel[1]), static_cast<double>(voxel[2])};
}

/// How far surfaces lie from where the scene has them.
struct SurfaceDistances {
    std::int64_t count = 0, beyondHalfAVoxel = 0;
    double largest = 0;  ///< voxels
};

/// Every place where the echo passes the middle between fluid and object from one voxel to the next along an axis.
/// Along the surface's normal the echo of the scene changes by the contrast within a ramp of so many voxels, which
/// turns its echo there into a distance.
SurfaceDistances surfaceDistances(const Volume& volume, const PhantomConfig& config) {
    const VolumeGeometry& geometry = volume.geometry();
    const PhantomTruth truth(config);
    const double middle = 0.5 * (config.fluid + config.object);
    const double perVoxel = (config.object - config.fluid) / config.ramp;
    SurfaceDistances distances;
    forEachVoxel(geometry.size, [&](const std::array<std::int64_t, 3>& voxel) {
        const std::int64_t offset = geometry.offset(voxel[0], voxel[1], voxel[2]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::array<std::int64_t, 3> before = voxel;
            if (--before[axis] < 0) continue;
            const std::int64_t beforeOffset = geometry.offset(before[0], before[1], before[2]);
            if (!volume.hasData(offset) || !volume.hasData(beforeOffset)) continue;
            const double here = volume.storedValue(offset), there = volume.storedValue(beforeOffset);
            if ((here > middle) == (there > middle)) continue;
            const double share = (middle - there) / (here - there);
            const Vec3 crossing =
                geometry.gridMmFromVoxel(vectorOf(before) + share * (vectorOf(voxel) - vectorOf(before)));
            const double distance = std::abs(truth.echoAt(crossing) - middle) / perVoxel;
            ++distances.count;
            distances.beyondHalfAVoxel += distance > 0.5 ? 1 : 0;
            distances.largest = std::max(distances.largest, distance);
        }
    });
    return distances;
}

void expectScene(const Volume& volume, const ConversionGrid& grid, const PhantomConfig& config, const EvenPolar& even,
                 double rangeEndMm, const std::string& name) {
    ASSERT_EQ(volume.geometry().size, grid.geometry.size) << name;
    EXPECT_NEAR(volume.geometry().spacing[0], grid.geometry.spacing[0], 1e-9);
    std::int64_t wrongMask = 0, data = 0;
    forEachVoxel(grid.geometry.size, [&](const std::array<std::int64_t, 3>& voxel) {
        const bool hasData = volume.hasData(volume.geometry().offset(voxel[0], voxel[1], voxel[2]));
        const double margin = insideBy(even, rangeEndMm, grid.probeMmFromVoxel(vectorOf(voxel)));
        data += hasData ? 1 : 0;
        // What lies on the border may fall to either side.
        if (std::abs(margin) > 1e-5 && hasData != (margin > 0)) ++wrongMask;
    });
    EXPECT_EQ(wrongMask, 0) << name;
    EXPECT_GT(data, 100000) << name;
    const SurfaceDistances distances = surfaceDistances(volume, config);
    std::printf("[ surfaces ] %s: %lld crossings, %.3f %% beyond half a voxel, the largest distance is %.2f voxels\n",
                name.c_str(), static_cast<long long>(distances.count),
                100.0 * static_cast<double>(distances.beyondHalfAVoxel) / static_cast<double>(distances.count),
                distances.largest);
    EXPECT_GT(distances.count, 1500) << name;
    EXPECT_LE(distances.beyondHalfAVoxel, distances.count / 1000) << name;
    EXPECT_LT(distances.largest, 1.0) << name;
}

TEST(PolarRoundTrip, SurfacesAndMaskAreThoseOfTheScene) {
    const TemporaryFolder folder;
    PhantomConfig scene = defaultPhantom(PhantomScene::shapes);
    scene.speckle = 0;
    scene.gainVariation = 0;
    scene.ramp = 4;
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler}) {
        if (takesSomeInputs && kind != PolarKind::wobbler) continue;
        EvenPolar even = usualPolar(kind, 101, 0.8);
        const PolarGeometry polar = polarGeometry(even, {101, 121, 111});
        const ConversionGrid grid = conversionGrid(polar);
        const PhantomConfig config = configOnGrid(scene, grid);
        const auto voxels = std::get<VoxelArray<std::uint8_t>>(*makePolarPhantom(config, polar, grid)).toVector();
        const std::string name(nameOf(kind));
        RawLayout layout{.size = polar.size()};
        layout.polar = polar;
        const std::string raw = folder.write("v.raw", bytesFrom(voxels));
        ASSERT_TRUE(rememberRawLayout(raw, layout));
        const auto study = readStudy(raw);
        ASSERT_TRUE(study) << study.error().sentence();
        expectScene(*study->phases.front(), grid, config, even, polar.rangeEndMm(), name + ", raw");
        if (kind != PolarKind::wobbler) continue;
        ASSERT_TRUE(writeKretz(folder.file("v.vol"), polar, {voxels, voxels}));
        const auto kretz = readStudy(folder.file("v.vol"));
        ASSERT_TRUE(kretz) << kretz.error().sentence();
        ASSERT_EQ(kretz->phases.size(), 2U);
        expectScene(*kretz->phases.back(), grid, config, even, polar.rangeEndMm(), name + ", Kretz");
    }
}

}  // namespace
}  // namespace echolucent
