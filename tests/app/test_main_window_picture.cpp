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
#include "widgets/panels/view_panel.h"

using namespace echolucent;

class TestMainWindowPicture : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_file = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        open(m_file);
    }
    void cleanup() { close(); }

    void aModeOfThePanelIsShownAndExplained() {
        const std::shared_ptr<const Picture> direct = view().picture();
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
        QVERIFY2(QRegularExpression("^software renderer · [0-9.,]+ ms$").match(label->text()).hasMatch(),
                 qPrintable(label->text()));
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

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    TestMainWindowPicture test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_main_window_picture.moc"
