#include "processing/document/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> frontSourceNames{"person", "found"};

/// The node (column, row) of a surface, grid mm, at depth 0.
Vec3 nodeOf(const CutSurface& surface, int column, int row) {
    return surface.frame.right * (surface.firstRightMm + surface.spacingMm * column) +
           surface.frame.down * (surface.firstDownMm + surface.spacingMm * row);
}

/// A plane over the whole volume, as a surface of two by two nodes.
CutSurface planeAs(const ViewFrame& frame, double depthMm, const VolumeGeometry& geometry) {
    CutSurface plane{.frame = frame, .columns = 2, .rows = 2};
    const Vec3 middle = (geometry.boxMinMm() + geometry.boxMaxMm()) * 0.5;
    plane.spacingMm = length(geometry.boxMaxMm() - geometry.boxMinMm());
    plane.firstRightMm = frame.right.dot(middle) - plane.spacingMm / 2;
    plane.firstDownMm = frame.down.dot(middle) - plane.spacingMm / 2;
    plane.depthMm.assign(4, static_cast<float>(depthMm));
    return plane;
}

}  // namespace

std::string_view nameOf(FrontSource source) { return nameIn(frontSourceNames, source); }

std::optional<FrontSource> frontSourceFromName(std::string_view name) {
    return choiceNamed<FrontSource>(frontSourceNames, name);
}

Scene withFrontAcrossPose(Scene scene, BeamAxis beam, const VolumeGeometry& geometry) {
    Front& front = scene.front;
    const auto across = std::exchange(front.direction, std::nullopt);
    if (!across || *across == scene.pose.direction || front.depthMm == 0.0) return scene;
    const Viewpoint view = viewpointOf(beam, *across, std::exchange(front.depthMm, 0.0));
    const ViewFrame frame = frameOf(view);
    const double depth = nearPlaneDepthMm(view, geometry);
    if (!front.surface) {
        front.surface = planeAs(frame, depth, geometry);
        return scene;
    }
    CutSurface& surface = *front.surface;
    const double rise = frame.forward.dot(surface.frame.forward);
    // A plane along the surface's own way has no depth over its nodes.
    constexpr double leastRise = 1e-6;
    if (rise < leastRise) return scene;
    for (int row = 0; row < surface.rows; ++row)
        for (int column = 0; column < surface.columns; ++column) {
            float& node = surface.depthMm[static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) +
                                          static_cast<std::size_t>(column)];
            const double ofPlane = (depth - frame.forward.dot(nodeOf(surface, column, row))) / rise;
            node = std::max(node, static_cast<float>(ofPlane));
        }
    return scene;
}

std::string problemOf(const Scene& scene) {
    if (const std::string problem = problemOf(scene.box); !problem.empty()) return "box " + problem;
    for (std::size_t i = 0; i < scene.strokes.size(); ++i)
        if (const std::string problem = problemOf(scene.strokes[i]); !problem.empty())
            return "strokes[" + std::to_string(i) + "] " + problem;
    if (scene.front.surface)
        if (const std::string problem = problemOf(*scene.front.surface); !problem.empty())
            return "front.surface " + problem;
    return {};
}

}  // namespace echolucent
