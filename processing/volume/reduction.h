// How a volume is made smaller than what its file holds: by which factors, and where its voxels then lie.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace echolucent {

/// Blocks of stored voxels of which one voxel each is kept, their mean (BlockMean).
struct Reduction {
    std::array<std::int64_t, 3> by{1, 1, 1};          ///< stored voxels along x, y and z of a block; each at least 1
    std::array<std::int64_t, 3> storedSize{1, 1, 1};  ///< voxels along x, y and z that the file holds
    friend bool operator==(const Reduction&, const Reduction&) = default;
};

/// How many blocks there are along x, y and z. The last one along an axis holds fewer stored voxels where the factor
/// does not divide the size.
[[nodiscard]] std::array<std::int64_t, 3> reducedSize(const Reduction& reduction);

/// No reduction has a larger factor.
constexpr std::int64_t largestReduction = 64;

/// The smallest whole factor, from 2 to largestReduction, by which a volume of this size (each at least 1) keeps no
/// more than `mostVoxels`. The factor holds along every axis but those of fewer voxels than twice the factor, which are
/// kept as they are. No value where no factor does it.
[[nodiscard]] std::optional<Reduction> reductionTo(const std::array<std::int64_t, 3>& size, std::int64_t mostVoxels);

/// The factors as they stand in a picture: "2 x 2 x 1".
[[nodiscard]] std::string factorsText(const Reduction& reduction);

/// Whether `reduction` can have made a volume of `size`: each factor is at least 1 and at most largestReduction, one of
/// them is above 1, and the sizes agree.
[[nodiscard]] bool canHaveMade(const Reduction& reduction, const std::array<std::int64_t, 3>& size);

}  // namespace echolucent
