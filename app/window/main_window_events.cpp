// What the window does when it is shown, closed, or given keys and files.
#include <QCloseEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QTimer>
#include <utility>

#include "app/lesson/lesson_player.h"
#include "app/motion/movie_files.h"
#include "app/picture/panes_saving.h"
#include "app/report/report_saving.h"
#include "app/sessions/session_keeping.h"
#include "app/study/study_opening.h"
#include "app/window/curve_and_picture_files.h"
#include "app/window/full_screen.h"
#include "app/window/main_window.h"
#include "app/window/window_place.h"

namespace echolucent {

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_shown, true)) return;
    QTimer::singleShot(0, this, [this] {
        keepOnScreen(*this);  // only now the frame is known
        emit shown();
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_lessons->leaveNow();  // the person's own session is asked for and remembered
    if (!m_sessions->mayClose() || !m_files->mayLoseManualCurve()) {
        event->ignore();
        return;
    }
    m_motionPlayer.pause();
    m_movies->cancel();
    m_report->cancel();
    m_panesSaving->cancel();
    m_fullScreen->leave();  // the hidden parts must be there again at the next start
    keepSettings();
    event->accept();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_escapes.endFirst()) return;
    QMainWindow::keyPressEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (!event->mimeData()->hasUrls()) return;
    event->acceptProposedAction();
    m_opening->openDropped(event->mimeData()->urls());
}

}  // namespace echolucent
