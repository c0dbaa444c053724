#include "widgets/planes/pane_grid.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> layoutNames{"3d", "quad", "large 3d"};
constexpr std::size_t pane3d = 3;
constexpr int gap = 3;               // logical pixels between panes
constexpr double columnShare = 0.3;  // of the width, for the small planes beside the large 3D view

}  // namespace

std::string_view nameOf(PaneLayout layout) { return nameIn(layoutNames, layout); }

std::optional<PaneLayout> paneLayoutFromName(std::string_view name) {
    return choiceNamed<PaneLayout>(layoutNames, name);
}

PaneGrid::PaneGrid(const std::array<QWidget*, paneCount>& panes, QWidget* parent) : QWidget(parent), m_panes(panes) {
    setObjectName(QStringLiteral("panes"));
    for (QWidget* pane : m_panes) pane->setParent(this);
    place();
}

void PaneGrid::setPaneLayout(PaneLayout layout) {
    if (layout == m_layout && !m_maximised) return;
    m_layout = layout;
    m_maximised.reset();
    place();
    emit paneLayoutChanged();
}

void PaneGrid::toggleMaximised(std::size_t pane) {
    if (endMaximised() || (m_layout == PaneLayout::only3d && pane == pane3d)) return;
    m_maximised = pane;
    place();
    emit paneLayoutChanged();
}

bool PaneGrid::endMaximised() {
    if (!m_maximised) return false;
    m_maximised.reset();
    place();
    emit paneLayoutChanged();
    return true;
}

void PaneGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    place();
}

std::array<QRect, paneCount> PaneGrid::places() const {
    std::array<QRect, paneCount> rectangles{};
    if (m_maximised) {
        rectangles[*m_maximised] = rect();
        return rectangles;
    }
    const int wide = (width() - gap) / 2, high = (height() - gap) / 2;
    const int column = static_cast<int>((width() - gap) * columnShare), third = (height() - 2 * gap) / 3;
    switch (m_layout) {
        case PaneLayout::only3d: rectangles[pane3d] = rect(); break;
        case PaneLayout::quad:
            rectangles = {QRect(0, 0, wide, high), QRect(width() - wide, 0, wide, high),
                          QRect(0, height() - high, wide, high), QRect(width() - wide, height() - high, wide, high)};
            break;
        case PaneLayout::large3d:
            for (int i = 0; i < 3; ++i)
                rectangles[static_cast<std::size_t>(i)] = QRect(0, i * (third + gap), column, third);
            rectangles[pane3d] = QRect(column + gap, 0, width() - column - gap, height());
            break;
    }
    return rectangles;
}

void PaneGrid::place() {
    const auto rectangles = places();
    // Hide panes first, so that they leave their places before others take them.
    for (std::size_t i = 0; i < paneCount; ++i)
        if (rectangles[i].isEmpty()) m_panes[i]->hide();
    for (std::size_t i = 0; i < paneCount; ++i) {
        if (rectangles[i].isEmpty()) continue;
        m_panes[i]->setGeometry(rectangles[i]);
        m_panes[i]->show();
    }
}

}  // namespace echolucent
