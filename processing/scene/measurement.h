// What a person measures in a volume: distances and angles between places that were marked.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

enum class MeasurementKind {
    distance,  ///< between two places
    angle,     ///< at the second of three places, between the ways to the first and the third
};
/// "distance", "angle".
[[nodiscard]] std::string_view nameOf(MeasurementKind kind);
[[nodiscard]] std::optional<MeasurementKind> measurementKindFromName(std::string_view name);
/// How many places a measurement of a kind has: 2 or 3.
[[nodiscard]] std::size_t placesNeeded(MeasurementKind kind);

/// What the places of a measurement were marked on.
enum class MeasurementGround {
    plane,    ///< plane A, B or C
    surface,  ///< what the 3D view showed
};
/// "plane", "surface".
[[nodiscard]] std::string_view nameOf(MeasurementGround ground);
[[nodiscard]] std::optional<MeasurementGround> measurementGroundFromName(std::string_view name);

/// The longest name and the longest comment of a measurement, letters.
inline constexpr std::size_t longestMeasurementName = 80, longestMeasurementComment = 500;

/// A measurement belongs to the volume: its places stay, however planes and camera are turned.
struct Measurement {
    int id = 1;  ///< its number in the window, unique in a document, at least 1
    MeasurementKind kind = MeasurementKind::distance;
    MeasurementGround ground = MeasurementGround::plane;
    std::vector<Vec3> placesMm{};  ///< grid mm, as many as the kind needs
    int phase = 0;                 ///< of a 4D study, counted from 0: the places were marked in it
    std::string name{};            ///< what was measured ("BPD"), one line of UTF-8; empty if nobody has named it
    std::string comment{};         ///< UTF-8, its lines end with "\n"; empty if there is none
    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// The value of a measurement with all places that its kind needs: a distance in mm, or an angle from 0 to 180 degrees.
/// It is measured between patient positions, so that oblique and anisotropic grids measure alike. Fails (wrong usage),
/// with the reason, if the spacing of the volume is unknown: then lengths and angles are no facts. Fails if the places
/// of a distance coincide, or an angle's vertex with one of its other places.
[[nodiscard]] Result<double> measuredValue(const Measurement& measurement, const VolumeGeometry& geometry);

/// A text that a person typed, as the name of a measurement: oneLine(), without blanks at its ends, not too long.
[[nodiscard]] std::string measurementNameOf(std::string_view typed);
/// A text that a person typed, as the comment of a measurement: each of its lines oneLine(), not too long.
[[nodiscard]] std::string measurementCommentOf(std::string_view typed);

/// Whether planes show data at a place, grid mm: it lies in the volume's box, and VolumeSampler finds an intensity
/// there. Only such a place may be marked.
[[nodiscard]] bool holdsData(const Volume& volume, const Vec3& gridMm);

/// What is wrong with a measurement that was read from a file: lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const Measurement& measurement);

}  // namespace echolucent
