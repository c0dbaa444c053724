// The grid of tube cores as a map: a cell for each, coloured by its weight.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "processing/explanation/tube_explanation.h"
#include "widgets/theme_colours.h"
#include "widgets/tube_cores/tube_core_words.h"

namespace echolucent {

/// The sign of a tube core: a square if it weighs, the larger and the more of the accent the larger its share of the
/// largest weight; a small ring if it weighs nothing, hatching without a surface, nothing outside, and a cross if it is
/// never placed.
void paintTubeCoreSign(QPainter& painter, const QRectF& cell, TubeState state, double share,
                       const ThemeColours& colours);

/// Object tubeCores.map. Columns go to the right and rows down, as the tube cores stand in the view. A cell that weighs
/// has a square, the larger and the more of the accent the heavier; one that weighs nothing has a small ring, one
/// without a surface is hatched, one outside is empty, and one that is never placed has a cross. A click chooses, and
/// so do the arrow keys, from the chosen one on.
class TubeCoreMap : public QWidget {
    Q_OBJECT

public:
    explicit TubeCoreMap(QWidget* parent = nullptr);

    /// Null: there is no run yet, and the map is empty.
    void setRun(std::shared_ptr<const AdaptiveOtf> run);
    void setChosen(std::optional<int> number);

    /// The cell of a tube core, and the number of the cell at a pixel; in pixels of the widget.
    [[nodiscard]] QRectF cellOf(int number) const;
    [[nodiscard]] std::optional<int> numberAt(const QPointF& pixel) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void chosen(int number);

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF grid() const;
    void paintLegend(QPainter& painter) const;

    std::shared_ptr<const AdaptiveOtf> m_run;
    TubeCoreStates m_states;
    std::optional<int> m_chosen;
};

}  // namespace echolucent
