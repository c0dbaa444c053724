// The config of the adaptive method as a designer.
#pragma once

#include "processing/designers/designer_words.h"

namespace echolucent {

/// The adaptive designer has no parameter of its own. DesignerInput::method holds them all, also the tube cores that
/// are never placed (TubeGrid::withoutTubes). docs/designers/adaptive.md says more.
struct AdaptiveConfig {
    static constexpr DesignerWords words{"adaptive", "Adaptive"};
    [[nodiscard]] static constexpr bool readsTubeCores() { return true; }
    friend bool operator==(const AdaptiveConfig&, const AdaptiveConfig&) = default;
};

}  // namespace echolucent
