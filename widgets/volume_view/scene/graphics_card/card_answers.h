// What a graphics card answers. A test may answer in its place.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "processing/picture/picture.h"
#include "widgets/volume_view/scene/graphics_card/graphics_card.h"

namespace echolucent {

/// The errors after which a card does not draw. Others are of no matter where the known picture is right: VTK and
/// drivers leave some of their own.
enum class CardError { none, outOfMemory, contextLost };

/// The newest error of OpenGL since the last call; the window's context must be current.
[[nodiscard]] CardError newestCardError(vtkOpenGLRenderWindow& window);

/// The questions that only a card can answer. By default it is asked.
struct CardAnswers {
    /// What the card says of itself; the window's context is current.
    std::function<GraphicsCard(vtkOpenGLRenderWindow&)> describe = graphicsCardOf;
    /// What went wrong since the last question.
    std::function<CardError(vtkOpenGLRenderWindow&)> error = newestCardError;
    /// The source of a shader as the card's driver is given it.
    std::function<std::string(std::string)> shaderSource = [](std::string source) { return source; };
    /// How the card drew the known picture. It is given what was read back.
    std::function<Picture(Picture)> drewKnownPicture = [](Picture picture) { return picture; };
};

}  // namespace echolucent
