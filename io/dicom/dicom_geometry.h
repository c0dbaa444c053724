// Where the pictures of a DICOM data set lie in space and time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/dicom_attributes.h"
#include "io/slice_stack.h"

class DcmItem;

namespace echolucent {

/// Three finite numbers of an attribute as a point; no value where it holds something else.
[[nodiscard]] std::optional<Vec3> dicomPoint(DcmItem& item, DicomTag tag);
/// The two directions of an image orientation (along a row, along a column), made perpendicular unit vectors; no value
/// where the attribute holds no directions or where they are far from perpendicular.
[[nodiscard]] std::optional<std::array<Vec3, 2>> dicomOrientation(DcmItem& item, DicomTag tag);
/// Pixel Spacing (0028,0030) of an item: mm along x (between columns) and y (between rows), both above 0.
[[nodiscard]] std::optional<std::array<double, 2>> dicomPixelSpacing(DcmItem& item);

/// What one frame says of its place; whatever is missing stays empty.
struct FramePlacement {
    std::optional<Vec3> position;                       ///< mm, of the centre of the first pixel
    DicomTag positionTag;                               ///< which attribute gave the position
    std::optional<std::array<Vec3, 2>> orientation;     ///< along a row, along a column
    bool orientationInPatient = false;                  ///< else in a frame of the volume's own
    std::optional<std::array<double, 2>> pixelSpacing;  ///< mm along x (between columns) and y (between rows)
};

/// The place of a single picture, from Image Position, Image Orientation and Pixel Spacing at top level; no value where
/// the position or the orientation is missing or makes no sense.
[[nodiscard]] std::optional<FramePlacement> topLevelPlacement(DcmItem& dataset);

/// The places of all frames from the old attributes at top level: pixel spacing with grid frame offsets (3004,000C) or
/// with spacing between slices (0018,0088), where frames are not said to follow each other in time. Empty where the
/// data set has no such geometry.
[[nodiscard]] std::vector<FramePlacement> classicPlacements(DcmItem& dataset, std::size_t frames);

/// Pixel spacing (x, y) in mm from (0028,0030) or from the ultrasound regions' deltas in cm; `source` is set to the
/// tags that gave it. No value where both are missing.
[[nodiscard]] std::optional<std::array<double, 2>> pixelSpacingOf(DcmItem& dataset, std::string& source);

}  // namespace echolucent
