// Steps along the axes of an NRRD file as its fields give them: spacings, or the ends of the axes; and their units.
#pragma once

#include <string>
#include <vector>

#include "io/headers/header_units.h"
#include "io/headers/nrrd_axes.h"
#include "io/headers/nrrd_fields.h"

namespace echolucent {

/// Steps along all axes in the header's own units.
struct NrrdSpacings {
    std::vector<double> values;         ///< NaN for an axis without one; empty if the header gives none at all
    std::string source;                 ///< "spacings", "axis mins, axis maxs, centerings"
    std::vector<std::string> warnings;  ///< sentences on what was assumed
};
/// The header's spacings; else the distances of the ends of its axes (axis mins and axis maxs), where centerings say
/// whether the ends are those of voxels or their centres. Fails (unreadable) if a field is no list of one number for
/// each axis.
[[nodiscard]] Result<NrrdSpacings> nrrdSpacings(const std::string& path, const NrrdFields& fields,
                                                const NrrdAxes& axes);

/// The unit of each of the three axes of space, by the field units. An axis that may be no space counts as mm.
[[nodiscard]] LengthUnits unitsOfSpaceAxes(const NrrdFields& fields, const NrrdAxes& axes);
/// The units of the three coordinates of space, by the field "space units".
[[nodiscard]] LengthUnits unitsOfCoordinates(const NrrdFields& fields);
/// The word for the unit along an axis that is no space; empty if the header has none.
[[nodiscard]] std::string unitOfAxis(const NrrdFields& fields, const NrrdAxes& axes, std::size_t axis);

}  // namespace echolucent
