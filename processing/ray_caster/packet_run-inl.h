// The places of a packet's samples: runs of samples from one corner of the volume, and regions to jump over.
#include <array>
#include <cmath>

#include "processing/ray_caster/packed/brick_grid.h"
#include "processing/ray_caster/packet_sampling-inl.h"

#if defined(ECHOLUCENT_PACKET_RUN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_RUN_INL
#undef ECHOLUCENT_PACKET_RUN_INL
#else
#define ECHOLUCENT_PACKET_RUN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// Rays end and jump at multiples of this many samples. So a ray's result does not depend on the rays beside it.
constexpr std::int64_t blockSize = 8;
/// The most samples in a run from one corner.
constexpr std::int64_t longestRun = 64;

/// Consecutive samples of all rays of a packet, or of one of them, in floats from a corner near them. Sample i of a run
/// is number first + i.
template <typename Voxel>
struct Run {
    // A defaulted constructor would belong to no instruction set, but its calls do.
    HWY_INLINE Run() {}
    std::int64_t first, count;
    Cubes<Voxel> volume;
    std::array<std::int64_t, 3> corner;                       ///< cube
    FloatVector startX, startY, startZ, stepX, stepY, stepZ;  ///< 1/65536 cubes
    FloatVector begin, end;                                   ///< the samples of each ray: begin <= i < end
    bool near = true;  ///< whether all cut steps lie near enough to the corner to count from it

    HWY_INLINE Position at(FloatVector i) const {
        return {truncated(hn::MulAdd(i, stepX, startX)), truncated(hn::MulAdd(i, stepY, startY)),
                truncated(hn::MulAdd(i, stepZ, startZ))};
    }
    /// The way from one sample to the next.
    HWY_INLINE Position way() const { return {rounded(stepX), rounded(stepY), rounded(stepZ)}; }
    HWY_INLINE LaneMask inRange(FloatVector i) const { return hn::And(hn::Ge(i, begin), hn::Lt(i, end)); }
};

#if HWY_TARGET == HWY_SCALAR
using Doubles = hn::CappedTag<double, 1>;
#else
using Doubles = hn::Repartition<double, Floats>;
#endif
using DoubleVector = hn::Vec<Doubles>;
HWY_INLINE DoubleVector setDouble(double value) { return hn::Set(Doubles(), value); }
HWY_INLINE double leastOf(DoubleVector values) { return hn::GetLane(hn::MinOfLanes(Doubles(), values)); }
HWY_INLINE double mostOf(DoubleVector values) { return hn::GetLane(hn::MaxOfLanes(Doubles(), values)); }

/// Least and most of value(first lane of a vector) over the lanes in chosen(first lane). 1e300 and -1e300 if no lane is
/// chosen.
template <typename Chosen, typename Value>
HWY_INLINE void findRange(const Chosen& chosen, const Value& value, double& least, double& most) {
    constexpr double beyond = 1e300;
    const auto none = setDouble(beyond);
    auto low = none, high = hn::Neg(none);
    for (int i = 0; i < lanes; i += static_cast<int>(hn::Lanes(Doubles()))) {
        const auto mask = chosen(i);
        const auto here = value(i);
        low = hn::Min(low, hn::IfThenElse(mask, here, none));
        high = hn::Max(high, hn::IfThenElse(mask, here, hn::Neg(none)));
    }
    least = leastOf(low);
    most = mostOf(high);
}
HWY_INLINE DoubleVector load(const double* values) { return hn::Load(Doubles(), values); }

/// Computes lanes in double by from(tag, first lane), and returns them as floats.
template <typename From>
HWY_INLINE FloatVector inFloats(const From& from) {
    const Doubles doubles;
#if HWY_TARGET == HWY_SCALAR
    return set(static_cast<float>(hn::GetLane(from(doubles, 0))));
#else
    const hn::Half<Floats> half;
    return hn::Combine(Floats(), hn::DemoteTo(half, from(doubles, lanes / 2)), hn::DemoteTo(half, from(doubles, 0)));
#endif
}

/// The range of positions and steps, in cubes, of the rays of neighbouring pixels.
struct Extent {
    double lowOrigin[3], highOrigin[3], lowStep[3], highStep[3];  ///< origins: at sample -0.5

    Extent() {
        for (int axis = 0; axis < 3; ++axis) {
            lowOrigin[axis] = lowStep[axis] = 1e300;
            highOrigin[axis] = highStep[axis] = -1e300;
        }
    }
    /// A box around all samples from `first` to before `last`.
    void findBox(double first, double last, double (&low)[3], double (&high)[3]) const {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = lowOrigin[axis] + std::min(lowStep[axis] * first, lowStep[axis] * last);
            high[axis] = highOrigin[axis] + std::max(highStep[axis] * first, highStep[axis] * last);
        }
    }
};

/// The pixels of a packet of rays.
struct PacketPixels {
    alignas(64) int column[lanes], row[lanes];
    int count = 0;  ///< lanes from this one on have no pixel; they repeat the first one

    /// The pixels of a block of packetColumns x packetRows, `apart` pixels from each other.
    static HWY_INLINE PacketPixels block(int column, int row, int apart) {
        PacketPixels pixels;
        for (int i = 0; i < lanes; ++i) {
            pixels.column[i] = column + i % packetColumns * apart;
            pixels.row[i] = row + i / packetColumns * apart;
        }
        pixels.count = lanes;
        return pixels;
    }
    [[nodiscard]] HWY_INLINE bool isIn(const Picture& picture, int lane) const {
        return column[lane] < picture.width && row[lane] < picture.height;
    }
    /// Calls visit(lane, offset of the pixel in a picture) for each pixel within it.
    template <typename Visit>
    void forEachIn(const Picture& picture, const Visit& visit) const {
        for (int i = 0; i < count; ++i)
            if (isIn(picture, i))
                visit(i, static_cast<std::size_t>(row[i]) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(column[i]));
    }
};

/// The rays of neighbouring pixels on their way through the volume.
template <typename Voxel>
class Packet {
public:
    Packet(const KernelJob<Voxel>& job, const PacketPixels& pixels) : m_job(job) {
        job.rays->fill(m_rays, pixels.column, pixels.row);
        // Pixels beyond the picture's edge cast nothing. No pixel of a block lies farther right or down than its last.
        if (pixels.count < lanes || !pixels.isIn(*job.picture, lanes - 1))
            for (int i = 0; i < lanes; ++i)
                if (i >= pixels.count || !pixels.isIn(*job.picture, i)) m_rays.remove(i);
        findExtent();
    }

    [[nodiscard]] bool empty() const { return !m_any; }
    [[nodiscard]] std::int64_t first() const { return m_first; }
    [[nodiscard]] std::int64_t last() const { return m_last; }
    [[nodiscard]] const RayBundle<lanes>& rays() const { return m_rays; }

    /// How many samples from `sample` on show nothing on any ray. `sample` and the result are multiples of blockSize.
    [[nodiscard]] std::int64_t emptyFrom(std::int64_t sample) const {
        const double number = static_cast<double>(sample);
        double low[3], high[3];
        std::int64_t brick[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = m_extent.lowOrigin[axis] +
                        m_extent.lowStep[axis] * (number + (m_extent.lowStep[axis] < 0.0 ? 1.0 : 0.0));
            high[axis] = m_extent.highOrigin[axis] +
                         m_extent.highStep[axis] * (number + (m_extent.highStep[axis] < 0.0 ? 0.0 : 1.0));
            const auto cube = static_cast<std::int64_t>(0.5 * (low[axis] + high[axis]));
            brick[axis] =
                std::clamp<std::int64_t>(cube >> BrickGrid::shift, 0, m_job.bricks[static_cast<std::size_t>(axis)] - 1);
        }
        const std::int64_t distance =
            m_job.distances[brick[0] + m_job.bricks[0] * (brick[1] + m_job.bricks[1] * brick[2])];
        if (distance == 0) return 0;
        double steps = static_cast<double>(m_last - sample) + blockSize;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t before = brick[axis] - distance + 1, behind = brick[axis] + distance;
            constexpr double margin = 0.01;  // for the kernel's rounding
            const bool endsBefore = before > 0, endsBehind = behind < m_job.bricks[static_cast<std::size_t>(axis)];
            const double lowest = static_cast<double>(before * BrickGrid::edge) + margin;
            const double highest = static_cast<double>(behind * BrickGrid::edge) - margin;
            if ((endsBefore && low[axis] < lowest) || (endsBehind && high[axis] >= highest)) return 0;
            if (endsBehind && m_extent.highStep[axis] > 0.0)
                steps = std::min(steps, (highest - high[axis]) / m_extent.highStep[axis]);
            if (endsBefore && m_extent.lowStep[axis] < 0.0)
                steps = std::min(steps, (lowest - low[axis]) / m_extent.lowStep[axis]);
        }
        return static_cast<std::int64_t>(steps) / blockSize * blockSize;
    }

    /// Whether data may end on the rays in `count` samples from `first` on.
    [[nodiscard]] bool bordersOn(std::int64_t first, std::int64_t count) const {
        if (farFromBorder(first, count)) return false;
        double low[3], high[3];
        findBox(first, -1, count, low, high);
        return touchesBorder(low, high);
    }

    /// The run from `first`, of at most `count` samples. It takes the ray of `lane` alone, or all rays if lane is -1.
    [[nodiscard]] Run<Voxel> run(std::int64_t first, std::int64_t count, int lane) const {
        Run<Voxel> run;
        run.first = first;
        run.count = std::min(count, m_last - first);
        double low[3], high[3];
        findBox(first, lane, run.count, low, high);
        locate(run, low, high);
        setLanes(run, lane);
        return run;
    }

    /// Cut steps as a run of one sample, of the ray of `lane` alone, or of all rays if lane is -1.
    [[nodiscard]] Run<Voxel> run(const CutSteps<lanes>& cut, int lane) const {
        Run<Voxel> run;
        run.first = 0;
        run.count = 1;
        double low[3], high[3];
        const Floats floats;
        for (int axis = 0; axis < 3; ++axis) {
            const auto chosen = [&](int i) {
                const auto length = load(cut.length + i);
                const auto here = hn::Gt(length, setDouble(0.0));
                return lane < 0 ? here : hn::And(here, hn::Eq(hn::Iota(Doubles(), i), setDouble(lane)));
            };
            const auto place = [&](int i) {
                const auto steps = hn::Mul(load(m_rays.step[axis] + i), load(cut.at + i));
                return hn::Add(hn::Add(load(m_rays.origin[axis] + i), steps), setDouble(cubeShift));
            };
            findRange(chosen, place, low[axis], high[axis]);
            // If no ray is cut, nothing is read, but the corner must lie in the volume.
            high[axis] = std::max(high[axis], 0.0);
            low[axis] = std::clamp(low[axis], 0.0, high[axis]);
            run.near = run.near && high[axis] - low[axis] < roomFromCorner();
        }
        locate(run, low, high);
        const auto along = [&](int axis) {
            const double shift = static_cast<double>(cubeShift - run.corner[static_cast<std::size_t>(axis)]);
            return inFloats([&](auto doubles, int i) {
                const auto origin = hn::Load(doubles, m_rays.origin[axis] + i);
                const auto steps = hn::Mul(hn::Load(doubles, m_rays.step[axis] + i), hn::Load(doubles, cut.at + i));
                return hn::Mul(hn::Add(hn::Add(origin, steps), hn::Set(doubles, shift)),
                               hn::Set(doubles, double{oneCube}));
            });
        };
        run.startX = along(0);
        run.startY = along(1);
        run.startZ = along(2);
        run.stepX = run.stepY = run.stepZ = run.begin = set(0.0f);
        const auto length = inFloats([&](auto doubles, int i) { return hn::Load(doubles, cut.length + i); });
        run.end = hn::IfThenElseZero(hn::Gt(length, set(0.0f)), set(1.0f));
        if (lane >= 0)
            run.end = hn::IfThenElseZero(hn::Eq(hn::Iota(floats, 0.0f), set(static_cast<float>(lane))), run.end);
        return run;
    }

    /// The most samples in one run for which positions and offsets from its corner stay within 32 bits. 0 if the rays
    /// are so far apart that each needs its own runs.
    [[nodiscard]] std::int64_t longestCommonRun() const { return m_longestRun; }
    [[nodiscard]] std::int64_t longestSingleRun() const { return std::max<std::int64_t>(runWithin(0.0), 1); }

private:
    void findExtent() {
        const auto isRay = [&](int i) { return hn::Lt(load(m_rays.enter + i), load(m_rays.leave + i)); };
        const auto isWhole = [&](int i) { return hn::Lt(load(m_rays.first + i), load(m_rays.last + i)); };
        double nearest, farthest, first, last, unused;
        findRange(
            isRay, [&](int i) { return load(m_rays.leave + i); }, nearest, farthest);
        m_any = farthest > -1e300;
        if (!m_any) return;
        findRange(
            isWhole, [&](int i) { return load(m_rays.first + i); }, first, unused);
        findRange(
            isWhole, [&](int i) { return load(m_rays.last + i); }, unused, last);
        if (last > 0.0) {
            m_first = static_cast<std::int64_t>(first) / blockSize * blockSize;
            // Whole blocks are fine: each lane has no samples behind its own last one.
            m_last = (static_cast<std::int64_t>(last) + blockSize - 1) / blockSize * blockSize;
        }
        for (int axis = 0; axis < 3; ++axis) {
            // The origin in cubes, at the beginning of step 0.
            findRange(
                isRay, [&](int i) { return hn::Add(load(m_rays.origin[axis] + i), setDouble(cubeShift)); },
                m_extent.lowOrigin[axis], m_extent.highOrigin[axis]);
            m_extent.lowStep[axis] = m_extent.highStep[axis] = m_rays.step[axis][0];
            if (!m_job.rays->parallel())
                findRange(
                    isRay, [&](int i) { return load(m_rays.step[axis] + i); }, m_extent.lowStep[axis],
                    m_extent.highStep[axis]);
        }
        double widest = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            widest = std::max(widest, m_extent.highOrigin[axis] - m_extent.lowOrigin[axis] +
                                          (m_extent.highStep[axis] - m_extent.lowStep[axis]) * farthest);
        m_longestRun = runWithin(widest);
    }

    /// The range for positions and offsets, cubes along each axis.
    [[nodiscard]] double roomFromCorner() const {
        return std::min(16000.0, 0x1p29 / static_cast<double>(m_job.voxels->sliceStride()));
    }

    /// How many samples stay near enough to a corner if rays are `widest` cubes apart: whole blocks, if one fits.
    [[nodiscard]] std::int64_t runWithin(double widest) const {
        double fastest = 1e-9;
        for (int axis = 0; axis < 3; ++axis)
            fastest = std::max({fastest, std::abs(m_extent.lowStep[axis]), std::abs(m_extent.highStep[axis])});
        const double samples = (roomFromCorner() - widest) / fastest;
        if (samples < 1.0) return 0;
        const auto most = static_cast<std::int64_t>(std::min(samples, static_cast<double>(longestRun)));
        return most >= blockSize ? most / blockSize * blockSize : most;
    }

    /// A box, in cubes, around all samples of a run.
    void findBox(std::int64_t first, int lane, std::int64_t count, double (&low)[3], double (&high)[3]) const {
        const double a = static_cast<double>(first), b = static_cast<double>(first + count);
        m_extent.findBox(a, b, low, high);
        for (int axis = 0; axis < 3; ++axis) {
            if (lane >= 0) {
                const double origin = m_rays.origin[axis][lane] + cubeShift, step = m_rays.step[axis][lane];
                low[axis] = origin + std::min(step * a, step * b);
                high[axis] = origin + std::max(step * a, step * b);
            }
            // Nothing is sampled outside. The last cube with samples is number size, and its corner can be read.
            const double cubes = static_cast<double>(m_job.geometry.size[static_cast<std::size_t>(axis)]);
            low[axis] = std::clamp(low[axis], 0.0, cubes);
            high[axis] = std::clamp(high[axis], 0.0, cubes + 1.0);
        }
    }

    /// Sets the corner of a run, from the run's box in cubes.
    void locate(Run<Voxel>& run, const double (&low)[3], const double (&high)[3]) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            run.corner[axis] = static_cast<std::int64_t>(std::floor(low[axis]));
        const PackedVoxels<Voxel>& voxels = *m_job.voxels;
        const std::int64_t offset =
            run.corner[0] + run.corner[1] * voxels.rowStride() + run.corner[2] * voxels.sliceStride();
        run.volume = {voxels.cubes() + offset * voxelsPerCube, nullptr, voxels.rowStride(), voxels.sliceStride()};
        if (m_job.borders != nullptr && touchesBorder(low, high))
            run.volume.presence = m_job.presence + offset * voxelsPerCube;
    }

    void setLanes(Run<Voxel>& run, int lane) const {
        const Floats floats;
        const auto along = [&](int axis, FloatVector& start, FloatVector& step) {
            const double shift = static_cast<double>(cubeShift - run.corner[static_cast<std::size_t>(axis)]);
            start = inFloats([&](auto doubles, int i) {
                const auto origin = hn::Load(doubles, m_rays.origin[axis] + i);
                const auto perSample = hn::Load(doubles, m_rays.step[axis] + i);
                const auto number = hn::Set(doubles, static_cast<double>(run.first) + 0.5);
                const auto cubes = hn::Add(hn::Add(origin, hn::Mul(perSample, number)), hn::Set(doubles, shift));
                return hn::Mul(cubes, hn::Set(doubles, double{oneCube}));
            });
            step = inFloats([&](auto doubles, int i) {
                return hn::Mul(hn::Load(doubles, m_rays.step[axis] + i), hn::Set(doubles, double{oneCube}));
            });
        };
        along(0, run.startX, run.stepX);
        along(1, run.startY, run.stepY);
        along(2, run.startZ, run.stepZ);
        const auto count = set(static_cast<float>(run.count));
        const auto inRun = [&](const double(&samples)[lanes]) {
            const auto relative = inFloats([&](auto doubles, int i) {
                return hn::Sub(hn::Load(doubles, samples + i), hn::Set(doubles, static_cast<double>(run.first)));
            });
            return hn::Min(hn::Max(relative, set(0.0f)), count);
        };
        run.begin = inRun(m_rays.first);
        run.end = inRun(m_rays.last);
        if (lane >= 0)
            run.end = hn::IfThenElseZero(hn::Eq(hn::Iota(floats, 0.0f), set(static_cast<float>(lane))), run.end);
    }

    /// A quick test that most blocks pass: no data ends in the cube of bricks around the samples.
    [[nodiscard]] bool farFromBorder(std::int64_t first, std::int64_t count) const {
        const BorderSpace& space = *m_job.borders;
        const double halfCount = 0.5 * static_cast<double>(count), middle = static_cast<double>(first) + halfCount;
        double half = 0.0;
        std::int64_t offset = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const double low = m_extent.lowOrigin[axis] + m_extent.lowStep[axis] * middle;
            const double high = m_extent.highOrigin[axis] + m_extent.highStep[axis] * middle;
            const double step = std::max(std::abs(m_extent.lowStep[axis]), std::abs(m_extent.highStep[axis]));
            half = std::max(half, 0.5 * (high - low) + halfCount * step);
            const std::int64_t size = space.size()[static_cast<std::size_t>(axis)];
            const auto cube = static_cast<std::int64_t>(0.5 * (low + high));
            offset = offset * size + std::clamp<std::int64_t>(cube >> BorderSpace::shift, 0, size - 1);
        }
        constexpr double rounding = 0.01;
        const auto bricks = static_cast<std::int64_t>((half + rounding) * (1.0 / BorderSpace::edge)) + 1;
        return space.distances()[static_cast<std::size_t>(offset)] > bricks;
    }

    /// Whether data may end in a box, in cubes.
    [[nodiscard]] bool touchesBorder(const double (&low)[3], const double (&high)[3]) const {
        const BorderSpace& space = *m_job.borders;
        std::int64_t brick[3];
        for (int axis = 0; axis < 3; ++axis) {
            const auto cube = static_cast<std::int64_t>(0.5 * (low[axis] + high[axis]));
            brick[axis] = std::clamp<std::int64_t>(cube >> BorderSpace::shift, 0,
                                                   space.size()[static_cast<std::size_t>(axis)] - 1);
        }
        const std::int64_t distance = space.distances()[static_cast<std::size_t>(
            brick[0] + space.size()[0] * (brick[1] + space.size()[1] * brick[2]))];
        if (distance == 0) return true;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t before = brick[axis] - distance + 1, behind = brick[axis] + distance;
            constexpr double rounding = 0.01;
            if (before > 0 && low[axis] < static_cast<double>(before * BorderSpace::edge) + rounding) return true;
            if (behind < space.size()[static_cast<std::size_t>(axis)] &&
                high[axis] > static_cast<double>(behind * BorderSpace::edge) - rounding)
                return true;
        }
        return false;
    }

    const KernelJob<Voxel>& m_job;
    RayBundle<lanes> m_rays;
    bool m_any = false;
    std::int64_t m_first = 0, m_last = 0;
    std::int64_t m_longestRun = longestRun;
    Extent m_extent;
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
