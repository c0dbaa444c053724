#include "processing/ray_caster/packet_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/ray_caster/packet_tile_words.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/packet_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {
// Highway's dispatch tables need plain functions.
void castTileOfWords(const KernelJob<std::uint16_t>& job, const Tile& tile) { castPackets(job, tile); }
}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {
HWY_EXPORT(castTileOfWords);
template <>
void castTile(const KernelJob<std::uint16_t>& job, const Tile& tile) {
    HWY_DYNAMIC_DISPATCH(castTileOfWords)(job, tile);
}
}  // namespace echolucent::ray_casting
#endif
