#include "processing/speckle_reduction/faded_rim.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>

#include "processing/parallel.h"
#include "processing/volume/filled_layers.h"
#include "processing/volume/grid_rows.h"

namespace echolucent {

namespace {

constexpr std::int64_t rowsOfRim = 64;  ///< rows that one thread takes at a time

/// The voxels that the mask marks as data, or those that it does not.
BitGrid markedAs(const Volume& volume, bool data) {
    const VolumeGeometry& geometry = volume.geometry();
    BitGrid marked(geometry.size);
    forEachRow(geometry.size, rowsOfRim, [&](std::int64_t y, std::int64_t z) {
        const std::uint8_t* mask = volume.dataMaskOrNull() + geometry.offset(0, y, z);
        std::uint64_t* row = marked.row(y, z);
        for (std::int64_t first = 0; first < geometry.size[0]; first += 64) {
            const std::int64_t count = std::min<std::int64_t>(64, geometry.size[0] - first);
            std::uint64_t bits = 0;
            for (std::int64_t i = 0; i < count; ++i) bits |= std::uint64_t{mask[first + i] != 0 ? 1U : 0U} << i;
            row[first / 64] = data ? bits : ~bits & (~std::uint64_t{0} >> (64 - count));
        }
    });
    return marked;
}

/// What is in `among` but not in `members`.
BitGrid butNot(const BitGrid& among, const BitGrid& members) {
    BitGrid rest = among;
    forEachRow(rest.size(), rowsOfRim, [&](std::int64_t y, std::int64_t z) {
        for (std::int64_t word = 0; word < rest.words(); ++word) rest.row(y, z)[word] &= ~members.row(y, z)[word];
    });
    return rest;
}

template <typename Visit>
void forEachMember(const BitGrid& members, const VolumeGeometry& geometry, const Visit& visit) {
    forEachRow(geometry.size, rowsOfRim, [&](std::int64_t y, std::int64_t z) {
        const std::uint64_t* row = members.row(y, z);
        for (std::int64_t word = 0; word < members.words(); ++word)
            for (std::uint64_t bits = row[word]; bits != 0; bits &= bits - 1)
                visit(static_cast<std::size_t>(geometry.offset(word * 64 + std::countr_zero(bits), y, z)));
    });
}

/// The mean intensity of some voxels; 0 if there are none.
double meanOf(const BitGrid& members, const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    const auto slices = static_cast<std::size_t>(geometry.size[2]);
    std::vector<double> sums(slices, 0.0);  // by slice, so that any number of threads gives the same
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        double& sum = sums[static_cast<std::size_t>(z)];
        for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
            const std::uint64_t* row = members.row(y, z);
            for (std::int64_t word = 0; word < members.words(); ++word)
                for (std::uint64_t bits = row[word]; bits != 0; bits &= bits - 1)
                    sum += volume.normalisedIntensity(geometry.offset(word * 64 + std::countr_zero(bits), y, z));
        }
    });
    const auto count = static_cast<double>(members.count());
    return count > 0.0 ? std::accumulate(sums.begin(), sums.end(), 0.0) / count : 0.0;
}

}  // namespace

FadedRim::FadedRim(const Volume& volume) : m_mask(volume.dataMask()), m_inner(volume.geometry().size) {
    if (volume.dataMaskOrNull() == nullptr) return;
    constexpr std::size_t apart = 2;
    constexpr double plateau = 0.9;
    const BitGrid data = markedAs(volume, true), none = markedAs(volume, false);
    BitGrid reached = none.eroded().dilated() & none;
    std::vector<BitGrid> layers;
    std::vector<double> means;
    std::size_t fading = 0;
    for (;; ++fading) {
        if (fading > static_cast<std::size_t>(mostLayers)) return;
        while (layers.size() < fading + apart + 1) {
            const BitGrid wider = reached.dilated();
            layers.push_back(butNot(wider, reached) & data);
            means.push_back(meanOf(layers.back(), volume));
            reached = wider;
        }
        if (means[fading] >= plateau * means[fading + apart]) break;
    }
    layers.resize(fading, BitGrid({0, 0, 0}));
    // Grow back from what the rim leaves: what is not reached is too thin.
    m_inner = data;
    for (const BitGrid& layer : layers) m_inner = butNot(m_inner, layer);
    BitGrid grown = m_inner;
    for (std::size_t i = layers.size(); i-- > 0;) {
        layers[i] = layers[i] & grown.dilated();
        grown = grown | layers[i];
    }
    m_inner = butNot(data, grown) | m_inner;
    m_layers = std::move(layers);
}

Volume FadedRim::without(const Volume& volume) const {
    if (m_layers.empty()) return volume;
    std::vector<std::uint8_t> mask = m_mask.toVector();
    for (const BitGrid& layer : m_layers)
        forEachMember(layer, volume.geometry(), [&](std::size_t at) { mask[at] = 0; });
    return volume.withDataMask(std::move(mask));
}

Volume FadedRim::filled(const Volume& quiet) const {
    if (m_layers.empty()) return quiet;
    const VolumeGeometry& geometry = quiet.geometry();
    Voxels voxels = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& held) -> Voxels {
            std::vector<Voxel> values = held.toVector();
            BitGrid known = m_inner;
            for (std::size_t i = m_layers.size(); i-- > 0;) {
                const bool inner = 2 * (i + 1) > m_layers.size() + 1;
                fillLayers<Voxel>(
                    geometry, values, known, 1,
                    [&](std::int64_t offset) {
                        if (!inner) return;
                        const std::int64_t row = offset / geometry.size[0], y = row % geometry.size[1];
                        const filled_layers::NineRows<Voxel> around(geometry, {held.data(), held.size()}, m_layers[i],
                                                                    y, row / geometry.size[1]);
                        const Voxel own = around.meanAround(offset % geometry.size[0]);
                        Voxel& value = values[static_cast<std::size_t>(offset)];
                        value =
                            static_cast<Voxel>(std::min(static_cast<double>(value), 2.0 * static_cast<double>(own)));
                    },
                    &m_layers[i]);
            }
            return VoxelArray<Voxel>(std::move(values));
        },
        quiet.voxels());
    return Volume(geometry, std::move(voxels), quiet.whiteLevel())
        .withValueScale(quiet.valueScale())
        .withDataMask(m_mask);
}

}  // namespace echolucent
