// At which intensities light is held back before the surface: haze, by intensity.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "processing/classification.h"
#include "processing/comparison/surface_rays.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The light that a picture holds back too early. On a ray whose shown depth is early (ShownSurface), each sample more
/// than rightUnits before the surface holds back T alpha: the light that comes to it, times its opacity. Other rays
/// hold back nothing early.
struct EarlyLight {
    static constexpr std::size_t bins = 64;
    /// By the sample's intensity; bin b holds intensities from b / 64 on, the last one 1 too. Shares of a ray's light,
    /// means over all rays: the sum is the mean share that a ray loses before its surface, [0,1].
    std::array<double, bins> held{};
    int rays = 0, early = 0;  ///< all rays, and those that are early
    [[nodiscard]] double sum() const;
    friend bool operator==(const EarlyLight&, const EarlyLight&) = default;
};
/// Of one classification, with samples, opacities and shown depths as in measuresOf(). The result has the same bits for
/// any number of threads. It is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<EarlyLight> earlyLightOf(const Volume& shown, const Viewpoint& view,
                                                     std::span<const SurfaceRay> rays,
                                                     const Classification& classification,
                                                     const Progress& progress = {});

}  // namespace echolucent
