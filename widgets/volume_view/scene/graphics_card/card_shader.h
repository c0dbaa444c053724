// The fragment shader that casts a pixel's ray as castRays() does.
#pragma once

#include <string>

#include "processing/card_picture/card_picture.h"

namespace echolucent {

/// How a card reads between voxels.
enum class CardReading {
    filter,        ///< by its own linear filter, which knows 8 bits between two voxels
    eightFetches,  ///< eight voxels and their mean in single precision; eight reads for one
};

/// The shader's source for a picture, with the parts that this picture needs. Pictures of one source differ in uniforms
/// and textures. `settings` are those of the picture or of the one mixed into it.
[[nodiscard]] std::string cardShader(const CardPicture& picture, const RayCastSettings& settings, CardReading reading);

}  // namespace echolucent
