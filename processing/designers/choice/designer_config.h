// The configs of all OTF designers as plain values. processing/designers/choice/designer.h says what they make of a
// volume.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "processing/designers/adaptive_config.h"
#include "processing/designers/fixed_presets_config.h"
#include "processing/designers/gradients/contour_spectrum_config.h"
#include "processing/designers/gradients/kindlmann_config.h"
#include "processing/designers/gradients/levoy_config.h"
#include "processing/designers/otsu_config.h"
#include "processing/designers/percentile_config.h"
#include "processing/designers/template/template_config.h"

namespace echolucent {

/// The config of one designer, in the order in which people see them.
using DesignerConfig = std::variant<AdaptiveConfig, LevoyConfig, KindlmannConfig, TemplateConfig, ContourSpectrumConfig,
                                    OtsuConfig, PercentileConfig, FetalPresetConfig, EchoRampConfig>;

/// The designers, in the order of DesignerConfig.
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
inline constexpr std::array allDesigners = []<std::size_t... index>(std::index_sequence<index...>) {
    return std::array{static_cast<Designer>(index)...};
}
(std::make_index_sequence<std::variant_size_v<DesignerConfig>>());

/// Its name for scripts and files: "adaptive", "contour-spectrum".
[[nodiscard]] std::string_view nameOf(Designer designer);
[[nodiscard]] std::optional<Designer> designerFromName(std::string_view name);
/// Its name for a person: "Adaptive", "Kindlmann and Durkin".
[[nodiscard]] std::string_view labelOf(Designer designer);

[[nodiscard]] inline Designer designerOf(const DesignerConfig& config) { return allDesigners.at(config.index()); }
/// The config of a designer with all its defaults.
[[nodiscard]] DesignerConfig defaultConfigOf(Designer designer);

/// Whether a designer reads tube cores. If so, its result depends on the method and on the direction of the tube cores.
/// A config has a member of this name, or it reads none.
[[nodiscard]] bool readsTubeCores(const DesignerConfig& config);

}  // namespace echolucent
