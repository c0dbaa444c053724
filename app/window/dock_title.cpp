#include "app/window/dock_title.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/controls/flow_layout.h"
#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {
constexpr int tabGap = 2, tabEdge = 3;  // pixels
}  // namespace

DockTitle::DockTitle(QMainWindow& window, QDockWidget& dock, const QList<QDockWidget*>& docks)
    : QWidget(&dock), m_window(window), m_dock(dock), m_docks(docks) {
    setProperty("dockTitle", true);  // for the style sheet
    setAttribute(Qt::WA_StyledBackground);
    auto* names = new QWidget;
    m_row = new FlowLayout(tabGap, names);
    m_close = named(new QToolButton(this), dock.objectName() + QStringLiteral(".close"), tr("Close this panel"),
                    tr("Closes this panel. View > Panels opens it again"));
    m_close->setText(QStringLiteral("✕"));
    m_close->setAutoRaise(true);
    connect(m_close, &QToolButton::clicked, &dock, &QDockWidget::close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(tabEdge, tabEdge, tabEdge, 0);
    layout->addWidget(names);
}

void DockTitle::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_tabs.empty()) createTabs();
    follow();
}

void DockTitle::createTabs() {
    for (QDockWidget* each : m_docks) {
        m_tabs.emplace(each, createTab(*each));
        connect(each->toggleViewAction(), &QAction::toggled, this, &DockTitle::follow);
        connect(each, &QDockWidget::topLevelChanged, this, &DockTitle::follow);
        connect(each, &QDockWidget::dockLocationChanged, this, &DockTitle::follow);
    }
    m_row->addStretch();
    m_row->addWidget(m_close);  // behind the last name, at the right
}

QToolButton* DockTitle::createTab(QDockWidget& of) {
    auto* tab = named(new QToolButton, m_dock.objectName() + QStringLiteral(".tab.") + of.objectName().section('.', -1),
                      of.windowTitle(), of.toggleViewAction()->toolTip());
    tab->setText(of.windowTitle());
    tab->setProperty("dockTab", true);
    tab->setCheckable(true);
    connect(tab, &QToolButton::clicked, this, [this, tab, &of] {
        tab->setChecked(&of == &m_dock);
        const bool byKey = tab->hasFocus();
        of.raise();
        if (!byKey) return;
        const auto* head = qobject_cast<DockTitle*>(of.titleBarWidget());
        if (const auto found = head->m_tabs.find(&of); found != head->m_tabs.end()) found->second->setFocus();
    });
    m_row->addWidget(tab);
    return tab;
}

/// Shows the names of the panels that lie one behind the other here.
void DockTitle::follow() {
    if (!isVisible()) return;
    const QList<QDockWidget*> behind = m_window.tabifiedDockWidgets(&m_dock);
    for (const auto& [dock, tab] : m_tabs) {
        tab->setChecked(dock == &m_dock);
        tab->setVisible(dock == &m_dock || (behind.contains(dock) && dock->toggleViewAction()->isChecked()));
    }
    m_row->invalidate();
    updateGeometry();
}

int DockTitle::heightFor(int width) const { return tabEdge + m_row->heightForWidth(width - 2 * tabEdge); }

QSize DockTitle::sizeHint() const {
    const int least = minimumSizeHint().width();
    return {least, heightFor(std::max(m_dock.width(), least))};
}

QSize DockTitle::minimumSizeHint() const {
    return {m_row->minimumSize().width() + 2 * tabEdge, tabEdge + m_row->minimumSize().height()};
}

void DockTitle::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != width()) updateGeometry();  // more names or fewer fit in a row
}

}  // namespace echolucent
