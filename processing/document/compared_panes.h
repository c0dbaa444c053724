// The panes of a comparison as views of a document: what each is rendered with, and how their number changes.
#pragma once

#include <optional>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

/// What a pane is rendered with.
struct PaneChoice {
    CurveKind curve = CurveKind::adaptive;   ///< where there is no design
    std::optional<DesignerConfig> design{};  ///< its designer
    std::vector<int> withoutTubes{};         ///< as View::withoutTubes
    std::optional<int> phase{};              ///< of its own; none: that of the first pane
    std::optional<MotionOtf> motionOtf{};    ///< as View::motionOtf; of the adaptive curve alone
    friend bool operator==(const PaneChoice&, const PaneChoice&) = default;
};

/// The adaptive curve, the parabolic and the linear one, and Levoy's OTF.
[[nodiscard]] std::vector<PaneChoice> standardPanes();

/// What the pane at a place of the comparison is rendered with. The place must be there (std::out_of_range).
[[nodiscard]] PaneChoice paneChoiceOf(const Document& document, std::size_t place);

/// The document that compares so many panes, two to four of them. The first is view 1; the others share all with it
/// but what they are rendered with. Views that were panes before are used again or removed, and keep, in their order,
/// nothing of what they were rendered with. How they are compared stays, as far as the panes are there.
[[nodiscard]] Document comparing(Document document, const std::vector<PaneChoice>& panes);
/// The document in which the pane at a place is rendered otherwise. The first pane is the 3D view: its phase and its
/// motion's OTF are the document's own, and no choice of the pane.
[[nodiscard]] Document withPane(Document document, std::size_t place, const PaneChoice& choice);
/// The document that compares so many panes (2 to 4): the last ones are removed, or standardPanes() added that are not
/// there yet. Where nothing is compared yet, the first pane shows what view 1 shows.
[[nodiscard]] Document withPaneCount(Document document, std::size_t count);

}  // namespace echolucent
