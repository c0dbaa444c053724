#include "processing/document/panes.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace echolucent {

std::vector<Pane> standardPanes() {
    return {{.curve = CurveKind::adaptive},
            {.curve = CurveKind::parabolic},
            {.curve = CurveKind::linear},
            {.designer = LevoyConfig{}}};
}

Document withPanes(Document document, std::vector<Pane> panes) {
    if (panes.empty() || panes.size() > mostPanes)
        throw std::invalid_argument("withPanes: a document has one to four panes");
    panes.front().phase.reset();
    panes.front().motionOtf.reset();
    panes.front().method.reset();
    Comparison& comparison = document.comparison;
    const auto count = static_cast<int>(std::max(panes.size(), fewestPanes));
    if (comparison.first >= count) comparison.first = comparison.second == 0 ? 1 : 0;
    if (comparison.second >= count) comparison.second = comparison.first == 0 ? 1 : 0;
    document.panes = std::move(panes);
    return document;
}

Document withPane(Document document, std::size_t place, Pane pane) {
    std::vector<Pane> panes = document.panes;
    panes.at(place) = std::move(pane);
    return withPanes(std::move(document), std::move(panes));
}

Document withPaneCount(Document document, std::size_t count) {
    std::vector<Pane> panes = document.panes;
    for (const Pane& standard : standardPanes()) {
        if (panes.size() >= count) break;
        if (std::ranges::find(panes, standard) == panes.end()) panes.push_back(standard);
    }
    panes.resize(count, standardPanes().front());
    return withPanes(std::move(document), std::move(panes));
}

}  // namespace echolucent
