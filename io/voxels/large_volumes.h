// Which volumes are too large to be kept as they are stored, and by how much these are reduced while they are read.
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

/// A phase keeps no more voxels than this on any machine: 512 Mi, half of a cube of 1024.
constexpr std::int64_t mostPhaseVoxels = std::int64_t{1} << 29;
/// The window takes about so many times the memory of a study's voxels once it is at rest: quiet voxels, masks, the
/// voxels that the ray caster packs, and planes stand beside them (docs/loading.md).
constexpr std::uint64_t memoryPerVoxels = 6;
/// A phase is kept whole where the machine has so many bytes for each of its voxels. For bytes the window takes 7 of
/// them while speckle is taken away (docs/loading.md); other types and a second pass need more.
constexpr std::uint64_t workingBytesPerVoxel = 18;

/// The most bytes that the voxels of all phases may take: ReadOptions::studyMebibytes, else what fits into this
/// machine's memory memoryPerVoxels times.
[[nodiscard]] std::uint64_t mostStudyBytes(const ReadOptions& options);

/// The most voxels that a phase may keep on a machine of so many bytes of memory: mostPhaseVoxels, or what can be
/// worked on there.
[[nodiscard]] std::int64_t mostVoxelsOfPhase(std::uint64_t machineBytes);

/// What a file declares of its voxels.
struct DeclaredVoxels {
    std::array<std::int64_t, 3> size{1, 1, 1};  ///< of a phase; each at least 1
    std::int64_t phases = 1;                    ///< at least 1
    StoredType type = StoredType::uint8;
    bool rescaled = false;  ///< they are put on a line, which makes them float32
};

/// The most bytes that one voxel of a stored type takes in memory, whatever its values are.
[[nodiscard]] std::int64_t mostKeptBytes(StoredType type, bool rescaled);

/// How a volume is reduced, and why.
struct ChosenReduction {
    Reduction reduction;
    std::string reason;  ///< "at most 536870912 voxels are kept of a phase", for the report
};

/// How the voxels are to be reduced while they are read; no value where they are kept as they are. Fails (unreadable,
/// about `file` and the key, tag or option `element` that gave the size) where no factor makes them small enough. To be
/// asked when it is known that the file holds what it declares, and before memory is taken.
[[nodiscard]] Result<std::optional<ChosenReduction>> chooseReduction(const std::string& file,
                                                                     const std::string& element,
                                                                     const DeclaredVoxels& declared,
                                                                     const ReadOptions& options);

/// The sentence for the person whose volume was reduced.
[[nodiscard]] std::string reductionWarning(const ChosenReduction& chosen);

}  // namespace echolucent
