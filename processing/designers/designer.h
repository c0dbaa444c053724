// The OTF designers by name: a config of any of them in, a classification and its explanation out.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "processing/choice_names.h"
#include "processing/designers/adaptive_design.h"
#include "processing/designers/contour_spectrum.h"
#include "processing/designers/design.h"
#include "processing/designers/fixed_presets.h"
#include "processing/designers/kindlmann.h"
#include "processing/designers/levoy.h"
#include "processing/designers/otsu.h"
#include "processing/designers/percentile.h"
#include "processing/designers/template_curve.h"
#include "processing/parameter.h"
#include "processing/progress.h"

namespace echolucent {

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

[[nodiscard]] inline Designer designerOf(const DesignerConfig& config) { return allDesigners.at(config.index()); }
[[nodiscard]] DesignerConfig defaultConfigOf(Designer designer);

/// Runs a designer. The result is empty only where progress.cancel was raised, and has the same bits for any number of
/// threads. Throws std::invalid_argument where problemOf(config) is not empty, or where the volumes of the input have
/// different grids.
[[nodiscard]] std::optional<Design> design(const DesignerConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// What is out of range, lower case, no full stop; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const DesignerConfig& config);

/// Calls visit(row, values) for each row of the table of the designer's parameters; `values` is the config as its own
/// type.
template <typename Visit>
void forEachParameter(const DesignerConfig& config, const Visit& visit) {
    std::visit(
        [&](const auto& values) {
            for (const auto& row : parametersOf(values)) visit(row, values);
        },
        config);
}
/// The same for a config that `visit` may change.
template <typename Visit>
void forEachParameter(DesignerConfig& config, const Visit& visit) {
    std::visit(
        [&](auto& values) {
            for (const auto& row : parametersOf(values)) visit(row, values);
        },
        config);
}

}  // namespace echolucent
