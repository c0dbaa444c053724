// Review and Teach: which panels and menus each offers, and what stays the same.
#include <QCheckBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <set>

#include "app/compare/compare_room.h"
#include "app/sessions/study_rows.h"
#include "app/window/window_faces.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestWindowFaces : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        m_file = file("still.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        window().resize(1280, 720);
    }
    void cleanup() { close(); }

    void theStartIsReviewAndTeachShowsAll() {
        QCOMPARE(window().faces().face(), Face::review);
        QVERIFY(child<QToolButton>("face.review")->isChecked());
        QVERIFY(child<QAction>("view.review")->isChecked());
        QCOMPARE(openPanels(), QStringList({"Picture", "Measure", "Study"}));
        QCOMPARE(entriesOf("menu.panels"), QStringList({"Picture", "Curve", "Measure", "Study"}));
        QVERIFY(!menuBarShows("menu.otf"));
        QVERIFY(!child<QMenu>("menu.room")->actions().contains(child<QAction>("room.compare")));
        QVERIFY(!child("view.beamAxis")->isVisible() && child("view.lightAmount")->isVisible());
        QVERIFY(!child("motion.mode.mean")->isVisible() && child("motion.play")->isVisible());
        open(m_file);
        QVERIFY(!child("status.otf")->isVisible());
        for (const char* dock : {"dock.study", "dock.room", "dock.view"}) {
            child<QDockWidget>(dock)->raise();
            QCoreApplication::processEvents();
            speaksPlainly();
        }
        const QStringList room = entriesOf("menu.room"), panels = entriesOf("menu.panels");

        const int steps = window().document().steps().count();
        click("face.teach");
        QCOMPARE(window().faces().face(), Face::teach);
        QVERIFY(!child<QToolButton>("face.review")->isChecked() && child<QAction>("view.teach")->isChecked());
        const QStringList all{"Picture", "Curve", "Measure", "Method",  "Tube cores", "Designers",
                              "Compare", "Study", "Motion",  "Explain", "Theory",     "Lessons"};
        QCOMPARE(openPanels(), all);
        QCOMPARE(entriesOf("menu.panels"), all);
        QVERIFY(menuBarShows("menu.otf"));
        const QList<QAction*> tools = child<QMenu>("menu.room")->actions();
        const auto compare = tools.indexOf(child<QAction>("room.compare"));
        QVERIFY(compare > 0 && tools.at(compare - 1)->isSeparator());  // a group of its own
        QCOMPARE(tools.mid(compare + 1), QList<QAction*>{child<QMenu>("menu.compare")->menuAction()});
        QVERIFY(child("view.beamAxis")->isVisible());
        QVERIFY(child("motion.mode.mean")->isVisible());
        QVERIFY(child("status.otf")->isVisible());
        QVERIFY(child<QLabel>("status.renderer")->text().contains(" ms"));
        child<QDockWidget>("dock.method")->raise();

        child<QAction>("view.review")->trigger();
        QCOMPARE(openPanels(), QStringList({"Picture", "Measure", "Study"}));
        QTRY_VERIFY(child("view.lightAmount")->isVisible());  // the panel that was in front is gone
        QCOMPARE(entriesOf("menu.room"), room);
        QCOMPARE(entriesOf("menu.panels"), panels);
        QVERIFY(!child<QLabel>("status.renderer")->text().contains(" ms"));
        QCOMPARE(window().document().steps().count(), steps);
    }

    void aPanelIsLaidOutWhenItsDockIsFirstShown() {
        const auto areaOf = [this](const char* dock) { return child<QDockWidget>(dock)->findChild<QScrollArea*>(); };
        for (const char* open : {"dock.view", "dock.room", "dock.study"}) QVERIFY(areaOf(open)->widget() != nullptr);
        for (const char* closed : {"dock.method", "dock.otfEditor", "dock.explain"})
            QCOMPARE(areaOf(closed)->widget(), nullptr);
        auto* dock = child<QDockWidget>("dock.method");
        dock->show();
        dock->raise();
        QWidget* panel = areaOf("dock.method")->widget();
        QCOMPARE(panel, child("adaptive"));
        // At once, so that nothing jumps when its width is asked for later.
        QVERIFY(areaOf("dock.method")->minimumWidth() >= panel->minimumSizeHint().width());
        QTRY_VERIFY(panel->isVisible() && panel->width() >= panel->minimumSizeHint().width());
        QCOMPARE(areaOf("dock.explain")->widget(), nullptr);
    }

    void studyBeginsWithWhatTheScanIs() {
        open(m_file);
        const auto* facts = child<QTableWidget>("study.facts");
        QCOMPARE(facts->item(0, 1)->text(), "3D, one volume");
        QCOMPARE(facts->item(1, 1)->text(), "84.0 × 78.4 × 81.2 mm");
        QStringList names;
        for (int row = 0; row < facts->rowCount(); ++row) names << facts->item(row, 0)->text();
        QVERIFY(names.indexOf("of the file") < names.indexOf("format"));
        QVERIFY(names.indexOf("of the file") > 1);
    }

    void studySaysWhereTheProbeLooksByTheDocument() {
        open(m_file);
        const auto* facts = child<QTableWidget>("study.facts");
        const auto rowOf = [facts](const QString& name) {
            for (int row = 0; row < facts->rowCount(); ++row)
                if (facts->item(row, 0)->text() == name) return row;
            return -1;
        };
        const auto setBeam = [this](const Beam& beam) {
            window().document().change("beam axis", [&beam](Document& next) { next.beam = beam; });
        };
        setBeam({BeamAxis::minusY, BeamSource::person});
        const int row = rowOf("probe looks along");
        QVERIFY(row > 0);
        QCOMPARE(facts->item(row, 1)->text(), "-y of the voxel grid");
        QCOMPARE(facts->item(row + 1, 1)->text(), "chosen by hand");
        setBeam({});
        QCOMPARE(rowOf("probe looks along"), -1);  // nobody knows it
        QCOMPARE(rowOf("beam"), -1);
        window().document().steps().undo();
        QCOMPARE(facts->item(rowOf("probe looks along"), 1)->text(), "-y of the voxel grid");
        waitUntilIdle();
    }

    void anUnevenStudyHasVolumesEverywhere() {
        const auto still = smallPhantom(PhantomScene::shapes, 5);
        const QString path = file("uneven.mha", {still, still, still});
        QFile written(path);
        QVERIFY(written.open(QIODevice::ReadWrite));
        QByteArray bytes = written.readAll();
        bytes.insert(bytes.indexOf("ElementDataFile"),
                     "Seq_Frame0000_Timestamp = 0\nSeq_Frame0001_Timestamp = 0.1\nSeq_Frame0002_Timestamp = 0.4\n");
        written.seek(0);
        written.write(bytes);
        written.close();
        open(path);
        const QString warning = child<QLabel>("study.warnings")->text();
        QVERIFY2(warning.contains("times between volumes are uneven"), qPrintable(warning));
        child<QDockWidget>("dock.study")->raise();
        QCoreApplication::processEvents();
        speaksPlainly();
        const auto* facts = child<QTableWidget>("study.facts");
        for (int row = 0; row < facts->rowCount(); ++row)
            for (int column = 0; column < 2; ++column)
                QVERIFY2(!facts->item(row, column)->text().contains("phase"),
                         qPrintable(facts->item(row, column)->text()));
        waitUntilIdle();
    }

    void whatAReaderCallsPhasesAreVolumesInTheWindow() {
        QCOMPARE(withVolumesForPhases("DICOM, 4 phases of 3 slices"), "DICOM, 4 volumes of 3 slices");
        QCOMPARE(
            withVolumesForPhases("Phases with missing slices were left out (x): phase 2 of 3 lacks 1 of 9 slices."),
            "Volumes with missing slices were left out (x): volume 2 of 3 lacks 1 of 9 slices.");
        for (const char* name : {"(0054,0030) Phase Information", "phase.mha", "/home/phase/a.mha", "my-phase"})
            QCOMPARE(withVolumesForPhases(name), QString(name));
    }

    void faceAndPanelsAreRememberedOverARestart() {
        click("face.teach");
        child<QDockWidget>("dock.designers")->close();
        click("face.review");
        click("face.teach");
        QVERIFY(child<QDockWidget>("dock.designers")->isHidden());
        QVERIFY(!child<QCheckBox>("otfEditor.earlyLight")->isChecked());
        child<QCheckBox>("otfEditor.earlyLight")->click();
        window().close();
        close();
        showAgain();
        QCOMPARE(window().faces().face(), Face::teach);
        QVERIFY(child<QToolButton>("face.teach")->isChecked());
        QVERIFY(openPanels().contains("Method") && !openPanels().contains("Designers"));
        QVERIFY(child<QCheckBox>("otfEditor.earlyLight")->isChecked());
        QVERIFY(menuBarShows("menu.otf"));
        click("face.review");
        click("toolBar.curve");
        window().close();
        close();
        showAgain();
        QCOMPARE(openPanels(), QStringList({"Picture", "Curve", "Measure", "Study"}));
        QVERIFY(!menuBarShows("menu.otf"));
    }

    void everyControlKeepsItsNameInBoth() {
        const std::set<QString> review = namesOfControls();
        click("face.teach");
        QCOMPARE(namesOfControls(), review);
        for (const char* name : {"adaptive.strength", "otfEditor.canvas", "designer.choice", "motion.mode.mean",
                                 "view.beamAxis", "compare.layout", "toolBar.sides", "menu.sides", "face.review"})
            QVERIFY2(review.contains(name), name);
    }

    void keysMeanTheSameInReview() {
        open(m_file);
        QTest::keyClick(&window(), Qt::Key_3);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::linear);
        QTest::keyClick(&window(), Qt::Key_F1);
        QTRY_VERIFY(child("explain.picture")->isVisible());
        QTest::keyClick(&window(), Qt::Key_F5);
        QVERIFY(window().compareRoom().shown());
        QTRY_VERIFY(child("compare.layout")->isVisible());
        click("face.teach");
        click("face.review");  // what is compared keeps its panel
        QVERIFY(!child<QDockWidget>("dock.compare")->isHidden());
        QTest::keyClick(&window(), Qt::Key_F5);
        QCOMPARE(openPanels(), QStringList({"Picture", "Measure", "Study", "Explain"}));
        // Also if the comparison ends in the other face.
        QTest::keyClick(&window(), Qt::Key_F5);
        click("face.teach");
        QTest::keyClick(&window(), Qt::Key_F5);
        click("face.review");
        QCOMPARE(openPanels(), QStringList({"Picture", "Measure", "Study", "Explain"}));
        waitUntilIdle();
    }

    void curveOpensBesideTheOthers() {
        auto* button = child<QToolButton>("toolBar.curve");
        auto* dock = child<QDockWidget>("dock.otfEditor");
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(child("otfEditor.canvas")->isVisible());
        QVERIFY(button->isChecked());
        QCOMPARE(openPanels(), QStringList({"Picture", "Curve", "Measure", "Study"}));
        child<QDockWidget>("dock.view")->raise();
        QTRY_VERIFY(!button->isChecked());  // it lies behind: a click brings it to the front
        QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(!dock->visibleRegion().isEmpty());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(dock->isHidden() && !button->isChecked());
    }

    void aToolDoesWhatTheMenuDoesOrSaysWhyNot() {
        for (const char* name : {"sides", "layout", "box", "front", "scalpel", "measure", "save", "reset"}) {
            auto* button = child<QToolButton>(QString("toolBar.") + name);
            QVERIFY2(!button->isEnabled() && button->toolTip().endsWith("\nOpen a volume first."), name);
        }
        QVERIFY(child("toolBar.open")->isEnabled());
        open(m_file);
        for (const char* name : {"sides", "layout", "box", "front", "scalpel", "measure", "save", "reset"}) {
            auto* button = child<QToolButton>(QString("toolBar.") + name);
            QVERIFY2(button->isEnabled() && !button->toolTip().contains("first"), name);
        }
        Document next = window().document().document();
        next.scene.front = Front{};
        window().document().edit(next, "no front");
        QVERIFY(!child<QAction>("view.noFront")->isEnabled());
        QVERIFY(child<QAction>("view.noFront")->toolTip().endsWith("There is no front to take away."));
        next.scene.front = frontAcross({}, 20);
        window().document().edit(next, "front");
        QVERIFY(child<QAction>("view.noFront")->isEnabled());
        click("toolBar.box");
        QVERIFY(window().document().document().scene.box.on);
        QTest::keyClick(&window(), Qt::Key_B);
        QVERIFY(!child<QToolButton>("toolBar.box")->isChecked());
        click("toolBar.scalpel");
        QVERIFY(child<QAction>("room.scalpel")->isChecked());
        click("toolBar.measure");  // one tool is in the hand at a time
        QVERIFY(child<QAction>("room.measureDistance")->isChecked());
        QVERIFY(!child<QToolButton>("toolBar.scalpel")->isChecked());
        child<QAction>("room.measureAngle")->trigger();
        QVERIFY(child<QToolButton>("toolBar.measure")->isChecked());
        QTest::keyClick(&window(), Qt::Key_Escape);
        QVERIFY(!child<QToolButton>("toolBar.measure")->isChecked());
        waitUntilIdle();
    }

private:
    QStringList openPanels() {
        QStringList names;
        for (const char* name :
             {"dock.view", "dock.otfEditor", "dock.room", "dock.method", "dock.tubeCores", "dock.designers",
              "dock.compare", "dock.study", "dock.motionMap", "dock.explain", "dock.theory", "dock.lessons"})
            if (auto* dock = child<QDockWidget>(name); !dock->isHidden()) names << dock->windowTitle();
        return names;
    }
    QStringList entriesOf(const char* menu) {
        QStringList texts;
        for (const QAction* action : child<QMenu>(menu)->actions()) texts << action->text().remove('&');
        return texts;
    }
    bool menuBarShows(const char* menu) { return child<QMenu>(menu)->menuAction()->isVisible(); }
    /// Of all controls and actions, but for the heads of docks, which make their names when they are seen.
    std::set<QString> namesOfControls() {
        std::set<QString> names;
        for (const QObject* each : window().findChildren<QObject*>())
            if (const QString name = each->objectName();
                !name.isEmpty() && !name.startsWith("qt_") && !name.contains(".tab."))
                names.insert(name);
        return names;
    }
    /// What a person sees in Review, and what the tool tips say, is in words of the field. The status line's tool tip
    /// is for experts.
    void speaksPlainly() {
        static const QRegularExpression jargon(QStringLiteral("\\bOTFs?\\b|voxel|tube core|grid axis|\\bstep on a "
                                                              "ray|designer|adaptive|\\bphases?\\b|render box|suggest"),
                                               QRegularExpression::CaseInsensitiveOption);
        for (const QWidget* each : window().findChildren<QWidget*>()) {
            if (!each->isVisible()) continue;
            QStringList words;
            if (!each->objectName().startsWith("status.")) words << each->toolTip();
            if (const auto* label = qobject_cast<const QLabel*>(each)) words << label->text();
            if (const auto* button = qobject_cast<const QAbstractButton*>(each)) words << button->text();
            for (const QString& said : words) QVERIFY2(!jargon.match(said).hasMatch(), qPrintable(said));
        }
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestWindowFaces)

#include "test_window_faces.moc"
