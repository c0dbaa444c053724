// Gradients of samples: from GradientPlaces, or else as differences of samples of the volume.
#include "processing/ray_caster/packed/gradient_places.h"
#include "processing/ray_caster/packet_run-inl.h"

#if defined(ECHOLUCENT_PACKET_GRADIENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_GRADIENT_INL
#undef ECHOLUCENT_PACKET_GRADIENT_INL
#else
#define ECHOLUCENT_PACKET_GRADIENT_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// Normalised intensity per unit.
struct Gradient {
    FloatVector x, y, z;
};

/// The places around the samples of a packet: in each lane, the address of the place of lower x, y and z.
struct GradientAddresses {
    const std::uint8_t* of[lanes];
};

/// Lanes that are not active get the address of zeros.
template <typename Voxel>
HWY_INLINE GradientAddresses addressesOf(const GradientPlaces& places, const Run<Voxel>& run, const Position& at,
                                         LaneMask active) {
    constexpr int shift = BrickGrid::shift, within = BrickGrid::edge - 1;
    const auto cube = [&](IntVector position, std::size_t axis) {
        return hn::Add(hn::ShiftRight<16>(position), set(static_cast<std::int32_t>(run.corner[axis])));
    };
    const auto x = cube(at.x, 0), y = cube(at.y, 1), z = cube(at.z, 2);
    const auto size = [&](std::size_t axis) { return set(static_cast<std::int32_t>(places.grid().size[axis])); };
    const auto row = hn::Add(hn::Mul(hn::ShiftRight<shift>(z), size(1)), hn::ShiftRight<shift>(y));
    const auto brick = hn::Add(hn::Mul(row, size(0)), hn::ShiftRight<shift>(x));
    const auto local = [&](IntVector value) { return hn::And(value, set(within)); };
    const auto place =
        hn::Add(hn::Mul(hn::Add(hn::ShiftLeft<shift>(local(z)), local(y)), set(GradientPlaces::columns)), local(x));
    static_assert(GradientPlaces::rows == 1 << shift);
    const Ints ints;
    const auto chosen = hn::RebindMask(ints, active);
    alignas(64) std::int32_t bricks[lanes], offsets[lanes];
    hn::Store(hn::IfThenElse(chosen, brick, set(static_cast<std::int32_t>(places.grid().count()))), ints, bricks);
    hn::Store(hn::IfThenElseZero(chosen, place), ints, offsets);
    GradientAddresses addresses;
    for (int i = 0; i < lanes; ++i)
        addresses.of[i] =
            places.brick(static_cast<std::size_t>(bricks[i])) + offsets[i] * GradientPlaces::bytesPerPlace;
    return addresses;
}

/// From one slice of places to the next.
constexpr std::ptrdiff_t placeSlice =
    std::ptrdiff_t{GradientPlaces::columns} * GradientPlaces::rows * GradientPlaces::bytesPerPlace;

/// The gradient of four means of bytes, each 127 times as large.
HWY_INLINE Gradient scaled(FloatVector x, FloatVector y, FloatVector z, FloatVector scale, float quantum) {
    const auto zero = set(static_cast<float>(GradientPlaces::zero * 127));
    const auto factor = hn::Mul(scale, set(quantum / static_cast<float>(127 * 127 * GradientPlaces::scaleOne)));
    return {hn::Mul(hn::Sub(x, zero), factor), hn::Mul(hn::Sub(y, zero), factor), hn::Mul(hn::Sub(z, zero), factor)};
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Gradient gradientBetween(const GradientAddresses& addresses, const Position& at, float quantum) {
    const auto share = [](IntVector position) { return (position.raw & 0xFFFF) >> 1; };
    const int shareX = share(at.x), shareY = share(at.y) >> 8, shareZ = share(at.z);
    const auto component = [&](int axis) {
        const auto alongX = [&](int x) {
            const auto alongY = [&](const std::uint8_t* two) { return two[0] * (127 - shareY) + two[1] * shareY; };
            const std::uint8_t* const near = addresses.of[0] + x * GradientPlaces::bytesPerPlace + 2 * axis;
            return fixedBetween(alongY(near), alongY(near + placeSlice), shareZ);
        };
        return set(static_cast<float>(fixedBetween(alongX(0), alongX(1), shareX)));
    };
    return scaled(component(0), component(1), component(2), component(3), quantum);
}

#else

/// Sixteen bytes of each lane, as four vectors of dwords: dwords 0 to 3 of all lanes.
struct FourDwords {
    hn::Vec<Bytes> of[4];
};
/// Blocks of 128 bits hold lanes i, i + 4, i + 8 and i + 12.
template <int count>
HWY_INLINE hn::Vec<hn::CappedTag<std::uint8_t, 4 * count> > blocksOf(const GradientAddresses& addresses, int i,
                                                                     std::ptrdiff_t offset) {
    const hn::CappedTag<std::uint8_t, 4 * count> bytes;
    if constexpr (count == 4)
        return hn::LoadU(bytes, addresses.of[i] + offset);
    else
        return hn::Combine(bytes, blocksOf<count / 2>(addresses, i + count / 2, offset),
                           blocksOf<count / 2>(addresses, i, offset));
}
HWY_INLINE FourDwords loadFour(const GradientAddresses& addresses, std::ptrdiff_t offset) {
    const Bytes bytes;
    const Ints ints;
    const Pairs pairs;
    const auto first = hn::BitCast(ints, blocksOf<lanes>(addresses, 0, offset)),
               second = hn::BitCast(ints, blocksOf<lanes>(addresses, 1, offset)),
               third = hn::BitCast(ints, blocksOf<lanes>(addresses, 2, offset)),
               fourth = hn::BitCast(ints, blocksOf<lanes>(addresses, 3, offset));
    const auto pairsOf = [&](IntVector a, IntVector b, bool upper) {
        return hn::BitCast(pairs, upper ? hn::InterleaveUpper(ints, a, b) : hn::InterleaveLower(ints, a, b));
    };
    const auto low01 = pairsOf(first, second, false), high01 = pairsOf(first, second, true);
    const auto low23 = pairsOf(third, fourth, false), high23 = pairsOf(third, fourth, true);
    return {{hn::BitCast(bytes, hn::InterleaveLower(pairs, low01, low23)),
             hn::BitCast(bytes, hn::InterleaveUpper(pairs, low01, low23)),
             hn::BitCast(bytes, hn::InterleaveLower(pairs, high01, high23)),
             hn::BitCast(bytes, hn::InterleaveUpper(pairs, high01, high23))}};
}

HWY_INLINE Gradient gradientBetween(const GradientAddresses& addresses, const Position& at, float quantum) {
    const FourDwords near = loadFour(addresses, 0), far = loadFour(addresses, placeSlice);
    const auto shareX = wordShares(at.x), shareZ = wordShares(at.z);
    const auto shareY = byteShares(at.y);
    const auto alongZ = [&](int dword) {
        return fixedBetween(pairSums(near.of[dword], shareY), pairSums(far.of[dword], shareY), shareZ);
    };
    // Dwords 0 and 1 belong to x, 2 and 3 to x + 1. Each holds two components.
    const Ints ints;
    const auto xAndY = hn::BitCast(ints, fixedBetween(alongZ(0), alongZ(2), shareX)),
               zAndScale = hn::BitCast(ints, fixedBetween(alongZ(1), alongZ(3), shareX));
    const auto low = [](IntVector two) { return hn::ConvertTo(Floats(), hn::And(two, set(0xFFFF))); };
    const auto high = [](IntVector two) { return hn::ConvertTo(Floats(), hn::ShiftRight<16>(two)); };
    return scaled(low(xAndY), high(xAndY), low(zAndScale), high(zAndScale), quantum);
}

#endif

/// Derivatives at the samples of a packet: central differences, whose ends do not go beyond the outermost voxels.
template <typename Voxel>
class Gradients {
public:
    explicit Gradients(const KernelJob<Voxel>& job)
        : m_source(*job.light), m_places(job.gradients), m_geometry(job.geometry), m_toTable(job.toTable) {}

    HWY_INLINE Gradient at(const Run<Voxel>& run, const Position& at, LaneMask active) const {
        if (m_places == nullptr) return differences(run, at, active);
        Gradient gradient = gradientBetween(addressesOf(*m_places, run, at, active), at, m_places->quantum());
        if (run.stored) return gradient;
        complete<0>(run, at, active, gradient.x);
        complete<1>(run, at, active, gradient.y);
        complete<2>(run, at, active, gradient.z);
        return gradient;
    }

private:
    HWY_NOINLINE Gradient differences(const Run<Voxel>& run, const Position& at, LaneMask active) const {
        return {differenceAlong<0>(run, at, active), differenceAlong<1>(run, at, active),
                differenceAlong<2>(run, at, active)};
    }
    /// Takes the differences that no place holds.
    template <int axis>
    HWY_INLINE void complete(const Run<Voxel>& run, const Position& at, LaneMask active, FloatVector& component) const {
        const auto left = hn::AndNot(isStored<axis>(run, at), active);
        if (!hn::AllFalse(Floats(), left)) takeDifference<axis>(run, at, left, component);
    }
    template <int axis>
    HWY_NOINLINE void takeDifference(const Run<Voxel>& run, const Position& at, LaneMask left,
                                     FloatVector& component) const {
        component = hn::IfThenElse(left, differenceAlong<axis>(run, at, left), component);
    }
    template <int axis>
    HWY_INLINE LaneMask isStored(const Run<Voxel>& run, Position at) const {
        const auto place = [&](std::int32_t cube) {
            return set(
                static_cast<std::int32_t>(std::clamp<std::int64_t>(cube - run.corner[axis], -32767, 32767) * oneCube));
        };
        const IntVector position = componentOf<axis>(at);
        const auto from = hn::Gt(position, hn::Sub(place(m_places->firstCube(axis)), set(1)));
        return hn::RebindMask(Floats(), hn::And(from, hn::Lt(position, place(m_places->lastCube(axis)))));
    }

    template <int axis>
    static HWY_INLINE IntVector& componentOf(Position& at) {
        if constexpr (axis == 0) return at.x;
        if constexpr (axis == 1) return at.y;
        if constexpr (axis == 2) return at.z;
    }

    /// Normalised intensity per unit.
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

    const LightSource& m_source;
    const GradientPlaces* m_places;
    const VolumeGeometry& m_geometry;
    float m_toTable;
};

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
