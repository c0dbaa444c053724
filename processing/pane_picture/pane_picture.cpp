#include "processing/pane_picture/pane_picture.h"

namespace echolucent {

std::optional<PanePicture> panePicture(const Document& document, std::size_t pane,
                                       std::span<const std::shared_ptr<const Volume>> scans, int width, int height,
                                       const Progress& progress, PictureQuality quality) {
    PaneCaster caster({.scans = {scans.begin(), scans.end()}});
    return caster.picture(document, pane, width, height, progress, quality);
}

}  // namespace echolucent
