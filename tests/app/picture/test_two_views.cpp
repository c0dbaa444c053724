// Two 3D views on one document: one camera.
#include <QApplication>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <atomic>
#include <thread>

#include "app/picture/document_view.h"
#include "io/document/document_file.h"
#include "io/writers/meta_image_writer.h"
#include "processing/phantom/phantom.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/hand_gesture.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> shapes() {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {48, 44, 46};
    config.spacing = Vec3(1.7, 1.7, 1.7);
    return std::make_shared<const Volume>(*makePhantom(config));
}

Document linear() {
    Document document;
    document.panes.front().curve = CurveKind::linear;
    return document;
}

}  // namespace

class TestTwoViews : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void initTestCase() {
        m_file = m_folder.filePath("shapes.mha");
        QVERIFY(writeMetaImage(m_file.toStdString(), {shapes()}));
    }
    void init() {
        m_window = std::make_unique<QWidget>();
        auto* row = new QHBoxLayout(m_window.get());
        for (VolumeViewWidget*& widget : m_widgets) {
            widget = new VolumeViewWidget(m_works);
            widget->setFixedSize(220, 200);
            row->addWidget(widget);
        }
        m_model = std::make_unique<DocumentModel>();
        m_model->begin(linear());
        m_hand = std::make_unique<HandGesture>(nullptr, 1'000'000);
        m_model->setHand([this] { return m_hand->current(); });
        m_openStudy = std::make_unique<OpenStudy>(m_works);
        m_otfs = std::make_unique<PaneOtfs>(*m_model, *m_openStudy, m_works);
        m_panes = std::make_unique<ShownPanes>(*m_model, *m_openStudy, *m_otfs, m_course);
        for (int i = 0; i < 2; ++i)
            m_views[static_cast<std::size_t>(i)] =
                std::make_unique<DocumentView>(*m_model, *m_openStudy, *m_panes, widget(i));
        open();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QVERIFY(awaitIdle());
    }
    void cleanup() {
        for (auto& view : m_views) view.reset();
        m_panes.reset();
        m_otfs.reset();
        m_openStudy.reset();
        m_window.reset();
    }

    void turningOneTurnsTheOtherToTheBit() {
        const std::string first = jsonOf(m_model->document());
        const std::vector<float> before = widget(1).picture()->rgba;
        drag(0, Qt::LeftButton, {}, {110, 100}, {151, 83});
        QVERIFY(widget(0).pose() != Pose{});
        QVERIFY(std::abs(widget(0).pose().direction.azimuth - 180.0 * 41 / 200) < 3);
        sameCamera();
        QVERIFY(awaitIdle());
        sameCamera();
        QVERIFY(widget(1).picture()->rgba != before);
        QVERIFY(widget(0).picture()->rgba == widget(1).picture()->rgba);
        QCOMPARE(m_model->steps().count(), 1);  // one drag

        drag(1, Qt::LeftButton, Qt::ShiftModifier, {110, 100}, {90, 117});
        sameCamera();
        QVERIFY(widget(0).pose().offsetMm != Vec3(0, 0, 0));
        turnWheel(1);
        turnWheel(1);
        sameCamera();
        QVERIFY(widget(0).pose().magnification > 1.0);
        QCOMPARE(m_model->steps().count(), 3);  // one burst of the wheel

        m_model->steps().undo();
        QCOMPARE(widget(1).pose().magnification, 1.0);
        m_model->steps().undo();
        m_model->steps().undo();
        QCOMPARE(jsonOf(m_model->document()), first);
        sameCamera();
        QVERIFY(widget(0).pose() == Pose{});
        QVERIFY(awaitIdle());
        QVERIFY(widget(1).picture()->rgba == before);
    }

    void aDragThatIsTakenBackIsTakenBackInBoth() {
        const Pose before = widget(1).pose();
        QTest::mousePress(inner(0), Qt::LeftButton, {}, {110, 100});
        moveTo(0, {150, 120}, Qt::LeftButton, {});
        QVERIFY(widget(1).pose() != before);
        QTest::keyClick(&widget(0), Qt::Key_Escape);
        QTest::mouseRelease(inner(0), Qt::LeftButton, {}, {150, 120});
        QVERIFY(widget(0).pose() == before);
        QVERIFY(widget(1).pose() == before);
        QCOMPARE(m_model->steps().count(), 0);
    }

    void aDragThatIsTakenBackShowsWhatAnotherStepHasLeft() {
        const Pose before = widget(0).pose();
        QTest::mousePress(inner(0), Qt::LeftButton, {}, {110, 100});
        moveTo(0, {150, 120}, Qt::LeftButton, {});
        Document next = m_model->document();
        next.scene.front.depthMm = 3.0;
        m_model->edit(next, "near cut");  // as where a search ends while the button is held
        QTest::keyClick(&widget(0), Qt::Key_Escape);
        QTest::mouseRelease(inner(0), Qt::LeftButton, {}, {150, 120});
        QVERIFY(m_model->document().scene.pose != before);
        sameCamera();
        m_model->steps().undo();
        sameCamera();
        QVERIFY(widget(0).pose() == before);
    }

    void theHandOnThePictureOfTheStudyBeforeChangesNothing() {
        openAnotherWhoseOtfIsAwaited();
        const std::string document = jsonOf(m_model->document());
        drag(0, Qt::LeftButton, {}, {110, 100}, {151, 83});
        turnWheel(0);
        QCOMPARE(jsonOf(m_model->document()), document);
        QCOMPARE(m_model->steps().count(), 0);
        m_otfIsAwaited = false;
        QTRY_VERIFY(!m_views[0]->held());
        sameCamera();
        QVERIFY(widget(0).pose() == Pose{});
    }

    void theLightOnThePictureOfTheStudyBeforeIsNotTheDocuments() {
        light();
        openAnotherWhoseOtfIsAwaited();
        const std::string document = jsonOf(m_model->document());
        drag(0, Qt::LeftButton, Qt::ControlModifier, {110, 100}, {151, 83});
        QVERIFY(widget(0).look().light != m_model->document().scene.look.light);
        QCOMPARE(jsonOf(m_model->document()), document);
        QCOMPARE(m_model->steps().count(), 0);
    }

    void aLightDragThatIsTakenBackMakesNoStep() {
        light();
        QTest::mousePress(inner(0), Qt::LeftButton, Qt::ControlModifier, {110, 100});
        moveTo(0, {150, 120}, Qt::LeftButton, Qt::ControlModifier);
        const LightDirection moved = m_model->document().scene.look.light;
        QVERIFY(moved != LightDirection{});
        Document next = m_model->document();
        next.scene.front.depthMm = 3.0;
        m_model->edit(next, "near cut");  // as where a search ends while the button is held
        QTest::keyClick(&widget(0), Qt::Key_Escape);
        QTest::mouseRelease(inner(0), Qt::LeftButton, Qt::ControlModifier, {150, 120});
        QCOMPARE(m_model->steps().count(), 1);
        QVERIFY(m_model->document().scene.look.light == moved);
        QVERIFY(widget(0).look().light == moved);
    }

    void anotherShapeOfAPictureLeavesThePoseAlone() {
        turnWheel(0);
        const Pose pose = widget(0).pose();
        const double height = widget(1).settings().camera.heightMm;
        widget(1).setFixedSize(120, 200);
        QVERIFY(awaitIdle());
        QVERIFY(widget(1).pose() == pose);
        QVERIFY(widget(0).pose() == pose);
        QVERIFY(widget(1).settings().camera.heightMm > 1.2 * height);  // what was in the picture still is
        QCOMPARE(m_model->steps().count(), 1);
    }

private:
    void open() {
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(m_file);
        QVERIFY(opened.wait(patience));
    }
    void openAnotherWhoseOtfIsAwaited() {
        m_model->begin(withCurve(m_model->document(), firstPane, CurveKind::adaptive));
        QTRY_VERIFY(m_otfs->isNewest(firstPane));
        m_otfIsAwaited = true;
        m_otfs->setRun([this](const DesignerConfig&, const DesignerInput&, const Progress& progress) {
            while (m_otfIsAwaited && !progress.cancelled()) std::this_thread::yield();
            return std::optional(Design{.classification = SampledCurve{}});
        });
        open();
        QVERIFY(m_views[0]->held() && m_views[1]->held());
    }
    void light() {
        Document lit = m_model->document();
        lit.scene.look.lighting = Lighting::surface;
        m_model->begin(lit);
    }
    VolumeViewWidget& widget(int i) { return *m_widgets[static_cast<std::size_t>(i)]; }
    QWindow* inner(int i) {
        // The native windows stand in the order of their widgets.
        const auto windows = m_window->windowHandle()->findChildren<QWindow*>();
        for (QWindow* window : windows) {
            const QPoint corner = window->mapToGlobal(QPoint(0, 0));
            if (corner == widget(i).mapToGlobal(QPoint(0, 0))) return window;
        }
        qFatal("no native window");
    }
    bool awaitIdle() {
        return QTest::qWaitFor(
            [this] { return m_works.idle() && widget(0).pictureIsFine() && widget(1).pictureIsFine(); }, patience);
    }
    void sameCamera() {
        QVERIFY(widget(0).pose() == widget(1).pose());
        QVERIFY(widget(0).pose() == m_model->document().scene.pose);
        QVERIFY(widget(0).settings().camera == widget(1).settings().camera);
    }
    void drag(int i, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPoint& from, const QPoint& to) {
        QTest::mousePress(inner(i), button, modifiers, from);
        for (int step = 1; step <= 10; ++step) moveTo(i, from + (to - from) * step / 10, button, modifiers);
        QTest::mouseRelease(inner(i), button, modifiers, to);
        QCoreApplication::processEvents();
    }
    void moveTo(int i, const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers) {
        QMouseEvent move(QEvent::MouseMove, QPointF(to), QPointF(inner(i)->mapToGlobal(to)), Qt::NoButton, buttons,
                         modifiers);
        QCoreApplication::sendEvent(inner(i), &move);
    }
    void turnWheel(int i) {
        QWheelEvent turn(QPointF(100, 100), inner(i)->mapToGlobal(QPointF(100, 100)), {}, {0, 120}, Qt::NoButton, {},
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(inner(i), &turn);
    }

    std::unique_ptr<QWidget> m_window;
    std::array<VolumeViewWidget*, 2> m_widgets{};
    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<HandGesture> m_hand;
    QTemporaryDir m_folder;
    QString m_file;
    OtfCourse m_course;
    std::atomic<bool> m_otfIsAwaited = false;
    std::unique_ptr<OpenStudy> m_openStudy;
    std::unique_ptr<PaneOtfs> m_otfs;
    std::unique_ptr<ShownPanes> m_panes;
    std::array<std::unique_ptr<DocumentView>, 2> m_views;
};

ECHOLUCENT_TEST_CLASS(TestTwoViews)

#include "test_two_views.moc"
