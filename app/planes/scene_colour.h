// A colour of the window as the 3D view's scene takes it.
#pragma once

#include <QColor>

#include "widgets/volume_view/scene/annotation/overlay.h"

namespace echolucent {

/// The colour without its opacity.
[[nodiscard]] inline Colour sceneColourOf(const QColor& colour) {
    return {static_cast<unsigned char>(colour.red()), static_cast<unsigned char>(colour.green()),
            static_cast<unsigned char>(colour.blue())};
}

}  // namespace echolucent
