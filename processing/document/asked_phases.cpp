#include "processing/document/asked_phases.h"

#include <algorithm>

namespace echolucent {

int lastPhaseOf(const Document& document) {
    int last = std::max(document.scene.phase, document.motion.otfPhase);
    for (const Pane& pane : document.panes) last = std::max(last, pane.phase.value_or(0));
    for (const Measurement& measurement : document.measurements) last = std::max(last, measurement.phase);
    if (const auto& range = document.motion.phaseRange) last = std::max({last, range->first, range->last});
    return last;
}

}  // namespace echolucent
