// Simulated scans with the probe on any side, and scanners' sectors.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

inline constexpr std::array<BeamAxis, 6> allBeamAxes{BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                                                     BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};

/// Where a voxel of a volume with the beam +z goes if its beam becomes another axis.
struct Turn {
    std::array<std::int64_t, 3> from;
    BeamAxis beam;

    [[nodiscard]] std::size_t axis() const { return static_cast<std::size_t>(beam) / 2; }
    [[nodiscard]] std::array<std::int64_t, 3> size() const { return turned(from); }
    [[nodiscard]] std::array<std::int64_t, 3> turned(const std::array<std::int64_t, 3>& value) const {
        std::array<std::int64_t, 3> result{};
        result[(axis() + 1) % 3] = value[0];
        result[(axis() + 2) % 3] = value[1];
        result[axis()] = value[2];
        return result;
    }
    template <typename Voxel>
    [[nodiscard]] std::vector<Voxel> operator()(const VoxelArray<Voxel>& voxels) const {
        const auto to = size();
        std::vector<Voxel> result(voxels.size());
        std::size_t i = 0;
        for (std::int64_t z = 0; z < from[2]; ++z)
            for (std::int64_t y = 0; y < from[1]; ++y)
                for (std::int64_t x = 0; x < from[0]; ++x) {
                    const bool reversed = static_cast<int>(beam) % 2 == 1;
                    const auto place = turned({x, y, reversed ? from[2] - 1 - z : z});
                    result[static_cast<std::size_t>(place[0] + to[0] * (place[1] + to[1] * place[2]))] = voxels[i++];
                }
        return result;
    }
};

/// The 8-bit volume (beam +z) and its mask with the probe on another side.
inline Volume turnedTo(const Volume& volume, const DataMask& mask, BeamAxis beam) {
    const Turn turn{volume.geometry().size, beam};
    VolumeGeometry geometry;
    geometry.size = turn.size();
    const Volume turned(geometry, turn(std::get<VoxelArray<std::uint8_t>>(volume.voxels())), 255.0);
    return mask.empty() ? turned : turned.withDataMask(turn(mask));
}

enum class Sector { none, cone, pyramid, convexFan };

/// Which voxels a sector scan along +z reaches.
inline std::vector<std::uint8_t> sectorMask(Sector sector, const std::array<std::int64_t, 3>& size) {
    if (sector == Sector::none) return {};
    const auto depth = static_cast<double>(size[2]);
    const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
    std::vector<std::uint8_t> mask;
    for (std::int64_t k = 0; k < size[2]; ++k)
        for (std::int64_t j = 0; j < size[1]; ++j)
            for (std::int64_t i = 0; i < size[0]; ++i) {
                const double x = static_cast<double>(i) - static_cast<double>(size[0] - 1) / 2;
                const double y = static_cast<double>(j) - static_cast<double>(size[1] - 1) / 2;
                const double z = static_cast<double>(k) + 1, radius = depth / 2;
                bool reached = std::hypot(x, y, z) <= depth;
                if (sector == Sector::cone) reached = reached && std::hypot(x, y) <= tangent(30) * z;
                if (sector == Sector::pyramid)
                    reached = reached && std::abs(x) <= tangent(40) * z && std::abs(y) <= tangent(30) * z;
                if (sector == Sector::convexFan)
                    reached = std::abs(x) <= tangent(15) * (z + radius) && std::hypot(x, z + radius) >= radius &&
                              std::hypot(x, z + radius) <= radius + depth;
                mask.push_back(reached ? 1 : 0);
            }
    return mask;
}

}  // namespace echolucent
