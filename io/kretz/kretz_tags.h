// The item tags that reader and writer of GE Voluson (Kretz) volumes know (docs/formats-read.md).
#pragma once

#include <cstdint>
#include <numbers>
#include <string>

namespace echolucent {

/// Group and element of an item.
struct KretzTag {
    std::uint16_t group = 0;
    std::uint16_t element = 0;
    friend bool operator==(const KretzTag&, const KretzTag&) = default;
};
/// The tag as reports show it: "C000:0001".
[[nodiscard]] std::string tagText(KretzTag tag);

}  // namespace echolucent

namespace echolucent::kretz {

constexpr KretzTag samples{0xC000, 0x0001}, lines{0xC000, 0x0002}, planes{0xC000, 0x0003};
constexpr KretzTag resolution{0xC100, 0x0001};   ///< m from sample to sample
constexpr KretzTag firstSample{0xC200, 0x0001};  ///< samples from the axis of the lines to the first sample
constexpr KretzTag planesAxis{0xC200, 0x0002};   ///< samples from the axis of the planes to that of the lines
constexpr KretzTag planeAngles{0xC300, 0x0001}, lineAngles{0xC300, 0x0002};  ///< radians; a quarter turn is straight on
constexpr KretzTag cartesianSpacing{0x0010, 0x0022};                         ///< mm
constexpr KretzTag voxels{0xD000, 0x0001};
constexpr KretzTag filteredVoxels{0xD000, 0x0002};
constexpr KretzTag sequenceVoxels{0xD600, 0x0001};  ///< voxels of all phases, one phase after another
/// Compressed volumes: grey values, colour flow and power Doppler.
constexpr KretzTag compressedVoxels[] = {{0x0002, 0x1000}, {0x0002, 0x1100}, {0x0002, 0x1200}};
/// Volumes of colour flow and power Doppler.
constexpr KretzTag colourVoxels{0xD000, 0x0101}, powerVoxels{0xD000, 0x0201};
constexpr KretzTag end{0xFFFF, 0xFFFF};

/// The stored value of angle 0, radians.
constexpr double straightOn = std::numbers::pi / 2;

}  // namespace echolucent::kretz
