#include "processing/volume/reduction.h"

#include <algorithm>

namespace echolucent {

namespace {

/// Whether the product of three sizes is at most `most`, without overflow.
bool isWithin(const std::array<std::int64_t, 3>& size, std::int64_t most) {
    return size[0] <= most && size[1] <= most / size[0] && size[2] <= most / (size[0] * size[1]);
}

}  // namespace

std::array<std::int64_t, 3> reducedSize(const Reduction& reduction) {
    std::array<std::int64_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = (reduction.storedSize[axis] - 1) / reduction.by[axis] + 1;
    return size;
}

std::array<std::int64_t, 3> lackingInFirst(const Reduction& reduction) {
    const auto size = reducedSize(reduction);
    std::array<std::int64_t, 3> lacking{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (reduction.smallerFirst[axis]) lacking[axis] = size[axis] * reduction.by[axis] - reduction.storedSize[axis];
    return lacking;
}

std::optional<Reduction> reductionTo(const std::array<std::int64_t, 3>& size, std::int64_t mostVoxels) {
    for (std::int64_t factor = 2; factor <= largestReduction; ++factor) {
        Reduction reduction{{1, 1, 1}, size};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (size[axis] >= 2 * factor) reduction.by[axis] = factor;
        if (isWithin(reducedSize(reduction), mostVoxels)) return reduction;
    }
    return std::nullopt;
}

std::string factorsText(const Reduction& reduction) {
    return std::to_string(reduction.by[0]) + " x " + std::to_string(reduction.by[1]) + " x " +
           std::to_string(reduction.by[2]);
}

bool canHaveMade(const Reduction& reduction, const std::array<std::int64_t, 3>& size) {
    const auto isFactor = [](std::int64_t factor) { return factor >= 1 && factor <= largestReduction; };
    return std::ranges::all_of(reduction.by, isFactor) && std::ranges::max(reduction.by) > 1 &&
           std::ranges::min(reduction.storedSize) >= 1 && reducedSize(reduction) == size;
}

}  // namespace echolucent
