// A study on its way out of the reader process: what it says as a message, its voxels in shared memory.
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

/// Puts those of a study's voxels and masks into shared memory that do not lie there yet, and hands the memory over.
/// The study is gone then: the workstation takes no memory that anyone could still write to. Fails (unreadable) where
/// the system has no more of it.
[[nodiscard]] Result<SharedStudy> shareStudy(Study study, SharedVoxelMemory& memory);

/// Takes a study out of what a reader sent, which may still run. Nobody trusts what it gave: memory that could still
/// change, sizes that do not agree and numbers that no reader gives are refused. No value then.
[[nodiscard]] std::optional<Study> takeStudy(std::span<const std::uint8_t> bytes, const Descriptor& voxels);

/// The same of what a coarse grid shows. No value either for one that is larger than a coarse grid can be.
[[nodiscard]] Result<SharedStudy> shareCoarse(const CoarseVolume& coarse);
[[nodiscard]] std::optional<CoarseVolume> takeCoarse(std::span<const std::uint8_t> bytes, const Descriptor& voxels);

}  // namespace echolucent::restricted
