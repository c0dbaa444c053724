// What is measured of the panes of a document.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "processing/comparison/classification_measures.h"
#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

/// Where the surfaces come from with which panes are measured.
enum class SurfacesFrom {
    truth,      ///< of a simulated scan (trueSurfaces())
    tubeCores,  ///< foundSurfaces()
};
/// Says with which surfaces something was measured: a sentence or two.
[[nodiscard]] std::string_view surfacesSentence(SurfacesFrom from);
struct MeasuredSurfaces {
    SurfacesFrom from = SurfacesFrom::tubeCores;
    std::vector<SurfaceRay> rays{};
    std::array<double, 2> apartUnits{1, 1};  ///< between rays, along the view's right and down axes, above 0
};
/// Units between the rays of true surfaces with which panes are measured.
inline constexpr double measuredRaySpacing = 2.0;
/// All that the surfaces of a document's panes depend on, but for the voxels.
struct SurfaceSource {
    Viewpoint view{};                      ///< viewpointOf()
    std::optional<SimulatedScan> known{};  ///< the scan whose truth is taken: the study, if it is simulated and the
                                           ///< scalpel has cut nothing
    friend bool operator==(const SurfaceSource&, const SurfaceSource&) = default;
};
[[nodiscard]] SurfaceSource surfaceSourceOf(const Document& document);
/// The surfaces with which panes are measured in a phase: the true ones of interfaces into tissue or object, if the
/// truth is taken; else those that tube cores find in `raw`, the phase as it was read, cut by the strokes. The result
/// is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<MeasuredSurfaces> measuredSurfacesOf(const SurfaceSource& source, const Volume& raw,
                                                                 const Progress& progress = {});

/// The measures of each pane, in their order: of the voxels of the pane's own phase, along viewpointOf(), with
/// measuredSurfacesOf() of that phase. A pane has no value if no surface is known. The result is empty only if
/// progress.cancel was raised. Throws std::out_of_range if the study lacks a phase that is measured.
struct PaneMeasures {
    SurfacesFrom from = SurfacesFrom::tubeCores;
    ClassificationMeasures measures;
};
[[nodiscard]] std::optional<std::vector<std::optional<PaneMeasures>>> measuresOfPanes(const Document& document,
                                                                                      StudyPhases phases,
                                                                                      const Progress& progress = {});

}  // namespace echolucent
