// Planes in space, put in order as the slices of one volume. This file knows nothing of files' formats.
#pragma once

#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// Where one picture lies in the patient: the centre of its first pixel, and the directions in which columns and rows
/// count up (unit vectors; DICOM's Image Orientation).
struct SlicePlane {
    Vec3 position{0, 0, 0};
    Vec3 alongRow{1, 0, 0};
    Vec3 alongColumn{0, 1, 0};
    std::string file{};  ///< that holds the picture, where each has one of its own
};

/// How the slices of one volume lie on each other.
struct SliceStack {
    std::vector<std::size_t> order;  ///< indices of the planes, ascending along the normal
    Vec3 origin{0, 0, 0};            ///< position of the first slice
    Mat3 direction = Mat3::eye();    ///< columns: along a row, along a column, normal
    double spacing = 1.0;            ///< mm between slices, their mean distance
    std::vector<std::string> warnings;
};

/// Sorts planes along their common normal. Fails (about the file of the plane concerned, or else `file`, naming
/// `positionTag`) where a position is no number or farther than 10 km away, where the planes are not parallel, where
/// two share a position, or where distances differ from their mean by more than a tenth. `planes` holds at least two.
[[nodiscard]] Result<SliceStack> stackSlices(const std::string& file, const std::string& positionTag,
                                             const std::vector<SlicePlane>& planes);

}  // namespace echolucent
