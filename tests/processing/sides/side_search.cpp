// Which side comes first: where one side alone shows a structure, where all are alike, and on simulated scans.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "processing/phantom/phantom.h"
#include "processing/sides/side_search.h"
#include "tests/processing/grids.h"
#include "tests/processing/sides/hill.h"
#include "tests/processing/wobbler.h"

namespace echolucent {
namespace {

TEST(SideSearch, TakesTheOneSideThatShowsTheStructure) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            Vec3 forward(0, 0, 0);
            forward[axis] = sign;
            const Volume volume = hillSeenAlong(forward);
            const SidesFinding found = *findSides(volume, {}, true);
            const JudgedSide& best = found.sides[found.best];
            EXPECT_EQ(frameOf(best.side.view).forward.dot(forward), 1.0)
                << "axis " << axis << ", sign " << sign << ": " << best.side.name;
            ASSERT_TRUE(makesFront(best.front));
            EXPECT_NEAR(best.front.nearCutMm, 14.0, 3.0) << "just behind the wall";
            EXPECT_NEAR(best.score.opened, std::numbers::pi * 18 * 18 / (48 * 48), 0.06)
                << "the whole cavity lies open";
            EXPECT_NE(found.sentence.find(best.side.name), std::string::npos) << found.sentence;
        }
}

/// A ball in a deep cavity behind a wall that slants by 30 degrees or bulges by 14 mm towards the fluid, seen along +z.
Volume ballBehindAWall(bool slanted) {
    return cubeOf([slanted](const Vec3& mm) {
        const double right = mm[0] - middleMm, aside = std::hypot(right, mm[1] - middleMm);
        const double wall = slanted ? 20 + right / std::sqrt(3.0) : 6 + 14 * std::exp(-aside * aside / (2 * 13 * 13));
        const bool inCavity = mm[2] >= wall && mm[2] < 40 && std::abs(right) < 20 && std::abs(mm[1] - middleMm) < 20;
        return inCavity && length(mm - Vec3(22, 26, 40)) > 11 ? dark : bright;
    });
}

TEST(SideSearch, TakesTheProbesSideBehindAWallThatABowedFrontFollows) {
    for (const bool slanted : {true, false}) {
        const SidesFinding bowed = *findSides(ballBehindAWall(slanted), {}, true, CutShapes::flatAndCurved);
        ASSERT_TRUE(bowed.sides[probeSide].front.surface);
        EXPECT_EQ(bowed.best, probeSide) << bowed.sentence;
    }
    const SidesFinding flat = *findSides(ballBehindAWall(true), {}, true);
    EXPECT_NE(flat.best, probeSide) << "a plane from there leaves the wall or cuts the ball: " << flat.sentence;
}

TEST(SideSearch, TakesTheProbesSideWhereAllAreAlike) {
    const Volume ball =
        cubeOf([](const Vec3& mm) { return length(mm - Vec3(middleMm, middleMm, middleMm)) < 15 ? dark : bright; });
    for (const BeamAxis axis :
         {BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY, BeamAxis::plusZ, BeamAxis::minusZ}) {
        const SidesFinding found = *findSides(ball, {.beamAxis = axis}, true);
        EXPECT_EQ(found.best, probeSide);
        EXPECT_EQ(found.sides[probeSide].side.view.beamAxis, axis);
        for (const JudgedSide& judged : found.sides) {
            EXPECT_TRUE(makesFront(judged.front)) << judged.side.name;
            EXPECT_NEAR(judged.score.total, found.sides[probeSide].score.total, 0.02 * judged.score.total);
        }
    }
}

/// A ball of fluid looks alike from all sides, but planes of voxels lie twice as far apart along y.
TEST(SideSearch, LooksOntoTheScanPlaneWhereItIsFiner) {
    const VolumeGeometry geometry = gridOf({64, 32, 64}, {0.75, 1.5, 0.75});
    std::mt19937 random(2);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t i = 0; i < geometry.voxelCount(); ++i) {
        const Vec3 mm = geometry.gridMmFromVoxel(
            {static_cast<double>(i % 64), static_cast<double>(i / 64 % 32), static_cast<double>(i / (64 * 32))});
        const double echo = length(mm - geometry.centreMm()) < 15 ? dark : bright;
        voxels[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(echo * (0.5 + random() / 4294967296.0));
    }
    const SidesFinding found = *findSides({geometry, std::move(voxels)}, {}, true);
    EXPECT_EQ(found.planes.evidence, ScanPlaneEvidence::spacing);
    const JudgedSide& best = found.sides[found.best];
    EXPECT_EQ(std::abs(frameOf(best.side.view).forward[1]), 1.0) << found.sentence;
    EXPECT_EQ(best.score.fineness, (PictureFineness{1.0, 1.0}));
    const PictureFineness fromProbe = found.sides[probeSide].score.fineness;
    EXPECT_NEAR(fromProbe.resolution, std::sqrt(0.5), 1e-12) << "grains of two voxels: half as many in the picture";
    EXPECT_NEAR(fromProbe.plane, 0.5, 1e-12);
}

TEST(SideSearch, TakesTheProbesSideWithoutFluid) {
    const Volume even = cubeOf([](const Vec3&) { return bright; });
    const SidesFinding found = *findSides(even, {.beamAxis = BeamAxis::minusY}, true);
    EXPECT_EQ(found.best, probeSide);
    for (const JudgedSide& judged : found.sides) EXPECT_EQ(judged.score.total, 0.0);
    EXPECT_NE(found.sentence.find("no side surely shows"), std::string::npos) << found.sentence;
    const Volume none =
        even.withDataMask(std::vector<std::uint8_t>(static_cast<std::size_t>(even.geometry().voxelCount()), 0));
    EXPECT_EQ(findSides(none, {}, true)->best, probeSide) << "nor without data";
}

PhantomConfig simulated(PhantomScene scene, bool wall, std::uint64_t seed) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = {80, 79, 80};
    config.spacing = {1.25, 1.25, 1.25};
    config.frontWall = wall;
    config.seed = seed;
    return config;
}

TEST(SideSearch, OpensSimulatedScansFromTheProbe) {
    for (const auto& [scene, wall] :
         {std::pair{PhantomScene::fetus, false}, {PhantomScene::fetus, true}, {PhantomScene::shapes, true}}) {
        const SidesFinding found = *findSides(*makePhantom(simulated(scene, wall, wall ? 5 : 4)), {}, true);
        EXPECT_EQ(found.best, probeSide) << nameOf(scene) << ' ' << wall << ": " << found.sentence;
        EXPECT_EQ(makesFront(found.sides[probeSide].front), wall);
    }
}

/// A scan of a wobbler: its sector is dim at the border, and less than half of the tube cores begin in fluid.
TEST(SideSearch, OpensTheFetusInAWideSectorFromTheProbe) {
    PhantomConfig config = simulated(PhantomScene::fetus, false, 6);
    const Volume volume = scanOfWobbler(config);
    const SidesFinding found = *findSides(volume, {}, true);
    EXPECT_EQ(found.best, probeSide) << found.sentence;
    EXPECT_GT(found.sides[probeSide].score.total, 0.0);
    EXPECT_EQ(findSides(volume, {}, false)->sides[probeSide].score.total, 0.0)
        << "where nobody knows the beam, data that begin in fluid need a sure search";
}

TEST(SideSearch, NumbersTheSidesOfAnUnsureBeam) {
    const SidesFinding found = *findSides(hillSeenAlong({0, 1, 0}), {}, false);
    for (const JudgedSide& judged : found.sides) {
        EXPECT_EQ(judged.side.name, "Side " + std::to_string(judged.side.number));
        EXPECT_EQ(judged.front.message.find("probe"), std::string::npos);
    }
    EXPECT_EQ(found.sentence.find("probe"), std::string::npos) << found.sentence;
    EXPECT_EQ(frameOf(found.sides[found.best].side.view).forward, Vec3(0, 1, 0)) << "it still finds the best";
}

TEST(SideSearch, AsksForMoreOfThePictureWhereTheBeamIsUnsure) {
    const Volume small = hillSeenAlong({0, 1, 0}, 11);
    const SidesFinding sure = *findSides(small, {}, true), unsure = *findSides(small, {}, false);
    EXPECT_EQ(frameOf(sure.sides[sure.best].side.view).forward, Vec3(0, 1, 0)) << sure.sentence;
    EXPECT_NEAR(sure.sides[sure.best].score.opened, std::numbers::pi * 11 * 11 / (48 * 48), 0.05);
    EXPECT_EQ(unsure.best, probeSide) << unsure.sentence;
    EXPECT_EQ(sure.reason, FirstSideReason::showsMost);
    EXPECT_EQ(unsure.reason, FirstSideReason::tooLittleOpenElsewhere);
}

TEST(SideSearch, SaysWhyASideComesFirst) {
    SidesFinding finding;
    const Sides sides = sidesOf({}, true, {});
    for (std::size_t i = 0; i < sides.size(); ++i) finding.sides[i].side = sides[i];
    finding.leastOpened = 0.1;
    const auto says = [&finding](std::size_t first, FirstSideReason reason, const std::string& sentence) {
        const SidesFinding said = withFirst(finding, first);
        EXPECT_EQ(said.best, first);
        EXPECT_EQ(said.reason, reason) << said.sentence;
        EXPECT_EQ(said.sentence, sentence);
    };
    const std::string probe = "\"From the probe\" comes first: ";
    says(0, FirstSideReason::nothingShows, probe + "no side surely shows anything behind fluid.");
    finding.sides[3].score = {.opened = 0.05, .total = 0.4};
    says(0, FirstSideReason::tooLittleOpenElsewhere,
         probe + "what other sides show behind fluid fills too little of their pictures.");
    finding.sides[0].score = {.opened = 0.03, .total = 0.2};
    says(0, FirstSideReason::tooLittleOpenElsewhere,
         probe + "what other sides show behind fluid fills too little of their pictures.");
    finding.sides[0].score.total = 0.37;
    says(0, FirstSideReason::noneClearlyMore,
         probe + "3 % of its picture are surfaces behind fluid, and no other side shows clearly more.");
    finding.sides[1].score = {.opened = 0.3, .total = 0.5};
    says(1, FirstSideReason::showsMost,
         "\"From behind\" comes first: 30 % of its picture are surfaces behind fluid, seen more clearly than from any "
         "other side that opens as much.");
    says(0, FirstSideReason::firstInTheCoarsePicture,
         probe + "so it did in the coarse picture, which comes before all is read.");
    says(3, FirstSideReason::firstInTheCoarsePicture,
         "\"From the upper edge of side 1\" comes first: so it did in the coarse picture, which comes before all is "
         "read.");
}

TEST(SideSearch, GivesTheSameBitsForAnyNumberOfThreads) {
    const Volume volume = *makePhantom(simulated(PhantomScene::fetus, true, 7));
    const Viewpoint leaning{.azimuthDegrees = 11, .elevationDegrees = -5};
    const auto withThreads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return *findSides(volume, leaning, true, CutShapes::flatAndCurved);
    };
    const SidesFinding one = withThreads(1), four = withThreads(4);
    EXPECT_EQ(one.planes, four.planes);
    EXPECT_EQ(one.best, four.best);
    EXPECT_EQ(one.sentence, four.sentence);
    for (std::size_t i = 0; i < one.sides.size(); ++i) {
        EXPECT_EQ(one.sides[i].side, four.sides[i].side);
        EXPECT_EQ(one.sides[i].score, four.sides[i].score);
        EXPECT_EQ(one.sides[i].front.nearCutMm, four.sides[i].front.nearCutMm);
        EXPECT_EQ(one.sides[i].front.surface, four.sides[i].front.surface);
        EXPECT_EQ(one.sides[i].front.message, four.sides[i].front.message);
    }
}

TEST(SideSearch, FindsTheFrontsOfTheSearchForOneView) {
    const Volume volume = *makePhantom(simulated(PhantomScene::shapes, true, 8));
    const SidesFinding found = *findSides(volume, {}, true);
    for (const JudgedSide& judged : found.sides) {
        const auto alone = findFlatNearCut(volume, judged.side.view);
        EXPECT_EQ(judged.front.answer, alone->answer);
        EXPECT_EQ(judged.front.nearCutMm, alone->nearCutMm);
        EXPECT_EQ(judged.front.confidence, alone->confidence);
        EXPECT_EQ(judged.front.message, alone->message);
    }
}

TEST(SideSearch, OfACancelledRunIsNone) {
    const Volume volume = *makePhantom(simulated(PhantomScene::shapes, false, 9));
    std::atomic<bool> cancel = false;
    Progress progress;
    progress.cancel = &cancel;
    std::vector<double> shares;
    progress.report = [&](double share) { shares.push_back(share); };
    ASSERT_TRUE(findSides(volume, {}, true, CutShapes::flat, progress));
    ASSERT_GE(shares.size(), 2U);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.back(), 1.0);
    for (const double until : shares) {
        if (until == 1.0) break;
        cancel = false;
        progress.report = [&](double share) { cancel = cancel || share >= until; };
        EXPECT_FALSE(findSides(volume, {}, true, CutShapes::flat, progress)) << until;
    }
}

}  // namespace
}  // namespace echolucent
