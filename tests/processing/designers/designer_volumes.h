// Small volumes and inputs for tests of designers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "tests/processing/grids.h"

namespace echolucent {

inline VolumeGeometry gridOf(std::int64_t x, std::int64_t y, std::int64_t z, const Vec3& spacing = {1, 1, 1}) {
    return gridOf({x, y, z}, spacing);
}

template <typename Value>
Volume lineOf(std::vector<Value> values, double white) {
    const auto count = static_cast<std::int64_t>(values.size());
    return Volume(gridOf(count, 1, 1), std::move(values), white);
}
inline Volume bytesOf(std::vector<std::uint8_t> values) { return lineOf(std::move(values), 255.0); }

inline DesignerInput inputOf(const Volume& volume) { return {volume, volume}; }

/// Runs a designer on a volume that is both raw and shown. The volume outlives the call.
template <typename Config>
Design designed(const Config& config, const Volume& volume) {
    return design(config, inputOf(volume)).value();
}

/// The volume with another mask: 1 is data.
inline Volume masked(const Volume& volume, std::vector<std::uint8_t> mask) {
    return volume.withDataMask(DataMask(std::move(mask)));
}

/// The intensities of all voxels with data.
inline std::vector<double> dataOf(const Volume& volume) {
    std::vector<double> data;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        if (volume.hasData(i)) data.push_back(volume.normalisedIntensity(i));
    return data;
}

/// Volumes of every type, of two overlapping classes, with and without a mask. Floats also hold values that are not
/// finite, below 0 or above white.
inline std::vector<Volume> twoClassVolumes(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> dark(40, 15), bright(150, 35);
    constexpr std::int64_t columns = 13, rows = 11, slices = 7;
    std::vector<std::uint8_t> bytes, mask;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
    for (std::int64_t i = 0; i < columns * rows * slices; ++i) {
        const double echo = std::round(std::max(0.0, random() % 3 != 0 ? dark(random) : bright(random)));
        bytes.push_back(static_cast<std::uint8_t>(std::min(echo, 255.0)));
        words.push_back(static_cast<std::uint16_t>(echo * 37));
        // Multiples of the steps in which floats are counted, so that the count is exact.
        floats.push_back(static_cast<float>(i % 97 == 0 ? -3.0 : i % 89 == 0 ? 1e6 : echo * 257));
        if (i % 83 == 0) floats.back() = std::numeric_limits<float>::quiet_NaN();
        if (i % 101 == 0) floats.back() = std::numeric_limits<float>::infinity();
        mask.push_back(random() % 4 != 0 ? 1 : 0);
    }
    const VolumeGeometry grid = gridOf(columns, rows, slices);
    std::vector<Volume> volumes{Volume(grid, bytes), Volume(grid, words, 9000.0), Volume(grid, floats, 65535.0)};
    volumes.push_back(masked(volumes[0], mask));
    volumes.push_back(masked(volumes[1], mask));
    // A value that is not finite is no data.
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (!std::isfinite(floats[i])) mask[i] = 0;
    volumes.push_back(masked(volumes[2], mask));
    return volumes;
}

/// Volumes from which no designer can make anything: of one value, or without data.
inline std::vector<Volume> volumesWithoutContrast() {
    const float none = std::numeric_limits<float>::quiet_NaN();
    return {bytesOf({0}),
            bytesOf({77}),
            masked(bytesOf({77}), {0}),
            Volume(gridOf(3, 4, 5), std::vector<std::uint8_t>(60, 0)),
            Volume(gridOf(3, 4, 5), std::vector<std::uint16_t>(60, 65535)),
            Volume(gridOf(3, 4, 5), std::vector<float>(60, 0.25F), 1.0),
            Volume(gridOf(2, 2, 2), std::vector<float>(8, none)),
            masked(bytesOf({3, 200}), {0, 1})};
}

/// The value of a fact. If there is none of that name, the test fails and the value is NaN.
inline double factOf(const Design& design, std::string_view name) {
    for (const DesignFact& fact : design.facts)
        if (fact.name == name) return fact.value;
    ADD_FAILURE() << name;
    return std::numeric_limits<double>::quiet_NaN();
}

/// The plot of that name. Throws std::out_of_range if there is none.
inline const DesignPlot& plotOf(const Design& design, std::string_view name) {
    for (const DesignPlot& plot : design.plots)
        if (plot.name == name) return plot;
    throw std::out_of_range(std::string(name));
}

/// A classification that can be rendered: finite, within [0,1], and not clear everywhere.
inline void expectSound(const Classification& classification) {
    double largest = 0.0;
    for (int i = 0; i <= 100; ++i)
        for (int j = 0; j <= 20; ++j) {
            const double opacity = opacityAt(classification, i / 100.0, j / 20.0);
            ASSERT_TRUE(opacity >= 0.0 && opacity <= 1.0) << i << " " << j;
            largest = std::max(largest, opacity);
        }
    EXPECT_GT(largest, 0.0);
}

/// Checks what every designer promises about cancelling, other grids and parameters out of range.
template <typename Config>
void expectContract(const Config& config) {
    const Volume volume = twoClassVolumes(3).front(), other = bytesOf({1, 2, 3});
    EXPECT_THROW((void)design(config, DesignerInput{volume, other}), std::invalid_argument);
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(design(config, inputOf(volume), Progress{{}, &raised}));
    double last = 0.0;
    const Progress progress{[&last](double share) {
        EXPECT_TRUE(share >= last && share <= 1.0);
        last = share;
    }};
    EXPECT_TRUE(design(config, inputOf(volume), progress));
    EXPECT_EQ(last, 1.0);
    for (const Parameter<Config>& row : parametersOf(config)) {
        EXPECT_FALSE(row.source.empty() || row.meaning.empty() || row.label.empty());
        const auto value = row.get(config);
        if (!value || !numberOf(*value)) continue;
        for (const double outside : {row.range.least - 0.01, row.range.largest + 0.01, std::nan("")}) {
            Config wrong = config;
            ASSERT_TRUE(row.set(wrong, outside));
            EXPECT_THROW((void)design(wrong, inputOf(volume)), std::invalid_argument) << row.name << " " << outside;
        }
    }
}

}  // namespace echolucent
