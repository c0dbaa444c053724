// What is measured of the panes of a document.
#pragma once

#include <optional>
#include <vector>

#include "processing/comparison/classification_measures.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

/// The measures of each pane, in their order. They are taken at the surfaces that the first pane's tube cores found. A
/// pane has no value if it shows another phase than the one whose tube cores are read for the first pane, or if no tube
/// core has a surface and a weight. The result is empty only if progress.cancel was raised. Throws std::out_of_range if
/// the study lacks the phase whose tube cores are read.
[[nodiscard]] std::optional<std::vector<std::optional<ClassificationMeasures>>> measuresOfPanes(
    const Document& document, StudyPhases phases, const Progress& progress = {});

}  // namespace echolucent
