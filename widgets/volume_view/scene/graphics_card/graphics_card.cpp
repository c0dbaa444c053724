#include "widgets/volume_view/scene/graphics_card/graphics_card.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

// OpenGL's enumerations for free memory in KiB, of GL_NVX_gpu_memory_info and GL_ATI_meminfo.
constexpr unsigned freeMemoryNvx = 0x9049;
constexpr unsigned freeTextureMemoryAti = 0x87FC;

std::string rendererStringIn(const std::string& capabilities) {
    const std::string key = "OpenGL renderer string:";
    const std::size_t found = capabilities.find(key);
    if (found == std::string::npos) return {};
    const std::size_t begin = capabilities.find_first_not_of(' ', found + key.size());
    return capabilities.substr(begin, capabilities.find('\n', begin) - begin);
}

std::string megabytes(std::int64_t bytes) {
    return std::to_string(static_cast<std::int64_t>(std::ceil(static_cast<double>(bytes) / (1 << 20)))) + " MB";
}

}  // namespace

GraphicsCard graphicsCardOf(vtkOpenGLRenderWindow& window) {
    const std::string capabilities = window.ReportCapabilities();
    GraphicsCard card;
    card.renderer = rendererStringIn(capabilities);
    if (card.renderer.empty()) card.renderer = "unknown";
    card.largestTextureSide = vtkTextureObject::GetMaximumTextureSize3D(&window);
    std::array<int, 4> kibibytes{-1, -1, -1, -1};
    if (capabilities.find("GL_NVX_gpu_memory_info") != std::string::npos) {
        window.GetState()->vtkglGetIntegerv(freeMemoryNvx, kibibytes.data());
    } else if (capabilities.find("GL_ATI_meminfo") != std::string::npos) {
        window.GetState()->vtkglGetIntegerv(freeTextureMemoryAti, kibibytes.data());
    }
    if (kibibytes[0] > 0) card.freeBytes = std::int64_t{kibibytes[0]} * 1024;
    return card;
}

bool isSoftwareOpenGl(std::string_view renderer) {
    const std::string lower = lowerCase(renderer);
    constexpr std::array names{"llvmpipe",    "softpipe",    "swr",      "software rasterizer",
                               "swiftshader", "gdi generic", "mesa x11", "microsoft basic render"};
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return lower.find(name) != std::string::npos; });
}

std::string whyTooLarge(const VolumeGeometry& geometry, std::int64_t bytes, const GraphicsCard& card) {
    const std::int64_t longest = *std::max_element(geometry.size.begin(), geometry.size.end());
    if (longest > card.largestTextureSide) {
        return "The volume is too large for the graphics card: it has " + std::to_string(longest) +
               " voxels along an axis, the card takes " + std::to_string(card.largestTextureSide) + ".";
    }
    if (card.freeBytes >= 0 && bytes > card.freeBytes) {
        return "The volume is too large for the graphics card: it needs " + megabytes(bytes) + " of its memory, " +
               megabytes(card.freeBytes) + " are free.";
    }
    return {};
}

}  // namespace echolucent
