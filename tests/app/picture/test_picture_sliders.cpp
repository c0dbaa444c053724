// The sliders of the panel Picture that move the curve: what they say, and when they move nothing.
#include <QDoubleSpinBox>
#include <QSlider>

#include "app/otf/pane_otfs.h"
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

        const auto whyNot = [&] { return slider->parentWidget()->toolTip(); };
        window().document().change("curve", [](Document& next) { next.panes.front().curve = CurveKind::manual; });
        QVERIFY(!slider->isEnabled());
        QVERIFY2(whyNot().contains("Only the computed curve"), qPrintable(whyNot()));
        window().document().change("pane", [](Document& next) { next.panes.push_back({}); });
        QVERIFY2(slider->isEnabled(), "another pane shows the adaptive curve");
        window().document().change("form", [](Document& next) { next.method.config.curve = ProductRule{}; });
        QVERIFY(!slider->isEnabled());
        QVERIFY2(whyNot().contains("A product of basis functions"), qPrintable(whyNot()));
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
