// The planes in which a scan was made: which way across the beam lies in them, and which across them.
#pragma once

#include <string>
#include <string_view>

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What the scan planes rest on.
enum class ScanPlaneEvidence {
    none,     ///< nothing clearly tells the two directions across the beam apart
    file,     ///< the file says how the planes lay (StatedProbe::planesKnown)
    spacing,  ///< voxels lie farther apart across the planes
    grain,    ///< the echo's grain is coarser across the planes
};
/// "none", "file", "spacing", "grain".
[[nodiscard]] std::string_view nameOf(ScanPlaneEvidence evidence);

/// A probe that sweeps makes plane after plane. A *scan plane* holds the beam and the *lateral* direction; the
/// *elevation* lies across it. Resolution is coarsest along the elevation: sound is focused least that way, and planes
/// lie apart.
struct ScanPlanes {
    /// A unit vector at a right angle to the beam, in grid mm. If not sure, it is the right of the view from the probe.
    Vec3 lateral{1, 0, 0};
    ScanPlaneEvidence evidence = ScanPlaneEvidence::none;
    double confidence = 0.0;  ///< [0,1]
    bool sure = false;        ///< whether sides may be named by the planes
    std::string sentence{};   ///< for a person: what was found
    friend bool operator==(const ScanPlanes&, const ScanPlanes&) = default;
};

/// The scan planes of a volume that is seen from the probe along `fromProbe`: from the file; else from the spacing,
/// which is coarser along the elevation; else from the grain (grainMm() of the volume). Spacing and grain are compared
/// only if the view's right and down lie along grid axes. The confidence is that of the larger ratio: none at 1, all
/// from 1.6 on. From 0.5 on the planes are sure.
[[nodiscard]] ScanPlanes scanPlanesOf(const VolumeGeometry& geometry, const Viewpoint& fromProbe, const Vec3& grainMm);

}  // namespace echolucent
