// OTF designers in the real window: chosen, turned, cancelled, taken back, kept in sessions, told in words.
#include <QAbstractItemView>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <atomic>
#include <thread>

#include "app/otf/pane_otfs.h"
#include "processing/adaptive/method_reading.h"
#include "processing/designers/choice/designer.h"
#include "processing/pane_picture/pane_caster.h"
#include "tests/app/session_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/panels/design_plot.h"
#include "widgets/panels/designer_panel.h"
#include "widgets/panels/emphasis_canvas.h"

using namespace echolucent;

class TestMainWindowDesigners : public QObject, private SessionFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        teach();
    }
    void init() {
        begin();
        auto* dock = child<QDockWidget>("dock.designers");
        dock->raise();
        QTRY_VERIFY(child<QComboBox>("designer.choice")->isVisible());
    }
    void cleanup() {
        m_held = false;
        close();
    }

    void eachDesignerIsShownAsTheCommandLineMakesIt_data() {
        QTest::addColumn<int>("designer");
        const std::size_t step = isLongRun() ? 1 : 4;
        for (std::size_t i = 0; i < allDesigners.size(); i += step)
            QTest::newRow(std::string(nameOf(allDesigners[i])).c_str()) << static_cast<int>(allDesigners[i]);
    }
    void eachDesignerIsShownAsTheCommandLineMakesIt() {
        QFETCH(int, designer);
        const Document before = document();
        const Classification curve = window().volumeView().classification();
        choose(defaultConfigOf(static_cast<Designer>(designer)));
        QCOMPARE(window().document().steps().count(), 1);
        QVERIFY(designerConfigOf(document(), firstPane) != nullptr);
        waitUntilIdle();
        QVERIFY(window().otfs().isNewest(firstPane));
        PaneCaster caster({.scans = window().openStudy().study()->phases});
        const auto otf = caster.otf(document(), firstPane);
        QVERIFY(otf.has_value());
        QVERIFY(window().volumeView().classification() == classificationOf(document(), firstPane, *otf));
        window().document().steps().undo();
        QVERIFY(document() == before);
        waitUntilIdle();
        QVERIFY(window().volumeView().classification() == curve);
        QCOMPARE(child<QComboBox>("designer.choice")->currentText(), QString("Curve"));
    }

    void aParameterIsOneStepAndIsTakenBack() {
        choose(OtsuConfig{});
        waitUntilIdle();
        const Document before = document();
        const Classification shown = window().volumeView().classification();
        type("designer.opacity", "0.5");
        QCOMPARE(window().document().steps().count(), 2);
        QCOMPARE(std::get<OtsuConfig>(*designerConfigOf(document(), firstPane)).opacity, 0.5);
        waitUntilIdle();
        QVERIFY(window().volumeView().classification() != shown);
        key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document() == before);
        waitUntilIdle();
        QVERIFY(window().volumeView().classification() == shown);
        QCOMPARE(child<QDoubleSpinBox>("designer.opacity")->value(), 1.0);
    }

    void resetIsOneStep() {
        choose(OtsuConfig{});
        QVERIFY(!child<QAbstractButton>("designer.reset")->isEnabled());
        type("designer.opacity", "0.5");
        click("designer.reset");
        QCOMPARE(window().document().steps().count(), 3);
        QVERIFY(*designerConfigOf(document(), firstPane) == DesignerConfig(OtsuConfig{}));
    }

    void keysOneToFiveAndTheEditorLeaveTheDesign() {
        choose(LevoyConfig{});
        waitUntilIdle();
        QVERIFY(window().otfEditor().state().designed);
        auto* active = child<QRadioButton>("otfEditor.active.design");
        QVERIFY(active->isChecked());
        QCOMPARE(active->text(), QString("Levoy"));
        for (const CurveKind kind : allCurveKinds) QVERIFY(!window().otfEditor().activateAction(kind)->isChecked());
        key(Qt::Key_3);
        QVERIFY(designerConfigOf(document(), firstPane) == nullptr);
        waitUntilIdle();
        QVERIFY(!window().volumeView().classification().isTwoDimensional());
        QCOMPARE(child<QComboBox>("designer.choice")->currentText(), QString("Curve"));
        window().document().steps().undo();
        waitUntilIdle();
        QVERIFY(window().volumeView().classification().isTwoDimensional());
        // The curve that was active before.
        key(Qt::Key_1);
        QVERIFY(designerConfigOf(document(), firstPane) == nullptr);
        waitUntilIdle();
        QVERIFY(window().volumeView().classification() == Classification(window().otfs().adaptive()->curve));
    }

    void itsUpperCurveIsCopiedIntoNodes() {
        choose(OtsuConfig{});
        waitUntilIdle();
        const OpacityCurve upper = upperCurveOf(window().otfs().designOf(firstPane)->design.classification);
        QCOMPARE(window().otfEditor().copyAdaptiveAction()->text(), QString("Copy Otsu ramp into nodes"));
        window().otfEditor().copyAdaptiveAction()->trigger();
        QVERIFY(designerConfigOf(document(), firstPane) == nullptr);
        QCOMPARE(document().panes.at(firstPane).curve, CurveKind::manual);
        for (const double intensity : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0})
            QVERIFY(std::abs(opacityAt(document().curves.manual, intensity) - opacityAt(upper, intensity)) < 0.02);
        window().otfEditor().setManualSaved();
    }

    void wordsSpeakOfTheDesignerThatIsRendered() {
        choose(OtsuConfig{});
        waitUntilIdle();
        const QString said = QString::fromStdString(window().otfs().designOf(firstPane)->design.explanation.front());
        QVERIFY(window().volumeView().caption().contains("OTF: Otsu ramp"));
        QVERIFY(window().explanation().contains("Otsu ramp: "));
        QVERIFY(window().explanation().contains(said));
        QVERIFY(!window().explanation().contains("adaptive"));
        QVERIFY(child<QLabel>("status.otf")->text().startsWith("Otsu ramp "));
        QVERIFY(child<QLabel>("designer.explanation")->text().contains(said));
        QVERIFY(child<QLabel>("designer.facts")->text().contains("ms"));
        key(Qt::Key_1);
        waitUntilIdle();
        QVERIFY(!window().volumeView().caption().contains("Otsu"));
        QVERIFY(window().explanation().contains("adaptive"));
        QVERIFY(child<QLabel>("status.otf")->text().startsWith("OTF "));
    }

    void wordsOfTheCurvesAreThoseOfThePaper() {
        key(Qt::Key_3);
        QVERIFY2(window().explanation().contains(
                     "A piecewise linear OTF (eq. 1): opacity is 0 up to an intensity of 0.08 (L_L), rises from there "
                     "by 0.5 (a) for each unit of intensity up to 1 (L_H), and stays at 0.46 above."),
                 qPrintable(window().explanation()));
        key(Qt::Key_1);
        Document next = document();
        next.method.config = configOf(MethodReading::asPublished);
        next.scene.look.reduction = SpeckleReduction::medium;
        window().document().edit(next, "reading");
        waitUntilIdle();
        const QString said = window().explanation();
        QVERIFY2(said.contains("first significant local maximum") && said.contains("eq. 5 mended") &&
                     said.contains("The paper knows no reduction of speckle"),
                 qPrintable(said));
        QVERIFY(!said.contains("word by word"));
    }

    void cancelLeavesThePictureAsItWas() {
        const Classification before = window().volumeView().classification();
        hold();
        choose(OtsuConfig{});
        QVERIFY(!window().idle());
        QTRY_VERIFY(child<QAbstractButton>("designer.cancel")->isVisible());
        QVERIFY(window().explanation().contains("not computed yet"));
        click("designer.cancel");
        waitUntilIdle();
        QVERIFY(window().volumeView().classification() == before);
        QVERIFY(!window().otfs().designOf(firstPane));
        m_held = false;
        QTRY_VERIFY(child<QAbstractButton>("designer.compute")->isVisible());
        click("designer.compute");
        waitUntilIdle();
        QVERIFY(window().otfs().isNewest(firstPane));
        QVERIFY(window().volumeView().classification() != before);
        QVERIFY(!child<QAbstractButton>("designer.compute")->isVisible());
    }

    void theNewestChoiceWins() {
        hold();
        choose(OtsuConfig{});
        choose(PercentileConfig{});
        m_held = false;
        waitUntilIdle();
        QVERIFY(window().otfs().isNewest(firstPane));
        PaneCaster caster({.scans = window().openStudy().study()->phases});
        QVERIFY(window().volumeView().classification() ==
                classificationOf(document(), firstPane, *caster.otf(document(), firstPane)));
    }

    void aSessionBringsItBack() {
        choose(LevoyConfig{});
        type("designer.surfaceOpacity", "0.75");
        waitUntilIdle();
        const Document saved = document();
        const Classification shown = window().volumeView().classification();
        again(savedSession());
        QVERIFY(nameless(document()) == nameless(saved));
        QVERIFY(window().volumeView().classification() == shown);
        QCOMPARE(child<QComboBox>("designer.choice")->currentText(), QString("Levoy"));
        QCOMPARE(child<QDoubleSpinBox>("designer.surfaceOpacity")->value(), 0.75);
        QCOMPARE(window().document().steps().count(), 0);
    }

    void theEmphasisIsDrawnByHand() {
        choose(KindlmannConfig{});
        auto* canvas = child<EmphasisCanvas>("designer.emphasis.canvas");
        QVERIFY(!canvas->isVisible());
        auto* emphasis = child<QComboBox>("designer.emphasis");
        emphasis->setFocus();
        QTest::keyClick(emphasis, Qt::Key_Down);
        QTRY_VERIFY(canvas->isVisible());
        const auto drawn = [this] { return std::get<KindlmannConfig>(*designerConfigOf(document(), firstPane)).drawn; };
        const int steps = window().document().steps().count();
        const auto from = canvas->positionOf({0, 1}).toPoint(), to = canvas->positionOf({0.5, 0.5}).toPoint();
        QTest::mousePress(canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas, (from + to) / 2);
        QTest::mouseMove(canvas, to);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, to);
        QCOMPARE(window().document().steps().count(), steps + 1);
        QVERIFY(std::abs(drawn()[1].position - 0.5) < 0.05 && std::abs(drawn()[1].opacity - 0.5) < 0.02);
        QTest::mouseDClick(canvas, Qt::LeftButton, {}, canvas->positionOf({2, 0.4}).toPoint());
        QCOMPARE(drawn().size(), std::size_t{4});
        QTest::keyClick(canvas, Qt::Key_Delete);
        QCOMPARE(drawn().size(), std::size_t{3});
        QCOMPARE(window().document().steps().count(), steps + 3);
        const Document before = document();
        QTest::mousePress(canvas, Qt::LeftButton, {}, canvas->positionOf(drawn()[0]).toPoint());
        QTest::mouseMove(canvas, canvas->positionOf({-2, 0.8}).toPoint());
        QVERIFY(!(document() == before));
        QTest::keyClick(canvas, Qt::Key_Escape);
        QVERIFY(document() == before);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, canvas->positionOf({-2, 0.8}).toPoint());
        QCOMPARE(window().document().steps().count(), steps + 3);
        for (int i = 0; i < 3; ++i) window().document().steps().undo();
        QVERIFY(drawn() == KindlmannConfig{}.drawn);
        waitUntilIdle();
    }

private:
    void choose(const DesignerConfig& config) {
        auto* choice = child<QComboBox>("designer.choice");
        choice->setFocus();
        const int wanted = choice->findData(static_cast<int>(designerOf(config)));
        // With the keys in the open list: letters are the window's.
        choice->showPopup();
        QTRY_VERIFY(choice->view()->isVisible());
        QTest::keyClick(choice->view(), Qt::Key_Home);
        for (int row = 0; row < wanted; ++row) QTest::keyClick(choice->view(), Qt::Key_Down);
        QTest::keyClick(choice->view(), Qt::Key_Return);
        QCOMPARE(choice->currentIndex(), wanted);
    }
    /// A key of the window. Without a window manager no window is active once a list is gone that took the focus.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QApplication::setActiveWindow(&window());
        QTest::keyClick(&window(), key, modifiers);
    }
    void type(const QString& name, const QString& number) {
        auto* box = child<QDoubleSpinBox>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// Designers go on once m_held is false.
    void hold() {
        m_held = true;
        window().otfs().setRun(
            [this](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
                while (m_held && !progress.cancelled()) std::this_thread::yield();
                return echolucent::design(config, input, progress);
            });
    }

    std::atomic<bool> m_held = false;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowDesigners, "eachDesignerIsShownAsTheCommandLineMakesIt")
#include "test_main_window_designers.moc"
