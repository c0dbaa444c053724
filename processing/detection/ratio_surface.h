// Finding the first transition from fluid to tissue along a tube core by the ratio of means before and behind it.
//
// Speckle multiplies: inside tissue the variance of the echo is as large as that of an edge, so along a tube core the
// variance is a step rather than a peak. Detectors of edges in radar pictures therefore compare means by their ratio,
// whose false alarms do not depend on the mean (Touzi 1988); Petersch 2005 (section 5) notes that both kinds of speckle
// are of one nature. Here the ratio is a difference on the SpeckleScale, so that it stays right for compressed echo.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "processing/detection/speckle_scale.h"
#include "processing/tube_core/rules/ratio_rule.h"
#include "processing/tube_core/slabs/tube_profiles.h"

namespace echolucent {

/// What the tubes of a view have in common: how strong a contrast is no accident, and where fluid ends.
struct RatioThresholds {
    double contrast = 0.0;             ///< a boundary counts from here on
    double fluidLevel = 0.0;           ///< means below it are fluid, above it tissue: value of the scale
    double fluid = 0.0, tissue = 0.0;  ///< typical levels before and behind the strongest boundaries, on the scale
    double step = 0.0;                 ///< a surface rises by at least this, normalised intensity
    bool mayHoldSurfaces = false;      ///< whether enough tubes hold a boundary that is certain and may be fluid's
};

/// The contrast at every boundary of a profile on the scale: mean of the slabs behind less mean of those before.
/// Element i belongs to the boundary between slabs i + leastFluid - 1 and i + leastFluid; there is none with fewer than
/// half of slabsBehind past it. `scaled` is the profile on the scale.
void contrastsAlong(std::span<const float> scaled, const RatioRule& rule, std::span<float> contrasts);
/// How many boundaries with a contrast a profile of `slabs` slabs has.
[[nodiscard]] std::size_t contrastCount(std::size_t slabs, const RatioRule& rule);

/// All tubes' profiles on the scale and their contrasts, computed once for the thresholds and for the surfaces.
class TubeContrasts {
public:
    TubeContrasts(const TubeProfiles& profiles, const SpeckleScale& scale, const RatioRule& rule);
    [[nodiscard]] std::size_t tubes() const { return m_profiles.size(); }
    [[nodiscard]] std::span<const float> scaled(std::size_t tube) const { return m_profiles[tube]; }
    /// As contrastsAlong() gives them.
    [[nodiscard]] std::span<const float> contrasts(std::size_t tube) const { return m_contrasts[tube]; }

private:
    std::unique_ptr<float[]> m_values;
    std::vector<std::span<float>> m_profiles, m_contrasts;  ///< in m_values
};

/// Looks at all tubes. The contrast's spread without boundaries is read off its lower quartile, which boundaries, being
/// few, hardly move. The fluid level is the median middle of the tubes' strongest boundaries. A boundary is certain
/// from `certainty` spreads on; like every contrast that counts, that is kept within the rule's floor and ceiling.
/// Boundaries may be those of fluid where the intensities behind and before them differ by the least ratio, and always
/// where echo is compressed (the spread of speckle grows less than the mean, and the ratio of intensities says
/// nothing).
[[nodiscard]] RatioThresholds ratioThresholds(const TubeContrasts& tubes, const SpeckleScale& scale,
                                              const RatioRule& rule);

/// A surface on a profile.
struct RatioSurface {
    int cell = 0;  ///< the slab, counted from the profile's first, that begins the surface cell
    double contrast = 0.0;
};
/// The first surface of one tube: the boundary in front of which lies fluid, behind which lies tissue, and whose
/// contrast counts; where several do in a row, the one of highest contrast. `means` is the tube's profile, `scaled` the
/// profile on the scale, and `contrasts` are its contrasts. The surface cell's mean is halfway between fluid and
/// tissue. Nothing is returned where there is no surface.
[[nodiscard]] std::optional<RatioSurface> firstFluidToTissue(std::span<const float> means,
                                                             std::span<const float> scaled,
                                                             std::span<const float> contrasts,
                                                             const RatioThresholds& thresholds, const RatioRule& rule,
                                                             int cellSize);

}  // namespace echolucent
