#include "processing/document/compared_panes.h"

#include <algorithm>
#include <stdexcept>

namespace echolucent {

namespace {

template <typename List>
int freeIdIn(const List& list) {
    int free = 1;
    while (std::ranges::any_of(list, [&](const auto& entry) { return entry.id == free; })) ++free;
    return free;
}

/// A view that shares all with the main one but what it is rendered with.
View linkedView(const Document& document, int id) {
    View view = viewOf(document, mainView);
    view.id = id;
    view.curve = CurveKind::adaptive;
    view.design = 0;
    view.withoutTubes.clear();
    view.motionOtf.reset();
    return view;
}

void removeView(Document& document, int view) {
    document = withCurve(std::move(document), view, CurveKind::adaptive);  // its design goes with it
    std::erase_if(document.views, [&](const View& each) { return each.id == view; });
}

void showPhaseOf(Document& document, int view, const std::optional<int>& phase) {
    const int shared = viewOf(document, mainView).phase;
    if (view == mainView) return;
    View& shown = viewOf(document, view);
    if (!phase) {
        shown.phase = shared;
        return;
    }
    if (shown.phase == shared) {
        shown.phase = freeIdIn(document.phases);
        document.phases.push_back({shown.phase, *phase});
    }
    phaseOf(document, view) = *phase;
}

/// Phases that no view shows are gone.
void removeUnusedPhases(Document& document) {
    std::erase_if(document.phases, [&](const Shared<int>& phase) {
        return std::ranges::none_of(document.views, [&](const View& view) { return view.phase == phase.id; });
    });
}

}  // namespace

std::vector<PaneChoice> standardPanes() {
    return {{.curve = CurveKind::adaptive},
            {.curve = CurveKind::parabolic},
            {.curve = CurveKind::linear},
            {.design = defaultConfigOf(Designer::levoy)}};
}

PaneChoice paneChoiceOf(const Document& document, std::size_t place) {
    const int id = document.comparison.panes.at(place);
    const View& view = viewOf(document, id);
    PaneChoice choice{.curve = view.curve, .withoutTubes = view.withoutTubes, .motionOtf = view.motionOtf};
    if (const DesignerConfig* design = designOf(document, id)) choice.design = *design;
    if (view.phase != viewOf(document, document.comparison.panes.front()).phase) choice.phase = phaseOf(document, id);
    return choice;
}

Document withPane(Document document, std::size_t place, const PaneChoice& choice) {
    const int view = document.comparison.panes.at(place);
    document = choice.design ? withDesign(std::move(document), view, *choice.design)
                             : withCurve(std::move(document), view, choice.curve);
    viewOf(document, view).withoutTubes = choice.withoutTubes;
    viewOf(document, view).motionOtf = place == 0 ? std::nullopt : choice.motionOtf;
    showPhaseOf(document, view, place == 0 ? std::nullopt : choice.phase);
    removeUnusedPhases(document);
    return document;
}

Document comparing(Document document, const std::vector<PaneChoice>& panes) {
    if (panes.size() < fewestPanes || panes.size() > mostPanes)
        throw std::invalid_argument("comparing: a comparison has two to four panes");
    Comparison& comparison = document.comparison;
    std::vector<int> ids{mainView};
    for (const int view : comparison.panes) {
        if (view == mainView) continue;
        if (ids.size() < panes.size())
            ids.push_back(view);
        else
            removeView(document, view);
    }
    while (ids.size() < panes.size()) {
        ids.push_back(freeIdIn(document.views));
        document.views.push_back(linkedView(document, ids.back()));
    }
    document.comparison.panes = ids;
    const auto count = static_cast<int>(ids.size());
    if (document.comparison.first >= count) document.comparison.first = document.comparison.second == 0 ? 1 : 0;
    if (document.comparison.second >= count) document.comparison.second = document.comparison.first == 0 ? 1 : 0;
    for (std::size_t place = 0; place < panes.size(); ++place)
        document = withPane(std::move(document), place, panes[place]);
    return document;
}

Document withPaneCount(Document document, std::size_t count) {
    if (document.comparison.panes.empty()) document.comparison.panes = {mainView};
    std::vector<PaneChoice> panes;
    for (std::size_t place = 0; place < document.comparison.panes.size(); ++place)
        panes.push_back(paneChoiceOf(document, place));
    for (const PaneChoice& standard : standardPanes()) {
        if (panes.size() >= count) break;
        if (std::ranges::find(panes, standard) == panes.end()) panes.push_back(standard);
    }
    while (panes.size() < count) panes.push_back(standardPanes().front());
    panes.resize(count);
    return comparing(document, panes);
}

}  // namespace echolucent
