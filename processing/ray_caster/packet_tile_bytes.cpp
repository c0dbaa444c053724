#include "processing/ray_caster/packet_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "processing/ray_caster/packet_tile_bytes.cpp"
#include <hwy/foreach_target.h>

#include "processing/ray_caster/packet_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {
// Highway's dispatch tables need plain functions.
void castTileOfBytes(const KernelJob<std::uint8_t>& job, const Tile& tile) { castPackets(job, tile); }
PacketShape shapeOfPackets() { return {packetColumns, packetRows}; }
}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace echolucent::ray_casting {
HWY_EXPORT(castTileOfBytes);
template <>
void castTile(const KernelJob<std::uint8_t>& job, const Tile& tile) {
    HWY_DYNAMIC_DISPATCH(castTileOfBytes)(job, tile);
}

HWY_EXPORT(shapeOfPackets);
PacketShape packetShape() { return HWY_DYNAMIC_DISPATCH(shapeOfPackets)(); }
}  // namespace echolucent::ray_casting
#endif
