// How much light reaches the samples of a packet of rays.
#include "processing/ray_caster/packed/packed_light.h"
#include "processing/ray_caster/packet_run-inl.h"

#if defined(ECHOLUCENT_PACKET_REACHING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_REACHING_INL
#undef ECHOLUCENT_PACKET_REACHING_INL
#else
#define ECHOLUCENT_PACKET_REACHING_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// The shares of the key light and of the light around the viewer, 0 to 1.
struct Reaching {
    FloatVector key, around;
};

/// A place of a light volume along one axis.
struct LightPlace {
    IntVector whole, share;  ///< share: 1/65536 of the way to the next place
};
template <typename Voxel>
HWY_INLINE LightPlace lightPlace(const PackedLight& light, const Run<Voxel>& run, std::size_t axis, IntVector at) {
    const double corner = static_cast<double>(run.corner[axis] - cubeShift);
    const auto start = set(static_cast<float>(corner * light.perVoxel[axis] + light.firstVoxel[axis]));
    const auto perCube = set(static_cast<float>(light.perVoxel[axis] / oneCube));
    const auto place = hn::Min(hn::Max(hn::MulAdd(hn::ConvertTo(Floats(), at), perCube, start), set(0.0f)),
                               set(static_cast<float>(light.size[axis] - 1)));
    const auto whole = truncated(place);
    const auto beyond = hn::Sub(place, hn::ConvertTo(Floats(), whole));
    return {whole, truncated(hn::Mul(beyond, set(static_cast<float>(oneCube))))};
}

/// The means of the eight places around. `near` and `far` are the first bytes of a slice and of the next one.
HWY_INLINE Reaching meansOf(const std::uint8_t* near, const std::uint8_t* far, IntVector offset,
                            const Position& shares) {
    const auto mean = [&](const CubeOfBytes& cube) { return hn::Mul(meanOf(cube), set(1.0f / (byteScale * 255.0f))); };
#if HWY_TARGET == HWY_SCALAR
    const auto place = static_cast<std::ptrdiff_t>(offset.raw) * PackedLight::bytesPerPlace;
    const auto share = [](IntVector position) { return (position.raw & 0xFFFF) >> 1; };
    CubeOfBytes cube{near + place, far + place, share(shares.x), share(shares.y) >> 8, share(shares.z)};
    const auto key = mean(cube);
    cube.near += PackedLight::bytesPerPlace / 2;
    cube.far += PackedLight::bytesPerPlace / 2;
    return {key, mean(cube)};
#else
    static_assert(PackedLight::bytesPerPlace == 1 << 3);
    const DwordPair before = loadPairs<3>(near, offset), behind = loadPairs<3>(far, offset);
    CubeOfBytes cube = sharesOf(shares);
    cube.near = hn::BitCast(Bytes(), before.low);
    cube.far = hn::BitCast(Bytes(), behind.low);
    const auto key = mean(cube);
    cube.near = hn::BitCast(Bytes(), before.high);
    cube.far = hn::BitCast(Bytes(), behind.high);
    return {key, mean(cube)};
#endif
}

template <typename Voxel>
HWY_INLINE Reaching reachingAt(const PackedLight& light, const Run<Voxel>& run, const Position& at) {
    const LightPlace x = lightPlace(light, run, 0, at.x), y = lightPlace(light, run, 1, at.y),
                     z = lightPlace(light, run, 2, at.z);
    const auto row = hn::Add(hn::Mul(z.whole, set(light.size[1])), y.whole);
    const auto offset = hn::Add(hn::Mul(row, set(light.size[0])), x.whole);
    const std::ptrdiff_t slice = std::ptrdiff_t{light.size[0]} * light.size[1] * PackedLight::bytesPerPlace;
    return meansOf(light.places.data(), light.places.data() + slice, offset, {x.share, y.share, z.share});
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
