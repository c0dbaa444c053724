// How the cells of a tube core are read.
#pragma once

#include "processing/sampling/interpolation.h"

namespace echolucent {

/// Arithmetic of samples and of the moments of slabs. Tubes on voxels of integers are summed exactly with either choice
/// (TubeReader). The curve is always computed in double.
enum class Precision { single32, double64 };

/// Lengths are in units: the volume's smallest spacing. The ranges stand in methodParameters().
struct CellRule {
    int size = 5;  ///< edge of a cell, units; cells slide along the tube core by one unit (Petersch 2005, 4.1)
    Interpolation sampling = Interpolation::trilinear;  ///< of samples that do not lie on voxels
    Precision precision = Precision::single32;
    friend bool operator==(const CellRule&, const CellRule&) = default;
};

}  // namespace echolucent
