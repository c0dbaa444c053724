#include "processing/pane_picture/pane_measures.h"

#include <utility>

namespace echolucent {

std::optional<std::vector<std::optional<ClassificationMeasures>>> measuresOfPanes(const Document& document,
                                                                                  StudyPhases phases,
                                                                                  const Progress& progress) {
    std::vector<std::optional<ClassificationMeasures>> measured(document.panes.size());
    PaneCaster caster(std::move(phases));
    const Progress silent{{}, progress.cancel};
    const auto read = caster.readTubeCores(document, firstPane, silent);
    if (!read) return std::nullopt;
    const int phase = otfPhaseOf(document, firstPane, caster.phaseCount());
    std::vector<std::size_t> places;
    std::vector<Classification> classifications;
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        if (phaseOf(document, place) != phase) continue;
        const auto otf = caster.otf(document, place, silent);
        if (!otf) return std::nullopt;
        places.push_back(place);
        classifications.push_back(classificationOf(document, place, *otf));
    }
    const auto measures = measuresOf(*read->shown, read->otf, classifications, progress);
    if (!measures) return std::nullopt;
    for (std::size_t i = 0; i < places.size(); ++i)
        if ((*measures)[i].light.rays > 0) measured[places[i]] = (*measures)[i];
    return measured;
}

}  // namespace echolucent
