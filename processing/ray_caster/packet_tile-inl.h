// A tile of a picture, packet by packet.
#include <algorithm>

#include "processing/ray_caster/packet_direct-inl.h"
#include "processing/ray_caster/packet_extremes-inl.h"

#if defined(ECHOLUCENT_PACKET_TILE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef ECHOLUCENT_PACKET_TILE_INL
#undef ECHOLUCENT_PACKET_TILE_INL
#else
#define ECHOLUCENT_PACKET_TILE_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace echolucent::ray_casting::HWY_NAMESPACE {

/// Calls write(lane, offset of the pixel in the picture) for each ray of a packet.
template <typename Write>
void forEachPixel(const Picture& picture, int column, int row, const Write& write) {
    for (int i = 0; i < lanes; ++i) {
        const int x = column + i % packetColumns, y = row + i / packetColumns;
        if (x < picture.width && y < picture.height)
            write(i,
                  static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    }
}

template <typename Voxel>
KeptSamples::Packet* keptOf(const KernelJob<Voxel>& job, int column, int row) {
    if (job.kept == nullptr) return nullptr;
    const int packetsInRow = (job.picture->width + packetColumns - 1) / packetColumns;
    return &job.kept->packets[static_cast<std::size_t>(row / packetRows) * static_cast<std::size_t>(packetsInRow) +
                              static_cast<std::size_t>(column / packetColumns)];
}

template <typename Voxel>
void writeDirect(const KernelJob<Voxel>& job, const Gathered& gathered, int column, int row) {
    const Floats floats;
    Picture& picture = *job.picture;
    const auto rounded = [&](const double* values) {
        return inFloats([&](Doubles, int i) { return load(values + i); });
    };
    const auto one = set(1.0f);
    alignas(64) float rgba[lanes * 4];
    const auto opacity =
        inFloats([&](Doubles, int i) { return hn::Sub(setDouble(1.0), load(gathered.transmittance + i)); });
    hn::StoreInterleaved4(hn::Min(rounded(gathered.colour[0]), one), hn::Min(rounded(gathered.colour[1]), one),
                          hn::Min(rounded(gathered.colour[2]), one), opacity, floats, rgba);
    forEachPixel(picture, column, row, [&](int lane, std::size_t pixel) {
        std::copy_n(rgba + lane * 4, 4, &picture.rgba[pixel * 4]);
        if (!picture.depthMm.empty()) picture.depthMm[pixel] = gathered.depthMm[lane];
    });
}

template <typename Voxel, bool isTwoDimensional>
void castDirect(const KernelJob<Voxel>& job, DirectKernel<Voxel, isTwoDimensional>& kernel, int column, int row) {
    DirectRays<Voxel> rays(job, column, row, keptOf(job, column, row));
    if (rays.packet.empty()) return;
    kernel.cast(rays);
    writeDirect(job, rays.gathered, column, row);
}

template <typename Voxel>
void castExtremes(const KernelJob<Voxel>& job, const Packet<Voxel>& packet, ColourMap map, int column, int row) {
    Picture& picture = *job.picture;
    ExtremesKernel<Voxel> kernel(job, packet);
    kernel.cast();
    const Seen& seen = kernel.seen();
    forEachPixel(picture, column, row, [&](int lane, std::size_t pixel) {
        if (seen.count[lane] == 0.0) return;
        const double share = job.mode == RenderMode::mean ? 1.0 / seen.count[lane] : 1.0;
        const Vec3 colour = colourOf(map, seen.value[lane] * share / TransferTable::intervals);
        float* out = &picture.rgba[pixel * 4];
        for (int channel = 0; channel < 3; ++channel) out[channel] = static_cast<float>(colour[channel]);
        out[3] = 1.0f;
        if (!picture.depthMm.empty()) picture.depthMm[pixel] = seen.depthMm[lane];
    });
}

/// Calls cast(column, row) for each packet of a tile.
template <typename Cast>
void forEachPacket(const Tile& tile, const Cast& cast) {
    for (int row = tile.firstRow; row < tile.lastRow; row += packetRows)
        for (int column = tile.firstColumn; column < tile.lastColumn; column += packetColumns) cast(column, row);
}

template <bool isTwoDimensional, typename Voxel>
void castDirectPackets(const KernelJob<Voxel>& job, const Tile& tile) {
    DirectKernel<Voxel, isTwoDimensional> kernel(job);
    forEachPacket(tile, [&](int column, int row) { castDirect(job, kernel, column, row); });
}

template <typename Voxel>
void castPackets(const KernelJob<Voxel>& job, const Tile& tile) {
    if (job.mode == RenderMode::direct) {
        if (job.twoDimensional != nullptr) return castDirectPackets<true>(job, tile);
        return castDirectPackets<false>(job, tile);
    }
    forEachPacket(tile, [&](int column, int row) {
        const Packet<Voxel> packet(job, column, row);
        if (!packet.empty()) castExtremes(job, packet, job.colourMap, column, row);
    });
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
