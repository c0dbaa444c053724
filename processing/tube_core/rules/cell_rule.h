// How the cells of a tube core are read.
#pragma once

namespace echolucent {

/// How a tube core's samples are taken where they do not lie on voxels.
enum class TubeSampling { trilinear, nearest };

/// Arithmetic of samples, moments and interface function. The curve is double always.
enum class Precision { single32, double64 };

/// Lengths are in units: the volume's smallest spacing. The ranges stand in methodParameters().
struct CellRule {
    int size = 5;  ///< edge of a cell, units; cells slide along the tube core by one unit (Petersch 2005, 4.1)
    TubeSampling sampling = TubeSampling::trilinear;
    Precision precision = Precision::single32;
    friend bool operator==(const CellRule&, const CellRule&) = default;
};

}  // namespace echolucent
