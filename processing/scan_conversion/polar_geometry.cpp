#include "processing/scan_conversion/polar_geometry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "processing/choice_names.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double farthestMm = 1e4;
/// How far beyond the first or last sample, line or plane a position still counts, for rounding.
constexpr double forgivenPosition = 1e-6;

constexpr ChoiceNames<4> kindNames{"linear", "convex", "linear-wobbler", "wobbler"};

bool isAngular(const PolarAxis& axis) { return axis.spread == PolarSpread::angles; }

/// Where a place `along` mm before the transducer's face comes to lie if it is turned by `angle` about an axis that
/// lies `radius` mm behind the face.
struct Turned {
    double across, along;
};
Turned turned(double along, double angle, double radius) {
    return {(radius + along) * std::sin(angle), (radius + along) * std::cos(angle) - radius};
}

double valueAt(const PolarAxis& axis, double index) {
    const std::size_t last = axis.values.size() - 1;
    const auto before = std::min(static_cast<std::size_t>(std::max(index, 0.0)), last - 1);
    const double share = index - static_cast<double>(before);
    return axis.values[before] + share * (axis.values[before + 1] - axis.values[before]);
}

std::optional<std::string> problemOfRange(const PolarGeometry& geometry) {
    if (geometry.samples < 2)
        return "has " + textOf(static_cast<double>(geometry.samples)) + " sample(s), not two or more";
    if (geometry.samples > mostPolarSamples ||
        geometry.samples > mostPlaneSamples / std::max<std::int64_t>(geometry.size()[1], 1))
        return "has " + textOf(static_cast<double>(geometry.samples)) + " samples, more than any scanner has";
    // Ask whether each number lies inside, because every comparison with NaN is false.
    if (!(geometry.rangeStepMm >= 1e-4 && geometry.rangeStepMm <= 100))
        return "has a step of " + textOf(geometry.rangeStepMm) + " mm, which no scanner has";
    if (!(std::abs(geometry.rangeStartMm) <= farthestMm))
        return "starts at " + textOf(geometry.rangeStartMm) + " mm, where no scanner begins";
    if (!(geometry.rangeEndMm() <= farthestMm))
        return "ends at " + textOf(geometry.rangeEndMm()) + " mm, farther than any scanner reaches";
    return std::nullopt;
}

std::optional<std::string> problemOfAxis(const PolarAxis& axis, double rangeStartMm) {
    const bool angular = isAngular(axis);
    if (axis.values.size() < 2) return "are " + textOf(static_cast<double>(axis.values.size())) + ", not two or more";
    if (axis.values.size() > static_cast<std::size_t>(mostPolarLines))
        return "are " + textOf(static_cast<double>(axis.values.size())) + ", more than any scanner has";
    for (const double value : axis.values) {
        if (angular && !(std::abs(value) < pi))
            return "hold " + textOf(value) + " radians, which is no angle between minus and plus half a turn";
        if (!angular && !(std::abs(value) <= farthestMm)) return "hold " + textOf(value) + " mm, which no scanner has";
    }
    const bool rise = axis.values[1] > axis.values[0];
    for (std::size_t i = 1; i < axis.values.size(); ++i)
        if (rise ? !(axis.values[i] > axis.values[i - 1]) : !(axis.values[i] < axis.values[i - 1]))
            return "neither rise nor fall throughout: " + textOf(axis.values[i]) + " follows " +
                   textOf(axis.values[i - 1]);
    if (!angular) return std::nullopt;
    if (!(std::abs(axis.radiusMm) <= farthestMm))
        return "turn about an axis " + textOf(axis.radiusMm) + " mm from the face, which no probe has";
    if (rangeStartMm + axis.radiusMm < -forgivenPosition)
        return "turn about an axis that lies behind the first sample, at " + textOf(-axis.radiusMm) + " mm";
    return std::nullopt;
}

PolarAxis evenAxis(PolarSpread spread, const std::array<double, 2>& ends, double radiusMm, std::int64_t count) {
    PolarAxis axis;
    axis.spread = spread;
    const bool angular = spread == PolarSpread::angles;
    if (angular) axis.radiusMm = radiusMm;
    const double unit = angular ? pi / 180 : 1.0;
    count = std::clamp<std::int64_t>(count, 1, mostPolarLines);
    for (std::int64_t i = 0; i < count; ++i) {
        const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
        axis.values.push_back(unit * (ends[0] * (1 - share) + ends[1] * share));
    }
    return axis;
}

std::array<double, 2> endsOf(const PolarAxis& axis) {
    if (axis.values.empty()) return {0, 0};
    const double unit = isAngular(axis) ? 180 / pi : 1.0;
    return {unit * axis.values.front(), unit * axis.values.back()};
}

}  // namespace

std::optional<PolarProblem> problemOf(const PolarGeometry& geometry) {
    if (auto words = problemOfRange(geometry)) return PolarProblem{PolarPart::range, *words};
    if (auto words = problemOfAxis(geometry.lines, geometry.rangeStartMm))
        return PolarProblem{PolarPart::lines, *words};
    if (auto words = problemOfAxis(geometry.planes, geometry.rangeStartMm))
        return PolarProblem{PolarPart::planes, *words};
    return std::nullopt;
}

Vec3 probeMmFromPolar(const PolarGeometry& geometry, const Vec3& index) {
    const double range = geometry.rangeStartMm + index[0] * geometry.rangeStepMm;
    const double line = valueAt(geometry.lines, index[1]), plane = valueAt(geometry.planes, index[2]);
    const Turned within =
        isAngular(geometry.lines) ? turned(range, line, geometry.lines.radiusMm) : Turned{line, range};
    const Turned tilted = isAngular(geometry.planes) ? turned(within.along, plane, geometry.planes.radiusMm)
                                                     : Turned{plane, within.along};
    return {within.across, tilted.across, tilted.along};
}

std::optional<double> indexOnAxis(const PolarAxis& axis, double value) {
    const bool rise = axis.values.back() > axis.values.front();
    const auto after = rise ? std::upper_bound(axis.values.begin(), axis.values.end(), value)
                            : std::upper_bound(axis.values.begin(), axis.values.end(), value, std::greater<>());
    const auto last = static_cast<std::ptrdiff_t>(axis.values.size()) - 1;
    const auto before = std::clamp<std::ptrdiff_t>(after - axis.values.begin() - 1, 0, last - 1);
    const double low = axis.values[static_cast<std::size_t>(before)];
    const double high = axis.values[static_cast<std::size_t>(before + 1)];
    const double index = static_cast<double>(before) + (value - low) / (high - low);
    if (!(index >= -forgivenPosition && index <= static_cast<double>(last) + forgivenPosition)) return std::nullopt;
    return std::clamp(index, 0.0, static_cast<double>(last));
}

std::optional<Vec3> apexMm(const PolarGeometry& geometry) {
    if (!isAngular(geometry.lines) || !isAngular(geometry.planes)) return std::nullopt;
    return Vec3(0, 0, -0.5 * (geometry.lines.radiusMm + geometry.planes.radiusMm));
}

bool turnsLines(PolarKind kind) { return kind == PolarKind::convex || kind == PolarKind::wobbler; }
bool turnsPlanes(PolarKind kind) { return kind == PolarKind::linearWobbler || kind == PolarKind::wobbler; }

PolarKind kindOf(const PolarGeometry& geometry) {
    if (isAngular(geometry.planes)) return isAngular(geometry.lines) ? PolarKind::wobbler : PolarKind::linearWobbler;
    return isAngular(geometry.lines) ? PolarKind::convex : PolarKind::linear;
}

std::string_view nameOf(PolarKind kind) { return nameIn(kindNames, kind); }

std::optional<PolarKind> polarKindFromName(std::string_view name) { return choiceNamed<PolarKind>(kindNames, name); }

PolarGeometry polarGeometry(const EvenPolar& even, const std::array<std::int64_t, 3>& size) {
    const auto spreadIf = [](bool angular) { return angular ? PolarSpread::angles : PolarSpread::positions; };
    PolarGeometry geometry;
    geometry.samples = std::max<std::int64_t>(size[0], 1);
    geometry.rangeStartMm = even.rangeStartMm;
    geometry.rangeStepMm = even.rangeStepMm;
    geometry.lines = evenAxis(spreadIf(turnsLines(even.kind)), even.lines, even.lineRadiusMm, size[1]);
    geometry.planes = evenAxis(spreadIf(turnsPlanes(even.kind)), even.planes, even.planeRadiusMm, size[2]);
    return geometry;
}

EvenPolar evenPolarOf(const PolarGeometry& geometry) {
    EvenPolar even;
    even.kind = kindOf(geometry);
    even.rangeStartMm = geometry.rangeStartMm;
    even.rangeStepMm = geometry.rangeStepMm;
    even.lines = endsOf(geometry.lines);
    even.planes = endsOf(geometry.planes);
    even.lineRadiusMm = geometry.lines.radiusMm;
    even.planeRadiusMm = geometry.planes.radiusMm;
    return even;
}

}  // namespace echolucent
