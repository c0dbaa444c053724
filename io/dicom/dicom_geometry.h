// Where the pictures of a DICOM data set lie in space and time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/slice_stack.h"

class DcmItem;

namespace echolucent {

/// What one frame says of its place; whatever is missing stays empty.
struct FramePlacement {
    std::optional<Vec3> position;
    std::optional<std::array<Vec3, 2>> orientation;     ///< along a row, along a column
    std::optional<std::array<double, 2>> pixelSpacing;  ///< mm along x (between columns) and y (between rows)
    std::optional<double> time;                         ///< seconds, or an index where timeIsIndex
    bool timeIsIndex = false;
    std::string dataType;  ///< (0018,9808): TISSUE_INTENSITY, FLOW, ...
};

/// Three numbers as a point; none where the attribute does not hold three.
[[nodiscard]] std::optional<FramePlacement> topLevelPlacement(DcmItem& dataset);

/// The places of all frames from the functional groups (shared, then per frame); fewer where the sequence is short,
/// none where there are no functional groups.
[[nodiscard]] std::vector<FramePlacement> functionalGroupPlacements(DcmItem& dataset, std::size_t frames);

/// Places by the old attributes at top level: pixel spacing with grid frame offsets (3004,000C) or with spacing between
/// slices (0018,0088), where frames are not said to follow each other in time. None where there is no such geometry.
[[nodiscard]] std::vector<FramePlacement> classicPlacements(DcmItem& dataset, std::size_t frames);

/// Pixel spacing (x, y) in mm from (0028,0030) or from the ultrasound regions' deltas in cm; source says which.
[[nodiscard]] std::optional<std::array<double, 2>> pixelSpacingOf(DcmItem& dataset, std::string& source);

}  // namespace echolucent
