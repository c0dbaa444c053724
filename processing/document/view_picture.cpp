#include "processing/document/view_picture.h"

#include <utility>

namespace echolucent {

std::optional<ViewPicture> viewPicture(const Document& document, int view,
                                       std::span<const std::shared_ptr<const Volume>> scans, int width, int height,
                                       const Progress& progress) {
    ViewCaster caster({.scans = {scans.begin(), scans.end()}});
    ViewOtf otf;
    if (needsComputedOtf(document, view)) {
        auto computed = caster.otf(document, view, progress);
        if (!computed) return std::nullopt;
        otf = std::move(*computed);
    }
    return caster.picture(document, view, width, height, otf, progress);
}

}  // namespace echolucent
