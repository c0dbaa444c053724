// The boundary emphasis function of Kindlmann and Durkin, drawn by hand.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "processing/designers/choice/designer_config.h"
#include "widgets/accessibility/spoken_widget.h"

namespace echolucent {

/// Mouse: a drag moves a node, a double click adds one. Keys: Tab and the Page keys go from node to node, arrows move
/// the selected one by 1/20, Delete removes it, Escape ends a drag without change. A node stays between its neighbours,
/// and within shownPositions unless it was set beyond.
class EmphasisCanvas : public QWidget, public SpokenWidget {
    Q_OBJECT

public:
    static constexpr double hitDistance = 10.0;    ///< pixels, in letters of the application's size
    static constexpr double shownPositions = 4.0;  ///< standard deviations to either side of the boundary's middle

    explicit EmphasisCanvas(QWidget* parent = nullptr);

    /// Emits nothing.
    void setNodes(const std::vector<EmphasisNode>& nodes);
    [[nodiscard]] QPointF positionOf(const EmphasisNode& node) const;

    [[nodiscard]] std::vector<SpokenNode> spokenNodes() const override;
    void chooseSpokenNode(int node) override;
    void setSpokenOpacity(int node, double opacity) override;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// A drag goes on. dragEnded() or dragCancelled() follows, unless setNodes() sets other nodes and so ends the drag.
    void previewed(const std::vector<echolucent::EmphasisNode>& nodes);
    void dragEnded();
    void dragCancelled();
    /// One change; `what` names it.
    void edited(const std::vector<echolucent::EmphasisNode>& nodes, const QString& what);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] EmphasisNode valueAt(QPointF position) const;
    [[nodiscard]] int nodeAt(QPointF position) const;
    [[nodiscard]] EmphasisNode clamped(int index, const EmphasisNode& node) const;
    bool select(int step);
    bool nudge(int key);
    /// Moves the selected node as far as it may.
    void moveSelected(const EmphasisNode& wanted);
    void removeSelected();
    [[nodiscard]] static bool isOwnKey(int key);

    std::vector<EmphasisNode> m_nodes{{-1, 0}, {0, 1}, {1, 0}};
    int m_selected = -1;
    bool m_dragging = false, m_moved = false;
};

}  // namespace echolucent
