#include "tests/app/stress/lesson_actions.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>
#include <QListWidget>
#include <QTest>

#include "app/compare/compare_room.h"
#include "app/compare/paper_figures.h"
#include "app/explain/tube_core_choice.h"
#include "app/lesson/lesson_player.h"
#include "app/sessions/session_keeping.h"
#include "app/window/window_faces.h"
#include "tests/app/stress/window_checks.h"

namespace echolucent {

namespace {

/// The lesson on a scan of a few voxels, which is made and cast sooner.
Lesson small(Lesson lesson) {
    std::get<SimulatedScan>(lesson.begins.study).size = {44, 40, 42};
    return lesson;
}

}  // namespace

LessonActions::LessonActions(MainWindow& window, WindowHand& hand, const StressFiles& files)
    : m_window(window), m_hand(hand), m_studies(files.studies) {
    connect(&m_window.openStudy(), &OpenStudy::aboutToReplace, this, [this] { m_leaving = ownNow(); });
    connect(&m_window.lessonPlayer(), &LessonPlayer::playingChanged, this, [this](bool playing) {
        if (playing) m_own = m_leaving;
    });
    connect(&m_window.openStudy(), &OpenStudy::studyOpened, this, &LessonActions::checkWhatCameBack);
}

LessonActions::Own LessonActions::ownNow() {
    DocumentModel& model = m_window.document();
    SessionKeeping& sessions = m_window.sessionKeeping();
    const Document document = model.ownDocument();
    return {m_window.openStudy().study(),
            document,
            bytesOf(m_window, document),
            model.steps().count(),
            model.steps().index(),
            sessions.snapshots().list().size(),
            sessions.file()};
}

void LessonActions::checkWhatCameBack() {
    if (!m_own || m_window.lessonPlayer().playing()) return;
    const Own own = *std::exchange(m_own, std::nullopt);
    const Own now = ownNow();
    if (now.study == own.study) {
        if (now.bytes != own.bytes)
            fail("the lesson left another document: " + difference(now.bytes, own.bytes));
        else if (now.steps != own.steps || now.index != own.index)
            fail("the lesson left other steps");
        else if (now.snapshots != own.snapshots || now.session != own.session)
            fail("the lesson left another session");
    } else if (!m_window.openStudy().saved() && !m_window.openStudy().given()) {
        CurveSet curves = own.document.curves;
        curves.adjustment = {};
        if (now.document.curves != curves || now.document.scene.look != own.document.scene.look)
            fail("the study that ended the lesson took over other curves or another look than the person's");
    }
}

std::vector<StressAction> LessonActions::actions() {
    const auto own = [this](QString (LessonActions::*run)(RandomChoice&)) {
        return [this, run](RandomChoice& choice) { return (this->*run)(choice); };
    };
    const auto controlOf = [this](const char* dock) {
        return [this, dock](RandomChoice& choice) { return m_hand.turnControlOf(choice, QLatin1String(dock)); };
    };
    const auto click = [this](const char* name) {
        return [this, name](RandomChoice&) {
            auto* button = m_window.findChild<QAbstractButton*>(QLatin1String(name));
            const bool there = m_window.lessonPlayer().playing() && button->isEnabled() && !button->isHidden();
            if (there) button->click();
            return there ? QStringLiteral("step %1").arg(m_window.lessonPlayer().step() + 1) : QString();
        };
    };
    return {{"enter a lesson", 70, own(&LessonActions::enter)},
            {"next", 330, click("lessons.next")},
            {"back", 45, click("lessons.back")},
            {"skip", 170, click("lessons.skip")},
            {"reset", 40, click("lessons.reset")},
            {"hint", 20, click("lessons.hint")},
            {"answer", 70, own(&LessonActions::answer)},
            {"leave", 12, own(&LessonActions::leave)},
            {"close the panel", 12, own(&LessonActions::closePanel)},
            {"another study", 12, own(&LessonActions::open)},
            {"face", 15, own(&LessonActions::chooseFace)},
            {"compare", 20, own(&LessonActions::compare)},
            {"figure", 15, own(&LessonActions::showFigure)},
            {"control of Lessons", 60, controlOf("dock.lessons")},
            {"control of Tube cores", 80, controlOf("dock.tubeCores")},
            {"control of Compare", 40, controlOf("dock.compare")},
            {"control of Theory", 15, controlOf("dock.theory")},
            {"control of Method", 30, controlOf("dock.method")},
            {"tube core", 40, own(&LessonActions::chooseTubeCore)},
            {"keep a snapshot", 10, own(&LessonActions::keepSnapshot)},
            {"full screen", 10, own(&LessonActions::switchFullScreen)}};
}

void LessonActions::end() { QTest::keyClick(&m_window, Qt::Key_Escape); }

QString LessonActions::enter(RandomChoice& choice) {
    LessonPlayer& player = m_window.lessonPlayer();
    if (player.playing() && !choice.chance(0.15)) return {};
    const auto number = choice.below(static_cast<int>(player.lessons().size()));
    if (choice.chance(0.03)) {  // on its own scan, which is larger
        m_window.findChild<QListWidget*>("lessons.list")->setCurrentRow(number);
        m_window.findChild<QAbstractButton*>("lessons.begin")->click();
        return QStringLiteral("%1, by its button").arg(number);
    }
    player.enter(small(player.lessons()[static_cast<std::size_t>(number)]));
    return QString::number(number);
}

QString LessonActions::open(RandomChoice& choice) {
    const QString file = choice.of(m_studies);
    m_window.open(file);
    return file;
}

QString LessonActions::answer(RandomChoice& choice) {
    const QString name = QStringLiteral("lessons.answer.%1").arg(choice.below(3));
    auto* button = m_window.findChild<QAbstractButton*>(name);
    if (button == nullptr || !m_window.lessonPlayer().playing()) return {};
    button->click();
    return name;
}

QString LessonActions::leave(RandomChoice& choice) {
    if (!m_window.lessonPlayer().playing()) return {};
    choice.chance(0.8) ? m_window.lessonPlayer().leave() : m_window.lessonPlayer().leaveNow();
    return {};
}

QString LessonActions::closePanel(RandomChoice& choice) {
    auto* dock = m_window.findChild<QDockWidget*>("dock.lessons");
    if (choice.chance(0.5))
        dock->hide();
    else
        dock->toggleViewAction()->trigger();
    return {};
}

QString LessonActions::chooseFace(RandomChoice& choice) {
    m_window.faces().choose(choice.chance(0.6) ? Face::teach : Face::review);
    return {};
}

QString LessonActions::compare(RandomChoice& choice) {
    m_window.compareRoom().setShown(choice.chance(0.6));
    return {};
}

QString LessonActions::showFigure(RandomChoice& choice) {
    const QString name = QStringLiteral("compare.figure%1").arg(choice.of(paperFigures()).number);
    m_window.findChild<QAction*>(name)->trigger();
    return name;
}

QString LessonActions::keepSnapshot(RandomChoice& choice) {
    if (m_window.openStudy().study() == nullptr) return {};
    Snapshots& snapshots = m_window.sessionKeeping().snapshots();
    if (snapshots.list().size() > 5) snapshots.remove(0);
    return snapshots.keep(QStringLiteral("kept %1").arg(choice.below(1'000'000'000)),
                          m_window.document().ownDocument());
}

QString LessonActions::switchFullScreen(RandomChoice&) {
    m_window.findChild<QAction*>("view.fullScreen")->trigger();
    return {};
}

QString LessonActions::chooseTubeCore(RandomChoice& choice) {
    const auto otf = m_window.otfs().adaptive();
    if (!otf || otf->tubes.empty()) return {};
    m_window.tubeCoreChoice().setShown(choice.chance(0.7));
    m_window.tubeCoreChoice().choose(choice.below(static_cast<int>(otf->tubes.size())));
    return QString::number(*m_window.tubeCoreChoice().number());
}

/// Reset gives one document, whatever was done since the step began, and is one step that can be taken back.
QString LessonActions::problemAtRest() {
    LessonPlayer& player = m_window.lessonPlayer();
    if (!player.playing()) return {};
    DocumentModel& model = m_window.document();
    const auto bytes = [&] { return bytesOf(m_window, model.ownDocument()); };
    const std::string before = bytes();
    const int index = model.steps().index();
    player.reset();
    const std::string began = bytes();
    if (model.steps().index() > index + 1) return "reset made several steps";
    if (model.steps().index() == index + 1) {
        model.steps().undo();
        if (bytes() != before) return "undo after reset is another document: " + difference(bytes(), before);
        model.steps().redo();
        if (bytes() != began) return "reset, done again, is another document: " + difference(bytes(), began);
    }
    player.reset();
    if (bytes() != began) return "the second reset is another document: " + difference(bytes(), began);
    if (m_own && ++m_rests % 6 == 0) player.leave();
    return {};
}

}  // namespace echolucent
