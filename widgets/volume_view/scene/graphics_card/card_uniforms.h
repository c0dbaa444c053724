// The numbers of a picture for the shader.
#pragma once

#include "processing/card_picture/card_picture.h"

class vtkShaderProgram;

namespace echolucent {

/// Sets all uniforms of cardShader() but its textures. `settings` as there. `weight` scales colours and alpha.
void setCardUniforms(vtkShaderProgram& program, const CardPicture& picture, const RayCastSettings& settings,
                     double weight);

}  // namespace echolucent
