#include "widgets/volume_view/scene/annotation/scale_bar.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "widgets/volume_view/scene/annotation/annotation_style.h"

namespace echolucent {

namespace {
constexpr double longestShare = 0.22;    // of the picture's width
constexpr double longestPixels = 200.0;  // pixels of a plain screen
constexpr double tickHeight = 4.0;       // above and below the bar
constexpr double lineWidth = 2.0;
constexpr const char* unknownSpacing = "spacing unknown:\nproportions may be wrong";
}  // namespace

RoundLength roundLengthUpTo(double mm) {
    const double decade = std::pow(10.0, std::floor(std::log10(mm)));
    RoundLength rounded{decade, {}};
    for (const double times : {2.0, 5.0, 10.0}) {
        // The limit itself is allowed although the logarithm may fall a rounding short of it.
        if (times * decade <= mm * (1 + 1e-12)) rounded.mm = times * decade;
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.10g mm", rounded.mm);
    rounded.text = text.data();
    return rounded;
}

ScaleBar::ScaleBar() {
    styleAnnotation(*m_text, annotationColour);
    m_text->GetTextProperty()->SetVerticalJustificationToBottom();
}

ScaleBar::~ScaleBar() = default;

void ScaleBar::addTo(vtkRenderer* renderer) {
    renderer->AddActor2D(m_lines.actor());
    renderer->AddActor2D(m_text);
}

void ScaleBar::setVisible(bool visible) {
    m_lines.actor()->SetVisibility(visible);
    m_text->SetVisibility(visible);
}

void ScaleBar::layOut(int viewportWidth, int viewportHeight, double scale, double heightMm, bool spacingKnown) {
    m_lines.clear();
    m_lengthPixels = 0.0;
    const double margin = annotationMargin * scale;
    const double right = viewportWidth - margin;
    if (!spacingKnown) {
        m_said = unknownSpacing;
        m_text->GetTextProperty()->SetJustificationToRight();
        m_text->SetDisplayPosition(static_cast<int>(right), static_cast<int>(margin));
    } else {
        const double pixelsPerMm = viewportHeight / heightMm;
        const double longest = std::min(longestShare * viewportWidth, longestPixels * scale);
        const RoundLength length = roundLengthUpTo(longest / pixelsPerMm);
        m_said = length.text;
        m_lengthPixels = length.mm * pixelsPerMm;
        const double y = std::round(margin + tickHeight * scale);
        const double left = right - m_lengthPixels;
        const double tick = tickHeight * scale, width = lineWidth * scale;
        m_lines.addLine({left, y - tick}, {left, y + tick}, width, annotationColour);
        m_lines.addLine({right, y - tick}, {right, y + tick}, width, annotationColour);
        m_lines.addLine({left, y}, {right, y}, width, annotationColour);
        m_text->GetTextProperty()->SetJustificationToCentered();
        m_text->SetDisplayPosition(static_cast<int>((left + right) / 2), static_cast<int>(y + tick + 3 * scale));
    }
    m_text->SetInput(m_said.c_str());
}

}  // namespace echolucent
