#include "processing/ray_caster/packed/packed_light.h"

#include <algorithm>

#include "processing/parallel.h"

namespace echolucent::ray_casting {

PackedLight::PackedLight(const LightVolume& light, const VolumeGeometry& geometry)
    : size{light.size[0], light.size[1], light.size[2]} {
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        perVoxel[i] = geometry.spacing[axis] / light.spacingMm[axis];
        firstVoxel[i] = -light.firstMm[axis] / light.spacingMm[axis];
    }
    const std::int64_t columns = size[0], rows = size[1], slices = size[2];
    places.resize(static_cast<std::size_t>(columns * rows * (slices + 1) * bytesPerPlace));
    parallelFor(LoopRange<std::int64_t>(0, rows * (slices + 1), 32), [&](const auto& range) {
        for (std::int64_t row = range.begin(); row < range.end(); ++row) {
            const std::int64_t y = row % rows, z = std::min(row / rows, slices - 1);
            const std::uint8_t* const here = light.reaching.data() + (z * rows + y) * columns * 2;
            const std::uint8_t* const below =
                light.reaching.data() + (z * rows + std::min(y + 1, rows - 1)) * columns * 2;
            std::uint8_t* out = places.data() + row * columns * bytesPerPlace;
            for (std::int64_t x = 0; x < columns; ++x)
                for (int kind = 0; kind < 2; ++kind, out += bytesPerPlace / 2) {
                    const std::int64_t left = 2 * x + kind, right = 2 * std::min(x + 1, columns - 1) + kind;
                    out[0] = here[left];
                    out[1] = below[left];
                    out[2] = here[right];
                    out[3] = below[right];
                }
        }
    });
}

}  // namespace echolucent::ray_casting
