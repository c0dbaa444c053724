// The four panes: planes A, B and C, and the 3D view.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <string_view>

namespace echolucent {

/// How the panes share the room.
enum class PaneLayout {
    only3d,   ///< the 3D view alone
    quad,     ///< A and B above C and the 3D view, of one size
    large3d,  ///< the 3D view beside a column of A, B and C
};
/// "3d", "quad", "large 3d".
[[nodiscard]] std::string_view nameOf(PaneLayout layout);
[[nodiscard]] std::optional<PaneLayout> paneLayoutFromName(std::string_view name);

/// Planes A, B and C, and the 3D view, in this order.
inline constexpr std::size_t paneCount = 4;

/// Places four panes by a layout. One of them may fill the whole room for a while. A pane without a place is hidden, so
/// that nothing is computed for it.
class PaneGrid : public QWidget {
    Q_OBJECT

public:
    /// Takes the panes as its children, in the order of `paneCount`.
    explicit PaneGrid(const std::array<QWidget*, paneCount>& panes, QWidget* parent = nullptr);

    [[nodiscard]] PaneLayout paneLayout() const { return m_layout; }
    /// Ends a maximised pane.
    void setPaneLayout(PaneLayout layout);
    /// The pane that fills the whole room, by its place in `paneCount`.
    [[nodiscard]] std::optional<std::size_t> maximised() const { return m_maximised; }
    /// Gives a pane the whole room. If a pane has the whole room already, returns to the layout. Does nothing for a 3D
    /// view that is alone.
    void toggleMaximised(std::size_t pane);
    /// False if no pane is maximised.
    bool endMaximised();

    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }
    [[nodiscard]] QSize sizeHint() const override { return {900, 640}; }

signals:
    void paneLayoutChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] std::array<QRect, paneCount> places() const;
    void place();

    std::array<QWidget*, paneCount> m_panes;
    PaneLayout m_layout = PaneLayout::only3d;
    std::optional<std::size_t> m_maximised;
};

}  // namespace echolucent
