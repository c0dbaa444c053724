// Where the pictures of a DICOM data set lie in space and time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/study/slice_stack.h"
#include "processing/result.h"

class DcmItem;

namespace echolucent {

/// Three finite numbers of an attribute as a point; else no value.
[[nodiscard]] std::optional<Vec3> dicomPoint(DcmItem& item, DicomTag tag);
/// The two directions of an image orientation (along a row, along a column), made perpendicular unit vectors. No value
/// unless the attribute holds two vectors that are nearly of length 1 and nearly perpendicular.
[[nodiscard]] std::optional<std::array<Vec3, 2>> dicomOrientation(DcmItem& item, DicomTag tag);

/// What one frame says of its place; missing parts are empty.
struct FramePlacement {
    std::optional<Vec3> position;                       ///< mm, of the centre of the first pixel
    std::optional<std::array<Vec3, 2>> orientation;     ///< along a row, along a column
    bool orientationInPatient = false;                  ///< else in the volume's own frame of reference
    std::optional<std::array<double, 2>> pixelSpacing;  ///< mm along x (between columns) and y (between rows)
};

/// The place of a single picture, from Image Position, Image Orientation and Pixel Spacing at top level. No value if
/// the position or the orientation is missing or makes no sense.
[[nodiscard]] std::optional<FramePlacement> topLevelPlacement(DcmItem& dataset);

/// The places of frames by the old attributes at top level.
struct ClassicPlaces {
    SlicePlane start;                      ///< distances count from here along the normal of this plane
    bool orientationInPatient = false;     ///< whether the file states the orientation; else it is assumed
    PictureScale scale;                    ///< of the pixels: stated, or of one of several regions
    std::string name;                      ///< of the attribute that stackSlices() blames if the places make no sense
    std::optional<double> between{};       ///< mm from frame to frame; the first lies at the start
    std::vector<double> offsets{};         ///< else the distance of each frame from the start, mm
    bool isBetweenGuess = false;           ///< whether `between` is a guess, because times of frames are stated too
    std::optional<double> otherBetween{};  ///< mm from frame to frame that the file states beside offsets
    std::vector<std::string> warnings{};
};

/// The places of all frames by the old attributes at top level: pixel spacing or the scale of ultrasound regions with
/// grid frame offsets (3004,000C), with slice locations (0018,2005) that the increment pointer names, or with spacing
/// between slices (0018,0088). Position and orientation may stand in the first item of Detector Information
/// (0054,0022), and are left out with a note if they make no sense there. The spacing between slices is a guess if
/// ultrasound regions give the scale and times of frames are stated. No value if the data set has no such geometry, if
/// the spacing between slices is 0, or if the data set says that its frames follow each other in time. Fails
/// (unreadable, about the file at `path`, with Failure::framesCouldBeSlices) if the geometry makes no sense: offsets
/// for more or fewer frames, or a bad spacing, position or orientation. `frames` may be any number; the result is no
/// larger than the file.
[[nodiscard]] Result<std::optional<ClassicPlaces>> classicPlaces(DcmItem& dataset, const std::string& path,
                                                                 std::size_t frames);

}  // namespace echolucent
