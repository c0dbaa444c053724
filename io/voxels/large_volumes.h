// Decides which volumes are too large to be kept as stored, and by how much reading reduces them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "io/voxels/voxel_types.h"
#include "processing/document/read_options.h"
#include "processing/result.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// The most voxels that are kept of a phase on any machine: 512 Mi, half of a cube of 1024.
constexpr std::int64_t mostPhaseVoxels = std::int64_t{1} << 29;
/// A window at rest takes about this many times the memory of its study's voxels: quiet voxels, masks, packed voxels of
/// the ray caster and planes come on top (docs/loading.md).
constexpr std::uint64_t memoryPerVoxels = 6;
/// A phase is reduced if the machine has fewer than this many bytes of memory for each voxel. While speckle is taken
/// away, voxels of one byte take 7 of these bytes (docs/loading.md); other types and a second pass need more.
constexpr std::uint64_t workingBytesPerVoxel = 18;

/// The most bytes for the voxels of all phases: ReadOptions::studyMebibytes, else this machine's memory over
/// memoryPerVoxels.
[[nodiscard]] std::uint64_t mostStudyBytes(const ReadOptions& options);

/// The most voxels that are kept of a phase on a machine with this much memory: mostPhaseVoxels, or fewer if the
/// machine has less than workingBytesPerVoxel for each.
[[nodiscard]] std::int64_t mostVoxelsOfPhase(std::uint64_t machineBytes);

/// The voxels that a file declares.
struct DeclaredVoxels {
    std::array<std::int64_t, 3> size{1, 1, 1};  ///< of a phase; each at least 1
    std::int64_t phases = 1;                    ///< at least 1
    StoredType type = StoredType::uint8;
    bool rescaled = false;  ///< whether a Rescale makes them float32
};

/// The most bytes that one voxel of a stored type takes in memory, whatever the values.
[[nodiscard]] std::int64_t mostKeptBytes(StoredType type, bool rescaled);

/// How a volume is reduced, and why.
struct ChosenReduction {
    Reduction reduction;
    std::string reason;  ///< "at most 536870912 voxels are kept of a phase", for the report
};

/// How to reduce the voxels while they are read; no value if they are kept as they are. Fails (unreadable, about `file`
/// and the key, tag or option `element` that gave the size) if no factor is large enough. Call it after the file is
/// known to hold what it declares, and before memory is taken for the voxels.
[[nodiscard]] Result<std::optional<ChosenReduction>> chooseReduction(const std::string& file,
                                                                     const std::string& element,
                                                                     const DeclaredVoxels& declared,
                                                                     const ReadOptions& options);

/// Tells the person that the volume was reduced.
[[nodiscard]] std::string reductionWarning(const ChosenReduction& chosen);

}  // namespace echolucent
