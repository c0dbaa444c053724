// The opacity, colour and light of a sample.
#include "processing/ray_caster/packet_reaching-inl.h"

#if defined(ECHOLUCENT_PACKET_COLOUR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_COLOUR_INL
#undef ECHOLUCENT_PACKET_COLOUR_INL
#else
#define ECHOLUCENT_PACKET_COLOUR_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

struct Colour {
    FloatVector red, green, blue;
};

/// The value of a table at a position from 0 on, linear between its entries.
HWY_INLINE FloatVector entryAt(const float* entries, FloatVector position) {
    const auto left = truncated(position);
    return between(loadEntries(entries, left), loadEntries(entries + 1, left),
                   hn::Sub(position, hn::ConvertTo(Floats(), left)));
}

/// The colour map, as two permutations of four values instead of a look-up in memory.
class Colours {
public:
    explicit Colours(const ColourRanges& ranges) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            m_base[channel] = spread(ranges.base[channel]);
            m_slope[channel] = spread(ranges.slope[channel]);
        }
    }
    /// The colour at a table position, 0 ... intervals.
    HWY_INLINE Colour at(FloatVector position) const {
        // Slightly less, so that the last position is in the last range.
        constexpr float perRange = ColourRanges::count / (TransferTable::intervals * (1.0f + 0x1p-20f));
        const auto range = truncated(hn::Mul(position, set(perRange)));
        const auto channel = [&](std::size_t c) {
            return hn::MulAdd(valueOf(m_slope[c].values, range), position, valueOf(m_base[c].values, range));
        };
        return {channel(0), channel(1), channel(2)};
    }

private:
    static constexpr int length = std::max(lanes, ColourRanges::count);
    struct alignas(64) Lanes {
        float values[length];
    };
    static HWY_INLINE FloatVector valueOf(const float* values, IntVector range) {
#if HWY_TARGET == HWY_SCALAR
        return set(values[range.raw]);
#else
        return hn::TableLookupLanes(hn::Load(Floats(), values), hn::IndicesFromVec(Floats(), range));
#endif
    }
    static Lanes spread(const ColourRanges::Values& values) {
        Lanes spread{};
        for (int i = 0; i < length; ++i) spread.values[i] = values[static_cast<std::size_t>(i % ColourRanges::count)];
        return spread;
    }
    Lanes m_base[3], m_slope[3];
};

/// The factors of Shading for red, green and blue.
struct LitBy {
    FloatVector red, green, blue;
};

/// Gradients and light of the samples of one packet.
template <typename Voxel>
class Light {
public:
    Light(const KernelJob<Voxel>& job, const RayBundle<lanes>& rays)
        : m_source(*job.light), m_reaching(job.reaching), m_geometry(job.geometry), m_toTable(job.toTable) {
        for (int i = 0; i < lanes; ++i) {
            double half[3], square = 0.0;
            const double stepMm = job.rays->stepMm();
            for (int axis = 0; axis < 3; ++axis) {
                const double direction = rays.step[axis][i] * job.geometry.spacing[axis] / stepMm;
                half[axis] = static_cast<double>(m_source.towardsLight[static_cast<std::size_t>(axis)]) - direction;
                square += half[axis] * half[axis];
            }
            const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 0.0;
            for (int axis = 0; axis < 3; ++axis) m_half[axis][i] = static_cast<float>(half[axis] * scale);
        }
    }

    /// The light on samples. Those that are not `worth` a gradient have no surface. All light reaches those that are
    /// not `reached`; all that are worth a gradient are.
    HWY_INLINE LitBy at(const Run<Voxel>& run, FloatVector number, LaneMask worth, LaneMask reached) const {
        const Floats floats;
        const auto even = set(m_source.ambient + m_source.diffuse * m_source.evenLight);
        const bool surfaces = !hn::AllFalse(floats, worth);
        if (m_reaching == nullptr) {
            if (!surfaces) return {even, even, even};
            const auto all = hn::IfThenElse(worth, keyLight(run, run.at(number), worth, set(m_source.ambient)), even);
            return {all, all, all};
        }
        if (hn::AllFalse(floats, reached)) return {even, even, even};
        const Position place = run.at(number);
        auto key = set(m_source.diffuse * m_source.evenLight);
        if (surfaces) key = hn::IfThenElse(worth, keyLight(run, place, worth, set(0.0f)), key);
        const LitBy by = reachedBy(reachingAt(*m_reaching, run, place), key);
        return {hn::IfThenElse(reached, by.red, even), hn::IfThenElse(reached, by.green, even),
                hn::IfThenElse(reached, by.blue, even)};
    }

    /// `unlit` is the share that keeps its colour (CutFace). No colour gets brighter than white.
    HWY_INLINE FloatVector lit(FloatVector colour, FloatVector factor, FloatVector unlit, std::size_t channel) const {
        const auto one = set(1.0f), tint = set(m_source.shadowTint[channel]);
        const auto mixed = hn::MulAdd(unlit, hn::Sub(one, factor), factor);
        const auto shadow = hn::MulAdd(hn::Sub(one, tint), hn::Min(one, mixed), tint);
        return hn::Min(one, hn::Mul(hn::Mul(colour, mixed), shadow));
    }

private:
    /// The full key light on surfaces, and `ambient` besides.
    HWY_INLINE FloatVector keyLight(const Run<Voxel>& run, const Position& at, LaneMask active,
                                    FloatVector ambient) const {
        const auto zero = set(0.0f), one = set(1.0f);
        const auto x = differenceAlong<0>(run, at, active);
        const auto y = differenceAlong<1>(run, at, active);
        const auto z = differenceAlong<2>(run, at, active);
        const auto square = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
        const auto hasGradient = hn::Gt(square, zero);
        const auto safeSquare = hn::IfThenElse(hasGradient, square, one);
        // The normal points against the gradient, to the darker side.
        const auto perLength = hn::Neg(hn::Div(one, hn::Sqrt(safeSquare)));
        const auto share =
            hn::IfThenElseZero(hasGradient, hn::Div(safeSquare, hn::Add(safeSquare, set(m_source.floorSquare))));
        const auto dot = [&](FloatVector a, FloatVector b, FloatVector c) {
            return hn::Mul(perLength, hn::MulAdd(x, a, hn::MulAdd(y, b, hn::Mul(z, c))));
        };
        const auto towards =
            dot(set(m_source.towardsLight[0]), set(m_source.towardsLight[1]), set(m_source.towardsLight[2]));
        const auto facing = hn::Max(zero, hn::Div(hn::Add(towards, set(m_source.wrap)), set(1.0f + m_source.wrap)));
        const auto diffuse = hn::MulAdd(share, facing, hn::Mul(hn::Sub(one, share), set(m_source.evenLight)));
        const Floats floats;
        const auto cosine = dot(hn::Load(floats, m_half[0]), hn::Load(floats, m_half[1]), hn::Load(floats, m_half[2]));
        return hn::MulAdd(share, highlightAt(cosine), hn::MulAdd(set(m_source.diffuse), diffuse, ambient));
    }

    /// As reachingFactor(). `key` is the full key light.
    HWY_INLINE LitBy reachedBy(const Reaching& reaching, FloatVector key) const {
        const auto left = [&](FloatVector reached, float strength) {
            return hn::MulAdd(reached, set(strength), set(1.0f - strength));
        };
        const auto ambient = hn::Mul(left(reaching.around, m_source.occlusion), set(m_source.ambient));
        const auto lightOf = [&](FloatVector reached) {
            return hn::MulAdd(left(reached, m_source.shadow), key, ambient);
        };
        const auto k = reaching.key, translucency = set(m_source.translucency);
        return {lightOf(between(k, hn::Sqrt(k), translucency)), lightOf(k),
                lightOf(between(k, hn::Mul(k, k), translucency))};
    }

    template <int axis>
    static HWY_INLINE IntVector& componentOf(Position& at) {
        if constexpr (axis == 0) return at.x;
        if constexpr (axis == 1) return at.y;
        if constexpr (axis == 2) return at.z;
    }

    /// Derivative along an axis, normalised intensity per unit: a central difference, whose ends do not go beyond the
    /// outermost voxels.
    template <int axis>
    HWY_INLINE FloatVector differenceAlong(const Run<Voxel>& run, const Position& at, LaneMask active) const {
        Position before = at, after = at;
        IntVector& low = componentOf<axis>(before);
        IntVector& high = componentOf<axis>(after);
        const auto corner = run.corner[axis];
        const auto place = [&](std::int64_t cube) {
            return set(static_cast<std::int32_t>(std::clamp<std::int64_t>(cube - corner, -32767, 32767) * oneCube));
        };
        const auto first = place(cubeShift), last = place(cubeShift + m_geometry.size[axis] - 1);
        const double farthest = 16000.0;
        const auto reach = set(static_cast<std::int32_t>(std::min(m_source.reach[axis], farthest) * oneCube));
        low = hn::Min(hn::Max(hn::Sub(low, reach), first), last);
        high = hn::Min(hn::Max(hn::Add(high, reach), first), last);
        const auto a = meanOf(run.volume, run.volume.offsetOf(before), before, active),
                   b = meanOf(run.volume, run.volume.offsetOf(after), after, active);
        const auto units =
            hn::Mul(hn::ConvertTo(Floats(), hn::Sub(high, low)), set(m_source.unitsPerVoxel[axis] / oneCube));
        const auto difference = hn::Mul(hn::Sub(b, a), set(m_toTable / static_cast<float>(TransferTable::intervals)));
        const auto some = hn::Gt(units, set(0.0f));
        return hn::IfThenElseZero(some, hn::Div(difference, hn::IfThenElse(some, units, set(1.0f))));
    }

    HWY_INLINE FloatVector highlightAt(FloatVector cosine) const {
        return entryAt(m_source.highlight.data(), hn::Mul(hn::Min(hn::Max(cosine, set(0.0f)), set(1.0f)),
                                                          set(static_cast<float>(LightSource::highlightIntervals))));
    }

    const LightSource& m_source;
    const PackedLight* m_reaching;  ///< null if all light reaches all places
    const VolumeGeometry& m_geometry;
    float m_toTable;
    alignas(64) float m_half[3][lanes];
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
