#include "widgets/volume_view/scene/graphics_card/card_answers.h"

#include <vtk_glew.h>

namespace echolucent {

CardError newestCardError(vtkOpenGLRenderWindow&) {
    constexpr unsigned lostContext = 0x0507;  // GL_CONTEXT_LOST, which OpenGL 4.5 brought
    constexpr int mostFlags = 16;             // a context that is lost may answer for ever
    CardError newest = CardError::none;
    for (int i = 0; i < mostFlags; ++i) {
        const unsigned code = glGetError();
        if (code == GL_NO_ERROR) break;
        if (code == lostContext) return CardError::contextLost;
        if (code == GL_OUT_OF_MEMORY) newest = CardError::outOfMemory;
    }
    return newest;
}

}  // namespace echolucent
