// Who renders the 3D view, and what pictures tell on request.
#include <QApplication>
#include <QTest>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/shown_view.h"
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

    void whatOpenGlDrawsByItselfIsThePictureToo() {
        // Software OpenGL is slow, but draws what a graphics card does.
        ShownView s;
        QVERIFY(s.ready);
        const QImage cast = s.view.screenImage();
        QList<PictureReport> reports;
        connect(&s.view, &VolumeViewWidget::pictureDelivered, this, [&](const PictureReport& r) { reports << r; });
        s.view.setRenderer(RendererChoice::graphicsCard);
        QTRY_COMPARE_WITH_TIMEOUT(s.view.rendererName(), "graphics card", patience);
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.pictureIsCurrent() && !s.view.picture());
        QCOMPARE(reports.size(), 1);
        QVERIFY(reports[0].converged && reports[0].castMilliseconds > 0);
        const QImage drawn = s.view.screenImage();
        QCOMPARE(drawn.size(), cast.size());
        double sum = 0, difference = 0;
        for (int y = 0; y < 140; ++y)
            for (int x = 0; x < drawn.width(); ++x) {
                sum += qRed(cast.pixel(x, y));
                difference += std::abs(qRed(drawn.pixel(x, y)) - qRed(cast.pixel(x, y)));
            }
        QVERIFY2(difference < 0.05 * sum, qPrintable(QString("%1 of %2").arg(difference).arg(sum)));
        // It follows, and an unchanged view is not drawn again.
        s.view.setLimits(withFrontAcross(s.view.view(), 16));
        QVERIFY(s.awaitIdle());
        QCOMPARE(reports.size(), 2);
        s.view.setLimits(withFrontAcross(s.view.view(), 16));
        QTRY_VERIFY_WITH_TIMEOUT(s.works.idle(), patience);
        QCOMPARE(reports.size(), 2);
        QVERIFY(s.view.screenImage() != drawn);
        s.view.setLimits(withFrontAcross(s.view.view(), 0));
        s.view.setRenderer(RendererChoice::software);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.awaitIdle(), patience);
        QCOMPARE(s.view.rendererName(), "software renderer");
        QCOMPARE(s.view.screenImage(), cast);
        disconnect(&s.view, &VolumeViewWidget::pictureDelivered, this, nullptr);
    }

    void theDepthOfEachPixelIsThereOnRequest() {
        ShownView s;
        QVERIFY(s.ready);
        QVERIFY(s.view.picture()->depthMm.empty());
        s.view.scene().setDepthWanted(true);
        s.view.setLimits(withFrontAcross(s.view.view(), 2));
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.pictureIsCurrent());
        const auto picture = s.view.picture();
        QCOMPARE(picture->depthMm.size(), picture->rgba.size() / 4);
        int surface = 0;
        for (const float depth : picture->depthMm) surface += std::isfinite(depth) ? 1 : 0;
        QVERIFY(surface > 100 && surface < static_cast<int>(picture->depthMm.size()));
    }
};

ECHOLUCENT_TEST_CLASS(ViewRendererTest)
#include "test_view_renderer.moc"
