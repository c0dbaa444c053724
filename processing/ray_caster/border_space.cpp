#include "processing/ray_caster/border_space.h"

#include <algorithm>
#include <span>

#include "processing/parallel.h"
#include "processing/ray_caster/packed_voxels.h"

namespace echolucent::ray_casting {

BorderSpace::BorderSpace(const VolumeGeometry& geometry, const std::optional<Volume>& presence) {
    // Samples lie in cubes 0 ... size.
    for (std::size_t axis = 0; axis < 3; ++axis) m_size[axis] = geometry.size[axis] / edge + 1;
    if (!presence) return;
    m_distances.assign(static_cast<std::size_t>(m_size[0] * m_size[1] * m_size[2]), farthest);
    findBorders(*presence);
    findDistances();
}

void BorderSpace::findBorders(const Volume& presence) {
    const VolumeGeometry& geometry = presence.geometry();
    const auto& bytes = std::get<std::vector<std::uint8_t>>(presence.voxels());
    // Each thread has slices of bricks of its own. The voxels of brick b are 4b - 1 ... 4b + 3.
    parallelFor(std::int64_t{0}, m_size[2], [&](std::int64_t brickZ) {
        const auto first = [](std::int64_t brick, std::int64_t size) {
            return std::clamp<std::int64_t>(brick * edge - cubeShift, 0, size - 1);
        };
        const auto last = [](std::int64_t brick, std::int64_t size) {
            return std::min<std::int64_t>(brick * edge + edge - cubeShift, size - 1);
        };
        // First what is least in each column of voxels of the bricks, whole rows at once.
        std::vector<std::uint8_t> least(static_cast<std::size_t>(geometry.size[0]));
        for (std::int64_t brickY = 0; brickY < m_size[1]; ++brickY) {
            std::ranges::fill(least, std::uint8_t{255});
            for (std::int64_t z = first(brickZ, geometry.size[2]); z <= last(brickZ, geometry.size[2]); ++z)
                for (std::int64_t y = first(brickY, geometry.size[1]); y <= last(brickY, geometry.size[1]); ++y) {
                    const std::uint8_t* row = bytes.data() + geometry.offset(0, y, z);
                    std::ranges::transform(least, std::span(row, least.size()), least.begin(),
                                           [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); });
                }
            for (std::int64_t brickX = 0; brickX < m_size[0]; ++brickX) {
                const bool borders = std::any_of(least.begin() + first(brickX, geometry.size[0]),
                                                 least.begin() + last(brickX, geometry.size[0]) + 1,
                                                 [](std::uint8_t here) { return here < PresenceUse::allFrom; });
                if (borders)
                    m_distances[static_cast<std::size_t>(brickX + m_size[0] * (brickY + m_size[1] * brickZ))] = 0;
            }
        }
    });
}

/// Distances over faces, edges and corners are exact after two sweeps, there and back. A frame of far bricks around the
/// grid spares both the question where it ends.
void BorderSpace::findDistances() {
    const std::int64_t row = m_size[0] + 2, slice = row * (m_size[1] + 2);
    std::vector<std::uint8_t> framed(static_cast<std::size_t>(slice * (m_size[2] + 2)), farthest);
    const auto rowAt = [&](std::int64_t y, std::int64_t z) {
        return framed.data() + 1 + row * (y + 1) + slice * (z + 1);
    };
    const auto forEachRow = [&](const auto& visit) {
        for (std::int64_t z = 0; z < m_size[2]; ++z)
            for (std::int64_t y = 0; y < m_size[1]; ++y)
                visit(rowAt(y, z), m_distances.data() + m_size[0] * (y + m_size[1] * z));
    };
    forEachRow([&](std::uint8_t* to, const std::uint8_t* from) { std::copy_n(from, m_size[0], to); });
    // The thirteen neighbours that a sweep has passed; on the way back they lie on the other side.
    std::array<std::int64_t, 13> passed{};
    for (std::int64_t i = 0; i < 13; ++i)
        passed[static_cast<std::size_t>(i)] = i % 3 - 1 + row * (i / 3 % 3 - 1) + slice * (i / 9 - 1);
    const auto relax = [&](std::uint8_t* brick, std::int64_t side) {
        int nearest = *brick;
        for (const std::int64_t offset : passed) nearest = std::min(nearest, brick[side * offset] + 1);
        *brick = static_cast<std::uint8_t>(nearest);
    };
    for (std::int64_t z = 0; z < m_size[2]; ++z)
        for (std::int64_t y = 0; y < m_size[1]; ++y)
            for (std::int64_t x = 0; x < m_size[0]; ++x) relax(rowAt(y, z) + x, 1);
    for (std::int64_t z = m_size[2] - 1; z >= 0; --z)
        for (std::int64_t y = m_size[1] - 1; y >= 0; --y)
            for (std::int64_t x = m_size[0] - 1; x >= 0; --x) relax(rowAt(y, z) + x, -1);
    forEachRow([&](const std::uint8_t* from, std::uint8_t* to) { std::copy_n(from, m_size[0], to); });
}

}  // namespace echolucent::ray_casting
