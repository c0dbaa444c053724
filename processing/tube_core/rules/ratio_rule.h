// Detection by the ratio of means before and behind a boundary (docs/method.md, "Detection by ratio").
#pragma once

namespace echolucent {

/// Lengths are in units along the tube core; a slab is one unit long. Contrasts are in standard deviations of a slab's
/// voxels (SpeckleScale). methodParameters() holds the ranges, and the experiment that chose each value.
struct RatioRule {
    double falseAlarm = 3.25;    ///< the least contrast of a surface, in standard deviations of the contrast without a
                                 ///< boundary; if 0, contrastFloor alone holds
    double contrastFloor = 0.5;  ///< the least contrast of a surface is never below this
    /// The least contrast of a surface is never above this, because speckle never has such a contrast.
    double contrastCeiling = 4.0;
    int slabsBefore = 10;        ///< slabs averaged before a boundary; leastFluid are enough if the tube begins later
    int slabsBehind = 6;         ///< slabs averaged behind a boundary; half of them are enough if the tube ends
    int rampSlabs = 3;           ///< slabs on each side of a boundary that may lie on its ramp
    int leastFluid = 8;          ///< at least this many slabs must lie before a surface
    int leastDark = 6;           ///< this many slabs before a surface must be darker than the fluid level: a gap
                                 ///< thinner than leastFluid, less its ramps, is no fluid
    double leastStep = 0.15;     ///< a surface rises by this share of the view's bright mean: slow changes of gain
                                 ///< and steps of one grey level are no surfaces, even without noise
    double certainty = 5.0;      ///< this contrast, in the deviations of falseAlarm, is no accident even among
                                 ///< thousands of boundaries
    double certainShare = 0.01;  ///< a view holds surfaces only if this share of its tube cores, at least one, holds
                                 ///< a contrast of `certainty`
    double leastRatio = 2.1;     ///< if echo is not compressed, tissue is typically this many times as bright as
                                 ///< fluid; a view of weaker boundaries holds bright tissue behind darker tissue
    friend bool operator==(const RatioRule&, const RatioRule&) = default;
};

}  // namespace echolucent
