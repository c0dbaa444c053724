// Shows in the window the work that is under way, and when it is at rest.
#include <QDockWidget>

#include "app/compare/compare_room.h"
#include "app/lesson/lesson_player.h"
#include "app/window/full_screen.h"
#include "app/window/main_window.h"
#include "app/window/review_room.h"
#include "app/window/window_faces.h"
#include "processing/document/panes.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/run_status.h"
#include "widgets/controls/side_strip.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/curve_sliders.h"
#include "widgets/panels/history_panel.h"
#include "widgets/panels/room_panel.h"
#include "widgets/panels/view_panel.h"

namespace echolucent {

void MainWindow::connectProgress() {
    connect(&m_openStudy, &OpenStudy::quieteningFailed, this, [this](const QString& sentence) {
        m_widgets.messages->showMessage(MessageKind::error, sentence, MessageEnd::withStudy("smoothing"));
    });
    connect(&m_openStudy, &OpenStudy::quietVoxelsMade, this, [this] { m_widgets.messages->takeBack("smoothing"); });
    connect(&m_works, &Works::changed, this, &MainWindow::followWorks);
    connect(&m_works, &Works::progressed, m_widgets.status, &RunStatus::setProgress);
    connect(m_widgets.status, &RunStatus::cancelRequested, &m_works, &Works::cancelShown);
    // A motion waits for all panes of a comparison. These connections are made after those of the units, so that the
    // units have followed a signal before announce() asks.
    const auto announce = [this] {
        if (!m_compare->shown() || m_compare->views().frameIsCurrent()) m_motion->announceShownFrame();
    };
    connect(&m_compare->views(), &ComparedViews::frameShown, this, announce);
    // The renderer and time of the 3D view do not hold for the panes.
    connect(&m_compare->views(), &ComparedViews::frameShown, this, [this] {
        const CastPicture& frame = *m_compare->views().frame();
        if (frame.converged()) m_widgets.status->setRenderer(tr("software renderer"), frame.milliseconds);
    });
    connect(m_panes.get(), &ShownPanes::changed, this, announce);
    connect(m_widgets.picture, &VolumeViewWidget::pictureDelivered, this, announce);
    connect(m_widgets.picture, &VolumeViewWidget::pictureDrawn, this, announce);
    // The end of a work may be all that a frame still waited for, so ask then too. Ask queued: the work for the next
    // frame may begin while the picture still shows the frame before, which would pass for the next.
    connect(&m_works, &Works::changed, this, announce, Qt::QueuedConnection);
    connect(m_room.get(), &ReviewRoom::pointed, this, [this](std::optional<double> intensity) {
        m_widgets.status->setPointed(intensity, std::nullopt);
        m_widgets.editor->setCursorIntensity(intensity);
    });
    const auto placeMessages = [this] {
        // Among planes of its own size the 3D view is small: there a message takes a strip below all of them.
        const PaneGrid& panes = *m_widgets.panes;
        const bool alone =
            panes.maximised() ? panes.maximised() == paneCount - 1 : panes.paneLayout() != PaneLayout::quad;
        QWidget& room = alone ? static_cast<QWidget&>(*m_widgets.picture) : *m_widgets.panes;
        // The measurements stand below the compared pictures.
        if (m_compare->shown())
            m_widgets.messages->lieOver(*m_widgets.compared, Qt::TopEdge);
        else
            m_widgets.messages->lieOver(room);
    };
    connect(m_widgets.panes, &PaneGrid::paneLayoutChanged, this, placeMessages);
    // On the full screen no panel is seen: they are arranged once the others are back.
    const auto arranged = std::make_shared<bool>(false);
    const auto arrange = [this, arranged] {
        const bool shown = m_compare->shown();
        if (!m_fullScreen->active() && std::exchange(*arranged, shown) != shown) arrangeForComparison(shown);
    };
    connect(m_compare.get(), &CompareRoom::shownChanged, this, [this, placeMessages, arrange](bool shown) {
        placeMessages();
        m_widgets.sliders->setComparing(shown);
        followStrip();
        arrange();
    });
    connect(m_fullScreen, &FullScreen::changed, this, arrange);
    // The document may have had several panes before, and a person may have left the comparison.
    connect(m_widgets.history, &HistoryPanel::chosen, m_compare.get(), [this] {
        if (isCompared(m_document.ownDocument())) m_compare->setShown(true);
    });
}

/// A comparison shows no planes, so the tab of the planes makes way for that of the comparison.
void MainWindow::arrangeForComparison(bool shown) {
    QDockWidget &planes = dockOf(*m_widgets.room), &compare = dockOf(*m_widgets.compare);
    if (shown) {
        m_planesTabWasThere = !planes.isHidden();
        planes.hide();
    } else {
        planes.setVisible(m_planesTabWasThere);
    }
    compare.setVisible(shown || m_faces->face() == Face::teach);
    (shown ? compare : dockOf(*m_widgets.controls)).raise();
}

/// Compared pictures take the room of the strip.
void MainWindow::followStrip() {
    m_widgets.sides->setVisible(findChild<QAction*>("view.sides")->isChecked() && !m_compare->shown() &&
                                !m_fullScreen->active() && !(m_lessons && m_lessons->playing()));
}

void MainWindow::followWorks() {
    const QString words = m_works.words();
    words.isEmpty() ? m_widgets.status->endProgress() : m_widgets.status->beginProgress(words);
    if (m_works.idle() != m_idle) emit idleChanged(m_idle = m_works.idle());
}

}  // namespace echolucent
