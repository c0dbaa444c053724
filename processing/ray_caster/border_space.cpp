#include "processing/ray_caster/border_space.h"

#include <algorithm>

#include "processing/parallel.h"
#include "processing/ray_caster/packed_voxels.h"

namespace echolucent::ray_casting {

BorderSpace::BorderSpace(const FilledVolume& volume) {
    // Samples lie in cubes 0 ... size.
    for (std::size_t axis = 0; axis < 3; ++axis) m_size[axis] = volume.voxels.geometry().size[axis] / edge + 1;
    if (!volume.presence) return;
    m_distances.assign(static_cast<std::size_t>(m_size[0] * m_size[1] * m_size[2]), farthest);
    findBorders(*volume.presence);
    sweep(true);
    sweep(false);
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
        for (std::int64_t brickY = 0; brickY < m_size[1]; ++brickY)
            for (std::int64_t z = first(brickZ, geometry.size[2]); z <= last(brickZ, geometry.size[2]); ++z)
                for (std::int64_t y = first(brickY, geometry.size[1]); y <= last(brickY, geometry.size[1]); ++y)
                    for (std::int64_t brickX = 0; brickX < m_size[0]; ++brickX) {
                        const std::uint8_t* row = bytes.data() + geometry.offset(0, y, z);
                        const std::uint8_t* from = row + first(brickX, geometry.size[0]);
                        const bool borders = std::any_of(from, row + last(brickX, geometry.size[0]) + 1,
                                                         [](std::uint8_t here) { return here < PresenceUse::allFrom; });
                        if (borders)
                            m_distances[static_cast<std::size_t>(brickX + m_size[0] * (brickY + m_size[1] * brickZ))] =
                                0;
                    }
    });
}

/// One of the two sweeps after which distances over faces, edges and corners are exact.
void BorderSpace::sweep(bool forwards) {
    const auto at = [&](std::int64_t axis, std::int64_t i) {
        return forwards ? i : m_size[static_cast<std::size_t>(axis)] - 1 - i;
    };
    const auto offset = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
        return static_cast<std::size_t>(at(0, x) + m_size[0] * (at(1, y) + m_size[1] * at(2, z)));
    };
    for (std::int64_t z = 0; z < m_size[2]; ++z)
        for (std::int64_t y = 0; y < m_size[1]; ++y)
            for (std::int64_t x = 0; x < m_size[0]; ++x) {
                int nearest = m_distances[offset(x, y, z)];
                // The thirteen neighbours that this sweep has passed.
                for (int passed = 0; passed < 13; ++passed) {
                    const std::int64_t i = x + passed % 3 - 1, j = y + passed / 3 % 3 - 1, k = z + passed / 9 - 1;
                    if (i < 0 || j < 0 || k < 0 || i >= m_size[0] || j >= m_size[1]) continue;
                    nearest = std::min(nearest, m_distances[offset(i, j, k)] + 1);
                }
                m_distances[offset(x, y, z)] = static_cast<std::uint8_t>(nearest);
            }
}

}  // namespace echolucent::ray_casting
