// Levoy 1988 as an OTF designer: opacity over intensity and gradient magnitude, along isovalue contours or region
// boundaries. The designer finds the levels of fluid and tissue in the volume (docs/designers/levoy.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "processing/designers/designer_declarations.h"

namespace echolucent {

/// Which of Levoy's forms the opacity has.
enum class LevoyForm : std::uint8_t {
    isovalues,   ///< contours of values, of one thickness everywhere
    boundaries,  ///< boundaries between regions of values; the steeper, the more opaque
};
/// Where the levels of fluid and tissue come from.
enum class LevoyLevels : std::uint8_t {
    tubeCores,  ///< means before and at the surfaces that tube cores found (meanInterfaceOf())
    otsu,       ///< means of the classes below and above Otsu's threshold
    given,      ///< the config's own
};
/// The gradient magnitude that counts as 1 in region boundaries; larger ones count as 1 too.
enum class LevoyGradientScale : std::uint8_t {
    largest,   ///< the largest of the voxels with data
    quantile,  ///< 99 % of the voxels with data do not exceed it; the largest, if this quantile is 0
};

/// The ranges stand in parametersOf().
struct LevoyConfig {
    static constexpr DesignerWords words{"levoy", "Levoy"};
    LevoyForm form = LevoyForm::isovalues;
    LevoyLevels levels = LevoyLevels::tubeCores;
    double fluidLevel = 0.1;      ///< only for LevoyLevels::given: normalised intensity, [0,1]
    double tissueLevel = 0.4;     ///< the same for tissue
    double fluidOpacity = 0.0;    ///< alpha of the fluid level, per unit
    double tissueOpacity = 1.0;   ///< alpha of the tissue level, per unit
    double surfaceOpacity = 1.0;  ///< alpha of the surface's contour between both, per unit; isovalues only
    /// Where the surface's contour lies, as a share of the way from the fluid to the tissue level; isovalues only.
    double surfaceShare = 0.5;
    double transitionWidth = 1.5;  ///< r, half the thickness of a contour, units; isovalues only
    LevoyGradientScale gradientScale = LevoyGradientScale::quantile;  ///< boundaries only
    [[nodiscard]] bool readsTubeCores() const { return levels == LevoyLevels::tubeCores; }
    friend bool operator==(const LevoyConfig&, const LevoyConfig&) = default;
};
[[nodiscard]] const ParameterTable<LevoyConfig>& parametersOf(const LevoyConfig&);

/// A two-dimensional OTF of one of Levoy's forms. Tube cores read input.raw along input.view; all other levels and the
/// gradients come from input.shown. If tube cores find no surface behind fluid, or both given levels are equal, Otsu's
/// levels replace them. If no level or no gradient is found, the curve is x^2. The message says which of these
/// happened.
///
/// The table of isovalues moves each level to its nearest node of the intensity (by 1/2040 at most), so that the crest
/// of a contour is exact. Between nodes it errs by at most alpha (d_f / (r g) + d_g / g), d the distances of the nodes
/// and g the smaller gradient of the cell. The table of boundaries is exact, except within the node distance d_f of a
/// level. There it errs by at most |alpha_2 - alpha_1| / (f_2 - f_1) d_f / 4.
[[nodiscard]] std::optional<Design> design(const LevoyConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

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
/// (f_2 - f_1). Below the first level and above the last it is g times that level's alpha. `levels` ascend; there is at
/// least one. `scaledGradient` is clamped into [0,1].
[[nodiscard]] double boundaryOpacity(double intensity, double scaledGradient, std::span<const LevoyLevel> levels);

}  // namespace echolucent
