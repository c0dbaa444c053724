#include "processing/document/pane_measures.h"

#include <utility>

namespace echolucent {

std::optional<std::vector<std::optional<ClassificationMeasures>>> measuresOfPanes(const Document& document,
                                                                                  StudyPhases phases,
                                                                                  const Progress& progress) {
    const std::vector<int>& views = document.comparison.panes;
    std::vector<std::optional<ClassificationMeasures>> measured(views.size());
    if (views.empty()) return measured;
    ViewCaster caster(std::move(phases));
    const Progress silent{{}, progress.cancel};
    const auto read = caster.readTubeCores(document, views.front(), silent);
    if (!read) return std::nullopt;
    const int phase = otfPhaseOf(document, views.front(), caster.phaseCount());
    std::vector<std::size_t> places;
    std::vector<Classification> classifications;
    for (std::size_t place = 0; place < views.size(); ++place) {
        if (phaseOf(document, views[place]) != phase) continue;
        std::optional<ViewOtf> otf = ViewOtf{};
        if (needsComputedOtf(document, views[place])) otf = caster.otf(document, views[place], silent);
        if (!otf) return std::nullopt;
        places.push_back(place);
        classifications.push_back(classificationOf(document, views[place], *otf));
    }
    const auto measures = measuresOf(*read->shown, read->otf, classifications, progress);
    if (!measures) return std::nullopt;
    for (std::size_t i = 0; i < places.size(); ++i)
        if ((*measures)[i].light.rays > 0) measured[places[i]] = (*measures)[i];
    return measured;
}

}  // namespace echolucent
