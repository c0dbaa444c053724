// The places of a polar volume's samples: along beams, beams side by side in a plane, planes side by side. One value
// describes linear, convex, sector and wobbler probes (docs/scan-conversion.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

/// How the lines of a plane, or the planes of a volume, lie side by side.
enum class PolarSpread {
    positions,  ///< they are parallel, mm apart
    angles,     ///< they are turned about an axis, radians apart
};

/// All lines of a plane, or all planes of a volume.
struct PolarAxis {
    PolarSpread spread = PolarSpread::positions;
    /// One value each, in mm or in radians; 0 is straight ahead. They rise throughout or fall throughout.
    std::vector<double> values;
    /// mm from the axis of the angles to the probe's face, along the beam straight ahead. 0 if beams meet in the face,
    /// negative if the axis lies in front of it. No meaning for positions.
    double radiusMm = 0.0;
    friend bool operator==(const PolarAxis&, const PolarAxis&) = default;
};

/// The geometry of a polar volume. Index order: samples along a beam run fastest, then lines, then planes. *Probe mm*:
/// x runs across the lines, y across the planes, z straight ahead, away from the probe. The origin is the middle of the
/// probe's face. With range d, line value u and plane value v, radii a (lines) and b (planes):
///   within the plane: x = u, w = d (positions);  x = (a + d) sin u, w = (a + d) cos u - a (angles);
///   the plane:        y = v, z = w (positions);  y = (b + w) sin v, z = (b + w) cos v - b (angles).
struct PolarGeometry {
    std::int64_t samples = 2;   ///< along a beam
    double rangeStartMm = 0.0;  ///< from the probe's face to the first sample
    double rangeStepMm = 1.0;   ///< from a sample to the next
    PolarAxis lines, planes;
    friend bool operator==(const PolarGeometry&, const PolarGeometry&) = default;

    [[nodiscard]] std::array<std::int64_t, 3> size() const {
        return {samples, static_cast<std::int64_t>(lines.values.size()),
                static_cast<std::int64_t>(planes.values.size())};
    }
    [[nodiscard]] double rangeEndMm() const { return rangeStartMm + static_cast<double>(samples - 1) * rangeStepMm; }
};

/// The most lines or planes of any probe.
constexpr std::int64_t mostPolarLines = 65536;
/// The most samples of any beam, and of any plane.
constexpr std::int64_t mostPolarSamples = std::int64_t{1} << 20, mostPlaneSamples = std::int64_t{1} << 28;

/// The part of a geometry that makes no sense.
enum class PolarPart { range, lines, planes };

/// One problem of a geometry.
struct PolarProblem {
    PolarPart part = PolarPart::range;
    std::string words;  ///< lower case, without full stop: "are not monotone: 0.2 follows 0.3"
};

/// Why a geometry has no closed-form way back from probe mm. Possible reasons: fewer than two samples, lines or planes;
/// numbers that are not finite or that no probe has; values that are not monotone; angles of half a turn or more; a
/// first sample behind an axis. Empty if all is well.
[[nodiscard]] std::optional<PolarProblem> problemOf(const PolarGeometry& geometry);

/// The position of a sample in probe mm. `index` is (sample, line, plane) in [0, size - 1]. It may lie between samples.
/// Between lines and planes, their values are interpolated.
[[nodiscard]] Vec3 probeMmFromPolar(const PolarGeometry& geometry, const Vec3& index);

/// The index of a value among the values of an axis. It may lie between two of them. Empty if the value lies outside.
[[nodiscard]] std::optional<double> indexOnAxis(const PolarAxis& axis, double value);

/// The origin of the beams: the middle between the axes of lines and planes, in probe mm. Empty if lines or planes are
/// parallel, because they have no axis then.
[[nodiscard]] std::optional<Vec3> apexMm(const PolarGeometry& geometry);

/// The kinds of probes for a person to name: each spread of the lines with each spread of the planes.
enum class PolarKind {
    linear,         ///< parallel lines, parallel planes
    convex,         ///< lines at angles, parallel planes
    linearWobbler,  ///< parallel lines, planes at angles
    wobbler,        ///< lines and planes at angles; a sector if both radii are 0
};
/// Whether a probe of that kind turns its lines, or its planes, about an axis.
[[nodiscard]] bool turnsLines(PolarKind kind);
[[nodiscard]] bool turnsPlanes(PolarKind kind);
[[nodiscard]] PolarKind kindOf(const PolarGeometry& geometry);
/// "linear", "convex", "linear-wobbler", "wobbler".
[[nodiscard]] std::string_view nameOf(PolarKind kind);
[[nodiscard]] std::optional<PolarKind> polarKindFromName(std::string_view name);

/// A geometry of evenly spaced lines and planes, as a person states it.
struct EvenPolar {
    PolarKind kind = PolarKind::wobbler;
    double rangeStartMm = 0.0, rangeStepMm = 0.5;
    std::array<double, 2> lines{-35, 35};   ///< the first and the last: degrees; mm if lines are parallel
    std::array<double, 2> planes{-30, 30};  ///< the first and the last: degrees; mm if planes are parallel
    double lineRadiusMm = 40.0, planeRadiusMm = 25.0;
    friend bool operator==(const EvenPolar&, const EvenPolar&) = default;
};

/// The geometry of `size` samples, lines and planes. A size below 1 counts as 1, and more than mostPolarLines lines or
/// planes count as that many. Radii of parallel lines or planes do not count.
[[nodiscard]] PolarGeometry polarGeometry(const EvenPolar& even, const std::array<std::int64_t, 3>& size);
/// The first and last line and plane of a geometry, as if all lines and planes were evenly spaced.
[[nodiscard]] EvenPolar evenPolarOf(const PolarGeometry& geometry);

}  // namespace echolucent
