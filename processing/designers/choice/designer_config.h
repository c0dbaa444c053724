// The list of all OTF designers: a new one stands here as an include and an alternative of DesignerConfig, and nowhere
// else. processing/designers/choice/designer.h runs them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "processing/designers/adaptive_design.h"
#include "processing/designers/fixed_presets.h"
#include "processing/designers/gradients/contour_spectrum.h"
#include "processing/designers/gradients/kindlmann.h"
#include "processing/designers/gradients/levoy.h"
#include "processing/designers/otsu.h"
#include "processing/designers/percentile.h"
#include "processing/designers/template/template_curve.h"

namespace echolucent {

/// The config of one designer, in the order in which people see them.
using DesignerConfig = std::variant<AdaptiveConfig, LevoyConfig, KindlmannConfig, TemplateConfig, ContourSpectrumConfig,
                                    OtsuConfig, PercentileConfig, FetalPresetConfig, EchoRampConfig>;

/// A designer: the index of its config in DesignerConfig. designerOf(OtsuConfig{}) names one.
enum class Designer : std::size_t {};
inline constexpr std::array allDesigners = []<std::size_t... index>(std::index_sequence<index...>) {
    return std::array{static_cast<Designer>(index)...};
}
(std::make_index_sequence<std::variant_size_v<DesignerConfig>>());

/// Its name for scripts and files: "adaptive", "contour-spectrum".
[[nodiscard]] std::string_view nameOf(Designer designer);
[[nodiscard]] std::optional<Designer> designerFromName(std::string_view name);
/// Its name for a person: "Adaptive", "Kindlmann and Durkin".
[[nodiscard]] std::string_view labelOf(Designer designer);

[[nodiscard]] inline Designer designerOf(const DesignerConfig& config) { return Designer{config.index()}; }
/// The config of a designer with all its defaults.
[[nodiscard]] DesignerConfig defaultConfigOf(Designer designer);

/// Whether a designer reads tube cores. If so, its result depends on the method and on the direction of the tube cores.
[[nodiscard]] bool readsTubeCores(const DesignerConfig& config);

}  // namespace echolucent
