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

template <typename Voxel>
KeptSamples::Packet* keptOf(const KernelJob<Voxel>& job, int column, int row) {
    if (job.kept == nullptr) return nullptr;
    const int packetsInRow = (job.picture->width + packetColumns - 1) / packetColumns;
    return &job.kept->packets[static_cast<std::size_t>(row / packetRows) * static_cast<std::size_t>(packetsInRow) +
                              static_cast<std::size_t>(column / packetColumns)];
}

template <typename Voxel>
void writeDirect(const KernelJob<Voxel>& job, const Gathered& gathered, const PacketPixels& pixels) {
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
    pixels.forEachIn(picture, [&](int lane, std::size_t pixel) {
        std::copy_n(rgba + lane * 4, 4, &picture.rgba[pixel * 4]);
        if (!picture.depthMm.empty()) picture.depthMm[pixel] = gathered.depthMm[lane];
    });
}

template <typename Voxel, bool isTwoDimensional>
void castDirect(const KernelJob<Voxel>& job, DirectKernel<Voxel, isTwoDimensional>& kernel, const PacketPixels& pixels,
                KeptSamples::Packet* kept) {
    DirectRays<Voxel> rays(job, pixels, kept);
    if (rays.packet.empty()) return;
    kernel.cast(rays);
    writeDirect(job, rays.gathered, pixels);
}

template <typename Voxel>
void castExtremes(const KernelJob<Voxel>& job, const Packet<Voxel>& packet, const PacketPixels& pixels) {
    Picture& picture = *job.picture;
    ExtremesKernel<Voxel> kernel(job, packet);
    kernel.cast();
    const Seen& seen = kernel.seen();
    pixels.forEachIn(picture, [&](int lane, std::size_t pixel) {
        if (seen.count[lane] == 0.0) return;
        const double share = job.mode == RenderMode::mean ? 1.0 / seen.count[lane] : 1.0;
        const Vec3 colour = colourOf(job.colourMap, seen.value[lane] * share / TransferTable::intervals);
        float* out = &picture.rgba[pixel * 4];
        for (int channel = 0; channel < 3; ++channel) out[channel] = static_cast<float>(colour[channel]);
        out[3] = 1.0f;
        if (!picture.depthMm.empty()) picture.depthMm[pixel] = seen.depthMm[lane];
    });
}

/// Calls cast(pixels, column, row) for each packet of a tile.
template <typename Voxel, typename Cast>
void forEachPacket(const KernelJob<Voxel>& job, const Tile& tile, const Cast& cast) {
    for (int row = tile.firstRow; row < tile.lastRow; row += packetRows * job.apart)
        for (int column = tile.firstColumn; column < tile.lastColumn; column += packetColumns * job.apart)
            cast(PacketPixels::block(column, row, job.apart), column, row);
}
/// Calls cast(pixels) for packets of the chosen pixels of a tile: those of each block of 8 x 8 pixels follow each
/// other.
template <typename Voxel, typename Cast>
void forEachChosen(const KernelJob<Voxel>& job, const Tile& tile, const Cast& cast) {
    constexpr int edge = 8;
    PacketPixels pixels;
    const auto castAll = [&] {
        for (int i = pixels.count; i < lanes; ++i) {
            pixels.column[i] = pixels.column[0];
            pixels.row[i] = pixels.row[0];
        }
        cast(pixels);
        pixels.count = 0;
    };
    for (int top = tile.firstRow; top < tile.lastRow; top += edge)
        for (int left = tile.firstColumn; left < tile.lastColumn; left += edge)
            for (int row = top; row < std::min(top + edge, tile.lastRow); ++row)
                for (int column = left; column < std::min(left + edge, tile.lastColumn); ++column) {
                    if (job.chosen[row * std::ptrdiff_t{job.picture->width} + column] == 0) continue;
                    pixels.column[pixels.count] = column;
                    pixels.row[pixels.count] = row;
                    if (++pixels.count == lanes) castAll();
                }
    if (pixels.count > 0) castAll();
}

template <bool isTwoDimensional, typename Voxel>
void castDirectPackets(const KernelJob<Voxel>& job, const Tile& tile) {
    DirectKernel<Voxel, isTwoDimensional> kernel(job);
    if (job.chosen != nullptr)
        return forEachChosen(job, tile, [&](const PacketPixels& pixels) { castDirect(job, kernel, pixels, nullptr); });
    forEachPacket(job, tile, [&](const PacketPixels& pixels, int column, int row) {
        castDirect(job, kernel, pixels, keptOf(job, column, row));
    });
}

template <typename Voxel>
void castPackets(const KernelJob<Voxel>& job, const Tile& tile) {
    if (job.mode == RenderMode::direct) {
        if (job.twoDimensional != nullptr) return castDirectPackets<true>(job, tile);
        return castDirectPackets<false>(job, tile);
    }
    forEachPacket(job, tile, [&](const PacketPixels& pixels, int, int) {
        const Packet<Voxel> packet(job, pixels);
        if (!packet.empty()) castExtremes(job, packet, pixels);
    });
}

}  // namespace echolucent::ray_casting::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
