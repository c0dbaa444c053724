#include "processing/ray_caster/packed/packed_gradients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "processing/ray_caster/packed/transfer_table.h"

namespace echolucent::ray_casting {

namespace {

/// The gradients as a volume of bytes. It shares the bytes, and only its size matters.
Volume volumeOf(const Volume& filled, const std::shared_ptr<const GradientLevels>& levels) {
    VolumeGeometry geometry;
    geometry.size = filled.geometry().size;
    return Volume(geometry, VoxelArray<std::uint8_t>(levels, levels->bytes), 255.0);
}

}  // namespace

PackedGradients::PackedGradients(const Volume& filled, std::shared_ptr<const GradientLevels> levels,
                                 const BrickGrid& bricks)
    : m_levels(std::move(levels)),
      m_packed(volumeOf(filled, m_levels)),
      m_lowest(static_cast<std::size_t>(bricks.count())),
      m_highest(m_lowest.size()) {
    forEachBrick(bricks, [&](const std::array<std::int64_t, 3>& at, std::size_t brick) {
        std::uint8_t lowest = 255, highest = 0;
        forEachRowOf(filled.geometry(), at, [&](std::int64_t first, std::int64_t count) {
            const auto* const from = m_levels->bytes.data() + first;
            const auto [least, most] = std::minmax_element(from, from + count);
            lowest = std::min(lowest, *least);
            highest = std::max(highest, *most);
        });
        m_lowest[brick] = lowest;
        m_highest[brick] = highest;
    });
}

VisibleNodes::VisibleNodes(const TwoDimensionalOtf& otf) : m_intensities(otf.intensities), m_gradients(otf.gradients) {
    const auto columns = static_cast<std::size_t>(m_intensities), rows = static_cast<std::size_t>(m_gradients);
    m_before.resize((columns + 1) * (rows + 1));
    std::size_t first = columns;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const float opacity = otf.opacities[row * columns + column];
            if (opacity > 0.0f) first = std::min(first, column);
            const std::size_t at = (row + 1) * (columns + 1) + column + 1;
            m_before[at] = m_before[at - 1] + m_before[at - columns - 1] - m_before[at - columns - 2] +
                           (static_cast<double>(opacity) > TransferTable::negligible ? 1 : 0);
        }
    m_firstVisible = (static_cast<float>(first) - 1.0f) * static_cast<float>(TransferTable::intervals) /
                     static_cast<float>(columns - 1);
}

bool VisibleNodes::transparentBetween(float lowest, float highest, std::uint8_t lowestGradient,
                                      std::uint8_t highestGradient) const {
    // Rounding in the kernel may leave the bytes' range by very little. The mean of equal bytes is exact.
    const double rounding = lowestGradient < highestGradient ? 0.01 : 0.0;
    const auto nodesOf = [](double low, double high, int nodes) {
        const double first = std::clamp(low, 0.0, 1.0) * (nodes - 1), last = std::clamp(high, 0.0, 1.0) * (nodes - 1);
        return std::pair(static_cast<std::size_t>(first), static_cast<std::size_t>(std::ceil(last)) + 1);
    };
    constexpr double positions = TransferTable::intervals;
    const auto f =
        nodesOf(static_cast<double>(lowest) / positions, static_cast<double>(highest) / positions, m_intensities);
    const auto g = nodesOf((lowestGradient - rounding) / 255.0, (highestGradient + rounding) / 255.0, m_gradients);
    const auto before = [&](std::size_t column, std::size_t row) {
        return m_before[row * (static_cast<std::size_t>(m_intensities) + 1) + column];
    };
    return before(f.second, g.second) - before(f.first, g.second) - before(f.second, g.first) +
               before(f.first, g.first) ==
           0;
}

}  // namespace echolucent::ray_casting
