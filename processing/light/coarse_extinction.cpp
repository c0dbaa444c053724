#include "processing/light/coarse_extinction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "processing/parallel.h"

namespace echolucent::light {

namespace {

constexpr double levelsAbove = 254.0;

/// Opacity per unit of each byte that stands for a voxel, then 256 zeros for bytes of no data.
using ByteOpacities = std::array<float, 512>;

/// Opacity per unit of a level: 0 is no data.
float levelOpacity(const OpacityCurve& curve, std::uint8_t level) {
    return level == 0 ? 0.0f : static_cast<float>(opacityAt(curve, static_cast<double>(level - 1) / levelsAbove));
}

/// Extinction per mm over opacity per unit, linear between entries. Opacity 1 counts as a little less: less light
/// passes than a byte can hold.
class ExtinctionTable {
public:
    explicit ExtinctionTable(double unitMm) {
        constexpr double mostOpacity = 1.0 - 1e-6;
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            const double opacity = std::min(static_cast<double>(i) / intervals, mostOpacity);
            m_entries[i] = static_cast<float>(-std::log1p(-opacity) / unitMm);
        }
    }
    [[nodiscard]] float at(float opacity) const {
        const float position = opacity * static_cast<float>(intervals);
        const auto entry = static_cast<std::size_t>(position);
        return m_entries[entry] + (position - static_cast<float>(entry)) * (m_entries[entry + 1] - m_entries[entry]);
    }

private:
    static constexpr int intervals = 4096;
    std::array<float, intervals + 2> m_entries{};  ///< the last entry stands twice
};

/// A row of bytes that stand for voxels.
struct ByteRow {
    const std::uint8_t* bytes;
    const std::uint8_t* mask;  ///< 0 is no data; null if all are data, or if byte 0 is no data
};

template <bool isMasked>
float opacityOf(const ByteRow& row, std::size_t at, const ByteOpacities& opacities) {
    if constexpr (isMasked)
        return opacities[row.bytes[at] + (row.mask[at] == 0 ? 256U : 0U)];
    else
        return opacities[row.bytes[at]];
}

/// Adds the opacities of a row of voxels to the sums of its whole places. A place has so few voxels that it is summed
/// in registers.
template <std::size_t voxels, bool isMasked>
void addWholePlaces(const ByteRow& row, std::size_t places, const ByteOpacities& opacities, float* sums) {
    for (std::size_t place = 0; place < places; ++place) {
        const std::size_t first = place * voxels;
        float sum = opacityOf<isMasked>(row, first, opacities);
        for (std::size_t i = 1; i < voxels; ++i) sum += opacityOf<isMasked>(row, first + i, opacities);
        sums[place] += sum;
    }
}

template <bool isMasked>
void addRow(const ByteRow& row, std::size_t count, std::size_t voxels, const ByteOpacities& opacities, float* sums) {
    const std::size_t whole = count / voxels;
    const auto addAll = [&]<std::size_t... below>(std::index_sequence<below...>) {
        ((voxels == below + 1 ? addWholePlaces<below + 1, isMasked>(row, whole, opacities, sums) : void()), ...);
    };
    addAll(std::make_index_sequence<coarsest>());
    for (std::size_t x = whole * voxels; x < count; ++x) sums[x / voxels] += opacityOf<isMasked>(row, x, opacities);
}

template <typename Voxel>
std::uint8_t levelOf(Voxel value, float perWhite) {
    // NaN becomes intensity 0. The caller gives voxels without data level 0.
    const float share = static_cast<float>(value) * perWhite;
    const float inside = share > 0.0f ? std::min(share, 1.0f) : 0.0f;
    return static_cast<std::uint8_t>(1.5f + inside * static_cast<float>(levelsAbove));
}

float perWhiteOf(const Volume& volume) { return static_cast<float>(1.0 / volume.whiteLevel()); }

/// The levels of marked rows.
template <typename Voxel>
void fillLevels(const VoxelArray<Voxel>& voxels, const Volume& volume, const RowMarks& rows,
                std::vector<std::uint8_t>& levels) {
    const VolumeGeometry& geometry = volume.geometry();
    const float perWhite = perWhiteOf(volume);
    const auto fillRow = [&](std::int64_t first, std::int64_t count) {
        const Voxel* from = voxels.data() + first;
        std::uint8_t* to = levels.data() + first;
        for (std::int64_t i = 0; i < count; ++i) to[i] = levelOf(from[i], perWhite);
        if (volume.dataMaskOrNull() == nullptr) return;
        const std::uint8_t* mask = volume.dataMaskOrNull() + first;
        for (std::int64_t i = 0; i < count; ++i) to[i] = mask[i] != 0 ? to[i] : std::uint8_t{0};
    };
    parallelFor(std::int64_t{0}, rows.slices(), [&](std::int64_t z) {
        for (std::int64_t y = 0; y < rows.rows(); ++y)
            if (const RowPart& part = rows.at(y, z); part.any())
                fillRow(geometry.offset(part.first, y, z), part.count());
    });
}

}  // namespace

CoarseExtinction::CoarseExtinction(const Volume& volume)
    : m_size(volume.geometry().size), m_unit(volume.geometry().unit()) {
    if (const auto* bytes = std::get_if<VoxelArray<std::uint8_t>>(&volume.voxels())) {
        m_bytes = *bytes;
        for (std::size_t byte = 0; byte < m_levelOfByte.size(); ++byte)
            m_levelOfByte[byte] = levelOf(static_cast<std::uint8_t>(byte), perWhiteOf(volume));
    } else {
        m_levels.resize(static_cast<std::size_t>(volume.geometry().voxelCount()));
        for (std::size_t level = 0; level < m_levelOfByte.size(); ++level)
            m_levelOfByte[level] = static_cast<std::uint8_t>(level);
    }
    setCut(volume, RowMarks(m_size, true));
}

void CoarseExtinction::setCut(const Volume& volume, const RowMarks& masked) {
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            if constexpr (std::is_same_v<Voxel, std::uint8_t>)
                m_mask = volume.dataMask();
            else
                fillLevels(voxels, volume, masked, m_levels);
        },
        volume.voxels());
}

void CoarseExtinction::make(std::vector<float>& extinctions, const RowMarks& rows, const OpacityCurve& curve,
                            const LightGrid& grid, const Progress& progress) const {
    ByteOpacities opacities{};
    std::ranges::transform(m_levelOfByte, opacities.begin(),
                           [&](std::uint8_t level) { return levelOpacity(curve, level); });
    const std::uint8_t* const bytes = m_levels.empty() ? m_bytes.data() : m_levels.data();
    const std::uint8_t* const mask = m_mask.empty() ? nullptr : m_mask.data();
    const auto add = [&](std::int64_t from, std::size_t count, std::size_t each, float* sums) {
        if (mask != nullptr)
            addRow<true>({bytes + from, mask + from}, count, each, opacities, sums);
        else
            addRow<false>({bytes + from, nullptr}, count, each, opacities, sums);
    };
    makeOf(extinctions, rows, grid, add, progress);
}

void CoarseExtinction::make(std::vector<float>& extinctions, const RowMarks& rows, const TwoDimensionalOtf& otf,
                            const GradientLevels& gradients, const LightGrid& grid, const Progress& progress) const {
    if (gradients.bytes.size() != static_cast<std::size_t>(m_size[0] * m_size[1] * m_size[2]) ||
        gradients.largest != otf.largestGradient)
        throw std::invalid_argument("CoarseExtinction: the gradients are of another grid or scale");
    // One opacity for each gradient byte and each byte of a voxel; the voxel's byte is fastest.
    constexpr std::size_t levels = 256;
    std::vector<float> opacities(levels * levels);
    parallelFor(std::size_t{0}, levels, [&](std::size_t gradient) {
        const double magnitude = gradients.largest * static_cast<double>(gradient) / 255.0;
        for (std::size_t byte = 0; byte < levels; ++byte) {
            const std::uint8_t level = m_levelOfByte[byte];
            if (level == 0) continue;
            opacities[gradient * levels + byte] =
                static_cast<float>(opacityAt(otf, static_cast<double>(level - 1) / levelsAbove, magnitude));
        }
    });
    const std::uint8_t* const bytes = m_levels.empty() ? m_bytes.data() : m_levels.data();
    const std::uint8_t* const mask = m_mask.empty() ? nullptr : m_mask.data();
    const auto add = [&](std::int64_t from, std::size_t count, std::size_t each, float* sums) {
        for (std::size_t x = 0; x < count; ++x) {
            const auto at = static_cast<std::size_t>(from) + x;
            if (mask != nullptr && mask[at] == 0) continue;
            sums[x / each] += opacities[std::size_t{gradients.bytes[at]} * levels + bytes[at]];
        }
    };
    makeOf(extinctions, rows, grid, add, progress);
}

template <typename AddRow>
void CoarseExtinction::makeOf(std::vector<float>& extinctions, const RowMarks& rows, const LightGrid& grid,
                              const AddRow& addRow, const Progress& progress) const {
    const ExtinctionTable table(m_unit);
    const auto perPlace = 1.0f / static_cast<float>(grid.voxels[0] * grid.voxels[1] * grid.voxels[2]);
    parallelFor(0, grid.size[2], [&](int z) {
        if (progress.cancelled()) return;
        for (int y = 0; y < grid.size[1]; ++y) {
            const std::int64_t firstY = y * std::int64_t{grid.voxels[1]}, firstZ = z * std::int64_t{grid.voxels[2]};
            const std::int64_t lastY = std::min<std::int64_t>(m_size[1], firstY + grid.voxels[1]),
                               lastZ = std::min<std::int64_t>(m_size[2], firstZ + grid.voxels[2]);
            const RowPart part = rows.partWithin({firstY, lastY}, {firstZ, lastZ});
            if (!part.any()) continue;
            const std::int64_t firstX = part.first / grid.voxels[0], lastX = (part.last - 1) / grid.voxels[0] + 1;
            const std::int64_t first = firstX * grid.voxels[0],
                               count = std::min(lastX * grid.voxels[0], m_size[0]) - first;
            const auto columns = static_cast<std::size_t>(lastX - firstX);
            float* row =
                extinctions.data() + (std::int64_t{z} * grid.size[1] + std::int64_t{y}) * grid.size[0] + firstX;
            std::fill_n(row, columns, 0.0f);
            for (std::int64_t k = firstZ; k < lastZ; ++k)
                for (std::int64_t j = firstY; j < lastY; ++j) {
                    addRow(first + m_size[0] * (j + m_size[1] * k), static_cast<std::size_t>(count),
                           static_cast<std::size_t>(grid.voxels[0]), row);
                }
            for (std::size_t x = 0; x < columns; ++x) row[x] = table.at(std::min(row[x] * perPlace, 1.0f));
        }
    });
}

}  // namespace echolucent::light
