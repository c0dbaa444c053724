// A study on its way out of the reader process: a message, and the voxels in shared memory.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/restricted/channel.h"
#include "io/restricted/shared_voxel_memory.h"
#include "io/study/study.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent::restricted {

/// A study as it travels.
struct SharedStudy {
    std::string bytes;
    Descriptor voxels;
};

/// Puts those voxels and masks of a study into shared memory that are not there yet, and hands the memory over. The
/// study is freed, because the workstation takes no memory that others could still write to. Fails (unreadable) if the
/// system has no more memory.
[[nodiscard]] Result<SharedStudy> shareStudy(Study study, SharedVoxelMemory& memory);

/// Takes a study from a reader's message. The reader may still run and is not trusted. No value if the memory could
/// still change, if sizes disagree, or if a number is one that no reader gives.
[[nodiscard]] std::optional<Study> takeStudy(std::span<const std::uint8_t> bytes, const Descriptor& voxels);

/// As shareStudy() and takeStudy(), but for what a coarse grid shows. takeCoarse() also has no value if that is larger
/// than a coarse grid can be.
[[nodiscard]] Result<SharedStudy> shareCoarse(const CoarseVolume& coarse);
[[nodiscard]] std::optional<CoarseVolume> takeCoarse(std::span<const std::uint8_t> bytes, const Descriptor& voxels);

}  // namespace echolucent::restricted
