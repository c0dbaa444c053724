// Visits the rows of a grid in parallel.
#pragma once

#include <array>
#include <cstdint>

#include "processing/parallel.h"

namespace echolucent {

/// Calls visit(y, z) for every row along x of a grid of `size` voxels (x, y, z), in no order and on several threads.
/// One thread takes up to `rowsOfPart` rows (above 0) together.
template <typename Visit>
void forEachRow(const std::array<std::int64_t, 3>& size, std::int64_t rowsOfPart, const Visit& visit) {
    parallelFor(LoopRange<std::int64_t>(0, size[1] * size[2], rowsOfPart), [&](const auto& rows) {
        for (std::int64_t row = rows.begin(); row < rows.end(); ++row) visit(row % size[1], row / size[1]);
    });
}

}  // namespace echolucent
