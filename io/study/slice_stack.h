// Puts planes in space in order as the slices of one volume. This file knows nothing of file formats.
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
    std::string file{};  ///< the picture's file, if each picture has its own
};

/// The order and the geometry of a volume's slices.
struct SliceStack {
    std::vector<std::size_t> order;  ///< indices of the planes, ascending along the normal
    Vec3 origin{0, 0, 0};            ///< position of the first slice
    Mat3 direction = Mat3::eye();    ///< columns: along a row, along a column, normal
    double spacing = 1.0;            ///< mean distance of slices, mm
    std::vector<std::string> warnings;
};

/// Sorts planes along their common normal. Fails if a position is no number or farther than 10 km away, or if the
/// planes are not parallel. It also fails if two share a position, or if distances differ from their mean by more than
/// a tenth. The failure is about the file of the plane in question, or about `file` if the plane names none, and names
/// `positionTag`. `planes` holds at least two.
[[nodiscard]] Result<SliceStack> stackSlices(const std::string& file, const std::string& positionTag,
                                             const std::vector<SlicePlane>& planes);

}  // namespace echolucent
