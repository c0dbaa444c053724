// What a run of the adaptive method gives: the curve and everything that led to it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/opacity_curve.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/tube_core/stage_times.h"
#include "processing/tube_core/tube_core.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// Around the surface of a tube core, in the quiet voxels that the curve is meant for. No values without a surface; of
/// a tube core that says nothing of these voxels the values of TubeCore.
struct QuietInterface {
    std::optional<double> low{}, high{}, fluidSpread{};  ///< I_L, I_H and the fluid's spread, as in TubeCore
};

/// The adaptive curve, the tube cores it was made of and what the run found out on the way. Units are those of
/// processing/tube_core/tube_core.h.
struct AdaptiveOtf {
    static constexpr int sampleCount = 256;
    /// The normalised intensity of a sample, [0, sampleCount).
    [[nodiscard]] static constexpr double intensityOf(std::size_t sample) {
        return static_cast<double>(sample) / (sampleCount - 1);
    }
    AdaptiveOtfConfig config;                      ///< as asked for
    std::array<double, 2> tubeSpacingUnits{0, 0};  ///< as used, units, along the view's right and down axes
    Viewpoint view;
    Vec3 directionVoxel{0, 0, 1};  ///< unit, voxel index space
    double tubeLengthUnit = 1.0;   ///< mm per unit
    int tubesMeetingVolume = 0;    ///< T and N: tube cores that meet the volume's data
    int tubesWithWeight = 0;       ///< status surface and d > 0
    /// No surface stands behind fluid: the surfaces are where the data begin, seen from outside the scanned sector, and
    /// the curve is the initial function.
    bool surfacesWhereDataBegin = false;
    double dMax = 0.0;                    ///< strengthOf(config.curve) / T
    std::vector<TubeCore> tubes;          ///< row-major: index = row * config.grid.columns + column
    std::optional<double> leastContrast;  ///< with RatioRule: a boundary counted from this contrast on
    /// With RatioRule: means below it counted as fluid. It is not set where no boundary tells.
    std::optional<double> fluidIntensity;
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of the voxels that the curve is meant for
    double speckleLeft = 1.0;                            ///< in these, see QuietReading; 1 where nothing was reduced
    std::vector<QuietInterface> quiet{};  ///< of each tube core; empty if the curve is meant for the voxels read
    double trust = 1.0;  ///< with RampRule the curve is trust * ramp + (1 - trust) * initial function, [0,1]
    /// sampleCount values: ln of the curve before any clamp; with ProductRule ln initial(x) + sum over the tubes of
    /// ln(1+d) g(x).
    std::vector<double> logOpacity;
    SampledCurve curve;   ///< min(1, exp(logOpacity))
    std::string message;  ///< a sentence where something could not be done ("No surface found: the initial
                          ///< function is used."); else empty
    StageTimes times;
};

/// Intensities before and at the surfaces that were found: means over the tube cores, weighted by what each brings to
/// the curve (TubeCore::d). Both are 0 where no tube core has weight.
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
