// How the intensities around a found surface are read.
#pragma once

namespace echolucent {

/// Lengths are in units: the volume's smallest spacing. The ranges stand in methodParameters().
struct SurfaceRule {
    int lowReach = 10;  ///< I_L is the mean of this many of the last cells that end before the surface cell; if 0, of
                        ///< all prior cells (Petersch 2005, 4.1)
    int highReach = 8;  ///< I_H is the largest cell mean from the surface to this many units behind it; if 0, the mean
                        ///< at the surface (Petersch 2005, 4.1)
    int slopeHalfStep = 5;              ///< the slope is a central difference of cell means over +- this many units
    bool priorCellsMayOverlap = false;  ///< if true, prior cells begin before the surface cell, i < s (Petersch 2005,
                                        ///< eq. 8); else they end before it, i <= s - cell size
    friend bool operator==(const SurfaceRule&, const SurfaceRule&) = default;
};

}  // namespace echolucent
