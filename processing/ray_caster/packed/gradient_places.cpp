#include "processing/ray_caster/packed/gradient_places.h"

#include <algorithm>
#include <cmath>

#include "processing/ray_caster/packed/transfer_table.h"

namespace echolucent::ray_casting {

namespace {

/// Rounding of spacings may leave a whole reach by this many voxels. A gradient then strays by as little.
constexpr double wholeWithin = 1e-6;
/// A longer reach leaves hardly a voxel of a volume, and this one keeps positions within 32 bits.
constexpr double longestReach = 64.0;

/// Gradients at the voxels of a brick, in quanta: one more voxel on each axis than the brick has cubes.
struct Lattice {
    static constexpr int edge = BrickGrid::edge + 1;
    static constexpr int rowLength = 16;  // for vectors of any length
    std::array<std::array<float, rowLength>, 3> rows[edge][edge];
};

/// The longest component of all gradients.
float longestOf(const Lattice& lattice) {
    float longest = 0.0f;
    for (const auto& slice : lattice.rows)
        for (const auto& row : slice)
            for (const auto& component : row)
                for (const float value : component) longest = std::max(longest, std::abs(value));
    return longest;
}

constexpr float mostQuanta = 127.0f;

/// Divides gradients by a brick's scale. One that is still longer than bytes hold keeps its direction.
void shorten(std::array<std::array<float, Lattice::rowLength>, 3>& row, float perScale) {
    for (std::size_t x = 0; x < Lattice::edge; ++x) {
        const float longest = std::max({std::abs(row[0][x]), std::abs(row[1][x]), std::abs(row[2][x])}) * perScale;
        const float factor = longest > mostQuanta ? perScale * (mostQuanta / longest) : perScale;
        for (auto& component : row) component[x] *= factor;
    }
}

/// The smallest scale with which a brick's gradients fit into bytes, in GradientPlaces::scaleOne; the largest if none.
/// Up to scaleOne it is a power of two, so that whole quanta stay whole.
int scaleOf(float longest) {
    constexpr int one = GradientPlaces::scaleOne, most = 255;
    if (longest > mostQuanta)
        return static_cast<int>(std::min(std::ceil(longest / mostQuanta * one), static_cast<float>(most)));
    int scale = one;
    while (scale > 1 && longest * 2.0f * one <= mostQuanta * static_cast<float>(scale)) scale /= 2;
    return scale;
}

template <typename Voxel>
class Filling {
public:
    Filling(std::shared_ptr<const PackedVoxels<Voxel>> voxels, const VolumeGeometry& geometry, const BrickGrid& grid,
            const std::array<int, 3>& reach, const std::array<float, 3>& quantaPerValue)
        : m_voxels(std::move(voxels)),
          m_size(geometry.size),
          m_grid(grid),
          m_reach(reach),
          m_quantaPerValue(quantaPerValue) {}

    void operator()(std::size_t brick, std::uint8_t* places) const {
        const auto index = static_cast<std::int64_t>(brick);
        const std::array<std::int64_t, 3> first{
            index % m_grid.size[0] * BrickGrid::edge - cubeShift,
            index / m_grid.size[0] % m_grid.size[1] * BrickGrid::edge - cubeShift,
            index / (m_grid.size[0] * m_grid.size[1]) * BrickGrid::edge - cubeShift};
        Lattice lattice;
        for (int z = 0; z < Lattice::edge; ++z)
            for (int y = 0; y < Lattice::edge; ++y) fillRow(first, y, z, lattice.rows[z][y]);
        const int scale = scaleOf(longestOf(lattice));
        const float perScale = static_cast<float>(GradientPlaces::scaleOne) / static_cast<float>(scale);
        for (auto& slice : lattice.rows)
            for (auto& row : slice) shorten(row, perScale);
        for (int z = 0; z < GradientPlaces::slices; ++z)
            for (int y = 0; y < GradientPlaces::rows; ++y)
                for (int x = 0; x < GradientPlaces::columns; ++x) {
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        for (int row = 0; row < 2; ++row)
                            *places++ = byteOf(lattice.rows[z][y + row][axis][static_cast<std::size_t>(x)]);
                    *places++ = static_cast<std::uint8_t>(scale);
                    *places++ = static_cast<std::uint8_t>(scale);
                }
    }

private:
    /// Not a number becomes some gradient.
    static std::uint8_t byteOf(float quanta) {
        const float within = std::min(127.0f, std::max(-127.0f, quanta));
        return static_cast<std::uint8_t>(static_cast<int>(within + (GradientPlaces::zero + 0.5f)));
    }
    /// Voxels beyond the grid are the outermost ones.
    [[nodiscard]] std::int64_t within(std::int64_t voxel, std::size_t axis) const {
        return std::clamp<std::int64_t>(voxel, 0, m_size[axis] - 1);
    }
    [[nodiscard]] const Voxel* rowOf(std::int64_t y, std::int64_t z) const {
        return m_voxels->cubes() + ((within(z, 2) + cubeShift) * m_voxels->sliceStride() +
                                    (within(y, 1) + cubeShift) * m_voxels->rowStride() + cubeShift) *
                                       voxelsPerCube;
    }
    void fillRow(const std::array<std::int64_t, 3>& first, int row, int slice,
                 std::array<std::array<float, Lattice::rowLength>, 3>& out) const {
        const std::int64_t y = first[1] + row, z = first[2] + slice;
        const auto difference = [&](std::size_t axis, const Voxel* before, const Voxel* after, std::int64_t shift) {
            const float factor = m_quantaPerValue[axis];
            for (int x = 0; x < Lattice::edge; ++x) {
                const float low = static_cast<float>(before[within(first[0] + x - shift, 0) * voxelsPerCube]);
                const float high = static_cast<float>(after[within(first[0] + x + shift, 0) * voxelsPerCube]);
                // Gradients of voxels of any magnitude stay finite in the sums of their squares.
                out[axis][static_cast<std::size_t>(x)] = std::clamp((high - low) * factor, -1e9f, 1e9f);
            }
        };
        for (auto& component : out) component.fill(0.0f);  // beyond the lattice too
        difference(0, rowOf(y, z), rowOf(y, z), m_reach[0]);
        difference(1, rowOf(y - m_reach[1], z), rowOf(y + m_reach[1], z), 0);
        difference(2, rowOf(y, z - m_reach[2]), rowOf(y, z + m_reach[2]), 0);
    }

    std::shared_ptr<const PackedVoxels<Voxel>> m_voxels;
    std::array<std::int64_t, 3> m_size;
    BrickGrid m_grid;
    std::array<int, 3> m_reach;
    std::array<float, 3> m_quantaPerValue;
};

}  // namespace

std::optional<GradientRule> GradientRule::of(const std::array<double, 3>& reach, double gradientFloor) {
    if (!(gradientFloor >= GradientPlaces::leastFloor) || gradientFloor > 1.0) return std::nullopt;
    GradientRule rule{{}, gradientFloor};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double whole = std::round(reach[axis]);
        if (whole < 1.0 || whole > longestReach || std::abs(reach[axis] - whole) > wholeWithin) return std::nullopt;
        rule.reach[axis] = static_cast<int>(whole);
    }
    return rule;
}

std::size_t GradientPlaces::mostBytes(std::size_t packed) {
    constexpr std::size_t usual = std::size_t{512} << 20;
    return std::max(usual, 2 * packed);
}

template <typename Voxel>
GradientPlaces::GradientPlaces(const std::shared_ptr<const PackedVoxels<Voxel>>& voxels, const VolumeGeometry& geometry,
                               float toTable, const GradientRule& rule)
    : m_rule(rule),
      m_grid(geometry),
      m_quantum(static_cast<float>(rule.gradientFloor * floorsPerQuantum)),
      m_bricks(static_cast<std::size_t>(m_grid.count()) + 1) {
    std::array<float, 3> quantaPerValue{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int reach = rule.reach[axis];
        const std::int64_t size = geometry.size[axis];
        m_firstCube[axis] = reach + cubeShift;
        m_lastCube[axis] = static_cast<std::int32_t>(std::max<std::int64_t>(size - reach, 0));
        const double units = 2.0 * reach * geometry.spacing[static_cast<int>(axis)] / geometry.unit();
        quantaPerValue[axis] = static_cast<float>(static_cast<double>(toTable) / TransferTable::intervals / units /
                                                  (rule.gradientFloor * floorsPerQuantum));
    }
    m_fill = Filling<Voxel>(voxels, geometry, m_grid, rule.reach, quantaPerValue);
}

GradientPlaces::~GradientPlaces() {
    for (const auto& brick : m_bricks) delete[] brick.load(std::memory_order_relaxed);
}

const std::uint8_t* GradientPlaces::make(std::size_t index) const {
    auto places = std::make_unique<std::uint8_t[]>(bytesPerBrick);
    if (index + 1 < m_bricks.size()) m_fill(index, places.get());
    // If another thread was sooner, its brick counts. Both hold the same.
    const std::uint8_t* made = nullptr;
    if (!m_bricks[index].compare_exchange_strong(made, places.get(), std::memory_order_acq_rel)) return made;
    m_made.fetch_add(1, std::memory_order_relaxed);
    return places.release();
}

template GradientPlaces::GradientPlaces(const std::shared_ptr<const PackedVoxels<std::uint8_t>>&, const VolumeGeometry&,
                                        float, const GradientRule&);
template GradientPlaces::GradientPlaces(const std::shared_ptr<const PackedVoxels<std::uint16_t>>&,
                                        const VolumeGeometry&, float, const GradientRule&);
template GradientPlaces::GradientPlaces(const std::shared_ptr<const PackedVoxels<float>>&, const VolumeGeometry&, float,
                                        const GradientRule&);

}  // namespace echolucent::ray_casting
