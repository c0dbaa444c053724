// Polar geometries of every kind, and a slow, obvious conversion as a measure for the fast one.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "processing/scan_conversion/scan_conversion.h"

namespace echolucent {

struct NamedPolar {
    std::string name;
    PolarGeometry polar;
};

/// Every kind of probe, a sector, falling and uneven angles, and angles beyond a quarter turn.
inline std::vector<NamedPolar> everyPolar(std::array<std::int64_t, 3> size = {30, 17, 13}) {
    std::vector<NamedPolar> all{
        {"linear", polarGeometry({PolarKind::linear, 5, 1.5, {-20, 20}, {-12, 15}, 0, 0}, size)},
        {"convex", polarGeometry({PolarKind::convex, 2, 1.5, {-35, 30}, {-12, 12}, 40, 0}, size)},
        {"linear wobbler", polarGeometry({PolarKind::linearWobbler, 0, 1.5, {-20, 20}, {-25, 30}, 0, 12}, size)},
        {"wobbler", polarGeometry({PolarKind::wobbler, 0, 1.5, {-35, 35}, {-30, 25}, 40, 25}, size)},
        {"axis of planes in front", polarGeometry({PolarKind::wobbler, 8, 1.5, {-20, 20}, {-30, 30}, 10, -6}, size)},
        {"sector", polarGeometry({PolarKind::wobbler, 0, 1.5, {-45, 40}, {-30, 30}, 0, 0}, size)},
        {"falling", polarGeometry({PolarKind::wobbler, 1, 1.5, {35, -35}, {30, -30}, 40, 25}, size)},
        {"three quarters of a turn", polarGeometry({PolarKind::wobbler, 3, 1.5, {-130, 140}, {-100, 120}, 4, 5}, size)},
        {"to one side", polarGeometry({PolarKind::wobbler, 3, 1.5, {95, 150}, {10, 40}, 4, 60}, size)},
    };
    PolarGeometry uneven = all[3].polar;
    for (PolarAxis* axis : {&uneven.lines, &uneven.planes}) {
        const double step = axis->values[1] - axis->values[0];
        for (std::size_t i = 0; i < axis->values.size(); ++i)
            axis->values[i] += 0.3 * step * std::sin(3.0 * static_cast<double>(i));
    }
    all.push_back({"uneven", uneven});
    return all;
}

/// A smooth value from 0 to 200, with waves of 30 mm.
inline double smoothAt(const Vec3& mm) {
    const double turn = 2 * std::numbers::pi / 30;
    return 100 + 100.0 / 3 * (std::sin(turn * mm[0]) + std::sin(turn * mm[1] + 1) + std::sin(turn * mm[2] + 2));
}

template <typename Value, typename Function>
std::vector<Value> sampledValues(const PolarGeometry& polar, const Function& function) {
    const auto size = polar.size();
    std::vector<Value> values;
    for (std::int64_t plane = 0; plane < size[2]; ++plane)
        for (std::int64_t line = 0; line < size[1]; ++line)
            for (std::int64_t sample = 0; sample < size[0]; ++sample) {
                const double value = function(probeMmFromPolar(
                    polar, {static_cast<double>(sample), static_cast<double>(line), static_cast<double>(plane)}));
                values.push_back(static_cast<Value>(std::is_floating_point_v<Value> ? value : std::round(value)));
            }
    return values;
}

/// The way back from probeMmFromPolar(): the index (sample, line, plane) at a position in probe mm. Empty outside the
/// insonified region, which reaches from the first sample, line and plane to the last, and a millionth of a sample
/// beyond, for rounding. Parts of beams behind the axis of the planes belong to no position.
inline std::optional<Vec3> polarFromProbeMm(const PolarGeometry& geometry, const Vec3& mm) {
    double plane = mm[1], along = mm[2];
    if (geometry.planes.spread == PolarSpread::angles) {
        const double depth = mm[2] + geometry.planes.radiusMm;
        plane = std::atan2(mm[1], depth);
        along = std::hypot(mm[1], depth) - geometry.planes.radiusMm;
    }
    double line = mm[0], range = along;
    if (geometry.lines.spread == PolarSpread::angles) {
        const double depth = along + geometry.lines.radiusMm;
        line = std::atan2(mm[0], depth);
        range = std::hypot(mm[0], depth) - geometry.lines.radiusMm;
    }
    constexpr double forgiven = 1e-6;
    const double sample = (range - geometry.rangeStartMm) / geometry.rangeStepMm;
    const auto last = static_cast<double>(geometry.samples - 1);
    if (!(sample >= -forgiven && sample <= last + forgiven)) return std::nullopt;
    const auto lineIndex = indexOnAxis(geometry.lines, line), planeIndex = indexOnAxis(geometry.planes, plane);
    if (!lineIndex || !planeIndex) return std::nullopt;
    return Vec3(std::clamp(sample, 0.0, last), *lineIndex, *planeIndex);
}

/// Trilinear in double, at an index of the polar volume.
template <typename Value>
double plainTrilinear(const PolarGeometry& polar, const std::vector<Value>& values, const Vec3& index) {
    const auto size = polar.size();
    double sum = 0;
    std::array<std::int64_t, 3> low{};
    Vec3 share;
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        low[at] = std::min(static_cast<std::int64_t>(index[axis]), size[at] - 2);
        share[axis] = index[axis] - static_cast<double>(low[at]);
    }
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<std::int64_t, 3> place = low;
        for (int axis = 0; axis < 3; ++axis) {
            const bool high = (corner >> axis & 1) != 0;
            weight *= high ? share[axis] : 1 - share[axis];
            place[static_cast<std::size_t>(axis)] += high ? 1 : 0;
        }
        if (weight > 0)
            sum += weight * static_cast<double>(
                                values[static_cast<std::size_t>(place[0] + size[0] * (place[1] + size[1] * place[2]))]);
    }
    return sum;
}

/// Calls use(offset, x, y, z, probe mm) for every voxel of a grid.
template <typename Use>
void forEachVoxel(const ConversionGrid& grid, const Use& use) {
    const auto& size = grid.geometry.size;
    std::size_t offset = 0;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x, ++offset)
                use(offset,
                    grid.probeMmFromVoxel({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}));
}

}  // namespace echolucent
