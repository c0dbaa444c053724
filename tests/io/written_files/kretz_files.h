// Kretz volumes for tests, as bytes, item by item.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "io/writers/kretz_writer.h"
#include "temporary_folder.h"

namespace echolucent {

/// One item: group, element, length, value.
inline std::string kretzItem(std::uint16_t group, std::uint16_t element, const std::string& value) {
    return bytesFrom<std::uint16_t>({group, element}) +
           bytesFrom<std::uint32_t>({static_cast<std::uint32_t>(value.size())}) + value;
}

inline std::string kretzWhole(std::uint16_t group, std::uint16_t element, std::uint16_t value) {
    return kretzItem(group, element, bytesFrom<std::uint16_t>({value}));
}

/// The items of a volume's size.
inline std::string kretzSize(std::uint16_t samples, std::uint16_t lines, std::uint16_t planes) {
    return kretzWhole(0xC000, 1, samples) + kretzWhole(0xC000, 2, lines) + kretzWhole(0xC000, 3, planes);
}

inline std::string kretzNumbers(std::uint16_t group, std::uint16_t element, const std::vector<double>& values) {
    return kretzItem(group, element, bytesFrom<double>(values));
}

/// The parts of a small toroidal volume. Tests change them one by one. Unset texts are left out.
struct KretzParts {
    std::string signature = "KRETZFILE 1.0   ";
    std::string size = kretzSize(20, 5, 4);
    std::string resolution = kretzNumbers(0xC100, 1, {0.0005});
    std::string firstSample = kretzNumbers(0xC200, 1, {80});
    std::string planesAxis = kretzNumbers(0xC200, 2, {-30});
    std::string planeAngles = kretzNumbers(0xC300, 1, {1.4, 1.5, 1.6, 1.7});
    std::string lineAngles = kretzNumbers(0xC300, 2, {1.3, 1.4, 1.5, 1.6, 1.7});
    std::string voxels = kretzItem(0xD000, 1, std::string(400, 'v'));
    std::string more;
    std::string end = kretzItem(0xFFFF, 0xFFFF, "");

    [[nodiscard]] std::string bytes() const {
        // Readers skip what a scanner writes about itself and the patient.
        return signature + kretzItem(0x0000, 1, "\1\2") + kretzItem(0x0110, 2, "Doe^Jane") + size + resolution +
               firstSample + planesAxis + planeAngles + lineAngles + voxels + more + end;
    }
};

}  // namespace echolucent
