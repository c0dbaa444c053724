#include "tests/app/stress/window_stress.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTest>
#include <QTimer>
#include <algorithm>

#include "app/compare/compare_room.h"
#include "app/lesson/lesson_player.h"
#include "app/sessions/session_keeping.h"
#include "app/window/review_room.h"
#include "app/window/window_faces.h"
#include "tests/app/stress/document_changes.h"
#include "tests/app/stress/window_checks.h"
#include "widgets/controls/message_bar.h"

namespace echolucent {

namespace {

constexpr int longestRest = 120'000;  // ms

}  // namespace

WindowStress::WindowStress(MainWindow& window, const StressFiles& files, std::uint64_t seed, const QString& log)
    : m_window(window),
      m_files(files),
      m_seed(seed),
      m_hand(window),
      m_log(log),
      m_first(window.document().ownDocument()),
      m_layout(window.saveState()) {
    m_clock.start();
    if (!m_log.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) qFatal("cannot write %s", qPrintable(log));
    connect(&model().steps(), &DocumentSteps::changed, this, [this] {
        if (m_window.openStudy().beginning() && model().steps().count() == 0) m_begun = model().ownDocument();
    });
    // A study that comes back has its steps.
    connect(&m_window.openStudy(), &OpenStudy::aboutToReplace, this, [this] { m_begun.reset(); });
    connect(&m_window.openStudy(), &OpenStudy::openFailed, this, [this](const QString& path, const Failure& failure) {
        if (!m_files.failures.contains(path))
            fail(QStringLiteral("%1 was not opened: %2").arg(path, QString::fromStdString(failure.sentence())));
    });
    connect(&m_window.openStudy(), &OpenStudy::savedStudyAsked, this, [this](const SavedStudyProblem& problem) {
        fail(QStringLiteral("the study of a session was not found: %1").arg(QString::fromStdString(problem.file)));
    });
}

std::vector<StressAction> WindowStress::actionsOfEveryRun() {
    const auto own = [this](QString (WindowStress::*does)(RandomChoice&)) {
        return [this, does](RandomChoice& choice) { return (this->*does)(choice); };
    };
    const auto byHand = [this](QString (WindowHand::*does)(RandomChoice&)) {
        return [this, does](RandomChoice& choice) { return (m_hand.*does)(choice); };
    };
    return {{"edit", 250, own(&WindowStress::edit)},
            {"preview", 50, own(&WindowStress::preview)},
            {"undo", 70, own(&WindowStress::undo)},
            {"redo", 40, own(&WindowStress::redo)},
            {"jump in the history", 5, own(&WindowStress::jump)},
            {"phase", 30, own(&WindowStress::showPhase)},
            {"play", 20, own(&WindowStress::play)},
            {"compare", 8, own(&WindowStress::compare)},
            {"open", 8, own(&WindowStress::open)},
            {"open what fails", 5, own(&WindowStress::openWhatFails)},
            {"open a session", 3, own(&WindowStress::openSession)},
            {"open the simulated scan", 1, own(&WindowStress::openSimulatedScan)},
            {"cancel", 15, own(&WindowStress::cancel)},
            {"save the session", 4, own(&WindowStress::saveSession)},
            {"save something else", 1, own(&WindowStress::saveOther)},
            {"wait for rest", 3, own(&WindowStress::waitForRest)},
            {"undo all", 3, own(&WindowStress::undoAll)},
            {"drag", 130, [this](RandomChoice& choice) { return m_hand.drag(choice); }},
            {"drag, interrupted", 15, own(&WindowStress::dragInterrupted)},
            {"wheel", 40, byHand(&WindowHand::turnWheel)},
            {"double click", 15, byHand(&WindowHand::doubleClick)},
            {"keys", 60, byHand(&WindowHand::pressKeys)},
            {"control", 180, byHand(&WindowHand::turnControl)},
            {"panel", 30, byHand(&WindowHand::raisePanel)},
            {"menu", 50, byHand(&WindowHand::triggerAction)},
            {"dialog", 3, byHand(&WindowHand::askAndDismiss)}};
}

void WindowStress::add(StressPart& part, int actionsBetweenRests) {
    m_part = &part;
    m_actionsBetweenRests = actionsBetweenRests;
    for (StressAction& action : part.actions()) m_actions.push_back(std::move(action));
}

QString WindowStress::run(int first, int end) {
    if (m_part) {  // all of it takes less time on a small study
        m_window.open(m_files.studies.first());
        if (const QString problem = rest(); !problem.isEmpty()) return problem;
    }
    int weights = 0;
    for (const StressAction& action : m_actions) weights += action.weight;
    for (int number = first; number < end && m_problem.isEmpty(); ++number) {
        RandomChoice choice(m_seed, static_cast<std::uint64_t>(number));
        int place = choice.below(weights);
        auto action = m_actions.begin();
        for (; place >= action->weight; ++action) place -= action->weight;
        tell(QStringLiteral("%1 %2, after %3 s").arg(number).arg(action->name).arg(m_clock.elapsed() / 1000));
        const QString done = action->run(choice);
        if (!done.isEmpty()) tell("    " + done);
        m_hand.dismissDialogs();
        if (choice.chance(0.6)) QCoreApplication::processEvents();
        const QString said = m_window.findChild<MessageBar*>()->text();
        if (std::exchange(m_said, said) != said && !said.isEmpty()) tell("    says: " + said);
        if (const std::string problem = problemOf(model().document()); !problem.empty())
            fail("the document breaks a rule: " + QString::fromStdString(problem));
        if (m_part) fail(m_part->problem());
        if (m_part && number % m_actionsBetweenRests == m_actionsBetweenRests - 1) checkAll(choice);
        if (!m_problem.isEmpty()) tell("    " + m_problem);
    }
    return m_problem;
}

void WindowStress::fail(const QString& problem) {
    if (m_problem.isEmpty()) m_problem = problem;
}

void WindowStress::tell(const QString& line) { m_log.write(line.toUtf8() + '\n'); }

int WindowStress::phases() const {
    const Study* study = m_window.openStudy().study();
    return study ? static_cast<int>(study->phases.size()) : 1;
}

std::string WindowStress::bytes() const { return bytesOf(m_window.document().ownDocument()); }

QString WindowStress::sessionFile(int number) const {
    return QStringLiteral("%1/stress-%2.session.json").arg(m_files.folder).arg(number);
}

// ---- Actions

QString WindowStress::edit(RandomChoice& choice) {
    const auto volume = m_window.openStudy().volume();
    if (!volume) return {};
    const ChangedDocument next = changedByChance(model().document(), {volume->dataBox(), phases()}, choice);
    model().edit(next.document, next.what);
    return next.what;
}

QString WindowStress::preview(RandomChoice& choice) {
    const auto volume = m_window.openStudy().volume();
    if (!volume) return {};
    QStringList done;
    for (int i = 0; i <= choice.below(4); ++i) {
        const ChangedDocument next = changedByChance(model().document(), {volume->dataBox(), phases()}, choice);
        model().preview(next.document, next.what);
        done << next.what;
        if (choice.chance(0.5)) QCoreApplication::processEvents();
    }
    switch (choice.below(4)) {
        case 0: model().cancelPreview(); return done.join(", ") + ", cancelled";
        case 1: model().steps().undo(); return done.join(", ") + ", undone";
        case 2: return done.join(", ") + ", left";
        default: model().commitPreview(); return done.join(", ") + ", committed";
    }
}

QString WindowStress::undo(RandomChoice& choice) {
    const int count = choice.chance(0.7) ? 1 : 1 + choice.below(6);
    for (int i = 0; i < count; ++i) {
        if (choice.chance(0.5))
            QTest::keyClick(&m_window, Qt::Key_Z, Qt::ControlModifier);
        else
            model().steps().undo();
    }
    return QStringLiteral("%1 times").arg(count);
}

QString WindowStress::redo(RandomChoice& choice) {
    const int count = choice.chance(0.7) ? 1 : 1 + choice.below(6);
    for (int i = 0; i < count; ++i) {
        if (choice.chance(0.5))
            QTest::keyClick(&m_window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        else
            model().steps().redo();
    }
    return QStringLiteral("%1 times").arg(count);
}

QString WindowStress::jump(RandomChoice& choice) {
    const int index = choice.below(model().steps().count() + 1);
    model().steps().setIndex(index);
    return QStringLiteral("to %1 of %2").arg(index).arg(model().steps().count());
}

QString WindowStress::showPhase(RandomChoice& choice) {
    const int phase = choice.below(phases());
    model().showPhase(phase);
    return QString::number(phase);
}

QString WindowStress::play(RandomChoice& choice) {
    choice.chance(0.6) ? m_window.motionPlayer().togglePlaying() : m_window.motionPlayer().pause();
    return {};
}

QString WindowStress::compare(RandomChoice& choice) {
    m_window.compareRoom().setShown(choice.chance(0.5));
    return {};
}

QString WindowStress::open(RandomChoice& choice) {
    const QString file = choice.of(m_files.studies);
    m_window.open(file);
    return file;
}

QString WindowStress::openWhatFails(RandomChoice& choice) {
    const QString file = choice.of(m_files.failures);
    m_window.open(file);
    return file;
}

QString WindowStress::openSession(RandomChoice& choice) {
    const QString file = sessionFile(choice.below(3));
    if (!QFile::exists(file)) return {};
    m_window.open(file);
    return file;
}

QString WindowStress::openSimulatedScan(RandomChoice&) {
    m_window.openSimulatedScan();
    return {};
}

QString WindowStress::cancel(RandomChoice& choice) {
    auto* button = m_window.findChild<QAbstractButton*>("status.cancel");
    if (button->isVisible() && choice.chance(0.7)) {
        button->click();
        return "by the button";
    }
    switch (choice.below(4)) {
        case 0: m_window.openStudy().cancelLoading(); return "loading";
        case 1: m_window.openStudy().quietPhases().cancel(); return "speckle reduction";
        case 2: m_window.otfs().cancel(); return "OTFs";
        default: QTest::keyClick(&m_window, Qt::Key_Escape); return "Escape";
    }
}

QString WindowStress::saveSession(RandomChoice& choice) {
    const QString file = sessionFile(choice.below(3));
    m_window.sessionKeeping().saveAs(file);
    return file;
}

QString WindowStress::saveOther(RandomChoice& choice) {
    switch (choice.below(3)) {
        case 0: m_window.savePicture(m_files.folder + "/stress.png"); return "picture";
        case 1: m_window.saveReport(m_files.folder + "/stress-report.html", false); return "report";
        default: m_window.compareRoom().savePage(m_files.folder + "/stress-page.html"); return "page";
    }
}

QString WindowStress::waitForRest(RandomChoice&) {
    fail(rest());
    if (m_problem.isEmpty()) fail(checkRest());
    return {};
}

void WindowStress::checkAll(RandomChoice& choice) {
    (void)waitForRest(choice);
    if (m_problem.isEmpty()) tell("    rests, undone and done again: " + undoAll(choice));
    if (m_problem.isEmpty()) fail(rest());
    if (m_problem.isEmpty()) fail(checkRest());
    if (m_problem.isEmpty()) fail(m_part->problemAtRest());
    fail(m_part->problem());
}

QString WindowStress::undoAll(RandomChoice& choice) {
    const int steps = model().steps().count();
    fail(checkSteps());
    if (choice.chance(0.5)) model().steps().setIndex(choice.below(model().steps().count() + 1));
    return QStringLiteral("%1 steps").arg(steps);
}

QString WindowStress::dragInterrupted(RandomChoice& choice) {
    return m_hand.drag(choice, [&] {
        switch (choice.below(6)) {
            case 0: undo(choice); break;
            case 1: redo(choice); break;
            case 2: showPhase(choice); break;
            case 3: play(choice); break;
            case 4: edit(choice); break;
            default: open(choice);
        }
        QCoreApplication::processEvents();
    });
}

// ---- What must hold

QString WindowStress::rest() {
    m_window.motionPlayer().pause();
    QElapsedTimer waited;
    waited.start();
    QTimer wakes;  // a work that never ends sends no event
    wakes.start(100);
    while (!m_window.idle()) {
        if (waited.elapsed() > longestRest) return "the window never rests: " + workUnderWay(m_window);
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        m_window.motionPlayer().pause();
    }
    return {};
}

QString WindowStress::checkRest() {
    if (const QString problem = problemOfPictures(m_window); !problem.isEmpty()) return problem;
    if (const QString problem = problemOfPanes(m_window); !problem.isEmpty()) return problem;
    if (const QString problem = problemOfWords(m_window); !problem.isEmpty()) return problem;
    return problemOfReading(model().document());
}

QString WindowStress::checkSteps() {
    // A study that is being opened would begin another document meanwhile.
    if (const QString problem = rest(); !problem.isEmpty()) return problem;
    DocumentSteps& steps = model().steps();
    model().commitPreview();
    while (steps.canRedo()) steps.redo();
    const int count = steps.count();
    std::vector<std::string> states{bytes()};
    while (steps.canUndo()) {
        const int before = steps.index();
        steps.undo();
        if (steps.index() != before - 1 || steps.count() != count)
            return QStringLiteral("undo of step %1 made a step").arg(before);
        states.push_back(bytes());
        if (const QString problem = problemOfReading(model().document()); !problem.isEmpty())
            return QStringLiteral("state %1: %2").arg(steps.index()).arg(problem);
    }
    if (m_allStepsKept && steps.dropped() > 0) return "steps were dropped";
    if (m_allStepsKept && m_begun && states.back() != bytesOf(*m_begun))
        return "undo of all is not the document of the opening: " + difference(states.back(), bytesOf(*m_begun));
    if (const QString problem = rest(); !problem.isEmpty()) return problem;
    if (steps.index() != 0 || steps.count() != count)
        return "the oldest state did not stay: " + difference(states.back(), bytes());
    if (bytes() != states.back()) return "the oldest state changed: " + difference(bytes(), states.back());
    for (int index = 1; index <= count; ++index) {
        steps.redo();
        const std::string& state = states[static_cast<std::size_t>(count - index)];
        if (steps.index() != index || steps.count() != count)
            return QStringLiteral("redo of step %1 made a step").arg(index);
        if (bytes() != state) return QStringLiteral("state %1 differs: %2").arg(index).arg(difference(bytes(), state));
    }
    if (const QString problem = rest(); !problem.isEmpty()) return problem;
    if (bytes() != states.front()) return "the newest state changed: " + difference(bytes(), states.front());
    steps.setIndex(0);
    if (bytes() != states.back()) return "the oldest state differs: " + difference(bytes(), states.back());
    steps.setIndex(count);
    return {};
}

QString WindowStress::beginAnew() {
    tell("begins anew");
    m_hand.dismissDialogs();
    if (m_part) m_part->end();
    m_window.lessonPlayer().leaveNow();
    m_window.faces().choose(Face::review);
    m_window.motionPlayer().pause();
    m_window.compareRoom().setShown(false);
    m_window.restoreState(m_layout);
    m_window.findChild<QAction*>("room.only3d")->trigger();
    m_window.findChild<QAbstractButton*>("presets.open")->setChecked(false);
    if (const QString problem = rest(); !problem.isEmpty()) return problem;
    Document next = m_first;
    next.study = model().document().study;
    model().begin(next);
    m_window.openSimulatedScan();
    if (const QString problem = rest(); !problem.isEmpty()) return problem;
    model().begin(model().document());
    return rest();
}

}  // namespace echolucent
