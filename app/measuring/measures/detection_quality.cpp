#include "app/measuring/measures/detection_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/halved_lengths.h"
#include "processing/parallel.h"
#include "processing/viewpoint/shown_stretch.h"

namespace echolucent {

std::optional<double> interfaceDepthMm(const PhantomTruth& truth, const VolumeGeometry& geometry, const Viewpoint& view,
                                       const TubeAxis& axis, const Vec3& offsetMm) {
    const Vec3 start = axis.pointMm + offsetMm;
    const auto shown = ShownStretches(view, geometry).of(start);
    if (!shown) return std::nullopt;
    const double startDepth = axis.directionMm.dot(start);
    const auto point = truth.firstInterfacePoint(start, axis.directionMm, startDepth + shown->begin);
    if (!point || axis.directionMm.dot(*point) > startDepth + shown->end) return std::nullopt;
    return axis.directionMm.dot(*point);
}

bool cornersAgree(const PhantomTruth& truth, const VolumeGeometry& geometry, const Viewpoint& view,
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

std::vector<TubeTruth> tubeTruths(const PhantomTruth& truth, const VolumeGeometry& geometry, const Viewpoint& view,
                                  const AdaptiveOtfConfig& config) {
    const auto axes = tubeAxes(geometry, view, config.grid, config.cells.size);
    std::vector<TubeTruth> truths(axes.size());
    parallelFor(std::size_t{0}, axes.size(), [&](std::size_t t) {
        if (!axes[t].entryVoxel || !cornersAgree(truth, geometry, view, axes[t], config.cells.size)) return;
        truths[t] = {true, interfaceDepthMm(truth, geometry, view, axes[t], {0, 0, 0})};
    });
    return truths;
}

DetectionQuality detectionQuality(const AdaptiveOtf& otf, const std::vector<TubeTruth>& truths,
                                  const VolumeGeometry& geometry) {
    if (truths.size() != otf.tubes.size())
        throw std::invalid_argument("detectionQuality: the truth is of another grid of tube cores");
    constexpr double rightWithin = 3.0;  // units
    const Vec3 forward = frameOf(otf.view).forward;
    DetectionQuality quality;
    for (std::size_t t = 0; t < truths.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        if (tube.status == TubeStatus::outside) continue;
        if (!truths[t].counts) {
            ++quality.tubesLeftOut;
            continue;
        }
        quality.weight += tube.d;
        if (!truths[t].interfaceDepthMm) {
            quality.emptyWeight += tube.d;
            continue;
        }
        ++quality.tubesWithInterface;
        if (!tube.surfaceVoxel) continue;
        const double found = forward.dot(geometry.gridMmFromVoxel(*tube.surfaceVoxel));
        const double distance = std::abs(found - *truths[t].interfaceDepthMm) / geometry.unit();
        ++quality.tubesFound;
        quality.distanceUnits += distance;
        if (distance > rightWithin) continue;
        ++quality.tubesRight;
        quality.rightWeight += tube.d;
    }
    return quality;
}

DetectionQuality detectionQuality(const AdaptiveOtf& otf, const PhantomTruth& truth, const VolumeGeometry& geometry) {
    return detectionQuality(otf, tubeTruths(truth, geometry, otf.view, configUsed(otf)), geometry);
}

}  // namespace echolucent
