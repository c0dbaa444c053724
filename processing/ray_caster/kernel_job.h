// A picture's task for the kernel, as plain pointers and numbers, and the kernel's entry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "processing/picture/picture.h"
#include "processing/picture/render_mode.h"
#include "processing/ray_caster/light_source.h"
#include "processing/ray_caster/packed/border_space.h"
#include "processing/ray_caster/packed/packed_light.h"
#include "processing/ray_caster/packed/packed_voxels.h"
#include "processing/ray_caster/packed/transfer_table.h"
#include "processing/ray_caster/ray_geometry.h"

namespace echolucent::ray_casting {

/// The two tints and their depths.
struct DepthTint {
    std::array<float, 3> near{}, change{};  ///< tint = near + change * t
    double nearDepthMm = 0.0, perMm = 0.0;  ///< t = (depth - nearDepth) * perMm
};

/// Table positions of the samples of one view, so that a picture with another curve need not sample again. The samples
/// of a packet of rays follow each other: all rays' first samples, then all rays' second samples and so on. A kept
/// value is the table position times KernelJob::keptPerPosition, in shaded and plain pictures alike. The presence of
/// data is looked up again.
struct KeptSamples {
    static constexpr float perTablePosition = 32.0f;
    static constexpr float perByte = 256.0f;
    struct Packet {
        std::int64_t first = 0;  ///< number of the first sample kept
        std::vector<std::uint16_t> samples;
    };
    std::vector<Packet> packets;  ///< row-major
};

/// A two-dimensional OTF for the kernel.
struct TwoDimensionalNodes {
    const float* opacities = nullptr;  ///< TwoDimensionalOtf::opacities
    int intensities = 2, gradients = 2;
    const std::uint8_t* cubes = nullptr;  ///< PackedGradients
    float firstVisible = 0.0f;            ///< table positions up to this one show nothing at any gradient
};

template <typename Voxel>
struct KernelJob {
    const PackedVoxels<Voxel>* voxels = nullptr;
    const std::uint8_t* presence = nullptr;  ///< PackedPresence; null if all voxels carry data
    VolumeGeometry geometry;
    const RayGeometry* rays = nullptr;
    float toTable = 0.0f;  ///< factor from a packed value to its table position
    const TransferTable* table = nullptr;
    const ColourBends* colourBends = nullptr;  ///< null unless DirectKernel casts plainly (castPlainly())
    /// For bytes of a white level of at least ByteOpacities::leastWhite. If null, the kernel reads `table`.
    const ByteOpacities* byteOpacities = nullptr;
    const TwoDimensionalNodes* twoDimensional = nullptr;  ///< null if `table` gives opacities
    const LightSource* light = nullptr;                   ///< null if no gradient is needed
    const PackedLight* reaching = nullptr;                ///< null if the light asks for no light volume
    float stepUnits = 1.0f;                               ///< RayCastSettings::step
    float worthGradient = 0.0f;                           ///< LightSource::worthGradient for the step
    const DepthTint* depthTint = nullptr;
    const std::uint8_t* distances = nullptr;  ///< EmptySpace; null if rays may not jump
    const BorderSpace* borders = nullptr;     ///< null if data ends nowhere
    std::array<std::int64_t, 3> bricks{};
    RenderMode mode = RenderMode::direct;
    ColourMap colourMap = ColourMap::sepia;
    bool nearest = false;
    double endTransmittance = 0.0;
    KeptSamples* kept = nullptr;                            ///< the kernel fills it, or uses it if it is full
    float keptPerPosition = KeptSamples::perTablePosition;  ///< perByte / toTable, if byteOpacities is set
    Picture* picture = nullptr;
    int apart = 1;                         ///< pixels from one ray to the next, along rows and columns
    const std::uint8_t* chosen = nullptr;  ///< direct mode only: not 0 where a ray is cast, row-major; null for all
};

/// Pixels [firstColumn, lastColumn) x [firstRow, lastRow). The first pixel is at the corner of a packet.
struct Tile {
    int firstColumn, lastColumn, firstRow, lastRow;
};

/// Casts the rays of a tile with the widest vectors of the machine.
template <typename Voxel>
void castTile(const KernelJob<Voxel>& job, const Tile& tile);

/// Columns and rows of a packet of rays on the machine at hand.
struct PacketShape {
    int columns, rows;
};
[[nodiscard]] PacketShape packetShape();

}  // namespace echolucent::ray_casting
