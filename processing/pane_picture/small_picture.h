// Pictures of panes for galleries: small, quick and smooth.
#pragma once

#include <optional>

#include "processing/document/document.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"

namespace echolucent {

/// A pane's picture, `width` x `height` pixels, each the mean of four rays in quick quality (PictureQuality::quick).
/// The caster keeps the samples of a view's second picture for the next curve (RayCaster::cast()). The result is empty
/// only if progress.cancel was raised.
[[nodiscard]] std::optional<Picture> smallPicture(PaneCaster& caster, const Document& document, std::size_t pane,
                                                  int width, int height, const Progress& progress = {});
/// The same with `otf` in place of the pane's computed OTF.
[[nodiscard]] std::optional<Picture> smallPictureWith(PaneCaster& caster, const PaneOtf& otf, const Document& document,
                                                      std::size_t pane, int width, int height,
                                                      const Progress& progress = {});

}  // namespace echolucent
