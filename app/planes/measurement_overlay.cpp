#include "app/planes/measurement_overlay.h"

#include <utility>

#include "app/planes/scene_colour.h"
#include "widgets/picture_labels/measurement_drawing.h"

namespace echolucent {

namespace {

const Colour measurementInScene = sceneColourOf(measurementColour);

void addLine(Overlay& overlay, const std::vector<Vec3>& places, bool dashed) {
    if (places.size() < 2) return;
    SpacePath line{places, measurementInScene, measurementLineWidth};
    if (dashed) {
        line.dash = measurementDash;
        line.gap = measurementDashGap;
    }
    overlay.spacePaths.push_back(std::move(line));
}

}  // namespace

Overlay overlayOf(const std::vector<ShownMeasurement>& shown) {
    Overlay overlay;
    for (const ShownMeasurement& each : shown) {
        addLine(overlay, each.placesMm, each.dashed);
        addLine(overlay, each.arcMm, each.dashed);
        for (const Vec3& place : each.placesMm)
            overlay.discs.push_back({place, measurementInScene, measurementMarkRadius});
        if (!each.text.empty())
            overlay.texts.push_back({each.placesMm, each.text, measurementInScene, measurementTextGap});
    }
    return overlay;
}

void append(Overlay& overlay, const Overlay& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(overlay.spaceLines, more.spaceLines);
    add(overlay.spacePaths, more.spacePaths);
    add(overlay.discs, more.discs);
    add(overlay.pictureLines, more.pictureLines);
    add(overlay.texts, more.texts);
}

PictureLine rubberLine(const PicturePlace& from, const PicturePlace& to) {
    return {{from, to}, measurementInScene, measurementLineWidth};
}

}  // namespace echolucent
