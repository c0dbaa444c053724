#include "processing/ray_caster/packet_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/ray_caster/packet_tile_floats.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/packet_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {
// Highway's dispatch tables need plain functions.
void castTileOfFloats(const KernelJob<float>& job, const Tile& tile) { castPackets(job, tile); }
}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {
HWY_EXPORT(castTileOfFloats);
template <>
void castTile(const KernelJob<float>& job, const Tile& tile) {
    HWY_DYNAMIC_DISPATCH(castTileOfFloats)(job, tile);
}
}  // namespace echolucent::ray_casting
#endif
