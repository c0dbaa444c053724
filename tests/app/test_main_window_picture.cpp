// The picture's panel, the light under the hand and the status line, in the real main window.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QSlider>
#include <QWindow>
#include <cmath>

#include "app/picture/picture_status.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/panels/view_panel.h"

using namespace echolucent;

namespace {

QRect whereSomethingShows(const Picture& picture) {
    QRect seen;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                  static_cast<std::size_t>(x))] > 0.05F)
                seen |= QRect(x, y, 1, 1);
    return seen;
}

}  // namespace

class TestMainWindowPicture : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_file = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show(lookAtStart());
        open(m_file);
    }
    void cleanup() { close(); }

    void aModeOfThePanelIsShownAndExplained() {
        const std::shared_ptr<const Picture> direct = view().picture();
        click("view.more");
        choose("view.mode", RenderMode::maximum);
        waitUntilIdle();
        QCOMPARE(view().settings().mode, RenderMode::maximum);
        QVERIFY(view().picture()->rgba != direct->rgba);
        QVERIFY(child<QLabel>("view.mode.remark")->isVisible());
        QVERIFY(window().explanation().contains("brightest echo"));
        // Another curve is no other picture.
        QSignalSpy delivered(&view(), &VolumeViewWidget::pictureDelivered);
        window().otfEditor().setActive(CurveKind::quartic);
        waitUntilIdle();
        QCOMPARE(delivered.size(), 0);
        choose("view.mode", RenderMode::direct);
        waitUntilIdle();
        QVERIFY(!window().explanation().contains("brightest echo"));
    }

    void depthColoursOfThePanelAreShownAndExplained() {
        QVERIFY(!view().settings().depthColouring);
        click("view.more");
        click("view.depthColouring");
        waitUntilIdle();
        QVERIFY(view().settings().depthColouring.has_value());
        QVERIFY(window().explanation().contains("tinted warm"));
    }

    void slidersAndHandMoveOneLight() {
        child<QSlider>("view.lightAzimuth")->setValue(180 + 40);  // sliders count from their left end
        waitUntilIdle();
        QVERIFY(std::abs(view().look().light.azimuthDegrees - 40) < 1e-9);
        QVERIFY(window().explanation().contains("40° to the right"));
        auto* inner = pictureWindow();
        const QPoint from(inner->width() / 2, inner->height() / 2);
        QTest::mousePress(inner, Qt::LeftButton, Qt::ControlModifier, from);
        const QPointF to = from + QPointF(-inner->height() / 6.0, 0);
        QMouseEvent move(QEvent::MouseMove, to, inner->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         Qt::ControlModifier);
        QCoreApplication::sendEvent(inner, &move);
        QVERIFY(std::abs(panel().look().light.azimuthDegrees - 10.0) < 1e-9);
        QCOMPARE(child<QSlider>("view.lightAzimuth")->value(), 180 + 10);
        QTest::keyClick(&view(), Qt::Key_Escape);
        QCOMPARE(panel().look().light.azimuthDegrees, 40.0);
        QTest::mouseRelease(inner, Qt::LeftButton, Qt::ControlModifier, from);
        waitUntilIdle();
    }

    void whatIsDataStandsInThePicturesCentreAlongEveryAxis() {
        // A block of echo far off the middle of its grid; the rest is no data.
        VolumeGeometry geometry;
        geometry.size = {64, 60, 56};
        geometry.spacing = Vec3(1.0, 0.8, 1.3);
        std::vector<std::uint8_t> voxels(64 * 60 * 56, 0);
        for (int z = 6; z < 34; ++z)
            for (int y = 28; y < 54; ++y)
                for (int x = 2; x < 24; ++x)
                    voxels[static_cast<std::size_t>((z * 60 + y) * 64 + x)] =
                        static_cast<std::uint8_t>(120 + (x * 7 + y * 5 + z * 3) % 60);
        open(file("aside.mha", {std::make_shared<const Volume>(geometry, Voxels(std::move(voxels)))}));
        choose("view.mode", RenderMode::maximum);
        choose("view.reduction", SpeckleReduction::off);
        for (const BeamAxis axis : {BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY,
                                    BeamAxis::plusZ, BeamAxis::minusZ}) {
            for (const double cutMm : {0.0, 4.0}) {
                choose("view.beamAxis", axis);
                Document next = window().document().document();
                next.scene.front = {.depthMm = cutMm};
                window().document().edit(next, "near cut");
                waitUntilIdle();
                const Picture& picture = *view().picture();
                const QRect seen = whereSomethingShows(picture);
                QVERIFY(seen.height() > picture.height / 4);
                QVERIFY2(std::abs(seen.left() + seen.right() + 1 - picture.width) <= 4 &&
                             std::abs(seen.top() + seen.bottom() + 1 - picture.height) <= 4,
                         qPrintable(QString("%1, cut %2: %3 %4 of %5 %6")
                                        .arg(child<QComboBox>("view.beamAxis")->currentText())
                                        .arg(cutMm)
                                        .arg(seen.center().x())
                                        .arg(seen.center().y())
                                        .arg(picture.width)
                                        .arg(picture.height)));
            }
        }
    }

    void looksAreRemembered() {
        choose("view.mode", RenderMode::mean);
        choose("view.renderer", RendererChoice::software);
        child<QSlider>("view.lightElevation")->setValue(90 - 20);
        choose("view.mode", RenderMode::direct);
        click("view.depthColouring");
        waitUntilIdle();
        const Look look = view().look();
        choose("view.mode", RenderMode::mean);
        window().close();
        MainWindow next(settingsFile());
        auto* nextPanel = next.findChild<ViewPanel*>();
        QCOMPARE(nextPanel->look().mode, RenderMode::mean);
        QCOMPARE(nextPanel->renderer(), RendererChoice::software);
        QCOMPARE(nextPanel->look().light, (LightDirection{lookAtStart().light.azimuthDegrees, -20}));
        Look expected = look;
        expected.mode = RenderMode::mean;
        QCOMPARE(next.volumeView().look(), expected);
    }

    void theStatusLineSaysWhatAPictureCosts() {
        auto* label = child<QLabel>("status.renderer");
        QCOMPARE(label->text(), QString("software renderer"));
        QVERIFY2(QRegularExpression("^picture [0-9.,]+ ms\n").match(label->toolTip()).hasMatch(),
                 qPrintable(label->toolTip()));
        QVERIFY2(QRegularExpression("\nOTF [0-9.,]+ ms, \\d+ of \\d+ tube cores$").match(label->toolTip()).hasMatch(),
                 qPrintable(label->toolTip()));
        QVERIFY(!child<QLabel>("status.otf")->isVisible());
        const RayCastSettings settings = view().settings();
        QVERIFY2(label->toolTip().contains(
                     QString("converged: %1 × %2 rays, step 0.25").arg(settings.width).arg(settings.height)),
                 qPrintable(label->toolTip()));
    }

    void theToolTipTellsPictureAndMovement() {
        const PictureReport newest{.quality = "converged",
                                   .converged = true,
                                   .rays = {512, 400},
                                   .step = 0.5,
                                   .castMilliseconds = 301.26,
                                   .drawMilliseconds = 8};
        QCOMPARE(pictureToolTip(newest, std::nullopt), QString("converged: 512 × 400 rays, step 0.5\n"
                                                               "casting 301.3 ms, drawing 8.0 ms"));
        const PictureReport movement{.quality = "preview", .rays = {256, 200}, .step = 2, .framesPerSecond = 34.4};
        QCOMPARE(pictureToolTip(newest, movement).section('\n', 2),
                 QString("while moving 34 frames/s, preview: 256 × 200 rays, step 2"));
    }

private:
    template <typename Choice>
    void choose(const char* name, Choice choice) {
        auto* comboBox = child<QComboBox>(name);
        const std::string_view value = nameOf(choice);
        const int byName = comboBox->findData(QString::fromUtf8(value.data(), static_cast<qsizetype>(value.size())));
        comboBox->setCurrentIndex(byName >= 0 ? byName : comboBox->findData(static_cast<int>(choice)));
    }
    VolumeViewWidget& view() { return window().volumeView(); }
    ViewPanel& panel() { return *window().findChild<ViewPanel*>(); }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowPicture)

#include "test_main_window_picture.moc"
