// Rays whose surface is known: from the truth of a simulated scan, or from tube cores.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/phantom/phantom.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A ray whose surface is known.
struct SurfaceRay {
    Vec3 pointMm{0, 0, 0};        ///< a point of the ray, grid mm; its direction is the view's forward
    double surfaceDepthMm = 0.0;  ///< of the surface, mm along the view's forward from the grid's origin
    friend bool operator==(const SurfaceRay&, const SurfaceRay&) = default;
};

/// What a ray's first interface (PhantomTruth::firstInterface) leads into. The simulated fetus is covered with skin,
/// which is tissue; only its bones are object.
enum class InterfaceInto { object, tissue, objectOrTissue };
/// The rays of a simulated scan whose first interface leads from fluid into `into`. They are parallel, `raySpacing`
/// units (above 0) apart across the view, row by row. Rays are missing once progress.cancel is raised: whoever raises
/// it drops the result.
[[nodiscard]] std::vector<SurfaceRay> trueSurfaces(const VolumeGeometry& geometry, const PhantomTruth& truth,
                                                   const Viewpoint& view, InterfaceInto into, double raySpacing = 1.0,
                                                   const Progress& progress = {});

/// The rays along the axes of the tube cores with a surface and a weight, in the order of the tube cores. The surface
/// found stands in for the true one. `geometry` is that of the volume that the tube cores read.
[[nodiscard]] std::vector<SurfaceRay> tubeCoreRays(const VolumeGeometry& geometry, const AdaptiveOtf& otf);

/// The surfaces that stand in for the truth of a scan that nobody knows: tubeCoreRays() of the reading of version 0.1,
/// MethodReading::firstVersion, with measuredTubesAcross tube cores each way. They depend on scan and view alone, so
/// every OTF is measured with the same ones, whatever the method is set to. `raw` holds the voxels as they were read.
/// The result is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<std::vector<SurfaceRay>> foundSurfaces(const Volume& raw, const Viewpoint& view,
                                                                   const Progress& progress = {});
/// foundSurfaces(), and how far apart the tube cores stand that were looked for.
struct SpacedSurfaces {
    std::vector<SurfaceRay> rays{};
    std::array<double, 2> apartUnits{1, 1};  ///< along the view's right and down axes, above 0
};
[[nodiscard]] std::optional<SpacedSurfaces> spacedSurfaces(const Volume& raw, const Viewpoint& view,
                                                           const Progress& progress = {});
/// Tube cores side by side, cell beside cell, in a volume of the paper's size.
inline constexpr int measuredTubesAcross = 40;

}  // namespace echolucent
