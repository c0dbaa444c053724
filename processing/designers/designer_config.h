// What a person sets of the OTF designers, as values: which designer, and its parameters.
// processing/designers/designer.h says what they make of a volume.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "processing/choice_names.h"
#include "processing/designers/template/template_comparison.h"
#include "processing/designers/template/template_reference.h"

namespace echolucent {

// ---- "adaptive"

/// The adaptive designer has no parameter of its own: DesignerInput::method holds them all, the tube cores that are
/// never placed among them (TubeGrid::withoutTubes). docs/designers/adaptive.md says more.
struct AdaptiveConfig {
    friend bool operator==(const AdaptiveConfig&, const AdaptiveConfig&) = default;
};

// ---- "levoy"

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
    friend bool operator==(const LevoyConfig&, const LevoyConfig&) = default;
};

// ---- "kindlmann"

/// What opacity is a function of.
enum class KindlmannDimensions {
    one,  ///< the intensity: alpha(v) = b(p(v))
    two,  ///< the intensity and the gradient magnitude: alpha(v, g) = b(p(v, g))
};
inline constexpr ChoiceNames<2> kindlmannDimensionsNames{"one", "two"};
[[nodiscard]] inline std::string_view nameOf(KindlmannDimensions dimensions) {
    return nameIn(kindlmannDimensionsNames, dimensions);
}
[[nodiscard]] inline std::optional<KindlmannDimensions> kindlmannDimensionsFromName(std::string_view name) {
    return choiceNamed<KindlmannDimensions>(kindlmannDimensionsNames, name);
}

/// Where the boundary emphasis function b comes from.
enum class BoundaryEmphasis {
    hat,    ///< made of three numbers
    drawn,  ///< KindlmannConfig::drawn
};
inline constexpr ChoiceNames<2> boundaryEmphasisNames{"hat", "drawn"};
[[nodiscard]] inline std::string_view nameOf(BoundaryEmphasis emphasis) {
    return nameIn(boundaryEmphasisNames, emphasis);
}
[[nodiscard]] inline std::optional<BoundaryEmphasis> boundaryEmphasisFromName(std::string_view name) {
    return choiceNamed<BoundaryEmphasis>(boundaryEmphasisNames, name);
}

/// One point of the boundary emphasis function.
struct EmphasisNode {
    double position = 0.0;  ///< within the boundary, standard deviations of it, negative on the darker side
    double opacity = 0.0;   ///< per reference step, [0,1]
    friend bool operator==(const EmphasisNode&, const EmphasisNode&) = default;
};

/// The most nodes that KindlmannConfig::drawn may have; it must have two.
inline constexpr std::size_t mostEmphasisNodes = 64;

/// parametersOf() has the ranges, the meanings and the sources of all members but `drawn`.
struct KindlmannConfig {
    KindlmannDimensions dimensions = KindlmannDimensions::one;
    double prefilter = 1.0;  ///< standard deviation of the Gaussian under which derivatives are taken, units
    double smoothing = 2.0;  ///< standard deviation over the intensity of the mean derivatives, levels of 255
    double threshold = 0.2;  ///< g0, share of the largest mean gradient magnitude
    BoundaryEmphasis emphasis = BoundaryEmphasis::hat;
    double centre = 0.0;     ///< of the hat, standard deviations of the boundary
    double halfWidth = 1.0;  ///< of the hat, standard deviations of the boundary
    double peak = 1.0;       ///< of the hat, opacity per reference step
    /// What a person drew, piecewise linear, constant beyond its first and last node; two nodes at one position make a
    /// step, of which the later one holds there. It counts where `emphasis` says so, and is kept where it does not, so
    /// that a person can go to the hat and back. Tables of parameters hold scalars and so do not hold it. 2 to
    /// mostEmphasisNodes nodes, of positions in [-8,8] that do not descend; the default is the default hat.
    std::vector<EmphasisNode> drawn{{-1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
    friend bool operator==(const KindlmannConfig&, const KindlmannConfig&) = default;
};

// ---- "template"

/// The ranges of the slopes stand in parametersOf(), too.
struct TemplateConfig {
    SharedTemplate reference = fetusTemplate();  ///< no row of the table
    TemplateComparison comparison = TemplateComparison::logarithm;
    double leastSlope = 0.25;   ///< of the warp, [1/8,1]
    double largestSlope = 4.0;  ///< of the warp, [1,8]
    friend bool operator==(const TemplateConfig&, const TemplateConfig&) = default;
};

// ---- "contour-spectrum"

/// Where the middle of the ramp comes from.
enum class IsovalueChoice {
    steepest,  ///< the steepest of maximaOf() the spectrum
    given,     ///< a person's choice
};
inline constexpr std::array allIsovalueChoices{IsovalueChoice::steepest, IsovalueChoice::given};
inline constexpr ChoiceNames<allIsovalueChoices.size()> isovalueChoiceNames{"steepest", "given"};
/// "steepest", "given".
[[nodiscard]] inline std::string_view nameOf(IsovalueChoice choice) { return nameIn(isovalueChoiceNames, choice); }
[[nodiscard]] inline std::optional<IsovalueChoice> isovalueChoiceFromName(std::string_view name) {
    return choiceNamed<IsovalueChoice>(isovalueChoiceNames, name);
}

/// The ranges stand in parametersOf(), too.
struct ContourSpectrumConfig {
    IsovalueChoice choice = IsovalueChoice::steepest;
    double threshold = 0.2;   ///< normalised intensity, [0,1]; it plays a part where it is the choice
    double leastArea = 0.1;   ///< share of the largest area, [0,1]: what smaller isosurfaces are like is noise
    double halfWidth = 0.08;  ///< of the ramp, normalised intensity, [0,1]
    double opacity = 0.6;     ///< behind the ramp, per unit, [0,1]
    friend bool operator==(const ContourSpectrumConfig&, const ContourSpectrumConfig&) = default;
};

// ---- "otsu"

/// The ranges stand in parametersOf().
struct OtsuConfig {
    double spreads = 1.0;  ///< the ramp reaches this many class spreads to either side of the threshold
    double opacity = 1.0;  ///< of the bright class beyond the ramp, per unit
    friend bool operator==(const OtsuConfig&, const OtsuConfig&) = default;
};

// ---- "percentile"

/// The ranges stand in parametersOf().
struct PercentileConfig {
    double clear = 60.0;   ///< opacity is 0 up to this percentile of the voxels with data, %
    double full = 95.0;    ///< and full from this one on, %; where it is not above `clear`, the ramp is a step
    double opacity = 1.0;  ///< full opacity, per unit
    friend bool operator==(const PercentileConfig&, const PercentileConfig&) = default;
};

// ---- "fetal-preset" and "echo-ramp"

/// 3D Slicer's preset for fetal ultrasound (fetalPresetNodes). It has no parameters.
struct FetalPresetConfig {
    friend bool operator==(const FetalPresetConfig&, const FetalPresetConfig&) = default;
};

/// The curve of SlicerHeart's module Echo Volume Render (docs/designers/echo-ramp.md): clear up to the threshold minus
/// the edge, rising to 0.2 at the threshold, 0.8 just above it and 0.95 at the threshold plus the edge.
struct EchoRampConfig {
    double threshold = 0.2;  ///< normalised intensity, [0,1]
    double edge = 0.05;      ///< width of the ramp to either side, normalised intensity, [0,1]
    friend bool operator==(const EchoRampConfig&, const EchoRampConfig&) = default;
};

// ---- All of them

/// The designers, in the order people are shown.
enum class Designer {
    adaptive,         ///< tube cores (docs/designers/adaptive.md)
    levoy,            ///< value and gradient magnitude (docs/designers/levoy.md)
    kindlmann,        ///< distance from boundaries (docs/designers/kindlmann.md)
    templateCurve,    ///< a curve carried over from a reference (docs/designers/template.md)
    contourSpectrum,  ///< a ramp where contours are strong (docs/designers/contour-spectrum.md)
    otsu,             ///< a ramp at the threshold of largest between-class variance (docs/designers/otsu.md)
    percentile,       ///< a ramp between two percentiles (docs/designers/percentile.md)
    fetalPreset,      ///< 3D Slicer's fetal preset (docs/designers/fetal-preset.md)
    echoRamp,         ///< SlicerHeart's echo ramp (docs/designers/echo-ramp.md)
};
inline constexpr std::array allDesigners{Designer::adaptive,      Designer::levoy,           Designer::kindlmann,
                                         Designer::templateCurve, Designer::contourSpectrum, Designer::otsu,
                                         Designer::percentile,    Designer::fetalPreset,     Designer::echoRamp};

/// Names for scripts and files: "adaptive", "levoy", "kindlmann", "template", "contour-spectrum", "otsu", "percentile",
/// "fetal-preset", "echo-ramp".
[[nodiscard]] std::string_view nameOf(Designer designer);
[[nodiscard]] std::optional<Designer> designerFromName(std::string_view name);
/// Names for persons: "Adaptive", "Levoy", "Kindlmann and Durkin", ...
[[nodiscard]] std::string_view labelOf(Designer designer);

/// The config of one designer; its alternatives stand in the order of allDesigners.
using DesignerConfig = std::variant<AdaptiveConfig, LevoyConfig, KindlmannConfig, TemplateConfig, ContourSpectrumConfig,
                                    OtsuConfig, PercentileConfig, FetalPresetConfig, EchoRampConfig>;

/// Which designer a config is of.
[[nodiscard]] inline Designer designerOf(const DesignerConfig& config) { return allDesigners.at(config.index()); }
/// The config of a designer nothing of which was chosen.
[[nodiscard]] DesignerConfig defaultConfigOf(Designer designer);

}  // namespace echolucent
