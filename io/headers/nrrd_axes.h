// What the axes of an NRRD file stand for: space, time or colour.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/headers/nrrd_fields.h"

namespace echolucent {

enum class NrrdAxisRole { space, time, colour };

/// The axes of a file, the fastest first.
struct NrrdAxes {
    std::vector<std::int64_t> sizes;     ///< three or four, each at least 1
    std::vector<std::string> kinds;      ///< in lower case; empty if the header states none
    std::vector<NrrdVector> directions;  ///< steps in space; empty if the header states none
    std::vector<NrrdAxisRole> roles;     ///< three of them are space
    std::vector<std::string> warnings;   ///< sentences about kinds that play no part

    [[nodiscard]] std::string kindOf(std::size_t axis) const { return kinds.empty() ? "" : kinds[axis]; }
    /// Whether an axis that counts as space may really be something else: frames over time, a list.
    [[nodiscard]] bool mayBeNoSpace(std::size_t axis) const { return kindOf(axis) == "time" || kindOf(axis) == "list"; }
};

/// How many numbers the vectors of a header have, by its fields space ("…-time" has four) and "space dimension"; 0 if
/// it says neither.
[[nodiscard]] std::size_t nrrdSpaceDimensions(const NrrdFields& fields);
/// Whether a direction leads through time alone: four numbers, of which the last is not 0 and the others are.
[[nodiscard]] bool isTimeDirection(const NrrdVector& direction);

/// The axes of the header at `path`; `type` is the type of its voxels. Fails (unreadable) if they are no axes of a
/// volume, alone or over time: 2D pictures, several values for a voxel, time in the middle.
[[nodiscard]] Result<NrrdAxes> readNrrdAxes(const std::string& path, const NrrdFields& fields, StoredType type);

}  // namespace echolucent
