#include "io/stored/right_handed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace echolucent {

namespace {

Vec3 columnOf(const Mat3& direction, int axis) { return {direction(0, axis), direction(1, axis), direction(2, axis)}; }

/// The largest part of a direction, with its sign.
double largestPart(const Vec3& direction) {
    double largest = direction[0];
    for (const double part : {direction[1], direction[2]})
        if (std::abs(part) > std::abs(largest)) largest = part;
    return largest;
}

/// 0 less the vector: no zero gets a sign.
Vec3 reversed(const Vec3& vector) { return Vec3(0, 0, 0) - vector; }

/// Reverses the order of `Voxel`s.
template <typename Voxel>
void reverseAs(std::span<std::uint8_t> bytes) {
    // The memory of byte vectors is aligned for every type, and so is each row of whole voxels.
    auto* first = reinterpret_cast<Voxel*>(bytes.data());
    std::reverse(first, first + bytes.size() / sizeof(Voxel));
}

void reverseVoxels(std::span<std::uint8_t> row, std::size_t bytes) {
    switch (bytes) {
        case 1: return reverseAs<std::uint8_t>(row);
        case 2: return reverseAs<std::uint16_t>(row);
        case 4: return reverseAs<std::uint32_t>(row);
        default: return reverseAs<std::uint64_t>(row);
    }
}

/// Reverses the order of pieces of `bytes` bytes, such as rows of a slice.
void reversePieces(std::span<std::uint8_t> pieces, std::size_t bytes) {
    for (std::size_t low = 0, high = pieces.size() - bytes; low < high; low += bytes, high -= bytes) {
        const auto piece = pieces.subspan(low, bytes);
        std::swap_ranges(piece.begin(), piece.end(), pieces.begin() + static_cast<std::ptrdiff_t>(high));
    }
}

}  // namespace

std::optional<GridAxis> axisToTurn(const StoredVolume& stored) {
    if (stored.polar || cv::determinant(stored.geometry.direction) > 0.0) return std::nullopt;
    constexpr double alike = 1e-3;
    GridAxis turned = GridAxis::z;
    double most = 0.0;
    for (const GridAxis axis : {GridAxis::z, GridAxis::y, GridAxis::x}) {
        const double along = largestPart(columnOf(stored.geometry.direction, placeOf(axis)).mul(stored.ownAxes));
        if (along > most - alike) continue;
        most = along;
        turned = axis;
    }
    return turned;
}

std::string handednessInWords(GridAxis turned) {
    return "left-handed grid: its " + std::string(nameOf(turned)) + " axis is turned round";
}

Reduction turnedRound(const Reduction& reduction, GridAxis axis) {
    Reduction turned = reduction;
    bool& smallerFirst = turned.smallerFirst[static_cast<std::size_t>(placeOf(axis))];
    smallerFirst = !smallerFirst;
    return turned;
}

VolumeGeometry turnedRound(const VolumeGeometry& geometry, GridAxis axis) {
    const int place = placeOf(axis);
    const double lengthMm =
        static_cast<double>(geometry.size[static_cast<std::size_t>(place)] - 1) * geometry.spacing[place];
    const Vec3 direction = columnOf(geometry.direction, place);
    VolumeGeometry turned = geometry;
    turned.origin += direction * lengthMm;
    for (int row = 0; row < 3; ++row) turned.direction(row, place) = reversed(direction)[row];
    if (geometry.reduction) turned.reduction = turnedRound(*geometry.reduction, axis);
    if (auto& probe = turned.probe) {
        probe->forward[place] = 0.0 - probe->forward[place];
        probe->down[place] = 0.0 - probe->down[place];
        if (probe->apexMm) (*probe->apexMm)[place] = lengthMm - (*probe->apexMm)[place];
    }
    return turned;
}

CoarseGrid asStored(const CoarseGrid& grid, const VolumeGeometry& stored, GridAxis axis) {
    const auto of = static_cast<std::size_t>(placeOf(axis));
    CoarseGrid same = grid;
    same.full = stored;
    same.first[of] = stored.size[of] - 1 - grid.voxelOf(placeOf(axis), grid.geometry.size[of] - 1);
    same.geometry = turnedRound(grid.geometry, axis);
    return same;
}

void turnRound(std::vector<VoxelBytes>& phases, const std::array<std::int64_t, 3>& size, std::size_t bytes,
               GridAxis axis) {
    const std::size_t row = static_cast<std::size_t>(size[0]) * bytes;
    const std::size_t slice = static_cast<std::size_t>(size[1]) * row;
    for (VoxelBytes& phase : phases) {
        const std::span<std::uint8_t> all(phase);
        if (axis == GridAxis::z) reversePieces(all, slice);
        const std::size_t step = axis == GridAxis::x ? row : slice;
        for (std::size_t first = 0; axis != GridAxis::z && first < all.size(); first += step)
            axis == GridAxis::x ? reverseVoxels(all.subspan(first, row), bytes)
                                : reversePieces(all.subspan(first, slice), row);
    }
}

}  // namespace echolucent
