#include "processing/tube_core/surface_reading.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "processing/tube_core/tube_weights.h"

namespace echolucent {
namespace {

/// I_L over all prior cells and I_H at the surface, as in the paper.
constexpr SurfaceRule atTheSurface{.lowReach = 0, .highReach = 0};

CellStatistics cellsWith(std::vector<double> means) {
    CellStatistics cells;
    cells.variances.assign(means.size(), 0.0);
    cells.complete.assign(means.size(), 1);
    cells.lastCell = static_cast<int>(means.size()) - 1;
    cells.means = std::move(means);
    return cells;
}

TEST(ReadSurface, ReadsPriorCellsSurfaceCellAndSlope) {
    std::vector<double> means;
    for (int i = 0; i < 30; ++i) means.push_back(0.01 * i);
    means[3] = 0.9;
    TubeCore tube;
    ASSERT_TRUE(readSurface(cellsWith(means), 20, atTheSurface, 5, tube));
    EXPECT_NEAR(*tube.lowIntensity, (0.01 * (15 * 16 / 2.0 - 3) + 0.9) / 16, 1e-15) << "cells 0 to 15";
    EXPECT_EQ(*tube.lowIntensityMax, 0.9);
    EXPECT_DOUBLE_EQ(*tube.highIntensity, 0.2);
    EXPECT_NEAR(*tube.slope, 0.01, 1e-15) << "per unit";
}

TEST(ReadSurface, ShortensTheSlopeAtTheTubesEnds) {
    std::vector<double> means;
    for (int i = 0; i < 12; ++i) means.push_back(0.01 * i * i);
    TubeCore tube;
    ASSERT_TRUE(readSurface(cellsWith(means), 9, atTheSurface, 5, tube));
    EXPECT_NEAR(*tube.slope, (0.01 * 121 - 0.01 * 16) / 7, 1e-15) << "from cell 4 to cell 11, the last";
}

TEST(ReadSurface, TheReachSaysHowFarFromTheSurfaceIntensitiesAreRead) {
    std::vector<double> means;
    for (int i = 0; i < 30; ++i) means.push_back(0.01 * i);
    TubeCore tube;
    ASSERT_TRUE(readSurface(cellsWith(means), 20, {.lowReach = 3, .highReach = 4}, 5, tube));
    EXPECT_NEAR(*tube.lowIntensity, 0.14, 1e-15) << "cells 13 to 15";
    EXPECT_DOUBLE_EQ(*tube.highIntensity, 0.24) << "cell 24";
    EXPECT_DOUBLE_EQ(*tube.lowIntensityMax, 0.15) << "of all prior cells";
}

TEST(ReadSurface, NeedsACellThatEndsBeforeTheSurface) {
    TubeCore tube;
    CellStatistics cells = cellsWith(std::vector<double>(20, 0.5));
    EXPECT_FALSE(readSurface(cells, 4, atTheSurface, 5, tube));
    EXPECT_TRUE(readSurface(cells, 5, atTheSurface, 5, tube));
    cells.firstCell = 3;
    EXPECT_FALSE(readSurface(cells, 7, atTheSurface, 5, tube));
    EXPECT_TRUE(readSurface(cells, 8, atTheSurface, 5, tube));
    std::fill(cells.complete.begin(), cells.complete.begin() + 4, std::uint8_t{0});
    EXPECT_FALSE(readSurface(cells, 8, atTheSurface, 5, tube)) << "cells of too little data do not count";
}

TEST(ReadSurface, PriorCellsThatMayOverlapAreAllThatBeginBeforeTheSurface) {
    std::vector<double> means;
    for (int i = 0; i < 30; ++i) means.push_back(0.01 * i);
    SurfaceRule rule = atTheSurface;
    rule.priorCellsMayOverlap = true;
    TubeCore tube;
    ASSERT_TRUE(readSurface(cellsWith(means), 20, rule, 5, tube));
    EXPECT_NEAR(*tube.lowIntensity, 0.01 * 19 / 2, 1e-15) << "cells 0 to 19";
    EXPECT_DOUBLE_EQ(*tube.lowIntensityMax, 0.19);
    EXPECT_TRUE(readSurface(cellsWith(means), 1, rule, 5, tube));
    EXPECT_FALSE(readSurface(cellsWith(means), 0, rule, 5, tube));
}

TEST(ScatterOf, IsTheStandardDeviationOfNoiseAndIgnoresAWall) {
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0.3, 0.02);
    std::vector<double> means(4000);
    for (double& mean : means) mean = noise(random);
    EXPECT_NEAR(*scatterOf(means, 5), 0.02, 0.001);
    for (std::size_t i = 0; i < 800; ++i) means[i] += 0.4;
    EXPECT_NEAR(*scatterOf(means, 5), 0.02, 0.001);
    EXPECT_FALSE(scatterOf(std::vector<double>(9, 0.1), 5));
    EXPECT_EQ(scatterOf(std::vector<double>(10, 0.1), 5), 0.0);
}

TubeCore tubeOfSlope(double lowMax, double slope) {
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.lowIntensity = 0.1;
    tube.highIntensity = 0.5;
    tube.lowIntensityMax = lowMax;
    tube.slope = slope;
    tube.edgeToNoise = 10;
    return tube;
}

TEST(WeighTubes, RanksAreExactInclusiveAndRelativeToAllTubesThatMeetTheVolume) {
    std::vector<TubeCore> tubes{
        tubeOfSlope(0.1, 0.03), tubeOfSlope(0.2, 0.01), tubeOfSlope(0.2, 0.02), tubeOfSlope(0.4, -0.05), {}, {}};
    tubes[4].status = TubeStatus::none;
    weighTubes(tubes, 0.03, 6.0, {});
    EXPECT_DOUBLE_EQ(tubes[0].intensityWeight, 1 - 1 / 5.0);
    EXPECT_DOUBLE_EQ(tubes[1].intensityWeight, 1 - 3 / 5.0) << "ties count together";
    EXPECT_DOUBLE_EQ(tubes[2].intensityWeight, 1 - 3 / 5.0);
    EXPECT_DOUBLE_EQ(tubes[3].intensityWeight, 1 - 4 / 5.0);
    EXPECT_DOUBLE_EQ(tubes[0].slopeWeight, 3 / 5.0) << "the falling one is in no histogram of slopes";
    EXPECT_DOUBLE_EQ(tubes[1].slopeWeight, 1 / 5.0);
    EXPECT_DOUBLE_EQ(tubes[2].slopeWeight, 2 / 5.0);
    EXPECT_EQ(tubes[3].slopeWeight, 0.0);
    EXPECT_DOUBLE_EQ(tubes[0].d, 0.03 * 0.8 * 0.6);
    EXPECT_EQ(tubes[3].d, 0.0);
    EXPECT_EQ(tubes[4].d, 0.0);
    EXPECT_EQ(tubes[5].d, 0.0);
}

TEST(WeighTubes, ValuesOfOneBinAreTies) {
    // There are ten bins from 0 to 0.4 and from 0 to 0.03: 0.20 and 0.21 share bin 5, and the largest value is in the
    // last.
    std::vector<TubeCore> tubes{tubeOfSlope(0.1, 0.03), tubeOfSlope(0.20, 0.0101), tubeOfSlope(0.21, 0.0119),
                                tubeOfSlope(0.4, -0.05)};
    const auto weights = [&](int bins) {
        weighTubes(tubes, 1.0, 0.0, {.rankBins = bins});
        std::vector<double> all;
        for (const TubeCore& tube : tubes) all.insert(all.end(), {tube.intensityWeight, tube.slopeWeight});
        return all;
    };
    const std::vector<double> exact{0.75, 0.75, 0.5, 0.25, 0.25, 0.5, 0.0, 0.0};
    EXPECT_EQ(weights(0), exact);
    EXPECT_EQ(weights(10), (std::vector<double>{0.75, 0.75, 0.25, 0.5, 0.25, 0.5, 0.0, 0.0}));
    EXPECT_EQ(weights(1), (std::vector<double>{0.0, 0.75, 0.0, 0.75, 0.0, 0.75, 0.0, 0.0})) << "all are ties";
    EXPECT_EQ(weights(1 << 20), exact) << "bins finer than the differences";
}

TEST(WeighTubes, AllTiesWeighNothing) {
    for (const int bins : {0, 256}) {
        std::vector<TubeCore> tubes(5, tubeOfSlope(0.2, 0.02));
        weighTubes(tubes, 1.0, 0.0, {.rankBins = bins});
        for (const TubeCore& tube : tubes) {
            EXPECT_EQ(tube.intensityWeight, 0.0) << "inclusive ranks";
            EXPECT_EQ(tube.slopeWeight, 1.0);
            EXPECT_EQ(tube.d, 0.0);
        }
        for (TubeCore& tube : tubes) tube.lowIntensityMax = 0.0;
        weighTubes(tubes, 1.0, 0.0, {.rankBins = bins});
        for (const TubeCore& tube : tubes) EXPECT_EQ(tube.d, 0.0) << "nothing but black before the surface";
    }
}

TEST(WeighTubes, NoWeightWithoutARiseOrAnEdgeThatStandsOut) {
    std::vector<TubeCore> tubes{
        tubeOfSlope(0.1, 0.03), tubeOfSlope(0.2, 0.02), tubeOfSlope(0.3, 0.01), tubeOfSlope(0.4, 0.01), {}};
    tubes[4].status = TubeStatus::none;
    tubes[0].highIntensity = 0.1;
    tubes[1].edgeToNoise = 5.9;
    tubes[2].edgeToNoise = std::nullopt;
    weighTubes(tubes, 1.0, 6.0, {});
    for (std::size_t t = 0; t < 3; ++t) EXPECT_EQ(tubes[t].d, 0.0);
    EXPECT_GT(tubes[3].d, 0.0);
    weighTubes(tubes, 1.0, 0.0, {});
    EXPECT_EQ(tubes[0].d, 0.0) << "I_H = I_L";
    EXPECT_GT(tubes[1].d, 0.0);
    EXPECT_GT(tubes[2].d, 0.0);
}

}  // namespace
}  // namespace echolucent
