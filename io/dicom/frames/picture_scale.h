// The size of the pixels of a data set's pictures, and the distance of its slices.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "processing/volume/geometry.h"

class DcmItem;

namespace echolucent {

inline constexpr DicomTag pixelSpacingTag{0x0028, 0x0030};
/// Spacing Between Slices, mm; its sign tells the order of frames along the normal.
inline constexpr DicomTag sliceDistanceTag{0x0018, 0x0088};

/// Pixel Spacing (0028,0030) of an item: mm along x (between columns) and y (between rows), both above 0.
[[nodiscard]] std::optional<std::array<double, 2>> dicomPixelSpacing(DcmItem& item);

struct PictureScale {
    enum class Kind {
        stated,
        severalScales,  ///< of several 2D regions with different scales that of the largest: a guess
        shapeOnly,      ///< Pixel Aspect Ratio: 1 along x, and the height of a pixel of width 1 along y
    };
    Kind kind = Kind::stated;
    Vec3 spacing{1, 1, 1};  ///< mm; along z the mean of x and y: a guess
    std::string source;     ///< the tags of x and y
    std::string warning{};  ///< a sentence if the scale is not stated; else empty
};

/// The scale that Pixel Spacing states. Else the scale of the largest 2D ultrasound region; M-modes and spectra do not
/// count; a region that states no format counts as 2D. The region's deltas must be in cm, and its pixels from 0.0001 mm
/// to 10 m large. Regions have different scales if these differ by more than 1 %. Else the shape that Pixel Aspect
/// Ratio states, if pixels are no squares. No value if nothing is stated.
[[nodiscard]] std::optional<PictureScale> pictureScaleOf(DcmItem& dataset);

/// Spacing Between Slices (0018,0088) at top level without its sign, mm; no value if it is missing, 0 or no length.
[[nodiscard]] std::optional<double> statedSliceDistance(DcmItem& dataset);

/// That the distance `mm` which the attribute `source` states is a guess, as the frames follow each other in time.
[[nodiscard]] std::string distanceIsGuess(const std::string& source, double mm);

/// The spacing of slices, and what is known of it.
struct SliceScale {
    Vec3 spacing{1, 1, 1};      ///< mm
    bool spacingKnown = false;  ///< along all axes
    bool inPlaneKnown = false;  ///< whether pixels have a known size; if spacingKnown is false, that alone
    std::string source{};       ///< the tags; empty if nothing is known
    std::vector<std::string> warnings{};
};

/// The spacing of slices that lie `distance` mm apart, as `distanceSource` states; a scale that is not stated is
/// guessed from that distance. If no distance is given, statedSliceDistance() gives it, else it is a guess too.
[[nodiscard]] SliceScale sliceScaleOf(DcmItem& dataset, std::optional<double> distance,
                                      const std::string& distanceSource);

}  // namespace echolucent
