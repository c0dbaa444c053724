// What is measured of the panes of a document.
#pragma once

#include <optional>
#include <vector>

#include "processing/comparison/classification_measures.h"
#include "processing/document/view_caster.h"

namespace echolucent {

/// The measures of each pane, in their order; no value for a pane that shows another phase than
/// the one whose tube cores are read for the first pane, and where no tube core has a surface and a weight. The
/// surfaces are those that the first pane's tube cores found. The result is empty only where progress.cancel was
/// raised. Throws std::out_of_range where a pane shows a phase that is not there.
[[nodiscard]] std::optional<std::vector<std::optional<ClassificationMeasures>>> measuresOfPanes(
    const Document& document, StudyPhases phases, const Progress& progress = {});

}  // namespace echolucent
