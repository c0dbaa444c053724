// The search for the place at which to cut off a wall of tissue that stands before the fluid.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/near_cut/seen_fluid.h"
#include "processing/progress.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What stands in front of a view.
enum class NearCutAnswer {
    fluidAtFront,     ///< fluid begins where the data begin: no cut is needed
    wallBeforeFluid,  ///< a wall stands before the fluid: cut there
    noFluid,          ///< no fluid was found: there is nothing to open
};
/// "fluid at the front", "wall before fluid", "no fluid".
[[nodiscard]] std::string_view nameOf(NearCutAnswer answer);

/// What the search for the near cut found (docs/near-cut.md).
struct NearCutFinding {
    NearCutAnswer answer = NearCutAnswer::noFluid;
    double nearCutMm = 0.0;     ///< the flat cut, as FrontPlane::depthMm; above 0 for wallBeforeFluid only
    double behindDataMm = 0.0;  ///< the flat cut, from where the data begin along the view; for wallBeforeFluid only
    /// The curved cut, for wallBeforeFluid only. Empty if fitCurvedCut() makes none, if fewer tube cores are in fluid
    /// at it than 95 % of those at the flat cut, or if findFlatNearCut() searched.
    std::optional<CutSurface> surface{};
    int tubes = 0;  ///< tube cores of the search that meet data, many more than in the adaptive method
    /// How many of `tubes` support the answer: they begin in fluid, are in fluid at the flat cut, or meet no fluid.
    int tubesThatSaySo = 0;
    int tubesInFluidBehindSurface = 0;  ///< tube cores in fluid at the fitted curved cut, even if `surface` is empty
    double confidence = 0.0;            ///< [0,1]
    bool sure = false;                  ///< whether a program may act on the answer without asking
    std::string message{};              ///< a sentence that says the answer
};

/// Whether a program may make a front from the finding without asking: a sure wall before fluid.
[[nodiscard]] bool makesFront(const NearCutFinding& finding);
/// A view behind the front of the finding, bowed if a bowed one was found; the view itself unless makesFront().
[[nodiscard]] Viewpoint behindFound(Viewpoint view, const NearCutFinding& finding);

/// What a person is told of a finding whose front is taken as behindFound() has it: `message`, or, of a bowed front,
/// how many tube cores are in fluid behind that one.
[[nodiscard]] std::string messageOfFront(const NearCutFinding& finding);

/// Looks along a view for large dark regions with a wall before and behind them. It stays within the view's box and
/// ignores the view's cuts. The volume's resolution hardly changes the answer, because the size of the cells that the
/// search reads is a share of the data's extent. The answer has the same bits for any number of threads. The result is
/// empty only if progress.cancel was raised.
[[nodiscard]] std::optional<NearCutFinding> findNearCut(const Volume& volume, const Viewpoint& view,
                                                        const Progress& progress = {});
/// Like findNearCut(), but without the curved cut: for callers that offer none. It takes less time.
[[nodiscard]] std::optional<NearCutFinding> findFlatNearCut(const Volume& volume, const Viewpoint& view,
                                                            const Progress& progress = {});
/// Which cuts are looked for.
enum class CutShapes { flat, flatAndCurved };
/// findNearCut() or findFlatNearCut() of what a view has seen already, of a volume with `geometry`. It cannot be
/// cancelled.
[[nodiscard]] NearCutFinding nearCutOf(const SeenFluid& seen, const VolumeGeometry& geometry, CutShapes shapes);

}  // namespace echolucent
