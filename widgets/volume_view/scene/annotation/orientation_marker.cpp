#include "widgets/volume_view/scene/annotation/orientation_marker.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

namespace {

constexpr double armLength = 40.0;       // pixels of a plain screen
constexpr double letterDistance = 10.0;  // beyond the arm's end
constexpr double lineWidth = 3.0;
constexpr double discRadius = 5.0;
constexpr double alongSight = 0.2;  // an arm seen shorter than this share is a disc
constexpr double dimming = 0.55;    // of what points away from the viewer

constexpr std::array<Colour, 3> axisColours{Colour{0xe0, 0x7b, 0x7b}, Colour{0x8f, 0xbc, 0x8f},
                                            Colour{0x7d, 0xae, 0xe8}};
constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};

Colour dimmedAway(const Colour& colour, double towardsViewer) {
    const double brightness = 1.0 - (1.0 - dimming) * std::clamp(-towardsViewer, 0.0, 1.0);
    Colour dimmed{};
    std::transform(colour.begin(), colour.end(), dimmed.begin(),
                   [&](unsigned char part) { return static_cast<unsigned char>(std::lround(part * brightness)); });
    return dimmed;
}

}  // namespace

Vec3 seenFrom(const ViewFrame& frame, const Vec3& axis) {
    return {frame.right.dot(axis), -frame.down.dot(axis), -frame.forward.dot(axis)};
}

OrientationMarker::OrientationMarker() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        styleAnnotation(*m_letters[axis], axisColours[axis]);
        m_letters[axis]->SetInput(axisNames[axis]);
        m_letters[axis]->GetTextProperty()->SetJustificationToCentered();
        m_letters[axis]->GetTextProperty()->SetVerticalJustificationToCentered();
    }
}

OrientationMarker::~OrientationMarker() = default;

void OrientationMarker::addTo(vtkRenderer* renderer) {
    renderer->AddActor2D(m_lines.actor());
    for (auto& letter : m_letters) renderer->AddActor2D(letter);
}

void OrientationMarker::setVisible(bool visible) {
    m_lines.actor()->SetVisibility(visible);
    for (auto& letter : m_letters) letter->SetVisibility(visible);
}

void OrientationMarker::layOut(double scale, const ViewFrame& frame) {
    m_lines.clear();
    const double reach = annotationMargin + armLength + letterDistance;
    const Point2 foot{reach * scale, reach * scale};
    std::array<Vec3, 3> seen;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction{0, 0, 0};
        direction[axis] = 1.0;
        seen[static_cast<std::size_t>(axis)] = seenFrom(frame, direction);
    }
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return seen[a][2] < seen[b][2]; });

    for (const std::size_t axis : order) {
        const Point2 inPicture{seen[axis][0], seen[axis][1]};
        const double share = cv::norm(inPicture);
        const Colour colour = dimmedAway(axisColours[axis], seen[axis][2]);
        Point2 letter;
        if (share < alongSight) {
            m_lines.addDisc(foot, discRadius * scale, colour);
            // Opposite the other two arms, where the letter covers neither.
            const Point2 others{seen[(axis + 1) % 3][0] + seen[(axis + 2) % 3][0],
                                seen[(axis + 1) % 3][1] + seen[(axis + 2) % 3][1]};
            letter = foot - others * ((discRadius + letterDistance) * scale / std::max(cv::norm(others), 1e-9));
        } else {
            const Point2 tip = foot + inPicture * (armLength * scale);
            m_lines.addLine(foot, tip, lineWidth * scale, colour);
            letter = tip + inPicture * (letterDistance * scale / share);
        }
        m_letters[axis]->SetDisplayPosition(static_cast<int>(std::lround(letter[0])),
                                            static_cast<int>(std::lround(letter[1])));
    }
}

}  // namespace echolucent
