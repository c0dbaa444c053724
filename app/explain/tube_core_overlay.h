// Tube cores over the 3D view.
#pragma once

#include <optional>
#include <vector>

#include "processing/explanation/tube_core_marks.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

namespace echolucent {

/// The 3D view marks at most so many tube cores: the picture stays readable.
inline constexpr std::size_t mostTubeCoresIn3d = 64;

/// The tube cores that the 3D view marks: thinned() ones, and the chosen one if it has a mark.
[[nodiscard]] std::vector<int> tubeCoresIn3d(const TubeCoreMarks& marks, std::optional<int> chosen);

/// Of each of tubeCoresIn3d() a disc at its surface and a short stretch before it, coloured by weight and thicker with
/// more of it. The chosen one is drawn whole, thicker, with its number; also without a surface.
[[nodiscard]] Overlay overlayOf(const TubeCoreMarks& marks, std::optional<int> chosen);

}  // namespace echolucent
