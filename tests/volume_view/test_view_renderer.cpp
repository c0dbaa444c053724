// Who renders the 3D view, and what pictures tell on request.
#include <QApplication>
#include <QTest>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/shown_view.h"
#include "widgets/volume_view/scene/graphics_card/card_answers.h"
#include "widgets/volume_view/scene/volume_scene.h"

using namespace echolucent;
using namespace echolucent::testing;

class ViewRendererTest : public QObject {
    Q_OBJECT

private slots:
    void whereOpenGlIsSoftwareTheRayCasterRenders() {
        ShownView s;
        QVERIFY(s.ready);
        if (s.view.graphicsCardUsable()) QSKIP("a graphics card is at hand");
        QCOMPARE(s.view.rendererName(), "software renderer");
        QVERIFY2(s.view.rendererRemark().contains("OpenGL is software"), qPrintable(s.view.rendererRemark()));
    }

    void theCardsPictureIsOnTheScreenAndTheProcessorsInFiles() {
        // Software OpenGL is slow, but draws what a graphics card does.
        ShownView s;
        QVERIFY(s.ready);
        const QImage cast = s.view.screenImage(), saved = s.view.convergedImage();
        QList<PictureReport> reports;
        connect(&s.view, &VolumeViewWidget::pictureDelivered, this, [&](const PictureReport& r) { reports << r; });
        s.view.setRenderer(RendererChoice::graphicsCard);
        QTRY_COMPARE_WITH_TIMEOUT(s.view.rendererName(), "graphics card", patience);
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.pictureIsCurrent() && !s.view.picture());
        // First as in motion, then converged.
        QCOMPARE(reports.size(), 2);
        QVERIFY(!reports[0].converged && reports[0].followsHand && reports[0].castMilliseconds > 0);
        QVERIFY(reports[1].converged && reports[1].step < reports[0].step);
        QCOMPARE(reports[0].rays, reports[1].rays);
        const QImage drawn = s.view.screenImage();
        QCOMPARE(drawn.size(), cast.size());
        double squares = 0;
        for (int y = 0; y < 140; ++y)
            for (int x = 0; x < drawn.width(); ++x)
                squares += std::pow(qRed(drawn.pixel(x, y)) - qRed(cast.pixel(x, y)), 2);
        const double rmse = std::sqrt(squares / (140.0 * drawn.width()));
        QVERIFY2(rmse < 1.0, qPrintable(QString::number(rmse)));
        QCOMPARE(s.view.convergedImage(), saved);
        // It follows, and an unchanged view is not drawn again.
        s.view.setLimits(withFrontAcross(s.view.view(), 16));
        QVERIFY(s.awaitIdle());
        QCOMPARE(reports.size(), 4);
        s.view.setLimits(withFrontAcross(s.view.view(), 16));
        QTRY_VERIFY_WITH_TIMEOUT(s.works.idle(), patience);
        QCOMPARE(reports.size(), 4);
        QVERIFY(s.view.screenImage() != drawn);
        s.view.setLimits(withFrontAcross(s.view.view(), 0));
        s.view.setRenderer(RendererChoice::software);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.awaitIdle(), patience);
        QCOMPARE(s.view.rendererName(), "software renderer");
        QCOMPARE(s.view.screenImage(), cast);
        disconnect(&s.view, &VolumeViewWidget::pictureDelivered, this, nullptr);
    }

    void aCardThatIsLostIsNoLoss() {
        ShownView s;
        QVERIFY(s.ready);
        const QImage cast = s.view.screenImage();
        CardAnswers answers;
        answers.error = [](vtkOpenGLRenderWindow&) { return CardError::contextLost; };
        s.view.scene().setCardAnswers(answers);
        s.view.setRenderer(RendererChoice::graphicsCard);
        (void)s.view.screenImage();  // now the scene knows the card
        s.view.setRenderer(RendererChoice::automatic);
        s.view.setRenderer(RendererChoice::graphicsCard);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.rendererRemark().contains("lost"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.awaitIdle(), patience);
        QCOMPARE(s.view.rendererName(), "software renderer");
        QCOMPARE(s.view.screenImage(), cast);
    }

    void theDepthOfEachPixelIsThereOnRequest() {
        ShownView s;
        QVERIFY(s.ready);
        QVERIFY(s.view.picture()->depthMm.empty());
        s.view.setRenderer(RendererChoice::graphicsCard);
        QTRY_COMPARE_WITH_TIMEOUT(s.view.rendererName(), "graphics card", patience);
        QVERIFY(s.awaitIdle());
        s.view.scene().setDepthWanted(true);  // that a card does not find
        QVERIFY2(s.view.rendererRemark().contains("depth"), qPrintable(s.view.rendererRemark()));
        s.view.setLimits(withFrontAcross(s.view.view(), 2));
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.pictureIsCurrent());
        const auto picture = s.view.picture();
        QCOMPARE(picture->depthMm.size(), picture->rgba.size() / 4);
        QCOMPARE(s.view.rendererName(), "software renderer");
        int surface = 0;
        for (const float depth : picture->depthMm) surface += std::isfinite(depth) ? 1 : 0;
        QVERIFY(surface > 100 && surface < static_cast<int>(picture->depthMm.size()));
    }
};

ECHOLUCENT_TEST_CLASS(ViewRendererTest)
#include "test_view_renderer.moc"
