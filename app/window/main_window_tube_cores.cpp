// Tube cores in the window: drawn in the pictures, chosen anywhere, explained in their panel.
#include <QAction>
#include <QDockWidget>
#include <QMenu>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_explaining.h"
#include "app/explain/tube_core_page.h"
#include "app/explain/tube_cores_in_pictures.h"
#include "app/window/curve_and_picture_files.h"
#include "app/window/main_window.h"
#include "app/window/review_room.h"
#include "app/window/window_faces.h"
#include "widgets/key_table.h"
#include "widgets/tube_cores/tube_core_panel.h"

namespace echolucent {

void MainWindow::createTubeCores() {
    m_tubeCoreChoice = std::make_unique<TubeCoreChoice>(*m_otfs, m_openStudy);
    m_tubeCoresInPictures = std::make_unique<TubeCoresInPictures>(
        TubeCoresInPictures::Parts{*m_tubeCoreChoice, *m_otfs, *m_panes, m_widgets.planes, *m_widgets.picture,
                                   m_room->overlay(), [this] { return m_room->handIsFree(); }});
    m_tubeCoreExplaining = std::make_unique<TubeCoreExplaining>(TubeCoreExplaining::Parts{
        m_document, m_openStudy, m_works, *m_otfs, *m_tubeCoreChoice, *m_widgets.tubeCores, *m_widgets.messages});
    m_tubeCorePage = std::make_unique<TubeCorePage>(TubeCorePage::Parts{
        *this, m_document, m_openStudy, m_works, *m_otfs, *m_tubeCoreExplaining, m_settings, *m_widgets.messages,
        m_names, [this](const QString& what) { return m_files->proposedName(what); }});
    connect(m_widgets.tubeCores, &TubeCorePanel::pageRequested, m_tubeCorePage.get(), &TubeCorePage::choose);
    // A dock below another tab counts as visible, but nobody sees it.
    connect(&dockOf(*m_widgets.tubeCores), &QDockWidget::visibilityChanged, m_tubeCoreExplaining.get(),
            &TubeCoreExplaining::setSeen);
    connect(m_tubeCoreExplaining.get(), &TubeCoreExplaining::comparisonRequested, m_compare.get(),
            [this] { m_compare->setShown(true); });
    // A person who points at a tube core wants to read of it, unless the panel was closed.
    connect(m_tubeCoresInPictures.get(), &TubeCoresInPictures::clicked, this, [this] {
        if (!dockOf(*m_widgets.tubeCores).isHidden()) showDockOf(*m_widgets.tubeCores);
    });
    auto* menu = findChild<QMenu*>(QStringLiteral("menu.room"));
    auto* show = new QAction(tr("Show t&ube cores"), menu);
    show->setObjectName(QStringLiteral("room.tubeCores"));
    show->setShortcut(keyOf(show->objectName()));
    show->setCheckable(true);
    connect(show, &QAction::triggered, m_tubeCoreChoice.get(), &TubeCoreChoice::setShown);
    connect(m_tubeCoreChoice.get(), &TubeCoreChoice::shownChanged, show, &QAction::setChecked);
    menu->insertAction(findChild<QAction*>(QStringLiteral("room.resetPlanes")), show);
    addAction(show);  // the key works also while the menu bar is hidden
}

}  // namespace echolucent
