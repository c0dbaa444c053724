// The loop that takes most of the time of most pictures: direct volume rendering without light and depth.
#include "processing/ray_caster/packet_gathered-inl.h"

#if defined(ECHOLUCENT_PACKET_PLAIN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_PLAIN_INL
#undef ECHOLUCENT_PACKET_PLAIN_INL
#else
#define ECHOLUCENT_PACKET_PLAIN_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// Whether the samples of a run are kept on the way, or kept ones are used.
enum class Keeping { none, keep, reuse };

/// A run and its constants. Values of samples are sums of meanOfBytes for bytes, else table positions.
template <typename Voxel>
struct PlainRun {
    const Run<Voxel>& run;
    const float* opacities;  ///< those of ByteOpacities for bytes, else those of TransferTable
    int bends;               ///< how many bends of the colour map count: ColourBends::count, or 0
    float toTable;           ///< factor from a voxel's value to its table position
    float firstVisible;      ///< values below this show nothing
    float whiteValue;        ///< the value of intensity 1
    bool clamped;            ///< whether values may be above whiteValue
    bool nearest;            ///< whether values are those of the nearest voxel, not means of those around
    float keptPerValue;
    std::uint16_t* kept;  ///< of the run's first sample; null if samples are not kept
    FloatVector limit;    ///< a ray ends if the run's opacity reaches it
};

/// The sums of one run, in shares of the light that reaches it: its opacity, the values, and their parts beyond each
/// bend. Its colours are made from them.
struct PlainSums {
    FloatVector opacity, along, beyond[ColourBends::count];
};

/// The colours of the sums; `whiteValue` is the value of intensity 1.
inline Blend blendOf(const ColourBends& bends, const PlainSums& sums, float whiteValue) {
    const auto channel = [&](std::size_t c) {
        auto change = hn::Mul(sums.along, set(bends.slope[c]));
        for (std::size_t i = 0; i < ColourBends::count; ++i)
            change = hn::MulAdd(sums.beyond[i], set(bends.change[c][i]), change);
        return hn::MulAdd(change, set(1.0f / whiteValue), hn::Mul(sums.opacity, set(bends.base[c])));
    };
    return {sums.opacity, channel(0), channel(1), channel(2), set(-1.0f)};
}

HWY_INLINE FloatVector entriesOf(const float* entries, IntVector index, LaneMask active) {
    return hn::IfThenElseZero(active, loadEntries(entries, hn::IfThenElseZero(hn::RebindMask(Ints(), active), index)));
}

template <typename Voxel>
HWY_INLINE FloatVector opacityOf(const PlainRun<Voxel>& from, FloatVector value, LaneMask active) {
    if constexpr (std::is_same_v<Voxel, std::uint8_t>) {
        constexpr float toIndex = ByteOpacities::perLevel / byteScale;
        return entriesOf(from.opacities, rounded(hn::Mul(value, set(toIndex))), active);
    } else {
        const auto left = truncated(value);
        return between(entriesOf(from.opacities, left, active), entriesOf(from.opacities + 1, left, active),
                       hn::Sub(value, hn::ConvertTo(Floats(), left)));
    }
}

HWY_INLINE void keepValue(FloatVector value, float keptPerValue, std::uint16_t* kept) {
    const hn::Rebind<std::uint16_t, Floats> words;
    hn::StoreU(hn::DemoteTo(words, rounded(hn::Mul(value, set(keptPerValue)))), words, kept);
}
HWY_INLINE FloatVector keptValue(const std::uint16_t* kept, float keptPerValue) {
    const hn::Rebind<std::uint16_t, Floats> words;
    const auto number = hn::PromoteTo(Ints(), hn::LoadU(words, kept));
    return hn::Mul(hn::ConvertTo(Floats(), number), set(1.0f / keptPerValue));
}

/// The lanes that have the samples of a block.
struct BlockLanes {
    LaneMask alive, whole;  ///< whole: they have all of them

    template <bool cut, typename Voxel>
    HWY_INLINE LaneMask present(const Run<Voxel>& run, std::int64_t i) const {
        if constexpr (cut) return run.inRange(set(static_cast<float>(i)));
        return whole;
    }
};

/// The place to read sample i. The sample lies at `at`, apart from rounding.
template <typename Voxel>
HWY_INLINE Position placeOf(const PlainRun<Voxel>& from, std::int64_t i, const Position& at) {
    return from.nearest ? nearestVoxel(from.run.at(set(static_cast<float>(i)))) : at;
}

/// A value clamped to the table's range.
template <typename Voxel>
HWY_INLINE FloatVector limited(FloatVector value) {
    constexpr bool bytes = std::is_same_v<Voxel, std::uint8_t>;
    const float highest = bytes ? 255.0f * byteScale : static_cast<float>(TransferTable::intervals);
    return hn::Max(hn::Min(value, set(highest)), set(0.0f));
}

/// Reads values of samples i ... i + group - 1 from `at` on, and moves `at` behind them. If `all`, it reads the samples
/// of rays that have ended too. Each stage handles all samples before the next stage begins. So the processor has other
/// samples to begin while one waits for its voxels.
template <bool all, int group, bool cut, typename Voxel>
HWY_INLINE void readGroup(const PlainRun<Voxel>& from, const BlockLanes& in, std::int64_t i, const Position& step,
                          Position& at, FloatVector (&value)[group]) {
    const Cubes<Voxel>& volume = from.run.volume;
    const auto lanesToRead = [&](int k) {
        const auto present = in.template present<cut>(from.run, i + k);
        return all ? present : hn::And(present, in.alive);
    };
    if constexpr (std::is_same_v<Voxel, std::uint8_t>) {
        CubeOfBytes cube[group];
        for (int k = 0; k < group; ++k, at = at + step) {
            const Position place = placeOf(from, i + k, at);
            cube[k] = cubeOfBytes(volume.cubes, volume.sliceStride, volume.offsetOf(place), place, lanesToRead(k));
        }
        for (int k = 0; k < group; ++k) value[k] = meanOf(cube[k]);
    } else {
        for (int k = 0; k < group; ++k, at = at + step) {
            const Position place = placeOf(from, i + k, at);
            value[k] = hn::Mul(meanOf(volume, volume.offsetOf(place), place, lanesToRead(k)), set(from.toTable));
        }
    }
    if constexpr (!std::is_same_v<Voxel, std::uint8_t>)
        for (int k = 0; k < group; ++k) value[k] = limited<Voxel>(value[k]);
}

/// Reduces opacities to the part that data covers.
template <bool cut, int group, typename Voxel>
HWY_INLINE void coverGroup(const PlainRun<Voxel>& from, const BlockLanes& in, std::int64_t i, const Position& step,
                           Position at, FloatVector (&opacity)[group]) {
    const Cubes<Voxel>& volume = from.run.volume;
    FloatVector presence[group];
    for (int k = 0; k < group; ++k, at = at + step) {
        const Position place = placeOf(from, i + k, at);
        const auto active = hn::And(in.template present<cut>(from.run, i + k), in.alive);
        presence[k] = presenceAt(volume, volume.offsetOf(place), place, active);
    }
    for (int k = 0; k < group; ++k) opacity[k] = hn::Mul(opacity[k], coverageOf(presence[k], from.nearest));
}

/// Adds `group` samples to the sums. If `cut`, some lanes do not have all of them.
template <Keeping keeping, bool bordering, int group, bool cut, typename Voxel>
HWY_INLINE void blendGroup(const PlainRun<Voxel>& from, const BlockLanes& in, std::int64_t i, const Position& step,
                           Position& at, PlainSums& sums) {
    const Floats floats;
    FloatVector value[group];
    const Position first = at;
    std::uint16_t* const kept = keeping == Keeping::none ? nullptr : from.kept + i * lanes;
    if constexpr (keeping == Keeping::reuse)
        for (int k = 0; k < group; ++k, at = at + step) value[k] = keptValue(kept + k * lanes, from.keptPerValue);
    else
        // Rays that have ended keep samples too, since another curve may let more light through.
        readGroup<keeping == Keeping::keep, group, cut>(from, in, i, step, at, value);
    if constexpr (keeping == Keeping::keep)
        for (int k = 0; k < group; ++k) keepValue(value[k], from.keptPerValue, kept + k * lanes);
    auto most = value[0];
    for (int k = 1; k < group; ++k) most = hn::Max(most, value[k]);
    // With a curve that clears fluid, half of the samples show nothing.
    if (hn::AllFalse(floats, hn::Ge(most, set(from.firstVisible)))) return;
    FloatVector opacity[group];
    for (int k = 0; k < group; ++k) {
        const auto active = hn::And(in.template present<cut>(from.run, i + k), in.alive);
        opacity[k] = opacityOf(from, value[k], active);
    }
    if constexpr (bordering) coverGroup<cut>(from, in, i, step, first, opacity);
    for (int k = 0; k < group; ++k) {
        const auto added = hn::NegMulAdd(opacity[k], sums.opacity, opacity[k]);
        sums.opacity = hn::Add(sums.opacity, added);
        if (from.clamped) value[k] = hn::Min(value[k], set(from.whiteValue));
        sums.along = hn::MulAdd(added, value[k], sums.along);
        opacity[k] = added;
    }
    // Bright samples are rare: most groups are below most bends.
    for (int bend = 0; bend < from.bends; ++bend) {
        const auto begin = set(from.whiteValue * ColourBends::at(bend));
        if (hn::AllFalse(floats, hn::Gt(most, begin))) return;
        for (int k = 0; k < group; ++k)
            sums.beyond[bend] = hn::MulAdd(opacity[k], hn::Max(hn::Sub(value[k], begin), set(0.0f)), sums.beyond[bend]);
    }
}

/// How many samples to add at once: if all rays have them, and if some do not. Smaller groups are skipped more often.
constexpr int wholeGroup = 8, cutGroup = 4;

/// Composites the samples from `block` to `last` - 1.
template <Keeping keeping, bool bordering, typename Voxel>
HWY_INLINE void blendBlock(const PlainRun<Voxel>& from, std::int64_t block, std::int64_t last, LaneMask alive,
                           PlainSums& sums) {
    const Floats floats;
    const Run<Voxel>& run = from.run;
    const auto someOf = [&](std::int64_t first, std::int64_t behind) {
        return hn::And(hn::Lt(run.begin, set(static_cast<float>(behind))),
                       hn::Gt(run.end, set(static_cast<float>(first))));
    };
    const auto whole =
        hn::And(hn::Le(run.begin, set(static_cast<float>(block))), hn::Ge(run.end, set(static_cast<float>(last))));
    const bool cut = !hn::AllFalse(floats, hn::AndNot(whole, someOf(block, last)));
    const BlockLanes in{alive, whole};
    const Position step = run.way();
    Position at = run.at(set(static_cast<float>(block)));
    std::int64_t i = block;
    if (!cut)
        for (; i + wholeGroup <= last; i += wholeGroup)
            blendGroup<keeping, bordering, wholeGroup, false>(from, in, i, step, at, sums);
    else
        for (; i + cutGroup <= last; i += cutGroup) {
            if (!hn::AllFalse(floats, someOf(i, i + cutGroup)))
                blendGroup<keeping, bordering, cutGroup, true>(from, in, i, step, at, sums);
            else
                at = run.at(set(static_cast<float>(i + cutGroup)));
        }
    // Runs of single rays may be shorter than a block.
    for (; i < last; ++i) blendGroup<keeping, bordering, 1, true>(from, in, i, step, at, sums);
}

/// endsAt(sample): the run shows nothing from there on. bordersOn(sample): data may end in the block from there on;
/// asked only if `bordering`. Returns the end of the last block done, which may lie behind the run's end.
template <Keeping keeping, bool bordering, typename Voxel, typename EndsAt, typename BordersOn>
HWY_NOINLINE std::int64_t blendRun(const PlainRun<Voxel>& from, const EndsAt& endsAt, const BordersOn& bordersOn,
                                   PlainSums& result) {
    const Floats floats;
    const auto zero = set(0.0f);
    PlainSums sums{zero, zero, {zero, zero, zero}};
    std::int64_t block = 0;
    for (; block < from.run.count; block += blockSize) {
        const auto alive = hn::Lt(sums.opacity, from.limit);
        if (hn::AllFalse(floats, hn::And(alive, hn::Gt(from.run.end, set(static_cast<float>(block)))))) break;
        if (endsAt(block)) break;
        const std::int64_t last = std::min(from.run.count, block + blockSize);
        if (bordering && bordersOn(block))
            blendBlock<keeping, true>(from, block, last, alive, sums);
        else
            blendBlock<keeping, false>(from, block, last, alive, sums);
    }
    result = sums;
    return block;
}

template <bool bordering, typename Voxel, typename EndsAt, typename BordersOn>
std::int64_t blendRun(const PlainRun<Voxel>& from, Keeping keeping, const EndsAt& endsAt, const BordersOn& bordersOn,
                      PlainSums& result) {
    switch (keeping) {
        case Keeping::none: break;
        case Keeping::keep: return blendRun<Keeping::keep, bordering>(from, endsAt, bordersOn, result);
        case Keeping::reuse: return blendRun<Keeping::reuse, bordering>(from, endsAt, bordersOn, result);
    }
    return blendRun<Keeping::none, bordering>(from, endsAt, bordersOn, result);
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
