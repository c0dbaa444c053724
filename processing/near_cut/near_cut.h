// Where to cut off a wall of tissue that stands in front of the fluid.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/progress.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What stands in front of a view.
enum class NearCutAnswer {
    fluidAtFront,     ///< fluid begins where the data do: no cut is needed
    wallBeforeFluid,  ///< a wall stands before it: cut there
    noFluid,          ///< no fluid was found: there is nothing to open
};
/// "fluid at the front", "wall before fluid", "no fluid".
[[nodiscard]] std::string_view nameOf(NearCutAnswer answer);

/// What the search for the near cut found (docs/near-cut.md).
struct NearCutFinding {
    NearCutAnswer answer = NearCutAnswer::noFluid;
    double nearCutMm = 0.0;     ///< the flat cut, as Viewpoint::nearCutMm; above 0 with wallBeforeFluid only
    double behindDataMm = 0.0;  ///< the same, counted from where the data begin along the view
    /// The curved cut, with wallBeforeFluid only, and only where it leaves as many tube cores in fluid (95 %).
    std::optional<CutSurface> surface{};
    int tubes = 0;  ///< tube cores of the search that meet data; they are many more than those of the adaptive method
    /// Of these, that say the answer: begin in fluid; are in fluid at the flat cut; meet no fluid.
    int tubesThatSaySo = 0;
    int tubesInFluidBehindSurface = 0;  ///< at the curved cut
    double confidence = 0.0;            ///< [0,1]
    bool sure = false;                  ///< whether a program may act on the answer without being asked
    std::string message{};              ///< a sentence that says the answer
};

/// Looks along a view, within its box and without its own cuts, for large dark regions with a wall before and behind
/// them. The answer depends neither on the volume's resolution nor, but for what a turned view shows, on its direction,
/// and has the same bits for any number of threads. It is empty only where the search was cancelled.
[[nodiscard]] std::optional<NearCutFinding> findNearCut(const Volume& volume, const Viewpoint& view,
                                                        const Progress& progress = {});
/// The same without a curved cut, which is a quarter of the work, for those who offer none.
[[nodiscard]] std::optional<NearCutFinding> findFlatNearCut(const Volume& volume, const Viewpoint& view,
                                                            const Progress& progress = {});
/// One of both.
using NearCutSearch = std::optional<NearCutFinding> (*)(const Volume&, const Viewpoint&, const Progress&);

}  // namespace echolucent
