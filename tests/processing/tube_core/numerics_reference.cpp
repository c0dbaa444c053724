// The numbers of the method against 50 digits. tests/fixtures holds the reference values and the script that made them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "app/measuring/stability/study_stability_inputs.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/slabs/tube_slabs.h"
#include "processing/tube_core/tube_weights.h"

namespace echolucent {
namespace {

/// The rows of a table under tests/fixtures, without its header.
std::vector<std::vector<std::string>> fixture(const std::string& name) {
    std::ifstream file(std::string(ECHOLUCENT_SOURCE_DIR) + "/tests/fixtures/" + name);
    EXPECT_TRUE(file) << name;
    std::vector<std::vector<std::string>> rows;
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    EXPECT_FALSE(rows.empty()) << name;
    return rows;
}

/// Reads as many of the 25 digits as this machine's longest number takes: at least three more than a double does.
long double reference(const std::string& digits) { return std::strtold(digits.c_str(), nullptr); }

double errorOf(double value, const std::string& digits) {
    return static_cast<double>(std::abs(static_cast<long double>(value) - reference(digits)));
}

TEST(Reference, BasisFunctionIsRightTo4e16ForGapsDownTo1e9) {
    double worst = 0.0, narrowest = 1.0;
    int near = 0;
    for (const auto& row : fixture("basis_function.csv")) {
        const auto [x, range] = reference::basisInput(std::stoull(row[0]));
        const double error = errorOf(basisFunction(x, range.low, range.high), row[1]);
        EXPECT_LE(error, 4e-16) << "row " << row[0];
        worst = std::max(worst, error);
        narrowest = std::min(narrowest, range.high - range.low);
        near += std::abs(reference(row[1])) > 0.01L ? 1 : 0;
    }
    std::printf("basis function: error at most %.2g, gaps from %.2g\n", worst, narrowest);
    EXPECT_LT(narrowest, 1.1e-9);
    EXPECT_GT(near, 400) << "many rows must lie where the function is not next to nothing";
}

void expectLogOpacity(const std::string& name, std::size_t count, double tolerance) {
    std::map<double, std::vector<double>> byStrength;
    double worst = 0.0;
    for (const auto& row : fixture(name)) {
        const double dMax = std::stod(row[0]);
        auto& logOpacity = byStrength[dMax];
        if (logOpacity.empty()) {
            std::vector<TubeCore> tubes(count);
            for (std::size_t t = 0; t < count; ++t) {
                const auto input = reference::tubeInput(t, dMax);
                tubes[t].status = TubeStatus::surface;
                tubes[t].d = input.d;
                tubes[t].lowIntensity = input.range.low;
                tubes[t].highIntensity = input.range.high;
            }
            logOpacity = adaptedLogOpacity(PowerCurve{2, 1.0}, tubes, 256);
        }
        const double error = errorOf(logOpacity[std::stoul(row[1])], row[2]) / std::max(1.0, std::stod(row[3]));
        EXPECT_LE(error, tolerance) << "d_max " << dMax << ", intensity " << row[1] << " / 255";
        worst = std::max(worst, error);
    }
    EXPECT_EQ(byStrength.size(), 3u);
    EXPECT_EQ(byStrength.rbegin()->first, 1e6);
    std::printf("log opacity, T = %zu: error at most %.2g of the sum of magnitudes\n", count, worst);
}

TEST(Reference, LogOpacityOf225TubesIsRightTo1e12) { expectLogOpacity("log_opacity_225.csv", 225, 1e-12); }

TEST(Reference, LogOpacityOf100000TubesIsRightTo1e11) { expectLogOpacity("log_opacity_100000.csv", 100000, 1e-11); }

TEST(Reference, OpacityForAnotherStepNearNothingAndNearOne) {
    double worst = 0.0;
    for (const auto& row : fixture("opacity_for_step.csv")) {
        const double opacity = std::strtod(row[0].c_str(), nullptr), ratio = std::strtod(row[1].c_str(), nullptr);
        const double value = opacityForStep(opacity, ratio);
        // Below the normal numbers a double has fewer digits.
        if (reference(row[2]) < 1e-307L) {
            EXPECT_NEAR(value, static_cast<double>(reference(row[2])), 5e-324) << row[0] << " " << row[1];
            continue;
        }
        const double error = errorOf(value, row[2]) / static_cast<double>(reference(row[2]));
        EXPECT_LE(error, 1e-15) << row[0] << " " << row[1];
        worst = std::max(worst, error);
    }
    std::printf("opacity for another step: relative error at most %.2g\n", worst);
}

TEST(Reference, CellVarianceOf16BitVoxelsOfMean65000IsExactInIntegers) {
    VolumeGeometry geometry;
    geometry.size = {5, 5, 40};
    std::vector<std::uint16_t> voxels(1000);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = reference::brightVoxel(i);
    const Volume volume(geometry, voxels, 65535.0);

    // The sums as the method takes them, and the cells it makes of them.
    AdaptiveOtfConfig config = configOf(MethodReading::settled);
    config.grid.columns = config.grid.rows = 1;
    const TubeSamples samples = samplesOf(tubeAxes(geometry, {}, config.grid, 5), geometry, {}, 5).front();
    SlabSums sums;
    sumSlabs(volume, *exactStoredLimit(volume), {&samples, 1}, {&sums, 1});
    CellStatistics cells;
    cellsFrom(sums, 5, 1.0, cells);
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, config);
    ASSERT_EQ(otf.tubes[0].interfaceFunction.size(), 36u);
    ASSERT_EQ(cells.variances.size(), 36u);

    const auto rows = fixture("cell_variance_16_bit.csv");
    ASSERT_EQ(rows.size(), 36u);
    for (std::size_t cell = 0; cell < 36; ++cell) {
        const std::uint64_t exact = std::stoull(rows[cell][1]), exactSum = std::stoull(rows[cell][2]);
        std::uint64_t sum = 0, squares = 0;
        for (std::size_t k = cell; k < cell + 5; ++k) {
            EXPECT_EQ(sums.counts[k], 25);
            sum += static_cast<std::uint64_t>(sums.sums[k]);
            squares += sums.sumsOfSquares[k];
        }
        EXPECT_EQ(sum, exactSum);
        EXPECT_EQ(scaledVariance(125, sum, squares), exact);
        // What is left is one rounding a division: where it is multiplied back, the integer is met again.
        EXPECT_EQ(static_cast<std::uint64_t>(std::llround(cells.variances[cell] * 125.0 * 125.0)), exact);
        EXPECT_FLOAT_EQ(otf.tubes[0].interfaceFunction[cell],
                        static_cast<float>(static_cast<double>(exact) / (125.0 * 65535.0) / (125.0 * 65535.0)));
    }
}

struct Fraction {
    int above, below;
};

/// The weight must be the fraction as far as a double can be: three roundings.
void expectFraction(double weight, const Fraction& exact, const char* what) {
    EXPECT_NEAR(weight * exact.below, exact.above, 4e-16 * exact.below)
        << what << " " << exact.above << "/" << exact.below;
}

TEST(Reference, WeightsAreExactFractionsAlsoWithTies) {
    // There are few values, so that most are tied; 11 more tubes meet the volume without a surface.
    constexpr int surfaces = 250, meeting = 261;
    std::vector<TubeCore> tubes(meeting);
    for (std::size_t t = 0; t < surfaces; ++t) {
        TubeCore& tube = tubes[t];
        tube.status = TubeStatus::surface;
        tube.lowIntensity = 0.1;
        tube.highIntensity = 0.5;
        tube.lowIntensityMax = static_cast<double>(splitmix64(3 * t) % 17) / 16.0;
        tube.slope = (static_cast<double>(splitmix64(3 * t + 1) % 23) - 5.0) / 64.0;
        tube.edgeToNoise = 10.0;
    }
    for (std::size_t t = surfaces; t < meeting; ++t) tubes[t].status = TubeStatus::none;
    const double dMax = 0.03;
    weighTubes(tubes, dMax, 0.0, {});
    int atMost = 0;
    for (int t = 0; t < surfaces; ++t) {
        const TubeCore& tube = tubes[static_cast<std::size_t>(t)];
        Fraction intensity{meeting, meeting}, slope{0, meeting};
        for (int other = 0; other < surfaces; ++other) {
            const TubeCore& by = tubes[static_cast<std::size_t>(other)];
            intensity.above -= *by.lowIntensityMax <= *tube.lowIntensityMax ? 1 : 0;
            slope.above += *by.slope > 0.0 && *by.slope <= *tube.slope ? 1 : 0;
        }
        expectFraction(tube.intensityWeight, intensity, "w_I");
        expectFraction(tube.slopeWeight, slope, "w_S");
        EXPECT_NEAR(tube.d * meeting * meeting / dMax, static_cast<double>(intensity.above) * slope.above,
                    1e-15 * meeting * meeting);
        atMost += intensity.above == meeting - surfaces ? 1 : 0;
    }
    EXPECT_GT(atMost, 1) << "the largest prior maximum is tied";
    for (std::size_t t = surfaces; t < meeting; ++t) EXPECT_EQ(tubes[t].d, 0.0);
}

}  // namespace
}  // namespace echolucent
