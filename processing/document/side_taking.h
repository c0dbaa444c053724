// What a document becomes if the scan is looked into from another of its six sides.
#pragma once

#include <cstddef>
#include <optional>

#include "processing/document/document.h"
#include "processing/sides/side_search.h"

namespace echolucent {

/// The front of a finding along a view if makesFront(), bowed if a bowed one was found; else none. A flat one is
/// rounded to 0.1 mm, as people set it.
[[nodiscard]] Front frontOf(const Viewpoint& view, const NearCutFinding& finding);

/// The document with the scan looked into from a side: tube cores run along it, its front cuts, and all data, or the
/// render box if it is on, fill a picture of width / height `aspect` (> 0), seen along it. The motion's angle becomes
/// 0. The side's view must have the document's beam axis.
[[nodiscard]] Document withSideTaken(Document document, const JudgedSide& judged, const DataBox& box, double aspect);

/// The place among `sides` of the one that a direction, relative to the beam `axis`, looks along, to a degree; rolls
/// differ freely. No value if it looks along none.
[[nodiscard]] std::optional<std::size_t> sideAlong(const SidesFinding& sides, BeamAxis axis,
                                                   const ViewDirection& direction);

}  // namespace echolucent
