// What OpenGL says about the graphics card, and whether a volume fits on it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "processing/volume/volume.h"

class vtkOpenGLRenderWindow;

namespace echolucent {

struct GraphicsCard {
    std::string renderer;         ///< OpenGL's renderer string; empty if not known yet
    int largestTextureSide = 0;   ///< voxels along an axis of a 3D texture
    std::int64_t freeBytes = -1;  ///< of memory; -1 if the card does not tell
};

/// Asks OpenGL; the window's context must be current.
[[nodiscard]] GraphicsCard graphicsCardOf(vtkOpenGLRenderWindow& window);

/// True for OpenGL that runs on the processor (llvmpipe, softpipe, SWR, SwiftShader, ...), by its renderer string.
[[nodiscard]] bool isSoftwareOpenGl(std::string_view renderer);

/// A sentence that says why a card cannot hold a volume; empty if it can.
[[nodiscard]] std::string whyTooLarge(const VolumeGeometry& geometry, std::int64_t bytes, const GraphicsCard& card);

}  // namespace echolucent
