// Levoy 1988 as an OTF designer: opacity over intensity and gradient magnitude, along isovalue contours or region
// boundaries. It finds the levels of fluid and tissue in the volume (docs/designers/levoy.md).
#pragma once

#include <optional>
#include <span>

#include "processing/designers/design.h"
#include "processing/designers/gradients/levoy_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table; the argument only selects it.
[[nodiscard]] const ParameterTable<LevoyConfig>& parametersOf(const LevoyConfig&);

/// A level of the intensity and its opacity.
struct LevoyLevel {
    double intensity = 0.0;  ///< normalised
    double opacity = 0.0;    ///< alpha, per unit
    friend bool operator==(const LevoyLevel&, const LevoyLevel&) = default;
};

/// Opacity of an isovalue contour (Levoy 1988): alpha if f is the level and g = 0; alpha (1 - |f_v - f| / (r g)) if
/// g > 0 and |f_v - f| <= r g; else 0. `gradient` is g per unit, `width` r in units.
[[nodiscard]] double isovalueOpacity(double intensity, double gradient, const LevoyLevel& level, double width);

/// Opacity of region boundaries (Levoy 1988): between neighbouring levels g (alpha_2 (f - f_1) + alpha_1 (f_2 - f)) /
/// (f_2 - f_1). Intensities below the first level or above the last have its alpha. `levels` ascend; there is at least
/// one. `scaledGradient` is clamped into [0,1].
[[nodiscard]] double boundaryOpacity(double intensity, double scaledGradient, std::span<const LevoyLevel> levels);

/// A two-dimensional OTF of one of Levoy's forms. Tube cores read input.raw along input.view; all other levels and the
/// gradients come from input.shown. If tube cores find no surface behind fluid, or both given levels are equal, Otsu's
/// levels replace them. If no level or no gradient is found, the curve is x^2. The message says either.
///
/// The table of isovalues moves each level to its nearest node of the intensity (by 1/2040 at most), so that the crest
/// of a contour is exact. Between nodes it errs by at most alpha (d_f / (r g) + d_g / g), d the distances of the nodes
/// and g the smaller gradient of the cell. The table of boundaries is exact, except within the node distance d_f of a
/// level. There it errs by at most |alpha_2 - alpha_1| / (f_2 - f_1) d_f / 4.
///
/// The result is empty only if progress.cancel was raised. Its bits are the same for any number of threads. Throws
/// std::invalid_argument if a parameter, or one of input.method, is out of its range, or the volumes have different
/// grids.
[[nodiscard]] std::optional<Design> design(const LevoyConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
