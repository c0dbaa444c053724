// The head of a dock: the names of all panels of its column, in as many rows as they need.
#pragma once

#include <QList>
#include <QWidget>
#include <map>

class QDockWidget;
class QMainWindow;
class QToolButton;

namespace echolucent {

class FlowLayout;

/// Stands in the place of a dock's title and of the column's tabs, which shorten names that do not fit in one row. A
/// click on a name brings its panel to the front. Objects: DOCK.tab.NAME for each panel of the column
/// ("dock.view.tab.room" in the head of dock.view), and DOCK.close.
class DockTitle : public QWidget {
    Q_OBJECT

public:
    /// `window` holds the dock and all docks whose names may stand here, in this order.
    DockTitle(QMainWindow& window, QDockWidget& dock, const QList<QDockWidget*>& docks);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void follow();
    void createTabs();
    QToolButton* createTab(QDockWidget& of);
    [[nodiscard]] int heightFor(int width) const;

    QMainWindow& m_window;
    QDockWidget& m_dock;
    QList<QDockWidget*> m_docks;
    FlowLayout* m_row;
    QToolButton* m_close;
    std::map<QDockWidget*, QToolButton*> m_tabs;  ///< made when the head is seen for the first time
};

}  // namespace echolucent
