#include "widgets/volume_view/scene/annotation/overlay_lines.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <array>
#include <cmath>
#include <vector>

#include "processing/scene/shown_measurement.h"
#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

OverlayLines::OverlayLines() = default;
OverlayLines::~OverlayLines() = default;

void OverlayLines::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
    renderer->AddActor2D(m_lines.actor());
}

void OverlayLines::setVisible(bool visible) {
    m_visible = visible;
    m_lines.actor()->SetVisibility(visible);
    for (const auto& text : m_texts)
        if (!visible) text->VisibilityOff();
}

void OverlayLines::layOut(int viewportWidth, int viewportHeight, double scale, const Camera& camera) {
    m_lines.clear();
    m_lines.setViewport(viewportWidth, viewportHeight);
    const auto pixelOf = [&](const PicturePlace& place) {
        return Point2(viewportWidth / 2.0 + place[0] * viewportHeight,
                      viewportHeight / 2.0 - place[1] * viewportHeight);
    };
    for (const SpaceLine& line : m_overlay.spaceLines) {
        const auto from = placeInPicture(camera, line.from), to = placeInPicture(camera, line.to);
        if (from && to) m_lines.addLine(pixelOf(*from), pixelOf(*to), line.width * scale, line.colour);
    }
    for (const SpacePath& path : m_overlay.spacePaths) {
        std::vector<Point2> points;
        for (const Vec3& place : path.places)
            if (const auto at = placeInPicture(camera, place)) points.push_back(pixelOf(*at));
        if (points.size() < path.places.size()) continue;
        if (path.dash > 0.0 && path.gap > 0.0)
            m_lines.addDashedPath(points, path.width * scale, path.colour, path.dash * scale, path.gap * scale);
        else
            m_lines.addPath(points, path.width * scale, path.colour);
    }
    for (const SpaceDisc& disc : m_overlay.discs)
        if (const auto at = placeInPicture(camera, disc.at))
            m_lines.addDisc(pixelOf(*at), disc.radius * scale, disc.colour);
    for (const PictureLine& line : m_overlay.pictureLines)
        for (std::size_t i = 1; i < line.places.size(); ++i)
            m_lines.addLine(pixelOf(line.places[i - 1]), pixelOf(line.places[i]), line.width * scale, line.colour);
    layOutTexts(viewportWidth, viewportHeight, scale, camera);
}

void OverlayLines::layOutTexts(int viewportWidth, int viewportHeight, double scale, const Camera& camera) {
    while (m_texts.size() < m_overlay.texts.size()) {
        m_texts.push_back(vtkSmartPointer<vtkTextActor>::New());
        m_texts.back()->GetTextProperty()->SetVerticalJustificationToCentered();
        m_renderer->AddActor2D(m_texts.back());
    }
    const double height = viewportHeight;
    std::vector<vtkTextActor*> shown;
    std::vector<MeasurementWords> words;
    std::vector<double> gaps;
    for (std::size_t i = 0; i < m_texts.size(); ++i) {
        vtkTextActor& actor = *m_texts[i];
        actor.SetVisibility(false);
        if (i >= m_overlay.texts.size() || !m_visible) continue;
        const SpaceText& text = m_overlay.texts[i];
        std::vector<PicturePlace> places;
        for (const Vec3& place : text.beside)
            if (const auto at = placeInPicture(camera, place)) places.push_back(*at);
        if (places.size() < text.beside.size()) continue;  // a place lies behind the eye
        styleAnnotation(actor, text.colour);
        actor.SetInput(text.text.c_str());
        std::array<double, 2> size{};
        actor.GetSize(m_renderer, size.data());
        gaps.push_back(text.gap * scale);
        words.push_back({places, (size[0] + gaps.back()) / height, size[1] / height});
        shown.push_back(&actor);
    }
    const std::vector<MeasurementLabel> labels = labelsOf(words, viewportWidth / height);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const MeasurementLabel& label = labels[i];
        label.toTheRight ? shown[i]->GetTextProperty()->SetJustificationToLeft()
                         : shown[i]->GetTextProperty()->SetJustificationToRight();
        const double x = viewportWidth / 2.0 + label.at[0] * height + (label.toTheRight ? gaps[i] : -gaps[i]);
        shown[i]->SetDisplayPosition(static_cast<int>(std::lround(x)),
                                     static_cast<int>(std::lround(height / 2.0 - label.at[1] * height)));
        shown[i]->SetVisibility(true);
    }
}

}  // namespace echolucent
