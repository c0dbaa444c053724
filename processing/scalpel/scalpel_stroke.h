// What the scalpel cut out of a volume, as plain values: strokes drawn over a picture and carried through the volume.
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

/// What of a stroke is cut.
enum class ScalpelSide { inside, outside };
/// "inside", "outside".
[[nodiscard]] std::string_view nameOf(ScalpelSide side);
[[nodiscard]] std::optional<ScalpelSide> scalpelSideFromName(std::string_view name);

/// One stroke. It is fixed to the volume by the camera that it was drawn under.
struct ScalpelStroke {
    ScalpelTool tool = ScalpelTool::freehand;
    ScalpelSide side = ScalpelSide::inside;  ///< an eraser always cuts inside
    Camera camera{};
    /// Places in the picture: right and down of its centre, in picture heights. An outline (three places or more) is
    /// closed from its last place to its first, and what it winds around an odd number of times is inside it; an
    /// eraser's line has one place or more.
    SharedList<std::array<double, 2>> places{};
    double radius = 0.0;  ///< of an eraser, picture heights, above 0; 0 for the other tools
    /// Nothing is cut farther than this along camera.frame.forward, mm from the grid origin; not set: through
    /// everything.
    std::optional<double> depthMm{};
    friend bool operator==(const ScalpelStroke&, const ScalpelStroke&) = default;
};

/// What is wrong with a stroke that was read from a file, lower case, no full stop; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const ScalpelStroke& stroke);

/// Whether a stroke cuts a place of the grid, mm: the plain definition.
[[nodiscard]] bool cutsAway(const ScalpelStroke& stroke, const Vec3& gridMm);

}  // namespace echolucent
