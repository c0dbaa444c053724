#include "processing/tube_core/slabs/tube_slab_means.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "processing/tube_core/slabs/tube_slabs.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/tube_core/slabs/tube_slab_means.cpp"
#include <hwy/foreach_target.h>

#include "processing/tube_core/slabs/tube_slab_means-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::tube_slabs::HWY_NAMESPACE {

// Highway's dispatch tables need plain functions.
void sumBytes(const Piece<std::uint8_t>& piece, const SlabPattern& pattern, const PieceRoute& route,
              PieceMoments& moments) {
    sumPieceBy(piece, pattern, route, moments);
}
void sumWords(const Piece<std::uint16_t>& piece, const SlabPattern& pattern, const PieceRoute& route,
              PieceMoments& moments) {
    sumPieceBy(piece, pattern, route, moments);
}
void sumFloating(const Piece<float>& piece, const SlabPattern& pattern, const PieceRoute& route,
                 PieceMoments& moments) {
    sumPieceBy(piece, pattern, route, moments);
}

}  // namespace echolucent::tube_slabs::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent {

namespace tube_slabs {

HWY_EXPORT(sumBytes);
HWY_EXPORT(sumWords);
HWY_EXPORT(sumFloating);

template <>
void momentsOf(const Piece<std::uint8_t>& piece, const SlabPattern& pattern, const PieceRoute& route,
               PieceMoments& moments) {
    HWY_DYNAMIC_DISPATCH(sumBytes)(piece, pattern, route, moments);
}
template <>
void momentsOf(const Piece<std::uint16_t>& piece, const SlabPattern& pattern, const PieceRoute& route,
               PieceMoments& moments) {
    HWY_DYNAMIC_DISPATCH(sumWords)(piece, pattern, route, moments);
}
template <>
void momentsOf(const Piece<float>& piece, const SlabPattern& pattern, const PieceRoute& route, PieceMoments& moments) {
    HWY_DYNAMIC_DISPATCH(sumFloating)(piece, pattern, route, moments);
}

}  // namespace tube_slabs

namespace {

using namespace tube_slabs;

/// The step from slab to slab has this many binary places, so that the positions of slabs do not drift.
constexpr int stepBits = 32;

std::int64_t fixedPoint(double value, int bits) { return std::llround(std::ldexp(value, bits)); }

SlabPattern patternOf(const TubeSamples& tube) {
    SlabPattern pattern;
    const double half = (tube.cellSize - 1) / 2.0;
    for (int b = 0; b < tube.cellSize; ++b)
        for (int a = 0; a < tube.cellSize; ++a) {
            const Vec3 beside = tube.down * (b - half) + tube.right * (a - half);
            pattern.x.push_back(static_cast<std::int32_t>(fixedPoint(beside[0], positionBits)));
            pattern.y.push_back(static_cast<std::int32_t>(fixedPoint(beside[1], positionBits)));
            pattern.z.push_back(static_cast<std::int32_t>(fixedPoint(beside[2], positionBits)));
        }
    return pattern;
}

/// A range of slabs, the end not included.
struct SlabRange {
    int begin = 0, end = 0;
    [[nodiscard]] bool empty() const { return end <= begin; }
};

/// Reads pieces of the tubes of one view in one volume.
template <typename Voxel>
class PieceReader {
public:
    PieceReader(const Volume& volume, const Voxel* voxels, const TubeSamples& any, PieceRoute route)
        : m_voxels(voxels),
          m_mask(volume.dataMaskOrNull()),
          m_size(volume.geometry().size),
          m_strides{1, m_size[0], m_size[0] * m_size[1]},
          m_count(volume.geometry().voxelCount()),
          m_scale(static_cast<float>(slabScale(volume))),
          m_white(static_cast<float>(volume.whiteLevel() * slabScale(volume))),
          m_pattern(patternOf(any)),
          m_route(route) {
        const double half = (any.cellSize - 1) / 2.0;
        for (int axis = 0; axis < 3; ++axis) {
            m_reach[axis] = (std::abs(any.right[axis]) + std::abs(any.down[axis])) * half + slack;
            m_step[static_cast<std::size_t>(axis)] = fixedPoint(any.along[axis], stepBits);
        }
    }

    /// The slabs whose samples all have eight voxels around them and three more behind in memory.
    [[nodiscard]] SlabRange insideOf(const TubeSamples& tube) const {
        double begin = 0.0, end = tube.slabs - 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = m_reach[axis];
            // Along z the last cell is left out, so that the four bytes read for any sample end before the array does.
            const double high = static_cast<double>(size(axis) - (axis == 2 ? 2 : 1)) - m_reach[axis];
            const double at = tube.first[axis], step = tube.along[axis];
            if (step == 0.0) {
                if (at < low || at > high) return {};
                continue;
            }
            begin = std::max(begin, (step > 0 ? low - at : high - at) / step);
            end = std::min(end, (step > 0 ? high - at : low - at) / step);
        }
        if (!(end >= begin)) return {};
        return {static_cast<int>(std::ceil(begin)), static_cast<int>(std::floor(end)) + 1};
    }

    /// Reads up to pieceLength slabs of the range into the tube's arrays.
    void read(const TubeSamples& tube, SlabRange range, bool inside, SlabMeans& slabs) const {
        Piece<Voxel> piece;
        place(tube, range, piece);
        PieceRoute route = m_route;
        if (inside && (m_mask == nullptr || allData(tube, range))) route.surroundings = Surroundings::complete;
        PieceMoments moments;
        momentsOf(piece, m_pattern, route, moments);
        std::copy_n(moments.counts.begin(), piece.slabs, slabs.counts.begin() + range.begin);
        std::copy_n(moments.means.begin(), piece.slabs, slabs.means.begin() + range.begin);
        std::copy_n(moments.squaredDeviations.begin(), piece.slabs, slabs.squaredDeviations.begin() + range.begin);
    }

private:
    /// Positions are rounded, so a position this near to the border counts as on it.
    static constexpr double slack = 4.0 / oneVoxel;

    [[nodiscard]] std::int64_t size(int axis) const { return m_size[static_cast<std::size_t>(axis)]; }

    void place(const TubeSamples& tube, SlabRange range, Piece<Voxel>& piece) const {
        std::array<std::int32_t, pieceLength>* const positions[3] = {&piece.x, &piece.y, &piece.z};
        std::int64_t origin = 0;
        piece.slabs = range.end - range.begin;
        const Vec3 start = tube.onAxis(range.begin);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t last = m_size[axis] - 1;
            const double at = start[static_cast<int>(axis)];
            const std::int64_t voxel = std::clamp(static_cast<std::int64_t>(std::floor(at)), std::int64_t{0}, last);
            origin += voxel * m_strides[axis];
            constexpr int spare = stepBits - positionBits;
            const std::int64_t first =
                fixedPoint(at - static_cast<double>(voxel), stepBits) + (std::int64_t{1} << (spare - 1));
            for (int k = 0; k < pieceLength; ++k)
                (*positions[axis])[static_cast<std::size_t>(k)] =
                    static_cast<std::int32_t>((first + std::min(k, piece.slabs - 1) * m_step[axis]) >> spare);
            piece.lowest[axis] = fixedBound(-voxel);
            piece.highest[axis] = fixedBound(last - voxel);
            piece.lastCell[axis] = static_cast<std::int32_t>(std::max<std::int64_t>(last - 1, 0) - voxel);
        }
        piece.first = m_voxels + origin;
        piece.mask = m_mask == nullptr ? nullptr : m_mask + origin;
        piece.rowStride = m_size[1] > 1 ? static_cast<std::int32_t>(m_strides[1]) : 0;
        piece.sliceStride = m_size[2] > 1 ? static_cast<std::int32_t>(m_strides[2]) : 0;
        constexpr std::int64_t far = std::int64_t{1} << 30;
        piece.lastWord = static_cast<std::int32_t>(std::min(m_count - origin - 4, far));
        piece.white = m_white;
        piece.scale = m_scale;
    }

    /// A piece is short and never reaches beyond this distance, so bounds are cut there.
    [[nodiscard]] static std::int32_t fixedBound(std::int64_t voxels) {
        constexpr std::int64_t far = 1 << 13;
        return static_cast<std::int32_t>(std::clamp(voxels, -far, far)) * oneVoxel;
    }

    /// Whether all voxels of the box around the slabs' samples carry data. The box lies in the volume.
    [[nodiscard]] bool allData(const TubeSamples& tube, SlabRange range) const {
        std::array<std::int64_t, 3> low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            const double a = tube.onAxis(range.begin)[axis], b = tube.onAxis(range.end - 1)[axis];
            low[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::min(a, b) - m_reach[axis]);
            high[static_cast<std::size_t>(axis)] =
                std::min(static_cast<std::int64_t>(std::max(a, b) + m_reach[axis]) + 1, size(axis) - 1);
        }
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                if (std::memchr(m_mask + y * m_strides[1] + z * m_strides[2] + low[0], 0,
                                static_cast<std::size_t>(high[0] - low[0] + 1)) != nullptr)
                    return false;
        return true;
    }

    const Voxel* m_voxels;
    const std::uint8_t* m_mask;
    std::array<std::int64_t, 3> m_size, m_strides;
    std::int64_t m_count;
    float m_scale, m_white;
    SlabPattern m_pattern;
    PieceRoute m_route;
    Vec3 m_reach{0, 0, 0};                 ///< how far a slab's samples reach from the axis
    std::array<std::int64_t, 3> m_step{};  ///< from slab to slab, fixed point with stepBits
};

/// A tube's slabs in pieces: border, inside, border. The second value of a piece is true inside.
std::vector<std::pair<SlabRange, bool>> piecesOf(const TubeSamples& tube, SlabRange inside) {
    std::vector<std::pair<SlabRange, bool>> pieces;
    const auto cut = [&](SlabRange range, bool isInside) {
        for (int begin = range.begin; begin < range.end; begin += pieceLength)
            pieces.push_back({{begin, std::min(begin + pieceLength, range.end)}, isInside});
    };
    if (inside.empty()) inside = {tube.slabs, tube.slabs};
    cut({0, inside.begin}, false);
    cut(inside, true);
    cut({inside.end, tube.slabs}, false);
    return pieces;
}

}  // namespace

double slabScale(const Volume& volume) {
    if (!std::holds_alternative<VoxelArray<float>>(volume.voxels())) return 1.0;
    // 2^127 is the largest power of two in single precision, and its inverse is not 0.
    constexpr int largest = std::numeric_limits<float>::max_exponent - 1;
    return std::ldexp(1.0, std::clamp(-std::ilogb(volume.whiteLevel()), -largest, largest));
}

bool canMeanSlabs(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    constexpr std::int64_t longestAxis = 16384, largestSlice = std::int64_t{8} << 20;
    if (geometry.size[0] < 2 || geometry.size[0] * geometry.size[1] < 4) return false;
    if (*std::max_element(geometry.size.begin(), geometry.size.end()) > longestAxis) return false;
    if (geometry.size[0] * geometry.size[1] > largestSlice) return false;
    return !std::holds_alternative<VoxelArray<std::uint8_t>>(volume.voxels()) || volume.whiteLevel() >= 255.0;
}

void meanSlabs(const Volume& volume, Interpolation sampling, std::span<const TubeSamples> tubes,
               std::span<SlabMeans> slabs) {
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        const auto count = static_cast<std::size_t>(tubes[t].slabs);
        slabs[t].counts.resize(count);
        slabs[t].means.resize(count);
        slabs[t].squaredDeviations.resize(count);
    }
    if (tubes.empty()) return;
    const PieceRoute route{sampling == Interpolation::nearest, Surroundings::any};
    std::visit(
        [&](const auto& voxels) {
            const PieceReader reader(volume, voxels.data(), tubes[0], route);
            std::vector<std::vector<std::pair<SlabRange, bool>>> pieces;
            std::size_t most = 0;
            for (const TubeSamples& tube : tubes) {
                pieces.push_back(piecesOf(tube, reader.insideOf(tube)));
                most = std::max(most, pieces.back().size());
            }
            // Takes one depth of all tubes before the next depth: neighbours in the grid share cache lines.
            for (std::size_t piece = 0; piece < most; ++piece)
                for (std::size_t t = 0; t < tubes.size(); ++t)
                    if (piece < pieces[t].size())
                        reader.read(tubes[t], pieces[t][piece].first, pieces[t][piece].second, slabs[t]);
        },
        volume.voxels());
}

}  // namespace echolucent
#endif
