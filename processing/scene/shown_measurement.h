// Measurements as pictures show them: their values in words, and their places in planes and cameras' pictures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "processing/picture/picture_place.h"
#include "processing/scene/measurement.h"
#include "processing/scene/planes.h"

namespace echolucent {

/// The value of a measurement as tables hold it: "12.3" and "mm", or "47.1" and "°" (UTF-8).
struct MeasurementNumber {
    std::string digits;  ///< one decimal; of a distance below 1 mm two, below 0.1 mm three
    std::string_view unit;
};
/// Fails as measuredValue() does.
[[nodiscard]] Result<MeasurementNumber> measurementNumber(const Measurement& measurement,
                                                          const VolumeGeometry& geometry);
/// The value of a measurement in words: "12.3 mm", below 1 mm "0.47 mm", below 0.1 mm "0.047 mm"; "47.1°" (UTF-8).
/// Lists, planes, the 3D view and exports all use these words. Fails as measuredValue() does.
[[nodiscard]] Result<std::string> measurementText(const Measurement& measurement, const VolumeGeometry& geometry);

/// The longest name that pictures show whole, letters.
inline constexpr std::size_t longestShownName = 24;
/// The name of a measurement and its value, as pictures show them: "BPD 47.1 mm". A longer name than longestShownName
/// ends with "…" there. Without a name as measurementText(). Fails as measuredValue() does.
[[nodiscard]] Result<std::string> measurementLabel(const Measurement& measurement, const VolumeGeometry& geometry);

/// What the places of a measurement were marked on, in the words of lists and reports: "in a plane", "on a surface".
[[nodiscard]] std::string_view groundWords(MeasurementGround ground);

/// A measurement as it is drawn in the volume.
struct ShownMeasurement {
    int id = 0;  ///< of the measurement; 0 while a person still makes it
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<Vec3> placesMm{};  ///< grid mm; a line joins them in this order
    std::vector<Vec3> arcMm{};     ///< a second line, between the sides of an angle; else empty
    std::string text{};            ///< measurementLabel(), in 3D with the plane; empty if there is no value yet
    bool dashed = false;           ///< made in a plane, at which a 3D picture may look obliquely
    friend bool operator==(const ShownMeasurement&, const ShownMeasurement&) = default;
};

/// One measurement as it is drawn. While a person makes it, it may have fewer places than its kind needs, and then no
/// text. A complete one without a value (measuredValue()) is never drawn: the result is empty.
[[nodiscard]] std::optional<ShownMeasurement> shownMeasurement(const Measurement& measurement,
                                                               const VolumeGeometry& geometry);
/// All measurements of a phase (counted from 0) that have a value, in their order.
[[nodiscard]] std::vector<ShownMeasurement> shownMeasurements(const std::vector<Measurement>& measurements, int phase,
                                                              const VolumeGeometry& geometry);
/// The same as 3D pictures show them. One that was made in a plane is dashed, and its text ends with the plane that
/// holds it: "12.3 mm (in plane A)", or "(in a plane)" if neither A, B nor C does. A scale bar beside it measures no
/// such line.
[[nodiscard]] std::vector<ShownMeasurement> shownMeasurementsIn3d(const std::vector<Measurement>& measurements,
                                                                  int phase, const Volume& volume, const Planes& planes,
                                                                  BeamAxis beam);

/// A measurement as it is drawn in a picture: as ShownMeasurement, but in heights of the picture from its centre.
struct PlacedMeasurement {
    int id = 0;
    MeasurementKind kind = MeasurementKind::distance;
    std::vector<PicturePlace> places{};
    std::vector<PicturePlace> arc{};
    std::string text{};
    bool dashed = false;
    friend bool operator==(const PlacedMeasurement&, const PlacedMeasurement&) = default;
};

/// A measurement is drawn in a plane if none of its places lies farther than this from the plane, in units
/// (VolumeGeometry::unit()). Planes step by one unit. So at least one step shows a measurement that lies along the
/// planes, and hardly ever do two.
inline constexpr double planeReachUnits = 0.5;

/// Whether all places lie in the plane of a view, within `reachMm` (>= 0).
[[nodiscard]] bool liesInPlane(const std::vector<Vec3>& placesMm, const PlaneView& view, double reachMm);

/// The measurements that lie in the plane of a view, within planeReachUnits of `unitMm`, at their places in its
/// picture.
[[nodiscard]] std::vector<PlacedMeasurement> placedInPlane(const std::vector<ShownMeasurement>& shown,
                                                           const PlaneView& view, double unitMm);
/// The measurements at their places in a camera's picture. In perspective, a measurement is left out if one of its
/// places does not lie before the eye.
[[nodiscard]] std::vector<PlacedMeasurement> placedInPicture(const std::vector<ShownMeasurement>& shown,
                                                             const Camera& camera);

/// The words of a measurement, before they have a place. Lengths are in heights of the picture.
struct MeasurementWords {
    std::vector<PicturePlace> places{};  ///< of the measurement, at least one
    double width = 0.0;                  ///< with the gap between place and words
    double height = 0.0;
};
/// Where the text of a measurement stands: beside one of its places, so that its own lines do not cross it.
struct MeasurementLabel {
    PicturePlace at{};       ///< the end of the text at that place, without the gap, at half the text's height
    bool toTheRight = true;  ///< of that place; else to its left
};
/// Places one label for each text, in a picture of width / height `aspect`. The text stands right of the rightmost
/// place. If it would leave the picture there, it stands left of the leftmost. If it would leave the picture on both
/// sides, it ends at the picture's right edge, below or above the rightmost place, if that is seen. If earlier texts
/// are in the way, it moves up or down to the nearest free place in the picture, if there is one.
[[nodiscard]] std::vector<MeasurementLabel> labelsOf(const std::vector<MeasurementWords>& words, double aspect);

}  // namespace echolucent
