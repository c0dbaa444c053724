// Volumes whose voxels are counted one by one, for the tests of histograms.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"
#include "tests/processing/grids.h"

namespace echolucent {

/// Lines of 10,007 scattered voxels of every type, each without a mask and with one.
inline std::vector<Volume> scatteredLines() {
    constexpr std::int64_t count = 10007;  // no multiple of anything
    std::vector<std::uint8_t> bytes, mask;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t random = i * 2654435761U >> 7;
        bytes.push_back(static_cast<std::uint8_t>(random));
        words.push_back(static_cast<std::uint16_t>(random));
        floats.push_back(static_cast<float>(random % 7001) - 100.0F);
        mask.push_back(random % 3 != 0 ? 1 : 0);
    }
    const VolumeGeometry line = gridOf({count, 1, 1});
    std::vector<Volume> volumes;
    for (const Volume& volume :
         {Volume(line, bytes, 200.0), Volume(line, words, 60000.0), Volume(line, floats, 5000.0)}) {
        volumes.push_back(volume);
        volumes.push_back(volume.withDataMask(mask));
    }
    return volumes;
}

}  // namespace echolucent
