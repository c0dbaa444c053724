// What strokes leave of volumes: the plain definition, voxel by voxel, and lists of strokes that grow and shrink.
#include "processing/scalpel/scalpel_cuts.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "processing/intensity/no_data.h"
#include "processing/picture/camera_pose.h"
#include "processing/picture/picture_place.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

Volume noise(std::array<std::int64_t, 3> size, Vec3 spacing) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    std::mt19937 random(5);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::uint8_t& voxel : voxels) voxel = static_cast<std::uint8_t>(random() % 256);
    return Volume(geometry, std::move(voxels));
}

Camera cameraOf(const Volume& volume, const Viewpoint& view, Projection projection) {
    return cameraFor(fittedPose(volume.dataBox(), view, projection, 1.0));
}

std::vector<PicturePlace> wobblyOutline(int places, double size) {
    std::vector<PicturePlace> outline;
    for (int i = 0; i < places; ++i) {
        const double angle = 2 * std::numbers::pi * i / places, radius = size * (1 + 0.3 * std::sin(5 * angle));
        outline.push_back({0.05 + radius * std::cos(angle), -0.03 + radius * std::sin(angle)});
    }
    return outline;
}

std::vector<ScalpelStroke> strokesUnder(const Camera& camera) {
    const double middle = camera.frame.forward.dot(camera.focalPoint);
    std::vector<ScalpelStroke> strokes{
        {.camera = camera, .places = wobblyOutline(400, 0.2)},
        {.tool = ScalpelTool::polygon,
         .camera = camera,
         .places = {{0, -0.4}, {0.235, 0.324}, {-0.38, -0.124}, {0.38, -0.124}, {-0.235, 0.324}}},
        {.tool = ScalpelTool::box, .camera = camera, .places = {{-0.3, -0.2}, {0.1, -0.2}, {0.1, 0.25}, {-0.3, 0.25}}},
        {.tool = ScalpelTool::polygon, .camera = camera, .places = {{-0.2, 0.1}, {0.3, 0.1}, {0.05, 0.1}}},
    };
    const std::size_t outlines = strokes.size();
    for (std::size_t i = 0; i < outlines; ++i) {
        strokes.push_back(strokes[i]);
        strokes.back().side = ScalpelSide::outside;
        strokes.push_back(strokes[i]);
        strokes.back().depthMm = middle + 1.7;
    }
    const auto erase = [&](std::vector<PicturePlace> line, double radius) {
        strokes.push_back({.tool = ScalpelTool::eraser, .camera = camera, .places = std::move(line), .radius = radius});
    };
    erase({{0.1, -0.05}}, 0.12);
    erase({{0.1, -0.05}, {0.1, -0.05}, {-0.3, 0.2}}, 0.01);
    erase(wobblyOutline(300, 0.3), 0.06);
    erase({{-5, 0.2}, {5, 0.2}}, 0.05);
    strokes.back().depthMm = middle;
    return strokes;
}

void expectAgreement(const Volume& volume, const ScalpelStroke& stroke, const char* what) {
    ScalpelCuts cuts(volume.geometry());
    const auto cut = cuts.cut(volume, {&stroke, 1});
    ASSERT_TRUE(cut);
    const VolumeGeometry& geometry = volume.geometry();
    std::size_t apart = 0, away = 0;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const Vec3 voxel(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                const bool plain = cutsAway(stroke, geometry.gridMmFromVoxel(voxel));
                apart += cut->hasData(geometry.offset(x, y, z)) == plain ? 1 : 0;
                away += plain ? 1 : 0;
            }
    EXPECT_EQ(apart, 0U) << what << ", " << nameOf(stroke.tool) << ' ' << nameOf(stroke.side) << ", " << away << " of "
                         << geometry.voxelCount() << " cut";
}

TEST(ScalpelCuts, AgreeWithThePlainDefinitionAtEveryVoxel) {
    const Volume volume = noise({37, 45, 31}, {0.7, 0.4, 1.3});
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 33, .elevationDegrees = -21},
                                      Viewpoint{.beamAxis = BeamAxis::plusX, .rollDegrees = 12}}) {
            if (takesSomeInputs && projection == Projection::parallel) continue;
            const Camera camera = cameraOf(volume, view, projection);
            for (const ScalpelStroke& stroke : strokesUnder(camera))
                expectAgreement(volume, stroke, projection == Projection::parallel ? "parallel" : "perspective");
        }
}

TEST(ScalpelCuts, AgreeWhereOutlinesRunThroughVoxelCentres) {
    // One voxel a mm, the picture 32 mm high: the outline's corners and sides lie on voxel centres exactly.
    const Volume volume = noise({33, 33, 33}, {1, 1, 1});
    const Camera camera{{16, 16, 16}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Projection::parallel, 32, 30, 100};
    for (const ScalpelSide side : {ScalpelSide::inside, ScalpelSide::outside})
        for (const std::optional<double> depth : {std::optional<double>{}, std::optional(16.0)}) {
            expectAgreement(volume,
                            {.side = side,
                             .camera = camera,
                             .places = {{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}},
                             .depthMm = depth},
                            "square");
            expectAgreement(volume,
                            {.side = side,
                             .camera = camera,
                             .places = {{0, -0.375}, {0.375, 0}, {0, 0.375}, {-0.375, 0}},
                             .depthMm = depth},
                            "diamond");
        }
    expectAgreement(volume,
                    {.tool = ScalpelTool::eraser, .camera = camera, .places = {{0, 0}, {0.25, 0}}, .radius = 0.125},
                    "eraser");
}

TEST(ScalpelCuts, InPerspectiveAnEyeWithinTheVolumeCutsOnlyWhatItSees) {
    const Volume volume = noise({24, 24, 24}, {1, 1, 1});
    Camera camera = cameraOf(volume, {.azimuthDegrees = 20}, Projection::perspective);
    camera.distanceMm = 4.0;
    for (const ScalpelStroke& stroke : strokesUnder(camera)) expectAgreement(volume, stroke, "eye within");
}

TEST(ScalpelCuts, RandomStrokesAgree) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-0.6, 0.6), angle(-180, 180);
    const Volume volume = noise({21, 18, 25}, {0.9, 1.1, 0.6});
    for (int round = 0; round < 200; ++round) {
        const Camera camera = cameraOf(
            volume,
            {.azimuthDegrees = angle(random), .elevationDegrees = angle(random) / 2, .rollDegrees = angle(random)},
            round % 2 == 0 ? Projection::parallel : Projection::perspective);
        ScalpelStroke stroke{.camera = camera};
        for (int i = 0; i < 3 + round % 17; ++i) stroke.places.push_back({place(random), place(random)});
        if (round % 3 == 0) {
            stroke.tool = ScalpelTool::eraser;
            stroke.radius = 0.01 + 0.2 * std::abs(place(random));
        } else if (round % 3 == 1) {
            stroke.side = ScalpelSide::outside;
        }
        expectAgreement(volume, stroke, "random");
    }
}

TEST(ScalpelCuts, StrokesTakenBackLeaveWhatWasBeforeAndCostNoPass) {
    const Volume volume = noise({32, 30, 28}, {1, 1, 1}).withDataMask([] {
        std::vector<std::uint8_t> mask(32 * 30 * 28, 1);
        std::fill_n(mask.begin(), 32 * 30 * 6, std::uint8_t{0});
        return mask;
    }());
    const auto strokes = strokesUnder(cameraOf(volume, {.azimuthDegrees = 12}, Projection::parallel));
    ScalpelCuts cuts(volume.geometry());
    std::vector<DataMask> after;
    for (std::size_t count = 0; count <= strokes.size(); ++count) {
        const auto cut = cuts.cut(volume, std::span(strokes).first(count));
        after.push_back(cut->dataMask());
        EXPECT_EQ(cut->dataBox(), volume.dataBox()) << "the picture must not jump";
        EXPECT_TRUE(cut->isSameScanAs(volume));
        EXPECT_EQ(cut->isCut(), count > 0);
        for (std::size_t i = 0; i < after.back().size(); ++i) ASSERT_LE(after.back()[i], volume.dataMask()[i]);
        EXPECT_EQ(after.back(),
                  ScalpelCuts(volume.geometry()).cut(volume, std::span(strokes).first(count))->dataMask());
    }
    EXPECT_EQ(after.front(), volume.dataMask());
    EXPECT_EQ(cuts.passes(), static_cast<int>(strokes.size())) << "each new stroke takes one";
    for (std::size_t count = strokes.size(); count-- > 0;)
        EXPECT_EQ(cuts.cut(volume, std::span(strokes).first(count))->dataMask(), after[count]) << count;
    EXPECT_EQ(cuts.cut(volume, strokes)->dataMask(), after.back()) << "redone";
    EXPECT_EQ(cuts.passes(), static_cast<int>(strokes.size()));
    // Another stroke in place of the third.
    std::vector<ScalpelStroke> others(strokes.begin(), strokes.begin() + 2);
    others.push_back(strokes.back());
    EXPECT_EQ(cuts.cut(volume, others)->dataMask(), ScalpelCuts(volume.geometry()).cut(volume, others)->dataMask());
}

TEST(ScalpelCuts, PhasesThatHoldTheSameVoxelsShareAMask) {
    const Volume first = noise({20, 18, 16}, {1, 1, 1});
    std::vector<std::uint8_t> half(static_cast<std::size_t>(first.geometry().voxelCount()), 1);
    std::fill_n(half.begin(), half.size() / 2, std::uint8_t{0});
    const Volume second = noise({20, 18, 16}, {1, 1, 1}), third = first.withDataMask(half),
                 fourth = second.withDataMask(half);
    const auto strokes = strokesUnder(cameraOf(first, {.azimuthDegrees = 12}, Projection::parallel));
    ScalpelCuts cuts(first.geometry());
    for (const std::size_t count : {std::size_t{1}, std::size_t{3}, std::size_t{2}}) {
        const auto some = std::span(strokes).first(count);
        const auto mask = cuts.cut(first, some)->cut();
        EXPECT_EQ(cuts.cut(second, some)->cut(), mask);
        const auto held = cuts.cut(third, some)->cut();
        EXPECT_NE(*held, *mask) << "another scan's mask is no part of it";
        EXPECT_EQ(*held, ScalpelCuts(first.geometry()).cut(third, some)->dataMask());
        EXPECT_EQ(cuts.cut(fourth, some)->cut(), held);
    }
    EXPECT_EQ(cuts.passes(), 3);
}

TEST(ScalpelCuts, MoreStrokesThanNumbersAreCutToo) {
    const Volume volume = noise({16, 16, 3}, {1, 1, 1});
    const Camera camera = cameraOf(volume, {}, Projection::parallel);
    std::vector<ScalpelStroke> strokes;
    for (int row = 0; row < 15; ++row)
        for (int column = 0; column < 20; ++column)
            strokes.push_back({.tool = ScalpelTool::eraser,
                               .camera = camera,
                               .places = {{-0.45 + 0.9 * column / 19, -0.45 + 0.9 * row / 14}},
                               .radius = 0.03});
    ScalpelCuts cuts(volume.geometry());
    (void)cuts.cut(volume, strokes);
    const std::vector<std::size_t> counts =
        takesSomeInputs ? std::vector<std::size_t>{300, 255, 254}
                        : std::vector<std::size_t>{300, 299, 270, 256, 255, 254, 253, 260, 100, 300};
    for (const std::size_t count : counts)
        EXPECT_EQ(cuts.cut(volume, std::span(strokes).first(count))->dataMask(),
                  ScalpelCuts(volume.geometry()).cut(volume, std::span(strokes).first(count))->dataMask())
            << count;
}

TEST(ScalpelCuts, ACancelledCutLeavesTheNextOneRight) {
    const Volume volume = noise({32, 32, 32}, {1, 1, 1});
    const auto strokes = strokesUnder(cameraOf(volume, {}, Projection::parallel));
    // On a machine that is busy elsewhere, a cut may be done before a thread sees that it is cancelled.
    bool cancelled = false;
    for (int attempt = 0; attempt < 50 && !cancelled; ++attempt) {
        ScalpelCuts cuts(volume.geometry());
        (void)cuts.cut(volume, std::span(strokes).first(1));
        std::atomic<bool> cancel{false};
        const Progress progress{[&](double) { cancel = true; }, &cancel};
        cancelled = !cuts.cut(volume, strokes, progress);
        EXPECT_EQ(cuts.cut(volume, strokes)->dataMask(),
                  ScalpelCuts(volume.geometry()).cut(volume, strokes)->dataMask());
    }
    EXPECT_TRUE(cancelled);
}

TEST(ScalpelCuts, AnyNumberOfThreadsCutsTheSame) {
    const Volume volume = noise({40, 32, 36}, {1, 1, 1});
    const auto strokes = strokesUnder(cameraOf(volume, {.azimuthDegrees = 12}, Projection::perspective));
    const auto many = ScalpelCuts(volume.geometry()).cut(volume, strokes);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(ScalpelCuts(volume.geometry()).cut(volume, strokes)->dataMask(), many->dataMask());
}

TEST(ScalpelCuts, QuietVoxelsAreTheSameBeforeAndAfterAStroke) {
    const Volume volume = noise({28, 26, 24}, {1, 1, 1});
    const auto strokes = strokesUnder(cameraOf(volume, {}, Projection::parallel));
    const Volume cut = *ScalpelCuts(volume.geometry()).cut(volume, std::span(strokes).first(1));
    for (const SpeckleReduction reduction : allSpeckleReductions) {
        const auto before = quietVolume(volume, reduction), after = quietVolume(cut, reduction);
        EXPECT_EQ(before->voxels(), after->voxels()) << nameOf(reduction);
        EXPECT_EQ(after->dataMask(), cut.dataMask());
        EXPECT_EQ(after->scannedMask(), volume.dataMask());
    }
}

TEST(ScalpelCuts, WithoutTheGuessWhatWasCutStaysCut) {
    VolumeGeometry geometry;
    geometry.size = {4, 1, 1};
    const Volume scan = Volume(geometry, std::vector<std::uint8_t>{0, 0, 7, 9}).withDataMask({0, 1, 1, 1});
    const Volume cut = scan.withCut(std::make_shared<const DataMask>(std::vector<std::uint8_t>{0, 0, 1, 0}));
    EXPECT_EQ(dataMaskWithoutGuess(cut), (std::vector<std::uint8_t>{1, 0, 1, 0}));
}

}  // namespace
}  // namespace echolucent
