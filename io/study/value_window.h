// Which of a file's values is black, and how its voxels are kept so that black is 0 in memory.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/study/study_assembly.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

/// The note of a study whose black stays at 0 because `ReadOptions::blackAtZero` says so, where that may hide much.
inline constexpr std::string_view blackKeptAtZero =
    "Black is kept at 0, as an older document or --black-at-zero asks: what lies below it cannot be seen.";

/// Converts the bytes of all phases (machine byte order) into parts.voxels, as convertVoxels() or
/// convertRescaledVoxels() do if black is 0. Else the voxels are what lies above black. Black is, in this order:
/// - 0 if `options` say so;
/// - what the file states (parts.blackLevel), or 0 if it states white alone (parts.whiteLevel);
/// - 0 if that hides little (blackLevelOf());
/// - the smallest value that the stored bits can mean (parts.lowestLevel);
/// - the low end of the file's window if it suits, else that of the data.
/// Call it after these parts are set, and before voxels along beams are converted. It adds what it chose to `parts`.
void keepVoxels(StudyParts& parts, std::vector<VoxelBytes> phases, StoredType type,
                const std::optional<Rescale>& rescale, const ReadOptions& options);

}  // namespace echolucent
