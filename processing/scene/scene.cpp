#include "processing/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<2> frontSourceNames{"person", "found"};
constexpr double leastDepthMm = 0.1;  // of a front that a hand moves

/// The node of a surface that lies nearest to the volume's centre, as a place in CutSurface::depthMm.
std::size_t middleNodeOf(const CutSurface& surface, const VolumeGeometry& geometry) {
    const Vec3 middle = geometry.centreMm();
    const auto nearest = [&](const Vec3& axis, double first, int count) {
        return std::clamp(static_cast<int>(std::lround((axis.dot(middle) - first) / surface.spacingMm)), 0, count - 1);
    };
    const int column = nearest(surface.frame.right, surface.firstRightMm, surface.columns);
    const int row = nearest(surface.frame.down, surface.firstDownMm, surface.rows);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.columns) + static_cast<std::size_t>(column);
}

}  // namespace

std::string_view nameOf(FrontSource source) { return nameIn(frontSourceNames, source); }

std::optional<FrontSource> frontSourceFromName(std::string_view name) {
    return choiceNamed<FrontSource>(frontSourceNames, name);
}

bool cuts(const Front& front) { return front.surface || front.depthMm > 0.0; }

Front frontAcross(const ViewDirection& direction, double depthMm, FrontSource source) {
    return depthMm > 0.0 ? Front{.depthMm = depthMm, .direction = direction, .source = source} : Front{};
}

double depthOf(const Front& front, const VolumeGeometry& geometry) {
    if (!front.surface) return front.depthMm;
    const CutSurface& surface = *front.surface;
    return static_cast<double>(surface.depthMm[middleNodeOf(surface, geometry)]) -
           geometry.depthsAlong(surface.frame.forward).nearest;
}

Front movedTo(Front front, double depthMm, const VolumeGeometry& geometry) {
    if (!front.surface) return frontAcross(front.direction, depthMm);
    const auto by = static_cast<float>(depthMm - depthOf(front, geometry));
    front.surface->depthMm.change([by](std::vector<float>& depths) {
        for (float& depth : depths) depth += by;
    });
    if (front.depthMm > 0.0) front.depthMm = std::max(0.0, front.depthMm + static_cast<double>(by));
    front.source = FrontSource::person;
    return front;
}

Front movedBy(const Front& front, double mm, BeamAxis beam, const VolumeGeometry& geometry) {
    const auto depths = geometry.depthsAlong(forwardOf(front, beam));
    const double most = std::max(leastDepthMm, depths.farthest - depths.nearest);
    return movedTo(front, std::clamp(depthOf(front, geometry) + mm, leastDepthMm, most), geometry);
}

Front acrossView(const Front& front, const Viewpoint& view, const Vec3& pointMm, const VolumeGeometry& geometry) {
    constexpr double leastSlope = 0.1;
    const Vec3 along = frameOf(view).forward, forward = forwardOf(front, view.beamAxis);
    // A bowed front is taken as the plane through its place before or behind the point.
    const double depth =
        front.surface ? front.surface->depthAt(pointMm) : geometry.depthsAlong(forward).nearest + front.depthMm;
    const double slope = forward.dot(along), behind = depth - forward.dot(pointMm);
    const Vec3 place = pointMm + (slope > leastSlope ? along * (behind / slope) : forward * behind);
    constexpr double step = 0.1;
    const double most = std::floor(0.99 * depthAlongViewMm(view, geometry) / step) * step;
    const double across = std::round((along.dot(place) - geometry.depthsAlong(along).nearest) / step) * step;
    return frontAcross(directionOf(view), std::clamp(across, step, std::max(step, most)));
}

Vec3 forwardOf(const Front& front, BeamAxis beam) {
    return front.surface ? front.surface->frame.forward : frameOf(viewpointOf(beam, front.direction)).forward;
}

Viewpoint behindFront(Viewpoint view, const Front& front) {
    view.frontPlane.reset();
    if (front.depthMm > 0.0)
        view.frontPlane = FrontPlane{frameOf(viewpointOf(view.beamAxis, front.direction)).forward, front.depthMm};
    view.cutSurface = front.surface;
    return view;
}

Look shownLook(const Scene& scene) {
    Look look = scene.look;
    look.brightness *= scene.exposure;
    return look;
}

std::string problemOf(const Scene& scene) {
    if (!(scene.exposure > 0.0 && scene.exposure <= 1.0)) return "exposure must be above 0 and at most 1";
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
