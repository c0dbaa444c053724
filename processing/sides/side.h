// The six sides from which a scan is looked into: from the probe, from behind, onto and along the planes in which it
// was scanned.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "processing/sides/scan_planes.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// One of the six sides of a scan.
struct Side {
    int number = 1;            ///< 1 to 6, the place in the fixed order of sidesOf()
    std::string_view name;     ///< for a person, sentence case: "Onto the scan plane"; lasts for ever
    std::string_view word;     ///< for a command line: "onto"; lasts for ever
    std::string_view label;    ///< for a person, if there is little room: "3 Onto scan plane"; lasts for ever
    std::string_view meaning;  ///< for a person, a sentence or two: from where one looks; lasts for ever
    Viewpoint view{};          ///< along the side, uncut
    friend bool operator==(const Side&, const Side&) = default;
};

/// The sides of a scan, in a fixed order.
using Sides = std::array<Side, 6>;

/// The place among Sides of the side from the probe.
inline constexpr std::size_t probeSide = 0;
/// The place of the side onto the scan plane. Behind it stands the one onto the plane's back.
inline constexpr std::size_t ontoPlaneSide = 2;

/// The six sides of a scan. `fromProbe` is the view from the probe, whose cuts and box are left out.
///
/// | number | name | word | looks | down in the picture |
/// |---|---|---|---|---|
/// | 1 | From the probe | probe | along the beam | as in `fromProbe` |
/// | 2 | From behind | behind | against the beam | as in `fromProbe`: the scan is turned about the picture's vertical |
/// | 3 | Onto the scan plane | onto | along the elevation, the lateral direction to the right | the beam |
/// | 4 | Onto the back of the scan plane | onto-back | against the elevation | the beam |
/// | 5 | Along the scan plane, from the left | along-left | along the lateral direction | the beam |
/// | 6 | Along the scan plane, from the right | along-right | against the lateral direction | the beam |
///
/// Left and right are those of side 3. If the scan planes are not sure, sides 3 to 6 are called after the edges of the
/// view from the probe: "From the lower edge of side 1", then the upper, left and right one (across-1 to across-4), so
/// that side 3 looks up in the picture of side 1, side 4 down, side 5 to the right and side 6 to the left. If the beam
/// is not sure, all are called "Side 1" to "Side 6" (side-1 to side-6), whatever is known of the planes.
[[nodiscard]] Sides sidesOf(const Viewpoint& fromProbe, bool beamSure, const ScanPlanes& planes);

/// The place among `sides` of the one that a command line names: by its word, or by its number from 1 to 6. Empty if
/// there is none.
[[nodiscard]] std::optional<std::size_t> sideNamed(const Sides& sides, std::string_view wordOrNumber);

}  // namespace echolucent
