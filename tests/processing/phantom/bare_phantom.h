// Phantoms with materials only.
#pragma once

#include <array>
#include <cstdint>

#include "processing/phantom/phantom.h"

namespace echolucent {

/// A phantom of this many voxels without speckle, ramp, gain variation and loss.
inline PhantomConfig barePhantom(PhantomScene scene, const std::array<std::int64_t, 3>& size) {
    PhantomConfig config;
    config.scene = scene;
    config.size = size;
    config.speckle = 0;
    config.ramp = 0;
    config.gainVariation = 0;
    return config;
}

}  // namespace echolucent
