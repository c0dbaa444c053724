// Lessons in the window: their stage and their player.
#include <QAbstractButton>
#include <QStatusBar>

#include "app/lesson/lesson_author.h"
#include "app/lesson/lesson_handouts.h"
#include "app/lesson/lesson_player.h"
#include "app/lesson/lesson_stage.h"
#include "app/sessions/session_keeping.h"
#include "app/study/study_opening.h"
#include "app/window/full_screen.h"
#include "app/window/main_window.h"
#include "app/window/window_faces.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/view_panel.h"

namespace echolucent {

void MainWindow::createLessons() {
    m_lessonStage = std::make_unique<LessonStage>(
        LessonStage::Parts{*this,
                           *m_widgets.lessons,
                           *m_widgets.panes,
                           *m_tubeCoreChoice,
                           *m_widgets.theory,
                           *m_widgets.compare->findChild<QAbstractButton*>("compare.insets"),
                           {m_widgets.motion, statusBar()},
                           *m_widgets.controls});
    connect(m_fullScreen, &FullScreen::aboutToLeave, m_lessonStage.get(), &LessonStage::leaveFullScreen);
    connect(m_fullScreen, &FullScreen::changed, m_lessonStage.get(),
            [this] { m_lessonStage->fullScreenChanged(m_fullScreen->active()); });
    m_lessons = std::make_unique<LessonPlayer>(LessonPlayer::Parts{
        *this, m_document, m_openStudy, m_works, *m_otfs, *m_tubeCoreChoice, m_motionPlayer, *m_compare,
        *m_widgets.compare, *m_shownStudy, *m_sessions, *m_widgets.lessons, *m_lessonStage, *m_widgets.messages,
        [this] { return m_faces->face(); }, [this](Face face) { m_faces->choose(face); }});
    connect(m_lessons.get(), &LessonPlayer::playingChanged, this, &MainWindow::followStrip);
    connect(m_opening.get(), &StudyOpening::lessonChosen, m_lessons.get(), &LessonPlayer::enterFolder);
    m_lessonHandouts = std::make_unique<LessonHandouts>(
        LessonHandouts::Parts{*this, m_openStudy, m_works, m_settings, *m_widgets.messages, m_names});
    m_lessonAuthor = std::make_unique<LessonAuthor>(
        LessonAuthor::Parts{*this, m_document, m_openStudy, m_sessions->snapshots(), *m_compare, *m_lessons,
                            *m_lessonHandouts, *m_widgets.lessons, m_settings, *m_widgets.messages, m_names});
    // Panels that are moved on the full screen would be in their places before once it is left.
    connect(m_lessons.get(), &LessonPlayer::aboutToArrange, m_fullScreen, &FullScreen::leave);
}

}  // namespace echolucent
