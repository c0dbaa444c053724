// The parts of `study aim`: what the positions of the aim show of surfaces whose truth is known, beside all designers
// and the best ramps that anybody could choose.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/measuring/shown_surfaces.h"
#include "processing/phantom/phantom_config.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent::cli {

/// The conditions of ordinaryConditions() and hardConditions(), one after the other.
struct AimCase {
    PhantomScene scene = PhantomScene::shapes;
    bool oblique = false;  ///< obliqueView, else along the beam
    SpeckleReduction reduction = SpeckleReduction::medium;
    friend bool operator==(const AimCase&, const AimCase&) = default;
};
[[nodiscard]] std::string nameOf(const AimCase& one);

/// The positions of the aim that are measured.
inline constexpr double measuredAims[] = {0.0, 0.25, 0.5, 0.75, 1.0};
/// The names of the ramps that are best for the objects, and for all surfaces, found with the truth.
inline constexpr const char* boundOfObjects = "best ramp, objects";
inline constexpr const char* boundOfAll = "best ramp, all";

/// One OTF on one scan.
struct AimRow {
    AimCase of;
    std::uint64_t seed = 0;
    NamedSurfaces named;
};
/// What all designers, the positions of the aim and both best ramps show, in all conditions of a scan. The best ramps
/// are those of a table of 1200 (begin, width and opacity) that are right most often on rays 4 units apart.
[[nodiscard]] std::vector<AimRow> measureAims(const PhantomConfig& base, const AimCase& one);

/// Tables and figures of each case, for a terminal.
[[nodiscard]] std::string aimSummary(const std::vector<AimRow>& rows);
[[nodiscard]] std::string aimCsv(const std::vector<AimRow>& rows);

}  // namespace echolucent::cli
