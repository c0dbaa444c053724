// What the window shows of work that is under way, and when it is at rest.
#include <QDockWidget>

#include "app/compare/compare_room.h"
#include "app/motion/movie_files.h"
#include "app/otf/near_cut_finder.h"
#include "app/picture/preset_controls.h"
#include "app/report/report_saving.h"
#include "app/sessions/session_keeping.h"
#include "app/study/loading_picture.h"
#include "app/study/recent_pictures.h"
#include "app/study/study_opening.h"
#include "app/window/long_works.h"
#include "app/window/main_window.h"
#include "app/window/review_room.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/run_status.h"

namespace echolucent {

/// What takes long, that which a person waits for most first.
void MainWindow::createLongWorks() {
    m_works = std::make_unique<LongWorks>(*m_widgets.status);
    const auto changed = [this] {
        m_works->follow();
        updateIdle();
    };
    const std::size_t loading = m_works->add(
        {.busy = [this] { return m_openStudy->loading(); },
         .words = [this] { return m_loadingPicture->shown() ? tr("coarse picture, loading goes on") : tr("loading"); },
         .cancel = [this] { m_openStudy->cancelLoading(); }});
    m_works->add({.busy = [this] { return m_nearCutFinder->busy(); },
                  .words = [] { return tr("looking for the near cut"); },
                  .cancel = [this] { m_nearCutFinder->cancel(); }});
    const std::size_t quietening = m_works->add({.busy = [this] { return m_openStudy->quietPhases().busy(); },
                                                 .words = [] { return tr("reducing speckle"); },
                                                 .cancel = [this] { m_openStudy->cancelQuietening(); }});
    const std::size_t designing = m_works->add({.busy = [this] { return m_otfs->designing(); },
                                                .words = [] { return tr("designing the OTF"); },
                                                .cancel = [this] { m_otfs->cancel(); }});
    const std::size_t movie = m_works->add({.busy = [this] { return m_movies->busy(); },
                                            .words = [this] { return m_movies->activity(); },
                                            .cancel = [this] { m_movies->cancel(); }});
    const std::size_t report = m_works->add({.busy = [this] { return m_report->busy(); },
                                             .words = [] { return tr("making the report"); },
                                             .cancel = [this] { m_report->cancel(); }});
    const std::size_t comparing = m_works->add({.busy = [this] { return m_compare->computing(); },
                                                .words = [] { return tr("comparing"); },
                                                .cancel = [this] { m_compare->cancel(); }});
    connect(m_compare.get(), &CompareRoom::busyChanged, this, changed);
    connect(m_compare.get(), &CompareRoom::progressed, m_works.get(),
            [this, comparing](double share) { m_works->setProgress(comparing, share); });
    m_works->add({.busy = [this] { return m_sessions->saving(); },
                  .words = [] { return tr("saving the session"); },
                  .cancel = [this] { m_sessions->cancelSaving(); }});
    connect(m_sessions.get(), &SessionKeeping::busyChanged, this, changed);
    connect(m_openStudy.get(), &OpenStudy::loadingChanged, this, changed);
    connect(m_openStudy.get(), &OpenStudy::loadingProgressed, m_works.get(),
            [this, loading](double share) { m_works->setProgress(loading, share); });
    connect(m_loadingPicture.get(), &LoadingPicture::shownChanged, this, changed);
    connect(m_loadingPicture.get(), &LoadingPicture::busyChanged, this, changed);
    connect(m_nearCutFinder.get(), &NearCutFinder::busyChanged, this, changed);
    connect(m_openStudy.get(), &OpenStudy::quieteningChanged, this, changed);
    connect(m_openStudy.get(), &OpenStudy::quieteningProgressed, m_works.get(),
            [this, quietening](double share) { m_works->setProgress(quietening, share); });
    connect(m_otfs.get(), &PaneOtfs::progressed, m_works.get(),
            [this, designing](double share) { m_works->setProgress(designing, share); });
    connect(m_movies.get(), &MovieFiles::busyChanged, this, changed);
    connect(m_movies.get(), &MovieFiles::progressed, m_works.get(),
            [this, movie](double share) { m_works->setProgress(movie, share); });
    connect(m_report.get(), &ReportSaving::busyChanged, this, changed);
    connect(m_report.get(), &ReportSaving::progressed, m_works.get(),
            [this, report](double share) { m_works->setProgress(report, share); });
}

void MainWindow::connectProgress() {
    connect(m_openStudy.get(), &OpenStudy::quieteningFailed, this,
            [this](const QString& sentence) { m_widgets.messages->showMessage(MessageKind::error, sentence); });
    // This connection is made last, so that it runs after all others of these signals.
    const auto somethingEnded = [this] {
        // What plays waits for all panes of a comparison.
        if (!m_compare->shown() || m_compare->views().frameIsCurrent()) m_motion->announceShownFrame();
        m_works->follow();
        updateIdle();
    };
    connect(m_openStudy.get(), &OpenStudy::openFailed, this, &MainWindow::updateIdle);
    connect(m_openStudy.get(), &OpenStudy::cuttingChanged, this, somethingEnded);
    connect(&m_compare->views(), &ComparedViews::frameShown, this, somethingEnded);
    // What the 3D view took last says nothing of the panes.
    connect(&m_compare->views(), &ComparedViews::frameShown, this, [this] {
        const CastPicture& frame = *m_compare->views().frame();
        if (frame.converged()) m_widgets.status->setRenderer(tr("software renderer"), frame.milliseconds);
    });
    connect(m_panes.get(), &ShownPanes::changed, this, somethingEnded);
    connect(m_otfs.get(), &PaneOtfs::busyChanged, this, somethingEnded);
    connect(m_widgets.picture, &VolumeViewWidget::busyChanged, this, somethingEnded);
    connect(m_widgets.picture, &VolumeViewWidget::pictureDelivered, this, somethingEnded);
    connect(m_widgets.picture, &VolumeViewWidget::pictureDrawn, m_motion.get(), &MotionFrames::announceShownFrame);
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
        // What is measured stands below the pictures that are compared.
        if (m_compare->shown())
            m_widgets.messages->lieOver(*m_widgets.compared, Qt::TopEdge);
        else
            m_widgets.messages->lieOver(room);
    };
    connect(m_widgets.panes, &PaneGrid::paneLayoutChanged, this, placeMessages);
    connect(m_compare.get(), &CompareRoom::shownChanged, this, [this, placeMessages](bool shown) {
        placeMessages();
        arrangeForComparison(shown);
    });
    connect(m_room.get(), &ReviewRoom::busyChanged, this, &MainWindow::updateIdle);
    connect(m_recentPictures.get(), &RecentPictures::busyChanged, this, &MainWindow::updateIdle);
    connect(m_openStudy.get(), &OpenStudy::takingChecksumChanged, this, &MainWindow::updateIdle);
    connect(&m_presets->pictures(), &PresetPictures::busyChanged, this, &MainWindow::updateIdle);
    connect(&m_motionPlayer, &MotionPlayer::playingChanged, this, &MainWindow::updateIdle);
    connect(&m_motionPlayer, &MotionPlayer::frameChanged, this, &MainWindow::updateIdle);
}

/// The tab of the planes, of which a comparison shows none, makes way for that of the comparison.
void MainWindow::arrangeForComparison(bool shown) {
    auto* planes = findChild<QDockWidget*>("dock.room");
    if (shown) {
        m_planesTabWasThere = !planes->isHidden();
        planes->hide();
    } else {
        planes->setVisible(m_planesTabWasThere);
    }
    m_widgets.compareDock->setVisible(shown);
    (shown ? m_widgets.compareDock : findChild<QDockWidget*>("dock.view"))->raise();
}

bool MainWindow::idle() const {
    return atRest() && !m_presets->pictures().busy() && !m_recentPictures->busy() && !m_report->busy();
}

bool MainWindow::atRest() const {
    return !m_openStudy->loading() && !m_loadingPicture->busy() && !m_openStudy->takingChecksum() &&
           !m_openStudy->cutting() && !m_otfs->busy() && !m_nearCutFinder->busy() &&
           !m_openStudy->quietPhases().busy() && !m_sessions->busy() && !m_widgets.picture->busy() && !m_room->busy() &&
           !m_compare->busy() && !m_opening->busy() && !m_movies->busy() && !m_motionPlayer.isPlaying();
}

void MainWindow::updateIdle() {
    m_presets->pictures().setAtRest(atRest());
    m_recentPictures->setAtRest(atRest());
    m_report->setAtRest(atRest());
    if (idle() == m_idle) return;
    m_idle = !m_idle;
    emit idleChanged(m_idle);
}

}  // namespace echolucent
