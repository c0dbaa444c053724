#include "widgets/compare/compare_grid.h"

#include <QFontInfo>
#include <QPainter>
#include <algorithm>

namespace echolucent {

namespace {

constexpr int gap = 3;  // logical pixels between panes

/// The number of columns that makes the shorter side of a pane longest.
int columnsOf(int panes, const QSize& room) {
    int best = 1, longest = 0;
    for (int columns = 1; columns <= panes; ++columns) {
        const int rows = (panes + columns - 1) / columns;
        const int side = std::min(room.width() / columns, room.height() / rows);
        if (side > longest) {
            longest = side;
            best = columns;
        }
    }
    return best;
}

}  // namespace

std::vector<QRect> placesOfPanes(std::size_t panes, const QSize& room) {
    const auto count = static_cast<int>(panes);
    const int columns = columnsOf(count, room), rows = (count + columns - 1) / columns;
    const int wide = (room.width() - (columns - 1) * gap) / columns, high = (room.height() - (rows - 1) * gap) / rows;
    std::vector<QRect> places;
    for (int i = 0; i < count; ++i)
        places.emplace_back(i % columns * (wide + gap), i / columns * (high + gap), wide, high);
    return places;
}

CompareGrid::CompareGrid(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("compare.panes"));
    setAccessibleName(tr("Panes compared"));
    for (std::size_t i = 0; i < m_panes.size(); ++i) {
        m_panes[i] = new ComparePane(QStringLiteral("compare.pane%1").arg(i + 1), this);
        m_panes[i]->setAccessibleName(tr("Picture compared: %1").arg(i + 1));  // until it shows something
        connectPane(m_panes[i]);
        connect(m_panes[i], &ComparePane::focused, this, [this, i] { emit focused(i); });
        connect(m_panes[i], &ComparePane::maximiseRequested, this, [this, i] {
            if (endMaximised()) return;
            m_maximised = i;
            place();
            emit arranged();
        });
    }
    m_pair = new ComparePane(QStringLiteral("compare.pair"), this);
    m_pair->setAccessibleName(tr("Two pictures compared in one"));
    connectPane(m_pair);
    place();
}

void CompareGrid::connectPane(ComparePane* pane) {
    connect(pane, &ComparePane::dragEnded, this, &CompareGrid::dragEnded);
    connect(pane, &ComparePane::dragCancelled, this, &CompareGrid::dragCancelled);
    connect(pane, &ComparePane::orbited, this, &CompareGrid::orbited);
    connect(pane, &ComparePane::panned, this, &CompareGrid::panned);
    connect(pane, &ComparePane::zoomed, this, &CompareGrid::zoomed);
    connect(pane, &ComparePane::zoomedAbout, this, &CompareGrid::zoomedAbout);
    connect(pane, &ComparePane::lightMoved, this, &CompareGrid::lightMoved);
    connect(pane, &ComparePane::wipeMoved, this, &CompareGrid::wipeMoved);
    connect(pane, &ComparePane::painted, this, &CompareGrid::painted);
}

void CompareGrid::arrange(ComparisonLayout layout, std::size_t panes) {
    if (layout == m_layout && panes == m_count) return;
    m_layout = layout;
    m_count = std::clamp(panes, fewestPanes, mostPanes);
    m_maximised.reset();
    place();
    emit arranged();
}

std::vector<std::size_t> CompareGrid::shownPanes() const {
    std::vector<std::size_t> places;
    if (m_layout != ComparisonLayout::sideBySide) return places;
    if (m_maximised) return {*m_maximised};
    for (std::size_t i = 0; i < m_count; ++i) places.push_back(i);
    return places;
}

std::vector<ComparePane*> CompareGrid::shown() const {
    if (m_layout != ComparisonLayout::sideBySide) return {m_pair};
    std::vector<ComparePane*> panes;
    for (const std::size_t place : shownPanes()) panes.push_back(m_panes[place]);
    return panes;
}

void CompareGrid::setNames(const QStringList& names) {
    if (std::exchange(m_names, names) != names) layOutTexts();
}

void CompareGrid::setLarge(bool large) {
    if (std::exchange(m_large, large) == large) return;
    layOutTexts();
    emit arranged();
}

void CompareGrid::layOutTexts() {
    // From the last row, letters are read whose height is a 36th of the picture's on the wall.
    constexpr int rowsOfLetters = 36;
    QFont letters = font();
    if (m_large) letters.setPixelSize(std::max(QFontInfo(letters).pixelSize(), height() / rowsOfLetters));
    m_caption = captionLayout(m_names, shown().front()->width(), letters);
    for (ComparePane* pane : m_panes) pane->setCaption(m_caption);
    m_pair->setCaption(m_caption);
}

std::vector<PaneFace> CompareGrid::faces() const {
    std::vector<PaneFace> faces;
    for (std::size_t place = 0; place < m_count; ++place) faces.push_back(m_panes[place]->face());
    return faces;
}

QImage CompareGrid::image() const {
    if (!isVisible()) return {};
    QImage image((QSizeF(size()) * devicePixelRatioF()).toSize(), QImage::Format_RGB888);
    if (image.isNull()) return image;
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.scale(devicePixelRatioF(), devicePixelRatioF());
    for (const ComparePane* pane : shown()) {
        painter.save();
        painter.translate(pane->pos());
        pane->paintTo(painter);
        painter.restore();
    }
    return image;
}

QSize CompareGrid::pictureSize() const { return isVisible() ? shown().front()->pictureSize() : QSize(); }

bool CompareGrid::dragging() const {
    return m_pair->dragging() || std::ranges::any_of(m_panes, [](const ComparePane* pane) { return pane->dragging(); });
}

void CompareGrid::setDimmed(bool dimmed) {
    for (ComparePane* pane : m_panes) pane->setDimmed(dimmed);
    m_pair->setDimmed(dimmed);
}

bool CompareGrid::cancelDrag() {
    return m_pair->cancelDrag() || std::ranges::any_of(m_panes, [](ComparePane* pane) { return pane->cancelDrag(); });
}

bool CompareGrid::endMaximised() {
    if (!m_maximised) return false;
    m_maximised.reset();
    place();
    emit arranged();
    return true;
}

void CompareGrid::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    place();
    emit arranged();
}

void CompareGrid::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit arranged();
}

void CompareGrid::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit arranged();
}

void CompareGrid::place() {
    const std::vector<ComparePane*> panes = shown();
    for (ComparePane* pane : m_panes)
        if (std::ranges::find(panes, pane) == panes.end()) pane->hide();
    if (panes.front() != m_pair) m_pair->hide();
    const std::vector<QRect> places = placesOfPanes(panes.size(), size());
    for (std::size_t i = 0; i < panes.size(); ++i) {
        panes[i]->setGeometry(places[i]);
        panes[i]->show();
    }
    layOutTexts();
}

}  // namespace echolucent
