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

/// Positions that differ by less are one place, mm: a micrometre, the last of three decimals, with which programs write
/// positions. Slices of true volumes lie much farther apart.
inline constexpr double samePositionMm = 1e-3;

/// How far the directions of two planes lie apart: the longer of the differences of their unit vectors. Of small angles
/// that is the angle in radians.
[[nodiscard]] double turnBetween(const SlicePlane& a, const SlicePlane& b);

/// Whether the planes are turned by less than 0.001: as much as directions that are rounded to three decimals may seem
/// to be. The far edge of a picture of 200 mm lies 0.2 mm off then. Directions that are no numbers are parallel to
/// none.
[[nodiscard]] bool areParallel(const SlicePlane& a, const SlicePlane& b);

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
