#include "widgets/volume_view/scene/annotation/overlay_lines.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>

#include <optional>

namespace echolucent {

void OverlayLines::addTo(vtkRenderer* renderer) { renderer->AddActor2D(m_lines.actor()); }

void OverlayLines::setVisible(bool visible) { m_lines.actor()->SetVisibility(visible); }

void OverlayLines::layOut(int viewportWidth, int viewportHeight, double scale, const Camera& camera) {
    m_lines.clear();
    const auto pixelOf = [&](const PicturePlace& place) {
        return Point2(viewportWidth / 2.0 + place[0] * viewportHeight,
                      viewportHeight / 2.0 - place[1] * viewportHeight);
    };
    for (const SpaceLine& line : m_overlay.spaceLines) {
        const auto from = placeInPicture(camera, line.from), to = placeInPicture(camera, line.to);
        if (from && to) m_lines.addLine(pixelOf(*from), pixelOf(*to), line.width * scale, line.colour);
    }
    for (const SpaceDisc& disc : m_overlay.discs)
        if (const auto at = placeInPicture(camera, disc.at))
            m_lines.addDisc(pixelOf(*at), disc.radius * scale, disc.colour);
    for (const PictureLine& line : m_overlay.pictureLines)
        for (std::size_t i = 1; i < line.places.size(); ++i)
            m_lines.addLine(pixelOf(line.places[i - 1]), pixelOf(line.places[i]), line.width * scale, line.colour);
}

}  // namespace echolucent
