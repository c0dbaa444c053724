// The panes of a comparison: side by side, or one pane for a pair.
#pragma once

#include <QImage>
#include <QStringList>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "processing/document/comparison.h"
#include "widgets/compare/compare_pane.h"

namespace echolucent {

/// The places of `panes` panes (>= 1) of one size in a room, as large as they can be, row by row.
[[nodiscard]] std::vector<QRect> placesOfPanes(std::size_t panes, const QSize& room);

/// Places two to four panes of one size, as large as they can be. One of them may fill the whole room for a while. In a
/// difference or a wipe the pair's pane fills the room. Objects: compare.panes (this), compare.pane1 … .pane4,
/// compare.pair.
class CompareGrid : public QWidget {
    Q_OBJECT

public:
    explicit CompareGrid(QWidget* parent = nullptr);

    /// Arranges `panes` panes (fewestPanes to mostPanes, else clamped). Ends a maximised pane if the arrangement
    /// changes.
    void arrange(ComparisonLayout layout, std::size_t panes);
    /// Lays out the texts below the panes for these names of the panes that are arranged: all of one height. The
    /// pictures may be smaller or larger afterwards.
    void setNames(const QStringList& names);
    /// Sets whether texts and OTFs are for a projector: letters grow with the grid.
    void setLarge(bool large);
    /// The grid as it is shown, in device pixels; null if nothing is shown.
    [[nodiscard]] QImage image() const;
    /// The faces of the panes that are shown side by side, all of them even if one has the whole room.
    [[nodiscard]] std::vector<PaneFace> faces() const;
    [[nodiscard]] const CaptionLayout& caption() const { return m_caption; }
    [[nodiscard]] ComparePane& pane(std::size_t place) { return *m_panes.at(place); }
    [[nodiscard]] ComparePane& pair() { return *m_pair; }
    /// The size of all shown pictures, in device pixels; empty if none is shown.
    [[nodiscard]] QSize pictureSize() const;
    /// The places of the panes that are shown side by side, or of the maximised one; empty if the pair's pane is shown.
    [[nodiscard]] std::vector<std::size_t> shownPanes() const;
    [[nodiscard]] bool dragging() const;
    /// Dims all panes (ComparePane::setDimmed()).
    void setDimmed(bool dimmed);
    /// Ends a drag without change. False if there is none.
    bool cancelDrag();
    [[nodiscard]] std::optional<std::size_t> maximised() const { return m_maximised; }
    /// False if no pane is maximised.
    bool endMaximised();

    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

signals:
    /// Other panes are shown, their size has changed, or the whole grid was shown or hidden.
    void arranged();
    /// The keyboard's focus came to the pane of this place.
    void focused(std::size_t place);
    // The signals of the panes.
    void dragEnded();
    void dragCancelled();
    void orbited(double right, double down);
    void panned(double right, double down);
    void zoomed(double factor);
    void zoomedAbout(double right, double down, double factor);
    void lightMoved(double right, double down);
    void wipeMoved(double share);
    void painted(double milliseconds);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] std::vector<ComparePane*> shown() const;
    void connectPane(ComparePane* pane);
    void place();
    void layOutTexts();

    std::array<ComparePane*, mostPanes> m_panes{};
    ComparePane* m_pair = nullptr;
    ComparisonLayout m_layout = ComparisonLayout::sideBySide;
    std::size_t m_count = fewestPanes;
    std::optional<std::size_t> m_maximised;
    QStringList m_names;
    bool m_large = false;
    CaptionLayout m_caption;
};

}  // namespace echolucent
