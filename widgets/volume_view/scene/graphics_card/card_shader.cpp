#include "widgets/volume_view/scene/graphics_card/card_shader.h"

#include <variant>

#include "widgets/volume_view/scene/graphics_card/card_shader_parts.h"

namespace echolucent {

std::string cardShader(const CardPicture& picture, const RayCastSettings& settings, CardReading reading) {
    const bool isDirect = settings.mode == RenderMode::direct;
    // VTK writes the version and the outputs in place of these lines.
    std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\n";
    const auto define = [&](const char* name, bool holds) {
        if (holds) source += std::string("#define ") + name + "\n";
    };
    define("EIGHT_FETCHES", reading == CardReading::eightFetches);
    define("NEAREST", settings.interpolation == Interpolation::nearest);
    define("PRESENCE", picture.presence != nullptr);
    define("PARALLEL", picture.rays.parallel);
    define("BOWED", picture.surface != nullptr);
    define("TWO_DIMENSIONAL", isDirect && picture.gradients);
    define("LIT", isDirect && settings.shading.has_value());
    define("REACHING", isDirect && settings.shading && picture.light);
    define("TINTED", isDirect && settings.depthColouring.has_value());
    define("JUMPS", isDirect && picture.bricks);
    define("MEAN", settings.mode == RenderMode::mean);
    define("MINIMUM", settings.mode == RenderMode::minimum);
    const bool bytes = std::holds_alternative<VoxelArray<std::uint8_t>>(picture.scan->filled.voxels());
    source += std::string("#define BYTES ") + (bytes ? "true" : "false") + "\n";
    source += "#define HALF_SPACES " + std::to_string(picture.rays.halfSpaces.size()) + "\n";
    source += std::string(card_shader::samplesPart) + card_shader::raysPart;
    if (picture.surface) source += card_shader::frontPart;
    source += card_shader::stepsPart;
    if (isDirect)
        source += std::string(card_shader::opacitiesPart) + card_shader::lightPart + card_shader::directPart;
    else
        source += card_shader::extremesPart;
    return source + card_shader::pixelPart;
}

}  // namespace echolucent
