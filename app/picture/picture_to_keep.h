// The 3D view's picture as it is handed over: converged, with the measurements drawn over it.
#pragma once

#include <QImage>

#include "processing/document/document.h"
#include "processing/volume/volume.h"

namespace echolucent {

class VolumeViewWidget;

/// VolumeViewWidget::convergedImage() with the document's measurements of the phase that its view shows, as panes draw
/// them. `geometry` is that of the volume shown. The image is null where the view was never drawn.
[[nodiscard]] QImage pictureToKeep(VolumeViewWidget& picture, const Document& document, int view,
                                   const VolumeGeometry& geometry);

}  // namespace echolucent
