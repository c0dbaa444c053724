#include "processing/document/view_picture.h"

#include <utility>

namespace echolucent {

std::optional<ViewPicture> viewPicture(const Document& document, std::size_t pane,
                                       std::span<const std::shared_ptr<const Volume>> scans, int width, int height,
                                       const Progress& progress, PictureQuality quality) {
    ViewCaster caster({.scans = {scans.begin(), scans.end()}});
    ViewOtf otf;
    if (needsComputedOtf(document, pane)) {
        auto computed = caster.otf(document, pane, progress);
        if (!computed) return std::nullopt;
        otf = std::move(*computed);
    }
    return caster.picture(document, pane, width, height, otf, progress, quality);
}

}  // namespace echolucent
