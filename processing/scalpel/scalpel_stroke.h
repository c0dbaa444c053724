// A scalpel's cuts as plain values: strokes drawn over a picture and carried through the volume.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "processing/picture/camera.h"
#include "processing/shared_list.h"

namespace echolucent {

/// How a person draws a stroke.
enum class ScalpelTool {
    freehand,  ///< a closed outline, drawn in one go
    polygon,   ///< a closed outline of straight lines
    box,       ///< a rectangle
    eraser,    ///< a line as wide as the eraser
};
/// "freehand", "polygon", "box", "eraser".
[[nodiscard]] std::string_view nameOf(ScalpelTool tool);
[[nodiscard]] std::optional<ScalpelTool> scalpelToolFromName(std::string_view name);

/// The part of the picture that a stroke cuts.
enum class ScalpelSide { inside, outside };
/// "inside", "outside".
[[nodiscard]] std::string_view nameOf(ScalpelSide side);
[[nodiscard]] std::optional<ScalpelSide> scalpelSideFromName(std::string_view name);

/// One stroke. Its camera fixes it to the volume.
struct ScalpelStroke {
    ScalpelTool tool = ScalpelTool::freehand;
    ScalpelSide side = ScalpelSide::inside;  ///< an eraser always cuts inside
    Camera camera{};
    /// Places in the picture: right and down of its centre, in picture heights. An outline (three places or more) is
    /// closed from its last place to its first. It holds a place if it winds around the place an odd number of times.
    /// An eraser's line has one place or more.
    SharedList<std::array<double, 2>> places{};
    double radius = 0.0;  ///< of an eraser, picture heights, above 0; 0 for other tools
    /// The stroke cuts nothing farther than this along camera.frame.forward, mm from the grid origin. If not set, it
    /// cuts through everything.
    std::optional<double> depthMm{};
    friend bool operator==(const ScalpelStroke&, const ScalpelStroke&) = default;
};

/// What is wrong with a stroke read from a file, lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const ScalpelStroke& stroke);

/// Whether a stroke cuts a place of the grid, mm: the plain definition. In perspective, no stroke cuts a place that
/// does not lie before the eye.
[[nodiscard]] bool cutsAway(const ScalpelStroke& stroke, const Vec3& gridMm);

}  // namespace echolucent
