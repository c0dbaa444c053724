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
    angle,     ///< at the second of three places, between the ways to the first and to the third
};
/// "distance", "angle".
[[nodiscard]] std::string_view nameOf(MeasurementKind kind);
[[nodiscard]] std::optional<MeasurementKind> measurementKindFromName(std::string_view name);
/// How many places a measurement of a kind has: 2 or 3.
[[nodiscard]] std::size_t placesNeeded(MeasurementKind kind);

/// On what the places of a measurement were marked.
enum class MeasurementGround {
    plane,    ///< plane A, B or C
    surface,  ///< what the 3D view showed
};
/// "plane", "surface".
[[nodiscard]] std::string_view nameOf(MeasurementGround ground);
[[nodiscard]] std::optional<MeasurementGround> measurementGroundFromName(std::string_view name);

/// A measurement belongs to the volume: its places stay where they are, whichever way planes and camera are turned.
struct Measurement {
    int id = 1;  ///< its number in the window, unique in a document, at least 1
    MeasurementKind kind = MeasurementKind::distance;
    MeasurementGround ground = MeasurementGround::plane;
    std::vector<Vec3> placesMm{};  ///< grid mm, as many as the kind needs
    int phase = 0;                 ///< of the 4D study in which the places were marked, counted from 0
    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// What a measurement comes to: mm of a distance, degrees from 0 to 180 of an angle. Lengths are those between patient
/// positions, so that oblique and anisotropic grids measure alike. Fails (wrong usage) where the spacing of the volume
/// is not known, with the reason: neither lengths nor angles are facts then. Fails where the places of a distance
/// coincide, or an angle's vertex with one of its other places.
[[nodiscard]] Result<double> measuredValue(const Measurement& measurement, const VolumeGeometry& geometry);

/// What is wrong with a measurement that was read from a file, lower case, no full stop; an empty text where nothing
/// is.
[[nodiscard]] std::string problemOf(const Measurement& measurement);

}  // namespace echolucent
