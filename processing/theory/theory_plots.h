// What pages and the window show of section 4: plots and sentences.
#pragma once

#include <string>
#include <vector>

#include "processing/plots/plot.h"
#include "processing/theory/contrast_course.h"

namespace echolucent {

/// "Difference, share of white", "Michelson contrast", "Weber contrast".
[[nodiscard]] std::string labelOf(ContrastKind kind);
/// "thickness of the fluid, units", "c2 / c1".
[[nodiscard]] std::string labelOf(CourseAxis axis);
/// Where the setting's own model stands on an axis. Empty on `ratio` if c1 is 0 or c2 is above it.
[[nodiscard]] std::optional<double> placeOf(const TwoIntensities& model, CourseAxis axis);

/// The setting's curves over intensity, with marks at c2 and c1.
[[nodiscard]] Plot opacityPlot(const TheorySetting& setting);
/// The pixels into tissue of all curves along an axis, and faint behind them those of fluid alone. A mark stands at the
/// setting's model.
[[nodiscard]] Plot pixelPlot(const TheorySetting& setting, const ContrastCourse& course, CourseAxis axis);
/// The contrast of all curves along an axis. Weber contrast has a logarithmic axis.
[[nodiscard]] Plot contrastPlot(const TheorySetting& setting, const ContrastCourse& course, CourseAxis axis);

/// "By difference, the tissue is shown best by eq. 1 and adaptive: 0.333 of white. The parabola beats the line at every
/// depth." Both sentences speak of the difference, whatever the setting's contrast is.
[[nodiscard]] std::string winnerSentence(const TheorySetting& setting);
/// Three digits behind the point, as every table writes pixels and contrasts; "-" if there is no value.
[[nodiscard]] std::string shareText(const std::optional<double>& value);

}  // namespace echolucent
