#include "processing/scalpel/scalpel_stroke.h"

#include <algorithm>
#include <cmath>

#include "processing/choice_names.h"
#include "processing/picture/picture_place.h"
#include "processing/scalpel/outline.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<4> toolNames{"freehand", "polygon", "box", "eraser"};
constexpr ChoiceNames<2> sideNames{"inside", "outside"};
constexpr std::size_t mostPlaces = 100'000;  // limits the memory and time that a file can ask for

/// Whether an outline winds around a place an odd number of times.
bool insideOutline(const std::vector<PicturePlace>& outline, const PicturePlace& at) {
    bool inside = false;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++)
        if (scalpel::crosses(outline[before], outline[i], at)) inside = !inside;
    return inside;
}

bool underEraser(const ScalpelStroke& stroke, const PicturePlace& at) {
    for (std::size_t i = 0; i < stroke.places.size(); ++i)
        if (scalpel::liesWithin(stroke.radius, stroke.places[i > 0 ? i - 1 : 0], stroke.places[i], at)) return true;
    return false;
}

}  // namespace

std::string_view nameOf(ScalpelTool tool) { return nameIn(toolNames, tool); }
std::optional<ScalpelTool> scalpelToolFromName(std::string_view name) {
    return choiceNamed<ScalpelTool>(toolNames, name);
}

std::string_view nameOf(ScalpelSide side) { return nameIn(sideNames, side); }
std::optional<ScalpelSide> scalpelSideFromName(std::string_view name) {
    return choiceNamed<ScalpelSide>(sideNames, name);
}

std::string problemOf(const ScalpelStroke& stroke) {
    const bool eraser = stroke.tool == ScalpelTool::eraser;
    if (!eraser && stroke.places.size() < 3) return "has an outline of fewer than three places";
    if (stroke.places.empty()) return "has no place";
    if (stroke.places.size() > mostPlaces) return "has more than 100000 places";
    if (!std::ranges::all_of(stroke.places, [](const PicturePlace& place) {
            return std::isfinite(place[0]) && std::isfinite(place[1]);
        }))
        return "has a place that is not finite";
    if (!std::isfinite(stroke.radius) || (eraser ? !(stroke.radius > 0.0) : stroke.radius != 0.0))
        return eraser ? "has a radius that is not above 0" : "has a radius without an eraser";
    if (eraser && stroke.side != ScalpelSide::inside) return "has an eraser that cuts outside";
    if (stroke.depthMm && !std::isfinite(*stroke.depthMm)) return "has a depth that is not finite";
    if (const std::string camera = problemOf(stroke.camera); !camera.empty()) return "has a camera that " + camera;
    return {};
}

bool cutsAway(const ScalpelStroke& stroke, const Vec3& gridMm) {
    if (stroke.depthMm && stroke.camera.frame.forward.dot(gridMm) > *stroke.depthMm) return false;
    const std::optional<PicturePlace> place = placeInPicture(stroke.camera, gridMm);
    if (!place) return false;  // it lies beside or behind the eye
    if (stroke.tool == ScalpelTool::eraser) return underEraser(stroke, *place);
    return insideOutline(stroke.places, *place) == (stroke.side == ScalpelSide::inside);
}

}  // namespace echolucent
