#include "processing/near_cut.h"

namespace echolucent {

std::optional<NearCutSuggestion> suggestNearCut(const Volume& volume, const View& view, const AdaptiveOtfConfig& config,
                                                const Progress& progress) {
    View uncut = view;
    uncut.nearCutMm = 0.0;
    const auto otf = adaptOpacity(volume, uncut, config, progress);
    if (!otf) return std::nullopt;
    NearCutSuggestion suggestion;
    suggestion.message = otf->message;
    suggestion.tubesWithSurface = otf->tubesWithSurface;
    return suggestion;
}

}  // namespace echolucent
