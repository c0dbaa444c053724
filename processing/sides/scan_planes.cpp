#include "processing/sides/scan_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<4> evidenceNames{"none", "file", "spacing", "grain"};

constexpr double clearRatio = 1.6;  // of the two lengths: the elevation is beyond doubt
constexpr double sureFrom = 0.5;

/// The grid axis along which a unit vector lies; empty if it lies along none.
std::optional<int> axisAlong(const Vec3& direction) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(direction[axis]) > 1.0 - 1e-6) return axis;
    return std::nullopt;
}

/// The planes if `lengths`, in mm along the grid axes, are longest along the elevation.
ScanPlanes planesBy(const Vec3& lengths, int right, int down, ScanPlaneEvidence evidence) {
    const int elevation = lengths[right] > lengths[down] ? right : down, lateral = right + down - elevation;
    const double ratio = lengths[elevation] / lengths[lateral];
    ScanPlanes planes;
    planes.confidence = std::clamp((ratio - 1.0) / (clearRatio - 1.0), 0.0, 1.0);
    planes.sure = planes.confidence >= sureFrom;
    planes.evidence = evidence;
    // Towards the larger index, so that pictures of the planes look alike whichever way the beam runs.
    planes.lateral = Vec3(0, 0, 0);
    planes.lateral[lateral] = 1.0;
    planes.sentence = std::string("The scan planes lie across ") + "xyz"[elevation] +
                      (evidence == ScanPlaneEvidence::spacing ? ": voxels lie farther apart that way."
                                                              : ": the echo's grain is coarser that way.");
    return planes;
}

}  // namespace

std::string_view nameOf(ScanPlaneEvidence evidence) { return nameIn(evidenceNames, evidence); }

ScanPlanes scanPlanesOf(const VolumeGeometry& geometry, const Viewpoint& fromProbe, const Vec3& grainMm) {
    const ViewFrame frame = frameOf(fromProbe);
    constexpr double sameWay = 1.0 - 1e-6;
    // Of another beam, which a person chose, the file says nothing.
    if (const auto& probe = geometry.probe; probe && probe->planesKnown && frame.forward.dot(probe->forward) > sameWay)
        return {normalized(probe->down.cross(probe->forward)), ScanPlaneEvidence::file, 1.0, true,
                "The file says how the scan planes lay."};
    ScanPlanes planes;
    planes.lateral = frame.right;
    planes.sentence = "It cannot be told how the scan planes lay.";
    const auto right = axisAlong(frame.right), down = axisAlong(frame.down);
    if (!right || !down) return planes;
    if (geometry.spacingKnown) {
        if (auto bySpacing = planesBy(geometry.spacing, *right, *down, ScanPlaneEvidence::spacing); bySpacing.sure)
            return bySpacing;
    }
    auto byGrain = planesBy(grainMm, *right, *down, ScanPlaneEvidence::grain);
    if (byGrain.sure) return byGrain;
    planes.confidence = byGrain.confidence;
    return planes;
}

}  // namespace echolucent
