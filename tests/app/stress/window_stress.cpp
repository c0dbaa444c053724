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
#include "app/motion/movie_files.h"
#include "app/otf/near_cut_finder.h"
#include "app/sessions/session_keeping.h"
#include "app/window/review_room.h"
#include "io/document/document_file.h"
#include "processing/document/panes.h"
#include "tests/app/stress/document_changes.h"

namespace echolucent {

namespace {

constexpr int longestRest = 120'000;  // ms

/// Where two texts differ first.
QString difference(const std::string& one, const std::string& other) {
    std::size_t at = 0;
    while (at < std::min(one.size(), other.size()) && one[at] == other[at]) ++at;
    const std::size_t from = at > 60 ? at - 60 : 0;
    return QString::fromStdString("\"" + one.substr(from, 140) + "\" and \"" + other.substr(from, 140) + "\"");
}

}  // namespace

WindowStress::WindowStress(MainWindow& window, const StressFiles& files, std::uint64_t seed, const QString& log)
    : m_window(window),
      m_files(files),
      m_seed(seed),
      m_hand(window),
      m_log(log),
      m_first(window.document().ownDocument()),
      m_layout(window.saveState()) {
    if (!m_log.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) qFatal("cannot write %s", qPrintable(log));
    connect(&model().steps(), &DocumentSteps::changed, this, [this] {
        if (m_window.openStudy().beginning() && model().steps().count() == 0) m_begun = model().ownDocument();
    });
    connect(&m_window.openStudy(), &OpenStudy::openFailed, this, [this](const QString& path, const Failure& failure) {
        if (!m_files.failures.contains(path))
            fail(QStringLiteral("%1 was not opened: %2").arg(path, QString::fromStdString(failure.sentence())));
    });
    connect(&m_window.openStudy(), &OpenStudy::savedStudyAsked, this, [this](const SavedStudyProblem& problem) {
        fail(QStringLiteral("the study of a session was not found: %1").arg(QString::fromStdString(problem.file)));
    });
}

const std::vector<WindowStress::Action>& WindowStress::actions() {
    static const std::vector<Action> all{{"edit", 250, &WindowStress::edit},
                                         {"preview", 50, &WindowStress::preview},
                                         {"undo", 70, &WindowStress::undo},
                                         {"redo", 40, &WindowStress::redo},
                                         {"jump in the history", 5, &WindowStress::jump},
                                         {"phase", 30, &WindowStress::showPhase},
                                         {"play", 20, &WindowStress::play},
                                         {"compare", 8, &WindowStress::compare},
                                         {"open", 8, &WindowStress::open},
                                         {"open what fails", 5, &WindowStress::openWhatFails},
                                         {"open a session", 3, &WindowStress::openSession},
                                         {"open the simulated scan", 1, &WindowStress::openSimulatedScan},
                                         {"cancel", 15, &WindowStress::cancel},
                                         {"save the session", 4, &WindowStress::saveSession},
                                         {"save something else", 1, &WindowStress::saveOther},
                                         {"wait for rest", 3, &WindowStress::waitForRest},
                                         {"undo all", 3, &WindowStress::undoAll},
                                         {"drag", 130, &WindowStress::drag},
                                         {"drag, interrupted", 15, &WindowStress::dragInterrupted},
                                         {"wheel", 40, &WindowStress::turnWheel},
                                         {"double click", 15, &WindowStress::doubleClick},
                                         {"keys", 60, &WindowStress::pressKeys},
                                         {"control", 180, &WindowStress::turnControl},
                                         {"panel", 30, &WindowStress::raisePanel},
                                         {"menu", 50, &WindowStress::triggerAction},
                                         {"dialog", 3, &WindowStress::askAndDismiss}};
    return all;
}

QString WindowStress::run(int first, int end) {
    int weights = 0;
    for (const Action& action : actions()) weights += action.weight;
    for (int number = first; number < end && m_problem.isEmpty(); ++number) {
        RandomChoice choice(m_seed, static_cast<std::uint64_t>(number));
        int place = choice.below(weights);
        auto action = actions().begin();
        for (; place >= action->weight; ++action) place -= action->weight;
        tell(QStringLiteral("%1 %2").arg(number).arg(action->name));
        const QString done = (this->*action->run)(choice);
        if (!done.isEmpty()) tell("    " + done);
        m_hand.dismissDialogs();
        if (choice.chance(0.6)) QCoreApplication::processEvents();
        if (const std::string problem = problemOf(model().document()); !problem.empty())
            fail("the document breaks a rule: " + QString::fromStdString(problem));
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

std::string WindowStress::bytesOf(Document document) const {
    document = withShown(std::move(document), Document{});
    // A checksum is known some time after the opening.
    const StudyReference& newest = m_window.document().document().study;
    if (nameTheSame(document.study, newest)) document.study = newest;
    return jsonOf(document);
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

QString WindowStress::underWay() const {
    OpenStudy& study = m_window.openStudy();
    QStringList names;
    const auto add = [&](bool busy, const char* name) {
        if (busy) names << name;
    };
    add(study.loading(), "loading");
    add(study.takingChecksum(), "checksum");
    add(study.cutting(), "scalpel");
    add(study.quietPhases().busy(), "speckle reduction");
    add(m_window.otfs().busy(), "OTFs");
    add(m_window.nearCutFinder().busy(), "near cut");
    add(m_window.sessionKeeping().saving(), "session");
    add(!m_window.volumeView().pictureIsFine(), "picture");
    add(m_window.movieFiles().busy(), "movie");
    add(m_window.motionPlayer().isPlaying(), "motion");
    return names.isEmpty() ? QStringLiteral("something else") : names.join(", ");
}

QString WindowStress::rest() {
    m_window.motionPlayer().pause();
    QElapsedTimer waited;
    waited.start();
    QTimer wakes;  // a work that never ends sends no event
    wakes.start(100);
    while (!m_window.idle()) {
        if (waited.elapsed() > longestRest) return "the window never rests: " + underWay();
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
        m_window.motionPlayer().pause();
    }
    return {};
}

QString WindowStress::checkRest() {
    const Document& document = m_window.document().document();
    OpenStudy& study = m_window.openStudy();
    if (!study.study()) return {};
    if (study.phase() != document.scene.phase) return "the study shows another phase than the document";
    if (study.strokes() != document.scene.strokes.values()) return "other strokes are cut than the document's";
    if (m_window.volumeView().look() != document.scene.look) return "the picture has another look than the document";
    if (m_window.volumeView().isVisible() &&
        !(m_window.volumeView().pictureIsCurrent() && m_window.volumeView().pictureIsFine()))
        return "the picture is not that of the document, converged";
    const ComparedViews& compared = m_window.compareRoom().views();
    if (m_window.compareRoom().shown() && isCompared(document) && !compared.settled() && !compared.refused())
        return "the comparison is not that of the document, converged";
    return checkReading();
}

QString WindowStress::checkReading() const {
    const Document& document = m_window.document().document();
    const auto read = documentFromJson(jsonOf(document));
    if (!read) return "the document cannot be read again: " + QString::fromStdString(read.error().sentence());
    if (*read == document) return {};
    return "the document that is read again is another one: " + difference(jsonOf(document), jsonOf(*read));
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
        if (const QString problem = checkReading(); !problem.isEmpty())
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
