// Measurements as pictures show them: their values in words, and where planes and cameras see their places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "processing/picture/picture_place.h"
#include "processing/scene/measurement.h"
#include "processing/scene/planes.h"

namespace echolucent {

/// The value of a measurement in words: "12.3 mm", below 1 mm "0.47 mm", below 0.1 mm "0.047 mm"; "47.1°" (UTF-8).
/// Lists, planes, the 3D view and exports all say it so. Fails as measuredValue() does.
[[nodiscard]] Result<std::string> measurementText(const Measurement& measurement, const VolumeGeometry& geometry);

/// Where its places were marked, as lists and reports say it: "in a plane", "on a surface".
[[nodiscard]] std::string_view groundWords(MeasurementGround ground);

/// What is drawn of a measurement, in the volume.
struct ShownMeasurement {
    int id = 0;  ///< of the measurement; 0 of one that is being made
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<Vec3> placesMm{};  ///< grid mm; a line goes through them in this order
    std::vector<Vec3> arcMm{};     ///< a second line, between the sides of an angle; empty for all else
    std::string text{};            ///< measurementText(); empty where there is no value yet
    friend bool operator==(const ShownMeasurement&, const ShownMeasurement&) = default;
};

/// Of one measurement. Of one that is being made the places may be fewer than its kind needs, and then it has no text.
/// A measurement without a value (measuredValue()) is never drawn: nothing is returned.
[[nodiscard]] std::optional<ShownMeasurement> shownMeasurement(const Measurement& measurement,
                                                               const VolumeGeometry& geometry);
/// Of all measurements of a phase (counted from 0) that have a value, in their order.
[[nodiscard]] std::vector<ShownMeasurement> shownMeasurements(const std::vector<Measurement>& measurements, int phase,
                                                              const VolumeGeometry& geometry);

/// What is drawn of a measurement, in a picture: as ShownMeasurement, in heights of the picture from its centre.
struct PlacedMeasurement {
    int id = 0;
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<PicturePlace> places{};
    std::vector<PicturePlace> arc{};
    std::string text{};
    friend bool operator==(const PlacedMeasurement&, const PlacedMeasurement&) = default;
};

/// How far from a plane a place may lie to be drawn in it, in units (VolumeGeometry::unit()). Planes are stepped by
/// one unit, so that of all steps at least one shows a measurement that lies along them, and hardly ever two do.
inline constexpr double planeReachUnits = 0.5;

/// Whether all places lie in the plane of a view, within `reachMm` (>= 0).
[[nodiscard]] bool liesInPlane(const std::vector<Vec3>& placesMm, const PlaneView& view, double reachMm);

/// Those that lie in the plane of a view, within planeReachUnits of `unitMm`, where its picture shows them.
[[nodiscard]] std::vector<PlacedMeasurement> placedInPlane(const std::vector<ShownMeasurement>& shown,
                                                           const PlaneView& view, double unitMm);
/// Where a camera's picture shows them. In perspective, one of which a place does not lie before the eye is left out.
[[nodiscard]] std::vector<PlacedMeasurement> placedInPicture(const std::vector<ShownMeasurement>& shown,
                                                             const Camera& camera);

/// The words of a measurement, before they have a place. Lengths are in heights of the picture.
struct MeasurementWords {
    std::vector<PicturePlace> places{};  ///< those of the measurement, at least one
    double width = 0.0;                  ///< with the gap between a place and the words
    double height = 0.0;
};
/// Where the text of a measurement stands: beside one of its places, so that its own lines do not cross it.
struct MeasurementLabel {
    PicturePlace at{};       ///< the end of the text at that place, without the gap, at its middle height
    bool toTheRight = true;  ///< of that place; else to its left
};
/// To the right of the rightmost place, or, where the text would leave a picture of width / height `aspect`, to the
/// left of the leftmost; where those before it in the list stand there, as far below or above them as is needed,
/// whichever is nearer, if the picture has room there. One label for each.
[[nodiscard]] std::vector<MeasurementLabel> labelsOf(const std::vector<MeasurementWords>& words, double aspect);

}  // namespace echolucent
