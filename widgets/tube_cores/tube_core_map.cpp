#include "widgets/tube_cores/tube_core_map.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/controls/panel_controls.h"
#include "widgets/larger_letters.h"
#include "widgets/tube_core_colours.h"
#include "widgets/tube_cores/tube_core_words.h"

namespace echolucent {

namespace {

// Pixels, in letters of the application's size.
constexpr double legendWidth = 104.0, margin = 3.0, largestCell = 24.0, sampleSide = 13.0;
constexpr int mapHeight = 206;

bool isArrow(const QKeyEvent& event) {
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier)) return false;
    return event.key() == Qt::Key_Left || event.key() == Qt::Key_Right || event.key() == Qt::Key_Up ||
           event.key() == Qt::Key_Down;
}

}  // namespace

TubeCoreMap::TubeCoreMap(QWidget* parent) : QWidget(parent) {
    named(this, "tubeCores.map", tr("Grid of tube cores"),
          tr("A cell for each tube core, as they stand in the view. A click explains one; the arrow keys go on to its "
             "neighbours"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void TubeCoreMap::setRun(std::shared_ptr<const AdaptiveOtf> run) {
    m_run = std::move(run);
    m_states = TubeCoreStates(m_run.get());
    update();
}

void TubeCoreMap::setChosen(std::optional<int> number) {
    if (std::exchange(m_chosen, number) != number) update();
    setAccessibleDescription(m_run && number && static_cast<std::size_t>(*number) < m_run->tubes.size()
                                 ? lineOf(*m_run, *number)
                                 : QString());
}

QRectF TubeCoreMap::grid() const {
    if (!m_run || m_run->tubes.empty()) return {};
    const int columns = m_run->config.grid.columns, rows = m_run->config.grid.rows;
    const double letters = lettersOf(*this);
    const double side = std::min({(width() - letters * legendWidth - 2.0 * margin) / columns,
                                  (height() - 2.0 * margin) / rows, letters * largestCell});
    return {margin, margin, side * columns, side * rows};
}

QRectF TubeCoreMap::cellOf(int number) const {
    const QRectF all = grid();
    if (all.isEmpty()) return {};
    const int columns = m_run->config.grid.columns;
    const double side = all.width() / columns;
    return {all.left() + number % columns * side, all.top() + number / columns * side, side, side};
}

std::optional<int> TubeCoreMap::numberAt(const QPointF& pixel) const {
    const QRectF all = grid();
    if (all.isEmpty() || !all.contains(pixel)) return std::nullopt;
    const int columns = m_run->config.grid.columns, rows = m_run->config.grid.rows;
    const double side = all.width() / columns;
    const int column = std::min(columns - 1, static_cast<int>((pixel.x() - all.left()) / side));
    const int row = std::min(rows - 1, static_cast<int>((pixel.y() - all.top()) / side));
    return row * columns + column;
}

QSize TubeCoreMap::sizeHint() const { return inLettersOf(*this, QSize(300, mapHeight)); }

QSize TubeCoreMap::minimumSizeHint() const { return inLettersOf(*this, QSize(240, mapHeight)); }

void TubeCoreMap::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) updateGeometry();
    QWidget::changeEvent(event);
}

bool TubeCoreMap::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isArrow(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ToolTip && m_run) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto number = numberAt(help->pos())) {
            QToolTip::showText(help->globalPos(), lineOf(*m_run, *number), this, cellOf(*number).toAlignedRect());
            return true;
        }
    }
    return QWidget::event(event);
}

void TubeCoreMap::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    if (const auto number = numberAt(event->position())) emit chosen(*number);
}

void TubeCoreMap::keyPressEvent(QKeyEvent* event) {
    if (!m_run || m_run->tubes.empty() || !isArrow(*event)) return QWidget::keyPressEvent(event);
    const int columns = m_run->config.grid.columns, rows = m_run->config.grid.rows;
    if (!m_chosen) return emit chosen(rows / 2 * columns + columns / 2);
    int column = *m_chosen % columns, row = *m_chosen / columns;
    switch (event->key()) {
        case Qt::Key_Left: --column; break;
        case Qt::Key_Right: ++column; break;
        case Qt::Key_Up: --row; break;
        default: ++row; break;
    }
    if (column >= 0 && column < columns && row >= 0 && row < rows) emit chosen(row * columns + column);
}

void paintTubeCoreSign(QPainter& painter, const QRectF& cell, TubeState state, double share,
                       const ThemeColours& colours) {
    const QRectF inner = cell.adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.plot);
    if (state != TubeState::outside && state != TubeState::neverPlaced) painter.drawRect(inner);
    switch (state) {
        case TubeState::weighs: {
            constexpr double smallest = 0.35;
            const double side = inner.width() * (smallest + (1.0 - smallest) * share);
            painter.setBrush(tubeCoreColour(share, colours));
            painter.drawRect(QRectF(inner.center() - QPointF(side, side) / 2.0, QSizeF(side, side)));
            break;
        }
        case TubeState::weighsNothing:
            painter.setPen(QPen(colours.secondary, 1.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(inner.center(), inner.width() * 0.17, inner.width() * 0.17);
            break;
        case TubeState::noSurface:
            painter.setBrush(QBrush(colours.secondary, Qt::BDiagPattern));
            painter.drawRect(inner);
            break;
        case TubeState::outside: break;
        case TubeState::neverPlaced: {
            painter.setPen(QPen(colours.secondary, 1.0));
            const QRectF cross = inner.adjusted(3, 3, -3, -3);
            painter.drawLine(cross.topLeft(), cross.bottomRight());
            painter.drawLine(cross.topRight(), cross.bottomLeft());
            break;
        }
    }
}

void TubeCoreMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& colours = coloursOf(palette());
    const QRectF all = grid();
    if (all.isEmpty()) return;
    painter.fillRect(all.adjusted(-1, -1, 1, 1), colours.lineOfTable);
    painter.fillRect(all, colours.panel);
    for (std::size_t t = 0; t < m_states.states.size(); ++t)
        paintTubeCoreSign(painter, cellOf(static_cast<int>(t)), m_states.states[t], m_states.shares[t], colours);
    if (m_chosen && static_cast<std::size_t>(*m_chosen) < m_states.states.size()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.panel, 4.0));
        painter.drawRect(cellOf(*m_chosen));
        painter.setPen(QPen(colours.text, 2.0));
        painter.drawRect(cellOf(*m_chosen));
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.accent, 1.0));
        painter.drawRect(all.adjusted(-2, -2, 2, 2));
    }
    paintLegend(painter);
}

void TubeCoreMap::paintLegend(QPainter& painter) const {
    const std::array<std::pair<TubeState, double>, 6> samples{{{TubeState::weighs, 1.0},
                                                               {TubeState::weighs, 0.2},
                                                               {TubeState::weighsNothing, 0.0},
                                                               {TubeState::noSurface, 0.0},
                                                               {TubeState::outside, 0.0},
                                                               {TubeState::neverPlaced, 0.0}}};
    const QStringList words{tr("heaviest"),
                            tr("light"),
                            wordsOf(TubeState::weighsNothing),
                            wordsOf(TubeState::noSurface),
                            wordsOf(TubeState::outside),
                            wordsOf(TubeState::neverPlaced)};
    const ThemeColours& colours = coloursOf(palette());
    const double letters = lettersOf(*this);
    const double height = painter.fontMetrics().height() + 5.0, side = letters * sampleSide;
    const double left = width() - letters * legendWidth + 4.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const QRectF cell(left, margin + static_cast<double>(i) * height + (height - side) / 2.0, side, side);
        painter.setPen(QPen(colours.lineOfTable, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(cell);
        paintTubeCoreSign(painter, cell, samples[i].first, samples[i].second, colours);
        painter.setPen(colours.textBehind);
        painter.drawText(QRectF(cell.right() + 5.0, cell.center().y() - height / 2.0, width(), height),
                         Qt::AlignLeft | Qt::AlignVCenter, words[static_cast<qsizetype>(i)]);
    }
}

}  // namespace echolucent
