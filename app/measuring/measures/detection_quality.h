// How much of the weight lies on tube cores that found the true surface of a phantom.
#pragma once

#include <optional>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent {

struct DetectionQuality {
    double weight = 0.0;       ///< sum of d over the tube cores that count
    double rightWeight = 0.0;  ///< the part of `weight` on tube cores whose surface is within 3 units of the first
                               ///< fluid-tissue interface
    double emptyWeight = 0.0;  ///< the part of `weight` on tube cores without such an interface
    /// Of the tube cores that count: those with an interface, and those of them with the right surface. Then those in
    /// the volume that do not count (TubeTruth::counts).
    int tubesWithInterface = 0, tubesRight = 0, tubesLeftOut = 0;
    int tubesFound = 0;          ///< tube cores with an interface on which any surface was found
    double distanceUnits = 0.0;  ///< sum over tubesFound of |found - true|, units

    [[nodiscard]] double rightShare() const { return weight > 0 ? rightWeight / weight : 0.0; }
    [[nodiscard]] double emptyShare() const { return weight > 0 ? emptyWeight / weight : 0.0; }
    [[nodiscard]] double foundShare() const {
        return tubesWithInterface > 0 ? static_cast<double>(tubesRight) / tubesWithInterface : 0.0;
    }
    /// Mean |found - true| in units, over the tube cores with an interface on which any surface was found.
    [[nodiscard]] double meanDistanceUnits() const { return tubesFound > 0 ? distanceUnits / tubesFound : 0.0; }
    void add(const DetectionQuality& other) {
        weight += other.weight;
        rightWeight += other.rightWeight;
        emptyWeight += other.emptyWeight;
        tubesWithInterface += other.tubesWithInterface;
        tubesRight += other.tubesRight;
        tubesLeftOut += other.tubesLeftOut;
        tubesFound += other.tubesFound;
        distanceUnits += other.distanceUnits;
    }
};

/// Depth of the first interface on a ray parallel to the axis and shifted by offsetMm (grid mm): mm along the view from
/// the grid's origin. No value if the ray has no interface.
[[nodiscard]] std::optional<double> interfaceDepthMm(const PhantomTruth& truth, const VolumeGeometry& geometry,
                                                     const Viewpoint& view, const TubeAxis& axis, const Vec3& offsetMm);

/// Whether the four corners of the tube core see the interface at depths within 10 units, or none of them sees one.
[[nodiscard]] bool cornersAgree(const PhantomTruth& truth, const VolumeGeometry& geometry, const Viewpoint& view,
                                const TubeAxis& axis, int cellSize);

/// The truth of each tube core, in the order of AdaptiveOtf::tubes. Computed once for many runs over one grid.
struct TubeTruth {
    bool counts = false;                     ///< false if the tube core is outside or its corners disagree
    std::optional<double> interfaceDepthMm;  ///< depth along its axis, as interfaceDepthMm() gives it
};
[[nodiscard]] std::vector<TubeTruth> tubeTruths(const PhantomTruth& truth, const VolumeGeometry& geometry,
                                                const Viewpoint& view, const AdaptiveOtfConfig& config);

[[nodiscard]] DetectionQuality detectionQuality(const AdaptiveOtf& otf, const PhantomTruth& truth,
                                                const VolumeGeometry& geometry);
/// detectionQuality() with `truths`, which tubeTruths() gave for the geometry, view, grid and cell size of `otf`.
/// Throws std::invalid_argument if there is not one for each tube core.
[[nodiscard]] DetectionQuality detectionQuality(const AdaptiveOtf& otf, const std::vector<TubeTruth>& truths,
                                                const VolumeGeometry& geometry);

}  // namespace echolucent
