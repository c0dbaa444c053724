#include "processing/scene/scene.h"

#include <algorithm>
#include <utility>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> frontSourceNames{"person", "found"};
/// Farther than any volume; still finite as a float.
constexpr double farthestMm = 1e30;
/// The least cosine between a plane's and a surface's forward. Below it the plane has no depth over the nodes.
constexpr double leastAcross = 0.1;

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
    plane.depthMm = std::vector<float>(4, static_cast<float>(depthMm));
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
    if (!across || front.depthMm == 0.0) return scene;
    const Viewpoint view = viewpointOf(beam, *across, std::exchange(front.depthMm, 0.0));
    const ViewFrame frame = frameOf(view);
    const double behind = std::min(view.nearCutMm, depthAlongViewMm(view, geometry));  // deeper leaves nothing either
    const double depth = nearPlaneDepthMm(view, geometry) - view.nearCutMm + behind;
    if (!front.surface) {
        front.surface = planeAs(frame, depth, geometry);
        return scene;
    }
    CutSurface& surface = *front.surface;
    std::vector<float> depths = surface.depthMm;
    const double rise = frame.forward.dot(surface.frame.forward);
    for (int row = 0; row < surface.rows; ++row)
        for (int column = 0; column < surface.columns; ++column) {
            float& node = depths[static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) +
                                 static_cast<std::size_t>(column)];
            const double ofPlane = (depth - frame.forward.dot(nodeOf(surface, column, row))) / rise;
            node = std::max(node, static_cast<float>(std::min(ofPlane, farthestMm)));
        }
    surface.depthMm = std::move(depths);
    return scene;
}

std::string problemOf(const Scene& scene, BeamAxis beam) {
    if (const std::string problem = problemOf(scene.box); !problem.empty()) return "box " + problem;
    for (std::size_t i = 0; i < scene.strokes.size(); ++i)
        if (const std::string problem = problemOf(scene.strokes[i]); !problem.empty())
            return "strokes[" + std::to_string(i) + "] " + problem;
    if (scene.front.surface)
        if (const std::string problem = problemOf(*scene.front.surface); !problem.empty())
            return "front.surface " + problem;
    const Front& front = scene.front;
    if (!front.surface || front.depthMm == 0.0 || !front.direction) return {};
    const Vec3 forward = frameOf(viewpointOf(beam, *front.direction, 0.0)).forward;
    if (forward.dot(front.surface->frame.forward) < leastAcross)
        return "front.direction must look about the same way as front.surface";
    return {};
}

}  // namespace echolucent
