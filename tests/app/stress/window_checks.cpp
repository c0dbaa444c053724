#include "tests/app/stress/window_checks.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QSpinBox>
#include <QTest>
#include <algorithm>

#include "app/compare/compare_room.h"
#include "app/compare/paper_figures.h"
#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_explaining.h"
#include "app/lesson/lesson_player.h"
#include "app/motion/movie_files.h"
#include "app/otf/near_cut_finder.h"
#include "app/sessions/session_keeping.h"
#include "io/document/document_file.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/panes.h"
#include "processing/pane_picture/pane_caster.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/otf_editor/curve_style.h"

namespace echolucent {

namespace {

QString words(const std::string& text) { return QString::fromStdString(text); }

/// The classification of a pane, made here of the voxels that the window has; none if the motion smooths it.
std::optional<Classification> classificationAnew(MainWindow& window, std::size_t place) {
    const Document& document = window.document().document();
    if (!needsComputedOtf(document, place)) return classificationOf(document, place, {});
    OpenStudy& study = window.openStudy();
    const MotionOtf motion = document.panes[place].motionOtf.value_or(document.motion.otf);
    const auto asked = window.otfs().of(place);
    if (!asked || (motion != MotionOtf::oneOtf && motion != MotionOtf::eachView)) return std::nullopt;
    const int phases = static_cast<int>(study.study()->phases.size());
    const int phase = std::min(otfPhaseOf(document, place, phases), phases - 1);
    const QuietPhases& quiet = study.quietPhases();
    const auto raw = study.rawVoxelsOf(phase), shown = study.newestVoxelsOf(phase);
    DesignerInput input =
        designerInputOf(document, place, *raw, *shown, quiet.of(phase) ? quiet.reduction() : SpeckleReduction::off);
    // Without a choice of its own the pane looks as the motion does, which depends on its frames so far.
    if (!document.panes[place].motionOtf) input.view = asked->asked.view;
    const DesignerConfig* config = designerConfigOf(document, place);
    const auto made = design(config != nullptr ? *config : DesignerConfig(AdaptiveConfig{}), input);
    PaneOtf otf{.designed = made->classification};
    if (made->tubeCores) {
        otf.curve = made->tubeCores->curve;
        otf.designed = made->tubeCores->curve;
    }
    return classificationOf(document, place, otf);
}

QString problemOfPane(MainWindow& window, std::size_t place) {
    const Document& document = window.document().document();
    const ShownPane& shown = window.compareRoom().views().paneAt(place);
    const auto problem = [place](const char* what) { return QStringLiteral("pane %1 %2").arg(place + 1).arg(what); };
    if (shown.refused) return {};
    if (!shown.newest) return problem("does not show the OTF that the document asks for");
    const auto anew = classificationAnew(window, place);
    if (anew && *anew != shown.classification) return problem("shows another OTF than that of the document");
    auto& grid = *window.findChild<CompareGrid*>("compare.panes");
    const PaneFace& face = grid.pane(place).face();
    if (face.name != QStringLiteral("%1  %2").arg(place + 1).arg(captionOfPane(document, place)))
        return problem("has another name than the document says: ") + face.name;
    if (face.otf && *face.otf != shown.classification) return problem("has the OTF of another one as its inset");
    const Pane& choice = document.panes[place];
    if (face.coloured != document.comparison.colours) return problem("is coloured, or not, against the document");
    if (choice.designer && !isAdaptive(choice))
        return face.frame ? problem("has the colour of a curve, and shows none") : QString();
    const CurveKind kind = choice.designer ? CurveKind::adaptive : choice.curve;
    const bool own = kind == CurveKind::linear && choice.linear && *choice.linear != LinearCurve{};
    if ((face.frame == curveColor(kind, Theme::dark)) == own) return problem("has the colour of another curve");
    return {};
}

QString problemOfTitle(MainWindow& window) {
    OpenStudy& study = window.openStudy();
    const auto& size = study.volume()->geometry().size;
    const QString wanted = QStringLiteral(" · %1×%2×%3 · ").arg(size[0]).arg(size[1]).arg(size[2]);
    if (!window.windowTitle().contains(wanted)) return "the title is of another scan: " + window.windowTitle();
    const QString file = QFileInfo(study.path()).fileName();
    if (!file.isEmpty() && !window.findChild<QAction*>("view.numbersForNames")->isChecked() &&
        !window.windowTitle().contains(file))
        return "the title names another study than " + file + ": " + window.windowTitle();
    return {};
}

QString problemOfComparePanel(MainWindow& window) {
    const Document& document = window.document().document();
    CompareRoom& room = window.compareRoom();
    if (window.findChild<QAction*>("room.compare")->isChecked() != room.shown())
        return "the menu says that another room is shown";
    if (!isCompared(document)) return room.shown() ? QStringLiteral("one pane is compared") : QString();
    const auto* count = window.findChild<QSpinBox*>("compare.count");
    if (count->value() != static_cast<int>(document.panes.size())) return "the panel counts other panes";
    const auto* layout = window.findChild<QComboBox*>("compare.layout");
    if (layout->currentIndex() != static_cast<int>(document.comparison.layout)) return "the panel has another layout";
    if (!room.shown()) return {};
    const auto& rows = window.findChild<ComparePanel*>()->rows();
    for (std::size_t place = 0; place < rows.size(); ++place)
        if (rows.size() != document.panes.size() || rows[place].name != captionOfPane(document, place))
            return "the table is of other panes";
    return {};
}

QString problemOfLesson(MainWindow& window) {
    LessonPlayer& player = window.lessonPlayer();
    const auto label = [&](const char* name) { return window.findChild<QLabel*>(name)->text(); };
    const auto* panel = window.findChild<QWidget*>("lessons");
    // Else it shows the list, or the editor of a lesson.
    if (window.findChild<QWidget*>("lessons.title")->isVisibleTo(panel) != player.playing())
        return "the panel of lessons shows a lesson that is not played, or none while one is";
    auto* dock = window.findChild<QDockWidget*>("dock.lessons");
    if (!player.playing()) {
        if (!window.isFullScreen() && window.dockWidgetArea(dock) != Qt::RightDockWidgetArea)
            return "the panel of lessons is not in its place";
        for (int side = 0; side < 4; ++side)
            if (window.findChild<QWidget*>(QStringLiteral("lessons.outline.%1").arg(side))->isVisible())
                return "something is outlined without a lesson";
        return {};
    }
    const auto& lesson = player.lesson();  // one that comes with the program, or an edited copy of it
    if (words(textIn(*lesson, "en").title) != label("lessons.lesson")) return "the panel names another lesson";
    const auto *opened = std::get_if<SimulatedScan>(&window.openStudy().reference()),
               *wanted = std::get_if<SimulatedScan>(&lesson->begins.study);
    if (opened == nullptr || opened->scene != wanted->scene || opened->seed != wanted->seed)
        return "a lesson is played on another study than its own";
    const std::size_t step = player.step();
    if (label("lessons.title") != words(textIn(*lesson, "en").steps.at(step).title))
        return "the page is of another step than " + QString::number(step + 1);
    if (label("lessons.progress") != QStringLiteral("Step %1 of %2").arg(step + 1).arg(lesson->steps.size()))
        return "the page counts " + label("lessons.progress") + " at step " + QString::number(step + 1);
    const bool asks = lesson->steps[step].answers > 0;
    if (!asks && lesson->steps[step].until && label("lessons.done").startsWith(QChar(0x2713)) != player.isDone())
        return "the page says that the step is done, or not, against the player";
    return {};
}

/// What the panels explain of picture and tube core. They may be told a moment after the window rests.
QString problemOfExplanations(MainWindow& window) {
    const auto number = window.tubeCoreChoice().number();
    const auto* panel = window.findChild<QWidget*>("tubeCores");
    const auto isExplained = [&] {
        const auto& explained = window.tubeCoreExplaining().explanation();
        return explained && explained->run == window.otfs().adaptive() && explained->explanation->number == number;
    };
    if (number && !panel->visibleRegion().isEmpty() && !window.otfs().isAnyRefused() &&
        !QTest::qWaitFor(isExplained, patience))
        return QStringLiteral("tube core %1 is chosen, and another one or none is explained").arg(*number);
    const auto* words = window.findChild<QLabel*>("explain.picture");
    if (words->isVisible() && !QTest::qWaitFor([&] { return words->text() == window.explanationOfPane(); }, patience))
        return "another picture is explained: " + words->text().left(80);
    return {};
}

QString problemOfDocks(const MainWindow& window) {
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (dock->parentWidget() != &window ||
            window.dockWidgetArea(const_cast<QDockWidget*>(dock)) == Qt::NoDockWidgetArea)
            return "the panel has no place: " + dock->objectName();
        if (dock->isVisible() && dock->isFloating()) return "the panel floats: " + dock->objectName();
    }
    return {};
}

}  // namespace

QString difference(const std::string& one, const std::string& other) {
    std::size_t at = 0;
    while (at < std::min(one.size(), other.size()) && one[at] == other[at]) ++at;
    const std::size_t from = at > 60 ? at - 60 : 0;
    return words("\"" + one.substr(from, 140) + "\" and \"" + other.substr(from, 140) + "\"");
}

std::string bytesOf(MainWindow& window, Document document) {
    document = withShown(std::move(document), Document{});
    const StudyReference& newest = window.document().document().study;
    if (nameTheSame(document.study, newest)) document.study = newest;
    return jsonOf(document);
}

QString workUnderWay(MainWindow& window) {
    OpenStudy& study = window.openStudy();
    QStringList names;
    const auto add = [&](bool busy, const char* name) {
        if (busy) names << name;
    };
    add(study.loading(), "loading");
    add(study.takingChecksum(), "checksum");
    add(study.cutting(), "scalpel");
    add(study.quietPhases().busy(), "speckle reduction");
    add(window.otfs().busy(), "OTFs");
    add(window.nearCutFinder().busy(), "near cut");
    add(window.sessionKeeping().saving(), "session");
    add(!window.volumeView().pictureIsFine(), "picture");
    add(window.movieFiles().busy(), "movie");
    add(window.motionPlayer().isPlaying(), "motion");
    const QString said = window.works().words();
    if (!said.isEmpty()) names << '"' + said + '"';
    return names.isEmpty() ? QStringLiteral("something else") : names.join(", ");
}

QString problemOfReading(const Document& document) {
    const auto read = documentFromJson(jsonOf(document));
    if (!read) return "the document cannot be read again: " + words(read.error().sentence());
    if (*read == document && jsonOf(*read) == jsonOf(document)) return {};
    return "the document that is read again is another one: " + difference(jsonOf(document), jsonOf(*read));
}

QString problemOfPictures(MainWindow& window) {
    const Document& document = window.document().document();
    OpenStudy& study = window.openStudy();
    if (!study.study()) return {};
    if (study.phase() != document.scene.phase) return "the study shows another phase than the document";
    if (study.strokes() != document.scene.strokes.values()) return "other strokes are cut than the document's";
    if (window.volumeView().look() != document.scene.look) return "the picture has another look than the document";
    if (window.volumeView().isVisible() &&
        !(window.volumeView().pictureIsCurrent() && window.volumeView().pictureIsFine()))
        return "the picture is not that of the document, converged";
    const ComparedViews& compared = window.compareRoom().views();
    if (window.compareRoom().shown() && isCompared(document) && !compared.settled() && !compared.refused())
        return "the comparison is not that of the document, converged";
    return {};
}

QString problemOfPanes(MainWindow& window) {
    const Document& document = window.document().document();
    if (!window.openStudy().study() || !window.compareRoom().shown() || !isCompared(document)) return {};
    if (window.findChild<CompareGrid*>("compare.panes")->pictureSize().isEmpty()) return {};
    for (std::size_t place = 0; place < document.panes.size(); ++place)
        if (const QString problem = problemOfPane(window, place); !problem.isEmpty()) return problem;
    const Comparison& comparison = document.comparison;
    if (comparison.layout == ComparisonLayout::sideBySide) return {};
    const QString name = window.findChild<CompareGrid*>("compare.panes")->pair().face().name;
    for (const int place : {comparison.first, comparison.second})
        if (!name.contains(
                QStringLiteral("%1 %2").arg(place + 1).arg(captionOfPane(document, static_cast<std::size_t>(place)))))
            return "the pair is of other panes than the document's: " + name;
    return {};
}

QString problemOfWords(MainWindow& window) {
    if (!window.openStudy().study()) return {};
    for (const auto& problemOf : {&problemOfTitle, &problemOfComparePanel, &problemOfLesson, &problemOfExplanations})
        if (const QString problem = problemOf(window); !problem.isEmpty()) return problem;
    return problemOfDocks(window);
}

}  // namespace echolucent
