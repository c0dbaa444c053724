// The panes of a document: how their number changes, and what is added.
#pragma once

#include <variant>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// Panes with the adaptive curve, the parabolic curve, the linear curve, and Levoy's OTF.
[[nodiscard]] std::vector<Pane> standardPanes();

/// Whether a pane is rendered with the adaptive OTF, be it as a curve or as a designer.
[[nodiscard]] inline bool isAdaptive(const Pane& pane) {
    return pane.designer ? std::holds_alternative<AdaptiveConfig>(*pane.designer) : pane.curve == CurveKind::adaptive;
}
/// Whether there are several panes.
[[nodiscard]] inline bool isCompared(const Document& document) { return document.panes.size() >= fewestPanes; }
/// The document with these panes, one to mostPanes (else std::invalid_argument). How they are compared stays, as far as
/// the compared panes exist. The first pane shows the scene's phase and the motion's OTF, and has the document's
/// method.
[[nodiscard]] Document withPanes(Document document, std::vector<Pane> panes);
/// The document with another pane at a place. Throws std::out_of_range if there is no such place.
[[nodiscard]] Document withPane(Document document, std::size_t place, Pane pane);
/// The document with `count` panes, one to mostPanes (else std::invalid_argument). The last ones go, or those of
/// standardPanes() are added that are not there yet.
[[nodiscard]] Document withPaneCount(Document document, std::size_t count);

}  // namespace echolucent
