// How much of the weight lies on tubes that found the true surface of a phantom.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "processing/adaptive_otf.h"
#include "processing/phantom.h"
#include "processing/tube_core/tube_grid.h"

namespace echolucent {

struct DetectionQuality {
    double weight = 0.0;       ///< sum of d over the tubes in the count
    double rightWeight = 0.0;  ///< ... on tubes whose surface is within 3 units of the first fluid-tissue interface
    double emptyWeight = 0.0;  ///< ... on tubes without such an interface
    int tubesWithInterface = 0, tubesRight = 0, tubesLeftOut = 0;

    [[nodiscard]] double rightShare() const { return weight > 0 ? rightWeight / weight : 0.0; }
    [[nodiscard]] double emptyShare() const { return weight > 0 ? emptyWeight / weight : 0.0; }
    [[nodiscard]] double foundShare() const {
        return tubesWithInterface > 0 ? static_cast<double>(tubesRight) / tubesWithInterface : 0.0;
    }
    void add(const DetectionQuality& other) {
        weight += other.weight;
        rightWeight += other.rightWeight;
        emptyWeight += other.emptyWeight;
        tubesWithInterface += other.tubesWithInterface;
        tubesRight += other.tubesRight;
        tubesLeftOut += other.tubesLeftOut;
    }
};

/// Distance in mm along the view, from the grid's origin, of the first interface on a ray parallel to the axis.
inline std::optional<double> interfaceDepthMm(const PhantomTruth& truth, const VolumeGeometry& geometry,
                                              const View& view, const TubeAxis& axis, const Vec3& offsetMm) {
    const double nearDepth = nearPlaneDepthMm(view, geometry);
    const Vec3 point = axis.pointMm + offsetMm;
    const auto units = truth.firstInterface(point, axis.directionMm, nearDepth);
    if (!units) return std::nullopt;
    double begin = nearDepth - axis.directionMm.dot(point);
    for (int i = 0; i < 3; ++i) {
        if (axis.directionMm[i] == 0.0) continue;
        const double low = (geometry.boxMinMm()[i] - point[i]) / axis.directionMm[i];
        const double high = (geometry.boxMaxMm()[i] - point[i]) / axis.directionMm[i];
        begin = std::max(begin, std::min(low, high));
    }
    return axis.directionMm.dot(point) + begin + *units * geometry.unit();
}

/// Whether the four corners of the tube core see the interface at depths no more than 10 units apart, or none of them.
inline bool cornersAgree(const PhantomTruth& truth, const VolumeGeometry& geometry, const View& view,
                         const TubeAxis& axis, int cellSize) {
    const ViewFrame frame = frameOf(view);
    const double half = (cellSize - 1) / 2.0 * geometry.unit();
    double least = 1e300, most = -1e300;
    int without = 0;
    for (const auto& [right, down] : std::array<std::pair<int, int>, 4>{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}}) {
        const auto depth =
            interfaceDepthMm(truth, geometry, view, axis, frame.right * (right * half) + frame.down * (down * half));
        if (!depth) {
            ++without;
            continue;
        }
        least = std::min(least, *depth);
        most = std::max(most, *depth);
    }
    return without == 4 || (without == 0 && most - least <= 10 * geometry.unit());
}

inline DetectionQuality detectionQuality(const AdaptiveOtf& otf, const PhantomTruth& truth,
                                         const VolumeGeometry& geometry) {
    DetectionQuality quality;
    const auto axes = tubeAxes(geometry, otf.view, otf.config);
    for (std::size_t t = 0; t < axes.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        if (tube.status == TubeStatus::outside) continue;
        if (!cornersAgree(truth, geometry, otf.view, axes[t], otf.config.cellSize)) {
            ++quality.tubesLeftOut;
            continue;
        }
        const auto depth = interfaceDepthMm(truth, geometry, otf.view, axes[t], {0, 0, 0});
        quality.weight += tube.d;
        if (!depth) {
            quality.emptyWeight += tube.d;
            continue;
        }
        ++quality.tubesWithInterface;
        if (!tube.surfaceVoxel) continue;
        const double found = axes[t].directionMm.dot(geometry.gridMmFromVoxel(*tube.surfaceVoxel));
        if (std::abs(found - *depth) > 3.0 * geometry.unit()) continue;
        ++quality.tubesRight;
        quality.rightWeight += tube.d;
    }
    return quality;
}

}  // namespace echolucent
