// The adaptive method as one of the designers.
#pragma once

#include <memory>
#include <optional>

#include "processing/designers/designer_declarations.h"

namespace echolucent {

struct AdaptiveOtf;

/// The adaptive designer has no parameter of its own. DesignerInput::method holds the parameters of the method, also
/// the tube cores that are never placed (TubeGrid::withoutTubes). docs/designers/adaptive.md says more.
struct AdaptiveConfig {
    static constexpr DesignerWords words{"adaptive", "Adaptive"};
    [[nodiscard]] static constexpr bool readsTubeCores() { return true; }
    friend bool operator==(const AdaptiveConfig&, const AdaptiveConfig&) = default;
};
/// An empty table: the parameters are the rows of methodParameters().
[[nodiscard]] const ParameterTable<AdaptiveConfig>& parametersOf(const AdaptiveConfig&);

/// Runs adaptOpacity() (Petersch 2005; docs/method.md). Tube cores read the raw voxels along input.view, and the curve
/// is meant for the shown voxels. If no surface is found behind fluid, the curve is the initial function, and `message`
/// says so.
[[nodiscard]] std::optional<Design> design(const AdaptiveConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// The design of a finished run; `otf` is not null.
[[nodiscard]] Design designOf(std::shared_ptr<const AdaptiveOtf> otf);

}  // namespace echolucent
