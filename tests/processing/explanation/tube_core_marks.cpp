// Where tube cores are drawn: their places against the method's own, which of them stand for all, what a plane shows.
#include "processing/explanation/tube_core_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

struct Run {
    Volume volume;
    AdaptiveOtf otf;
};

const Run& obliqueRun() {
    static const Run run = [] {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {60, 56, 58};
        config.spacing = Vec3(1.4, 1.4, 1.4);
        Volume volume = *makePhantom(config);
        AdaptiveOtf otf = *adaptOpacity(volume, {.azimuthDegrees = 20.0, .elevationDegrees = -15.0}, {});
        return Run{std::move(volume), std::move(otf)};
    }();
    return run;
}

/// A grid of marks that look along +z, 10 mm apart, with cells of 4 mm, from z = 0 to 100.
TubeCoreMarks marksInGrid(int columns, int rows) {
    TubeCoreMarks marks{.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .halfWidthMm = 2.0, .halfSpacingMm = 5.0};
    marks.columns = columns;
    marks.rows = rows;
    for (int number = 0; number < columns * rows; ++number) {
        const double x = 10.0 * (number % columns), y = 10.0 * (number / columns);
        marks.marks.push_back({.number = number,
                               .beginMm = {x, y, 0},
                               .endMm = {x, y, 100},
                               .surfaceMm = Vec3(x, y, 40),
                               .share = (number % 7 + 1) / 8.0});
    }
    return marks;
}

TEST(TubeCoreMarks, SurfacesLieOnTheAxisWhereTheMethodFoundThem) {
    const auto& [volume, otf] = obliqueRun();
    const TubeCoreMarks marks = marksOf(otf, volume.geometry());
    ASSERT_GT(otf.tubesWithWeight, 20);
    EXPECT_EQ(static_cast<int>(marks.marks.size()), otf.tubesMeetingVolume);
    double largest = 0.0;
    int surfaces = 0;
    for (const TubeCoreMark& mark : marks.marks) {
        const TubeCore& tube = otf.tubes.at(static_cast<std::size_t>(mark.number));
        EXPECT_EQ(mark.surfaceMm.has_value(), tube.status == TubeStatus::surface);
        EXPECT_EQ(mark.share > 0.0, tube.d > 0.0);
        largest = std::max(largest, mark.share);
        // The axis runs along the view.
        EXPECT_LT(length((mark.endMm - mark.beginMm).cross(marks.axes.forward)), 1e-9);
        EXPECT_GT(marks.axes.forward.dot(mark.endMm - mark.beginMm), 0.0);
        if (!mark.surfaceMm) continue;
        ++surfaces;
        EXPECT_LT(length(volume.geometry().voxelFromGridMm(*mark.surfaceMm) - *tube.surfaceVoxel), 1e-9);
        const double along = marks.axes.forward.dot(*mark.surfaceMm - mark.beginMm);
        EXPECT_GT(along, 0.0);
        EXPECT_LT(along, length(mark.endMm - mark.beginMm));
        EXPECT_LT(length(mark.beginMm + marks.axes.forward * along - *mark.surfaceMm), 1e-9);
    }
    EXPECT_EQ(largest, 1.0);
    EXPECT_GT(surfaces, 20);
    EXPECT_EQ(marks.of(marks.marks.front().number), &marks.marks.front());
    EXPECT_EQ(marks.of(-1), nullptr);
}

TEST(TubeCoreMarks, ThinnedAreTheHeaviestOfEachSquareAndAllIfTheyFit) {
    TubeCoreMarks marks = marksInGrid(15, 15);
    marks.marks[16].share = 0.0;
    EXPECT_EQ(thinned(marks, 1000).size(), 224u);
    const std::vector<int> few = thinned(marks, 64);
    ASSERT_EQ(few.size(), 64u);
    EXPECT_TRUE(std::ranges::is_sorted(few));
    for (const int number : few) {
        const int column = number % 15 / 2 * 2, row = number / 15 / 2 * 2;
        for (int v = row; v < std::min(row + 2, 15); ++v)
            for (int u = column; u < std::min(column + 2, 15); ++u)
                EXPECT_LE(marks.of(v * 15 + u)->share, marks.of(number)->share) << number;
    }
    EXPECT_EQ(thinned(marks, 1).size(), 1u);
    EXPECT_EQ(marks.of(thinned(marks, 1).front())->share, 7.0 / 8.0);
    EXPECT_TRUE(thinned(TubeCoreMarks{}, 64).empty());
}

TEST(TubeCoreMarks, APlaneShowsTheTubeCoresWithinHalfASpacing) {
    const TubeCoreMarks marks = marksInGrid(3, 3);
    const auto numbersIn = [&](const Vec3& point, const Vec3& normal) {
        std::set<int> numbers;
        for (const TubeCoreMark& mark : marks.marks)
            if (shownInPlane(marks, mark, point, normal)) numbers.insert(mark.number);
        return numbers;
    };
    EXPECT_EQ(numbersIn({14, 0, 50}, {1, 0, 0}), (std::set<int>{1, 4, 7}));
    EXPECT_EQ(numbersIn({0, 6, 50}, {0, 1, 0}), (std::set<int>{3, 4, 5}));
    EXPECT_EQ(numbersIn({0, 0, 50}, {0, 0, 1}).size(), 9u);
    EXPECT_TRUE(numbersIn({0, 0, 106}, {0, 0, 1}).empty());

    // Along the view a column is as wide as a cell, as long as the tube core, and moved onto the plane.
    const auto along = shownInPlane(marks, *marks.of(4), {14, 0, 50}, {1, 0, 0});
    ASSERT_EQ(along->outlineMm.size(), 4u);
    for (const Vec3& corner : along->outlineMm) {
        EXPECT_NEAR(corner[0], 14.0, 1e-9);
        EXPECT_NEAR(std::abs(corner[1] - 10.0), 2.0, 1e-9);
    }
    EXPECT_EQ(*along->surfaceMm, Vec3(14, 10, 40));
    // Across the view it is a square, and its surface shows within half a cell.
    const auto across = [&](double z) { return shownInPlane(marks, *marks.of(4), {0, 0, z}, {0, 0, 1}); };
    EXPECT_TRUE(across(41.9)->surfaceMm);
    EXPECT_FALSE(across(42.1)->surfaceMm);
    EXPECT_EQ(across(60.0)->outlineMm.size(), 4u);
}

}  // namespace
}  // namespace echolucent
