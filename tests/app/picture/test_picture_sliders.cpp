// The sliders of the panel Picture that move the curve: what they say, and when they move nothing.
#include <QDoubleSpinBox>
#include <QSlider>

#include "app/compare/compare_room.h"
#include "app/otf/pane_otfs.h"
#include "processing/document/panes.h"
#include "processing/document/preset.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestPictureSliders : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        show();
        open(file("still.mha", {smallPhantom(PhantomScene::shapes, 5)}));
        m_begun = window().document().document();
    }
    /// One window, in which every function begins anew.
    void init() {
        window().document().begin(m_begun);
        waitUntilIdle();
    }
    void cleanupTestCase() { close(); }

    void theAimSaysWhichSurfacesTheAdaptiveCurveShows() {
        const auto* number = child<QDoubleSpinBox>("view.aim.value");
        auto* slider = child<QSlider>("view.aim");
        const auto aim = [&] { return std::get<RampRule>(window().document().document().method.config.curve).aim; };
        QCOMPARE(number->text(), "50 %");
        const auto before = window().otfs().adaptive();
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(number->text(), "51 %");
        QCOMPARE(aim(), 0.51);
        QCOMPARE(window().document().steps().undoText(), "surfaces");
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(aim(), 1.0);
        waitUntilIdle();
        QVERIFY(window().otfs().adaptive()->curve != before->curve);
        QVERIFY(window().otfs().adaptive()->everyWall == before->everyWall);
        while (aim() != 0.5) window().document().steps().undo();
        QCOMPARE(number->text(), "50 %");
        waitUntilIdle();
        QVERIFY(window().otfs().adaptive()->curve == before->curve);
    }

    void theAimIsGreyedIfItMovesNoPicture() {
        const auto expectGreyed = [this](const QString& why) {
            auto* slider = child<QSlider>("view.aim");
            const QString tip = slider->parentWidget()->toolTip();
            QVERIFY2(!slider->isEnabled() && !child<QDoubleSpinBox>("view.aim.value")->isEnabled(), qPrintable(why));
            QVERIFY2(tip.contains("100 %: every wall") && tip.endsWith(why), qPrintable(tip));
        };
        const auto* slider = child<QSlider>("view.aim");
        const auto curveOnly = QStringLiteral("It moves the computed curve only. Choose the preset Standard.");
        for (const Qt::Key key : {Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5}) {  // manual, linear, x², x⁴
            QTest::keyClick(&window(), key);
            expectGreyed(curveOnly);
            QTest::keyClick(&window(), Qt::Key_1);
            QVERIFY(slider->isEnabled());
        }
        for (const Preset& preset : standardPresets()) {
            window().document().edit(withPreset(m_begun, firstPane, preset), "preset");
            const bool direct = preset.look.mode == RenderMode::direct;
            QCOMPARE(slider->isEnabled(), direct && preset.curve == CurveKind::adaptive);
            if (direct && preset.curve != CurveKind::adaptive) expectGreyed(curveOnly);
        }
        window().document().begin(m_begun);
        for (const Designer designer : allDesigners) {
            window().document().edit(withDesigner(m_begun, firstPane, defaultConfigOf(designer)), "designer");
            const bool adaptive = designer == designerOf(AdaptiveConfig{});
            QCOMPARE(slider->isEnabled(), adaptive);
            if (!adaptive) expectGreyed(curveOnly);
        }
        window().document().begin(m_begun);
        window().document().change("form", [](Document& next) { next.method.config.curve = ProductRule{}; });
        expectGreyed(QStringLiteral("the form ramp can."));
        window().document().begin(m_begun);
        window().document().change("mode", [](Document& next) { next.scene.look.mode = RenderMode::maximum; });
        expectGreyed(QStringLiteral("There is a curve in the mode Direct rendering only (More)."));
        window().document().begin(m_begun);
        waitUntilIdle();
    }

    void theAimMovesAnotherPaneOnlyWhileItIsSeen() {
        const auto* slider = child<QSlider>("view.aim");
        Document next = withPanes(m_begun, {{.curve = CurveKind::manual}, {.curve = CurveKind::adaptive}});
        window().document().edit(next, "panes");  // shows them
        QVERIFY(slider->isEnabled());
        window().compareRoom().setShown(false);
        QVERIFY(!slider->isEnabled());
        window().compareRoom().setShown(true);
        QVERIFY(slider->isEnabled());
        waitUntilIdle();
    }

    void thresholdIsShownInPercentOfTheGreys() {
        const auto* number = child<QDoubleSpinBox>("view.threshold.value");
        QCOMPARE(number->text(), "0 %");
        auto* slider = child<QSlider>("view.threshold");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(number->text(), "1 %");
        QCOMPARE(window().document().document().curves.adjustment.threshold, 0.01);
        QCOMPARE(window().document().steps().undoText(), "threshold");
        window().document().steps().undo();
        QCOMPARE(number->text(), "0 %");
        window().document().change("threshold", [](Document& next) { next.curves.adjustment.threshold = 0.125; });
        QCOMPARE(number->text(), "12.5 %");
        QVERIFY2(slider->toolTip().isEmpty() &&
                     slider->parentWidget()->toolTip().contains("At 0 % this slider changes nothing"),
                 qPrintable(slider->parentWidget()->toolTip()));
        window().document().steps().undo();
        waitUntilIdle();
    }

private:
    Document m_begun;
};

ECHOLUCENT_TEST_CLASS(TestPictureSliders)

#include "test_picture_sliders.moc"
