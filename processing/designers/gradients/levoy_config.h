// The config of the designer by Levoy (docs/designers/levoy.md).
#pragma once

#include <cstdint>

#include "processing/designers/designer_words.h"

namespace echolucent {

/// Which of Levoy's forms opacity has.
enum class LevoyForm : std::uint8_t {
    isovalues,   ///< contours of values, as thick everywhere
    boundaries,  ///< boundaries between regions of values, as opaque as they are steep
};
/// What gives the levels of fluid and tissue.
enum class LevoyLevels : std::uint8_t {
    tubeCores,  ///< means before and at the surfaces that tube cores found (meanInterfaceOf())
    otsu,       ///< means of the classes below and above Otsu's threshold
    given,      ///< the config's own
};
/// What the gradient magnitude is divided by in region boundaries; larger ones count as 1.
enum class LevoyGradientScale : std::uint8_t {
    largest,   ///< the largest of the voxels with data
    quantile,  ///< what 99 % of the voxels with data do not exceed
};

/// The ranges stand in parametersOf().
struct LevoyConfig {
    static constexpr DesignerWords words{"levoy", "Levoy"};
    LevoyForm form = LevoyForm::isovalues;
    LevoyLevels levels = LevoyLevels::tubeCores;
    double fluidLevel = 0.1;       ///< where levels are given: normalised intensity, [0,1]
    double tissueLevel = 0.4;      ///< the same of tissue
    double fluidOpacity = 0.0;     ///< alpha of the fluid level, per unit
    double tissueOpacity = 1.0;    ///< alpha of the tissue level, per unit
    double surfaceOpacity = 1.0;   ///< alpha of the surface's contour between both, per unit; isovalues only
    double surfaceShare = 0.5;     ///< its value: this share of the way from the fluid to the tissue level
    double transitionWidth = 1.5;  ///< r, half the thickness of a contour, units; isovalues only
    LevoyGradientScale gradientScale = LevoyGradientScale::quantile;  ///< boundaries only
    [[nodiscard]] bool readsTubeCores() const { return levels == LevoyLevels::tubeCores; }
    friend bool operator==(const LevoyConfig&, const LevoyConfig&) = default;
};

}  // namespace echolucent
