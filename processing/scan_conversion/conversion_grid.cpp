#include "processing/scan_conversion/conversion_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace echolucent {

namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// The values between which sine and cosine are monotone: the ends of an axis, and the quarter turns between.
std::vector<double> turningValues(const PolarAxis& axis) {
    std::vector<double> values{axis.values.front(), axis.values.back()};
    const double low = std::min(values[0], values[1]), high = std::max(values[0], values[1]);
    if (axis.spread == PolarSpread::angles)
        for (const double quarter : {-0.5, 0.0, 0.5})
            if (const double angle = quarter * std::numbers::pi; angle > low && angle < high) values.push_back(angle);
    return values;
}

/// Extremes of across and along, if samples `low` to `high` mm from the face are spread over an axis.
struct Spread {
    Range across, along;
};
Spread spreadOver(const PolarAxis& axis, double low, double high) {
    Spread spread;
    for (const double value : turningValues(axis))
        for (const double distance : {low, high}) {
            const bool angular = axis.spread == PolarSpread::angles;
            // Samples behind the axis have no position.
            const double from = std::max(distance + axis.radiusMm, 0.0);
            spread.across.add(angular ? from * std::sin(value) : value);
            spread.along.add(angular ? from * std::cos(value) - axis.radiusMm : distance);
        }
    return spread;
}

/// Mean distance of neighbours on an axis at `along` mm from the face.
double neighbourDistance(const PolarAxis& axis, double along) {
    const double mean =
        std::abs(axis.values.back() - axis.values.front()) / static_cast<double>(axis.values.size() - 1);
    return axis.spread == PolarSpread::angles ? mean * (along + axis.radiusMm) : mean;
}

struct Bounds {
    Range axes[3];
};

Bounds boundsOf(const PolarGeometry& polar) {
    const Spread within = spreadOver(polar.lines, polar.rangeStartMm, polar.rangeEndMm());
    const Spread tilted = spreadOver(polar.planes, within.along.low, within.along.high);
    return {{within.across, tilted.across, tilted.along}};
}

double voxelsAlong(const Range& range, double spacing) {
    // Allow a millionth of a voxel for rounding.
    return std::floor((range.high - range.low) / spacing + 1e-6) + 1;
}

double rowsOf(const Bounds& bounds, double spacing) {
    return voxelsAlong(bounds.axes[1], spacing) * voxelsAlong(bounds.axes[2], spacing);
}

double voxelsOf(const Bounds& bounds, double spacing) {
    return voxelsAlong(bounds.axes[0], spacing) * rowsOf(bounds, spacing);
}

/// The least factor by which the spacing must grow to keep the grid within both limits. 1 if the grid is within them.
double excess(const Bounds& bounds, double spacing, const ConversionMemory& memory) {
    return std::max({std::cbrt(voxelsOf(bounds, spacing) / static_cast<double>(memory.mostVoxels())),
                     std::sqrt(rowsOf(bounds, spacing) / static_cast<double>(memory.mostRows())), 1.0});
}

void require(const PolarGeometry& polar) {
    if (const auto problem = problemOf(polar))
        throw std::invalid_argument("scan conversion: the geometry makes no sense: " + problem->words);
}

ConversionGrid gridWithin(const Bounds& bounds, double spacing) {
    ConversionGrid grid;
    for (int axis = 0; axis < 3; ++axis) {
        const Range& range = bounds.axes[axis];
        const double count = voxelsAlong(range, spacing);
        grid.geometry.size[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(count);
        grid.geometry.spacing[axis] = spacing;
        grid.geometry.origin[axis] = 0.5 * (range.low + range.high - (count - 1) * spacing);
    }
    return grid;
}

}  // namespace

std::int64_t ConversionMemory::mostVoxels() const {
    const std::int64_t ofAll = phaseBytes > std::numeric_limits<std::int64_t>::max() / conversionPhasesInFull
                                   ? phaseBytes
                                   : phaseBytes * conversionPhasesInFull / phases;
    return std::max<std::int64_t>(std::min(phaseBytes, ofAll) / bytesPerVoxel, 1);
}

std::int64_t ConversionMemory::mostRows() const { return std::max<std::int64_t>(phaseBytes / conversionRowBytes, 1); }

double finestResolutionMm(const PolarGeometry& polar) {
    require(polar);
    const double middle = 0.5 * (polar.rangeStartMm + polar.rangeEndMm());
    return std::min(
        {polar.rangeStepMm, neighbourDistance(polar.lines, middle), neighbourDistance(polar.planes, middle)});
}

ConversionGrid conversionGridOf(const PolarGeometry& polar, double spacingMm) {
    if (!(spacingMm > 0)) throw std::invalid_argument("scan conversion: the spacing must be above 0");
    require(polar);
    ConversionGrid grid = gridWithin(boundsOf(polar), spacingMm);
    grid.finestMm = finestResolutionMm(polar);
    grid.limitedByMemory = spacingMm > grid.finestMm;
    return grid;
}

ConversionGrid conversionGrid(const PolarGeometry& polar, const ConversionMemory& memory) {
    const double finest = finestResolutionMm(polar);
    const Bounds bounds = boundsOf(polar);
    double spacing = finest;
    // Voxels count whole along each axis, so one step by the excess may not be enough.
    for (double wider = excess(bounds, spacing, memory); wider > 1; wider = excess(bounds, spacing, memory))
        spacing *= std::max(wider, 1.0005);
    ConversionGrid grid = gridWithin(bounds, spacing);
    grid.finestMm = finest;
    grid.limitedByMemory = spacing > finest;
    return grid;
}

}  // namespace echolucent
