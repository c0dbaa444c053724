#include "tests/app/stress/compare_actions.h"

#include <QAbstractButton>
#include <QAction>
#include <QDir>
#include <QTest>

#include "app/compare/compare_room.h"
#include "app/compare/paper_figures.h"
#include "app/explain/tube_core_choice.h"
#include "app/motion/movie_files.h"
#include "app/picture/panes_saving.h"
#include "app/sessions/session_keeping.h"
#include "app/window/window_faces.h"
#include "io/document/session_file.h"
#include "tests/app/stress/document_changes.h"
#include "tests/app/stress/window_checks.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/panels/history_panel.h"

namespace echolucent {

CompareActions::CompareActions(MainWindow& window, WindowHand& hand, const StressFiles& files)
    : m_window(window), m_hand(hand), m_studies(files.studies), m_folder(files.folder) {}

std::vector<StressAction> CompareActions::actions() {
    const auto own = [this](QString (CompareActions::*run)(RandomChoice&)) {
        return [this, run](RandomChoice& choice) { return (this->*run)(choice); };
    };
    const auto controlOf = [this](const char* dock) {
        return [this, dock](RandomChoice& choice) { return m_hand.turnControlOf(choice, QLatin1String(dock)); };
    };
    return {{"show the comparison", 60, own(&CompareActions::show)},
            {"change panes", 180, own(&CompareActions::changePanes)},
            {"control of Compare", 260, controlOf("dock.compare")},
            {"control of Method", 60, controlOf("dock.method")},
            {"control of Tube cores", 40, controlOf("dock.tubeCores")},
            {"another study", 35, own(&CompareActions::open)},
            {"figure", 60, own(&CompareActions::showFigure)},
            {"answer the message", 15, own(&CompareActions::answerMessage)},
            {"focus a pane", 40, own(&CompareActions::focusPane)},
            {"explain", 15, own(&CompareActions::explain)},
            {"turn the motion", 50, own(&CompareActions::turnMotion)},
            {"tube core", 30, own(&CompareActions::chooseTubeCore)},
            {"compare without it", 20, own(&CompareActions::compareWithoutIt)},
            {"save a file", 15, own(&CompareActions::saveFile)},
            {"keep a snapshot", 15, own(&CompareActions::keepSnapshot)},
            {"return to a snapshot", 30, own(&CompareActions::returnToSnapshot)},
            {"full screen", 12, own(&CompareActions::switchFullScreen)},
            {"face", 6, own(&CompareActions::chooseFace)}};
}

void CompareActions::end() { QTest::keyClick(&m_window, Qt::Key_Escape); }

QString CompareActions::show(RandomChoice& choice) {
    if (choice.chance(0.3))
        QTest::keyClick(&m_window, Qt::Key_F5);
    else
        m_window.compareRoom().setShown(choice.chance(0.85));
    return m_window.compareRoom().shown() ? "shown" : "left";
}

QString CompareActions::changePanes(RandomChoice& choice) {
    const Study* study = m_window.openStudy().study();
    if (study == nullptr) return {};
    DocumentModel& model = m_window.document();
    const ChangedDocument next = withChangedPanes(
        model.document(), {m_window.openStudy().volume()->dataBox(), static_cast<int>(study->phases.size())}, choice);
    model.edit(next.document, next.what);
    return next.what;
}

QString CompareActions::open(RandomChoice& choice) {
    // The first one has several phases.
    const QString file = choice.chance(0.4) ? m_studies.first() : choice.of(m_studies);
    m_window.open(file);
    return file;
}

QString CompareActions::showFigure(RandomChoice& choice) {
    const int figure = choice.of(paperFigures()).number;
    // Of another study it asks first, and that study is larger.
    const QString name = choice.chance(0.1) ? QStringLiteral("compare.motions")
                                            : QStringLiteral("compare.figure%1%2")
                                                  .arg(figure)
                                                  .arg(choice.chance(0.1) ? QStringLiteral(".shapes") : QString());
    m_window.findChild<QAction*>(name)->trigger();
    return name;
}

QString CompareActions::answerMessage(RandomChoice& choice) {
    auto* action = m_window.findChild<QAbstractButton*>("message.action.0");
    if (action == nullptr || !action->isVisible() || !choice.chance(0.5)) return {};
    const QString text = action->text();
    action->click();
    return text;
}

QString CompareActions::focusPane(RandomChoice& choice) {
    auto& grid = *m_window.findChild<CompareGrid*>("compare.panes");
    const auto place = static_cast<std::size_t>(choice.below(static_cast<int>(mostPanes)));
    if (!grid.pane(place).isVisible()) return {};
    grid.pane(place).setFocus();
    return QStringLiteral("pane %1").arg(place + 1);
}

QString CompareActions::explain(RandomChoice&) {
    m_window.findChild<QAction*>("help.explain")->trigger();
    if (m_window.openStudy().study() == nullptr || !m_window.compareRoom().shown()) return {};
    const std::size_t pane = m_window.compareRoom().explainedPane();
    const QString begins =
        QStringLiteral("Pane %1: %2.").arg(pane + 1).arg(captionOfPane(m_window.document().document(), pane));
    const QString words = m_window.explanationOfPane();
    if (!words.startsWith(begins)) fail("the explanation is of another pane than " + begins + ' ' + words.left(80));
    return begins;
}

QString CompareActions::turnMotion(RandomChoice& choice) {
    const int degrees = choice.below(61) - 30;
    choice.chance(0.5) ? m_window.motionPlayer().setAngle(degrees) : m_window.motionPlayer().stepBy(degrees / 10);
    return QString::number(degrees);
}

QString CompareActions::chooseTubeCore(RandomChoice& choice) {
    const auto otf = m_window.otfs().adaptive();
    if (!otf || otf->tubes.empty()) return {};
    m_window.tubeCoreChoice().setShown(choice.chance(0.7));
    const int number = choice.below(static_cast<int>(otf->tubes.size()));
    m_window.tubeCoreChoice().choose(choice.chance(0.1) ? std::nullopt : std::optional(number));
    return QString::number(number);
}

QString CompareActions::compareWithoutIt(RandomChoice& choice) {
    auto* button = m_window.findChild<QAbstractButton*>("tubeCores.compare");
    if (!button->isEnabled()) (void)chooseTubeCore(choice);
    if (!button->isEnabled()) return "not offered";
    button->click();
    return {};
}

QString CompareActions::saveFile(RandomChoice& choice) {
    if (m_window.openStudy().study() == nullptr) return {};
    switch (choice.below(7)) {
        case 0:
        case 1: m_window.compareRoom().savePage(m_folder + "/stress-page.html"); return "page";
        case 2:
        case 3: m_window.savePicture(m_folder + "/stress.png"); return "picture";
        case 4:
        case 5:
            m_window.panesSaving().save(m_folder + "/stress-panes.png",
                                        {.allPanes = choice.chance(0.7), .width = 200 + choice.below(300)});
            return "all panes";
        default:
            m_window.movieFiles().begin(
                FrameOutput::series,
                {.path = m_folder + "/stress-series.png", .size = {48, 48}, .labels = false, .replace = true});
            return "series";
    }
}

QString CompareActions::keepSnapshot(RandomChoice& choice) {
    if (m_window.openStudy().study() == nullptr) return {};
    Snapshots& snapshots = m_window.sessionKeeping().snapshots();
    const int count = static_cast<int>(snapshots.list().size());
    if (count > 5) {
        snapshots.remove(choice.below(count));
        return "one removed";
    }
    // The name is the number of what is kept, which no other has.
    return snapshots.keep(QStringLiteral("kept %1").arg(choice.below(1'000'000'000)),
                          m_window.document().ownDocument());
}

QString CompareActions::returnToSnapshot(RandomChoice& choice) {
    const auto& list = m_window.sessionKeeping().snapshots().list();
    if (m_window.openStudy().study() == nullptr || list.empty()) return {};
    const int number = choice.below(static_cast<int>(list.size()));
    Document kept = list[static_cast<std::size_t>(number)].document;
    emit m_window.findChild<HistoryPanel*>()->chosen(number);
    const Document now = m_window.document().ownDocument();
    kept.study = now.study;
    if (bytesOf(m_window, now) != bytesOf(m_window, kept))
        fail("the snapshot is another document: " + difference(bytesOf(m_window, now), bytesOf(m_window, kept)));
    return QString::number(number);
}

QString CompareActions::switchFullScreen(RandomChoice&) {
    m_window.findChild<QAction*>("view.fullScreen")->trigger();
    return {};
}

QString CompareActions::chooseFace(RandomChoice& choice) {
    m_window.faces().choose(choice.chance(0.7) ? Face::teach : Face::review);
    return {};
}

QString CompareActions::problemAtRest() {
    if (m_window.openStudy().study() == nullptr) return {};
    ++m_rests;
    if (const QString problem = problemOfSnapshots(); !problem.isEmpty()) return problem;
    if (const QString problem = problemOfFigure(); !problem.isEmpty()) return problem;
    return problemOfSession();
}

/// Each snapshot is returned to and left again.
QString CompareActions::problemOfSnapshots() {
    DocumentModel& model = m_window.document();
    const std::string before = bytesOf(m_window, model.ownDocument());
    const auto count = static_cast<int>(m_window.sessionKeeping().snapshots().list().size());
    for (int number = 0; number < count; ++number) {
        const int index = model.steps().index();
        const Document kept = m_window.sessionKeeping().snapshots().list()[static_cast<std::size_t>(number)].document;
        emit m_window.findChild<HistoryPanel*>()->chosen(number);
        if (isCompared(kept) != m_window.compareRoom().shown() && isCompared(kept))
            return "a snapshot of a comparison does not show it";
        if (model.steps().index() == index) continue;  // the document is the same
        model.steps().undo();
        if (bytesOf(m_window, model.ownDocument()) != before)
            return "undo after a snapshot is another document: " +
                   difference(bytesOf(m_window, model.ownDocument()), before);
    }
    return {};
}

/// One of the figures is set up, taken back and done again.
QString CompareActions::problemOfFigure() {
    DocumentModel& model = m_window.document();
    const int figure = paperFigures()[static_cast<std::size_t>(m_rests) % paperFigures().size()].number;
    const std::string before = bytesOf(m_window, model.ownDocument());
    const std::string wanted = bytesOf(m_window, withFigure(model.ownDocument(), figure));
    const int index = model.steps().index();
    const auto shows = [&](const std::string& bytes, const char* what) {
        const std::string now = bytesOf(m_window, model.ownDocument());
        return now == bytes ? QString()
                            : QStringLiteral("figure %1, %2: ").arg(figure).arg(what) + difference(now, bytes);
    };
    m_window.findChild<QAction*>(QStringLiteral("compare.figure%1").arg(figure))->trigger();
    if (const QString problem = shows(wanted, "set up"); !problem.isEmpty()) return problem;
    if (model.steps().index() == index) return {};
    model.steps().undo();
    if (const QString problem = shows(before, "undone"); !problem.isEmpty()) return problem;
    model.steps().redo();
    if (const QString problem = shows(wanted, "done again"); !problem.isEmpty()) return problem;
    if (m_rests % 2 == 0) model.steps().undo();
    return {};
}

/// What is saved is read again byte for byte.
QString CompareActions::problemOfSession() {
    SessionKeeping& sessions = m_window.sessionKeeping();
    const QString file = m_folder + "/stress-checked.session.json";
    QFile::remove(file);
    const SavedSession wanted{.document = m_window.document().ownDocument(), .snapshots = sessions.snapshots().list()};
    sessions.saveAs(file);
    if (!QTest::qWaitFor([&sessions] { return !sessions.saving(); }, patience)) return "the session is not saved";
    auto read = readSession(file.toStdString());
    if (!read) return "the session cannot be read: " + QString::fromStdString(read.error().sentence());
    read->document.study = wanted.document.study;  // the file names it from its own folder
    if (jsonOf(read->document) != jsonOf(wanted.document))
        return "the session holds another document: " + difference(jsonOf(read->document), jsonOf(wanted.document));
    if (read->snapshots.size() != wanted.snapshots.size()) return "the session holds other snapshots";
    for (std::size_t i = 0; i < wanted.snapshots.size(); ++i) {
        Document kept = wanted.snapshots[i].document;
        kept.study = read->snapshots[i].document.study;
        if (jsonOf(kept) != jsonOf(read->snapshots[i].document)) return "the session holds another snapshot";
    }
    return {};
}

}  // namespace echolucent
