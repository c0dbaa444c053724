// What the kernel needs to know of a picture, as plain pointers and numbers; and its entry.
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

/// The two tints and the depths they belong to.
struct DepthTint {
    std::array<float, 3> near{}, change{};  ///< tint = near + change * t
    double nearDepthMm = 0.0, perMm = 0.0;  ///< t = (depth - nearDepth) * perMm
};

/// Table positions of the samples of one view, so that another curve need not sample again. Samples of a packet of rays
/// follow each other: all rays' first samples, then all rays' second samples and so on. Each is the table position
/// times KernelJob::keptPerPosition, in a shaded picture as in a plain one. What the presence of data leaves of them is
/// looked up anew.
struct KeptSamples {
    static constexpr float perTablePosition = 32.0f;
    static constexpr float perByte = 256.0f;
    struct Packet {
        std::int64_t first = 0;  ///< number of the first sample kept
        std::vector<std::uint16_t> samples;
    };
    std::vector<Packet> packets;  ///< row-major
};

/// A two-dimensional OTF as the kernel reads it.
struct TwoDimensionalNodes {
    const float* opacities = nullptr;  ///< TwoDimensionalOtf::opacities
    int intensities = 2, gradients = 2;
    const std::uint8_t* cubes = nullptr;  ///< PackedGradients
    float firstVisible = 0.0f;            ///< table positions up to this one show nothing at any gradient
};

template <typename Voxel>
struct KernelJob {
    const PackedVoxels<Voxel>* voxels = nullptr;
    const std::uint8_t* presence = nullptr;  ///< PackedPresence; null where all voxels carry data
    VolumeGeometry geometry;
    const RayGeometry* rays = nullptr;
    float toTable = 0.0f;  ///< factor from a packed value to its table position
    const TransferTable* table = nullptr;
    const ColourBends* colourBends = nullptr;  ///< null where the picture has light, depth colours or depths
    /// For bytes of a white level of at least ByteOpacities::leastWhite; where it is null, `table` is read.
    const ByteOpacities* byteOpacities = nullptr;
    const TwoDimensionalNodes* twoDimensional = nullptr;  ///< null where `table` tells opacities
    const LightSource* light = nullptr;                   ///< null where no gradient is computed
    const PackedLight* reaching = nullptr;                ///< null where the light asks for none
    float stepUnits = 1.0f;                               ///< RayCastSettings::step
    float worthGradient = 0.0f;                           ///< LightSource::worthGradient for the step
    const DepthTint* depthTint = nullptr;
    const std::uint8_t* distances = nullptr;  ///< EmptySpace; null where nothing may be jumped over
    const BorderSpace* borders = nullptr;     ///< null where data ends nowhere
    std::array<std::int64_t, 3> bricks{};
    RenderMode mode = RenderMode::direct;
    ColourMap colourMap = ColourMap::sepia;
    bool nearest = false;
    double endTransmittance = 0.0;
    KeptSamples* kept = nullptr;                            ///< it is filled, or used where it is filled already
    float keptPerPosition = KeptSamples::perTablePosition;  ///< where byteOpacities is set, perByte / toTable
    Picture* picture = nullptr;
};

/// Pixels [firstColumn, lastColumn) x [firstRow, lastRow); the first ones at the corner of a packet.
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
