// The config of the designer by Levoy (docs/designers/levoy.md).
#pragma once

#include <cstdint>

#include "processing/designers/designer_words.h"

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
    quantile,  ///< 99 % of the voxels with data do not exceed it
};

/// The ranges stand in parametersOf().
struct LevoyConfig {
    static constexpr DesignerWords words{"levoy", "Levoy"};
    LevoyForm form = LevoyForm::isovalues;
    LevoyLevels levels = LevoyLevels::tubeCores;
    double fluidLevel = 0.1;       ///< only for LevoyLevels::given: normalised intensity, [0,1]
    double tissueLevel = 0.4;      ///< the same for tissue
    double fluidOpacity = 0.0;     ///< alpha of the fluid level, per unit
    double tissueOpacity = 1.0;    ///< alpha of the tissue level, per unit
    double surfaceOpacity = 1.0;   ///< alpha of the surface's contour between both, per unit; isovalues only
    double surfaceShare = 0.5;     ///< where it lies, as a share of the way from the fluid to the tissue level
    double transitionWidth = 1.5;  ///< r, half the thickness of a contour, units; isovalues only
    LevoyGradientScale gradientScale = LevoyGradientScale::quantile;  ///< boundaries only
    [[nodiscard]] bool readsTubeCores() const { return levels == LevoyLevels::tubeCores; }
    friend bool operator==(const LevoyConfig&, const LevoyConfig&) = default;
};

}  // namespace echolucent
