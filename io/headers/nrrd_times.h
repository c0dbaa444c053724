// When the phases of an NRRD file were acquired, by its axes and by the keys of 3D Slicer and Plus.
#pragma once

#include <cstddef>
#include <optional>

#include "io/headers/nrrd_axes.h"
#include "io/headers/nrrd_fields.h"
#include "io/headers/nrrd_spacings.h"
#include "io/headers/stated_times.h"

namespace echolucent {

/// The times of the phases along `timeAxis`: the first that the header states of the index values of a sequence, the
/// labels of a MultiVolume, the time stamps of frames, the direction of that axis, its spacing. No value if it states
/// none.
[[nodiscard]] std::optional<StatedTimes> nrrdTimes(const NrrdFields& fields, const NrrdAxes& axes,
                                                   const NrrdSpacings& spacings, std::size_t timeAxis);

}  // namespace echolucent
