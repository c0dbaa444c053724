// How a volume is made smaller than in its file: by which factors, and how many voxels remain.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace echolucent {

/// Blocks of stored voxels; each block is kept as one voxel, its mean (BlockMean).
struct Reduction {
    std::array<std::int64_t, 3> by{1, 1, 1};          ///< stored voxels of a block along x, y and z; each at least 1
    std::array<std::int64_t, 3> storedSize{1, 1, 1};  ///< voxels along x, y and z in the file
    /// Along x, y and z: whether the first block is the one that may be smaller, in place of the last. True only while
    /// a file is read whose grid is turned round along that axis afterwards.
    std::array<bool, 3> smallerFirst{};
    friend bool operator==(const Reduction&, const Reduction&) = default;
};

/// How many blocks there are along x, y and z. If the factor does not divide the size, the last block is smaller, or
/// the first one (Reduction::smallerFirst).
[[nodiscard]] std::array<std::int64_t, 3> reducedSize(const Reduction& reduction);
/// How many voxels the first block along each axis has less than a whole one.
[[nodiscard]] std::array<std::int64_t, 3> lackingInFirst(const Reduction& reduction);

constexpr std::int64_t largestReduction = 64;

/// The reduction by the smallest whole factor, from 2 to largestReduction, that leaves at most `mostVoxels` of a volume
/// of this size (each at least 1). An axis of fewer voxels than twice the factor keeps its voxels. No value if no
/// factor is large enough.
[[nodiscard]] std::optional<Reduction> reductionTo(const std::array<std::int64_t, 3>& size, std::int64_t mostVoxels);

/// The factors as a picture shows them: "2 x 2 x 1".
[[nodiscard]] std::string factorsText(const Reduction& reduction);

/// Whether `reduction` can have made a volume of `size`: the sizes agree, each factor is 1 to largestReduction, and at
/// least one is above 1.
[[nodiscard]] bool canHaveMade(const Reduction& reduction, const std::array<std::int64_t, 3>& size);

}  // namespace echolucent
