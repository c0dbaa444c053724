// Finds the first transition from fluid to tissue along a tube core by the ratio of means before and behind it.
//
// Speckle multiplies: inside tissue the variance of the echo is as large as that of an edge. So along a tube core the
// variance is a step rather than a peak. Edge detectors for radar pictures therefore compare means by their ratio,
// whose false alarms do not depend on the mean (Touzi 1988). Speckle of radar and of ultrasound is of one nature, as
// Petersch 2005 (section 5) notes. Here the ratio is a difference on the SpeckleScale, so that it is right for
// compressed echo too.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "processing/detection/speckle_scale.h"
#include "processing/tube_core/rules/ratio_rule.h"
#include "processing/tube_core/slabs/tube_profiles.h"

namespace echolucent {

/// What the tubes of a view share: which contrast is no accident, and where fluid ends.
struct RatioThresholds {
    double contrast = 0.0;             ///< boundaries with more contrast count
    double fluidLevel = 0.0;           ///< means below it are fluid, above it tissue; on the scale
    double fluid = 0.0, tissue = 0.0;  ///< typical levels before and behind the strongest boundaries, on the scale
    double step = 0.0;                 ///< least rise of a surface, normalised intensity
    bool mayHoldSurfaces = false;  ///< whether enough tubes hold a certain boundary, and the strongest boundaries may
                                   ///< be those of fluid; if false, the levels above may be 0
};

/// The contrast at every boundary of a profile: the mean of the slabs behind less the mean of those before. Element i
/// is the boundary between slabs i + leastFluid - 1 and i + leastFluid. At least half of slabsBehind must lie behind a
/// boundary. `scaled` is the profile on the scale.
void contrastsAlong(std::span<const float> scaled, const RatioRule& rule, std::span<float> contrasts);
/// The number of boundaries with a contrast in a profile of `slabs` slabs.
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

/// Looks at all tubes. The lower quartile of all |contrast| gives the spread of contrasts without boundaries, because
/// boundaries are few and hardly move the quartile. Each tube has one strongest boundary, and the fluid level is the
/// median middle of the stronger ones of these. A boundary is certain from `certainty` spreads on. The rule's
/// contrastFloor and contrastCeiling limit this and every other least contrast. Boundaries may be those of fluid if the
/// intensities behind and before them differ by the least ratio. If echo is compressed, they always may be those of
/// fluid, because the ratio of intensities then says nothing.
[[nodiscard]] RatioThresholds ratioThresholds(const TubeContrasts& tubes, const SpeckleScale& scale,
                                              const RatioRule& rule);

/// A surface on a profile.
struct RatioSurface {
    int cell = 0;  ///< the first slab of the surface cell, counted from the profile's first
    double contrast = 0.0;
};
/// The first surface of one tube; empty if there is none. It begins at the first boundary with a contrast that counts,
/// fluid before it (the mean, and leastDark slabs), tissue behind it, and a rise of at least thresholds.step. From
/// there on, as long as contrasts count and fluid lies before them, the boundary of highest contrast is the surface.
/// `means` is the tube's profile, `scaled` the profile on the scale, `contrasts` its contrasts. The surface cell's mean
/// is halfway between fluid and tissue.
[[nodiscard]] std::optional<RatioSurface> firstFluidToTissue(std::span<const float> means,
                                                             std::span<const float> scaled,
                                                             std::span<const float> contrasts,
                                                             const RatioThresholds& thresholds, const RatioRule& rule,
                                                             int cellSize);

}  // namespace echolucent
