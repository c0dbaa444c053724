// What a run of the adaptive method gives: the curve and everything that led to it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/found_ramp.h"
#include "processing/opacity_curve.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/tube_core/stage_times.h"
#include "processing/tube_core/tube_core.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// Intensities around a tube core's surface, in the quiet voxels for which the curve is meant. They are TubeCore's
/// values if the tube core has no weight or the quiet voxels show no rise. They are not set if the tube core has no
/// surface.
struct QuietInterface {
    std::optional<double> low{}, high{}, fluidSpread{};  ///< I_L, I_H and the fluid's spread, as in TubeCore
};

/// The adaptive curve, its tube cores and all that the run found. Units are those of processing/tube_core/tube_core.h.
struct AdaptiveOtf {
    static constexpr int sampleCount = 256;
    /// The normalised intensity of a sample, [0, sampleCount).
    [[nodiscard]] static constexpr double intensityOf(std::size_t sample) {
        return static_cast<double>(sample) / (sampleCount - 1);
    }
    AdaptiveOtfConfig config;                      ///< as asked for
    bool lengthsHalved = false;                    ///< whether it ran with halvedLengths() of `config`: configUsed()
    std::array<double, 2> tubeSpacingUnits{0, 0};  ///< as used, units, along the view's right and down axes
    Viewpoint view;
    Vec3 directionVoxel{0, 0, 1};  ///< the view direction, of length 1, voxel index space
    double tubeLengthUnit = 1.0;   ///< mm per unit
    int tubesMeetingVolume = 0;    ///< T and N: tube cores that meet the volume's data
    int tubesWithWeight = 0;       ///< status surface and d > 0
    /// If true, no surface stands behind fluid. The surfaces are where the data begin, seen from outside the scanned
    /// sector, and the curve is the initial function.
    bool surfacesWhereDataBegin = false;
    double dMax = 0.0;                    ///< strengthOf(config.curve) / T; 0 if T is 0
    std::vector<TubeCore> tubes;          ///< row-major: index = row * config.grid.columns + column
    std::optional<double> leastContrast;  ///< with RatioRule: the least contrast of a boundary that counts
    /// With RatioRule: means below it count as fluid. Empty if the view shows no boundary of fluid.
    std::optional<double> fluidIntensity;
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of the voxels for which the curve is meant
    /// The share of the speckle that is left in the voxels for which the curve is meant, see QuietReading. 1 without
    /// reduction. With one, no value if none was measured: with VarianceRule, without a weight, or if
    /// surfacesWhereDataBegin.
    std::optional<double> speckleLeft = 1.0;
    /// Of each tube core. Empty if the curve is meant for the voxels read, if no tube core has a weight, or if
    /// surfacesWhereDataBegin.
    std::vector<QuietInterface> quiet{};
    /// With RampRule::aim above 0: the ramp that shows every surface found, in the voxels for which the curve is meant.
    /// Empty if no tube core has a weight, or if surfacesWhereDataBegin.
    std::optional<FoundRamp> everyWall{};
    double trust = 1.0;  ///< [0,1]; with RampRule the curve is trust * RampRule::opacity * ((1 - aim) * mean ramp + aim
                         ///< * everyWall) + (1 - trust) * initial function; 1 with ProductRule
    /// sampleCount values: ln of the curve before the clamp to 1. With ProductRule: ln initial(x) + sum over the tubes
    /// of ln(1+d) g(x).
    std::vector<double> logOpacity;
    SampledCurve curve;  ///< min(1, exp(logOpacity)); without a weight exactly the initial function
    /// A sentence if something could not be done ("No surface found: the initial function is used."); else empty.
    std::string message;
    StageTimes times;
};

/// The number of tube cores that found a surface.
[[nodiscard]] inline int surfacesFound(const AdaptiveOtf& otf) {
    return static_cast<int>(std::ranges::count(otf.tubes, TubeStatus::surface, &TubeCore::status));
}
/// The sum of TubeCore::d: with ProductRule the part of the strength that is used.
[[nodiscard]] inline double sumOfD(const AdaptiveOtf& otf) {
    return std::accumulate(otf.tubes.begin(), otf.tubes.end(), 0.0,
                           [](double sum, const TubeCore& tube) { return sum + tube.d; });
}

/// Intensities before and at the surfaces found: means over the tube cores, weighted by TubeCore::d, their weight in
/// the curve. Both are 0 if no tube core has a weight.
struct MeanInterface {
    double low = 0.0, high = 0.0;  ///< I_L and I_H, normalised
};
[[nodiscard]] inline MeanInterface meanInterfaceOf(const AdaptiveOtf& otf) {
    MeanInterface sum;
    double weight = 0.0;
    for (const TubeCore& tube : otf.tubes) {
        if (!(tube.d > 0.0) || !tube.lowIntensity || !tube.highIntensity) continue;
        sum.low += tube.d * *tube.lowIntensity;
        sum.high += tube.d * *tube.highIntensity;
        weight += tube.d;
    }
    return weight > 0.0 ? MeanInterface{sum.low / weight, sum.high / weight} : MeanInterface{};
}

}  // namespace echolucent
