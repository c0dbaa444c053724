// The real main window, driven as a person or a script would, with real files, mouse and keys.
#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QMessageBox>
#include <QRadioButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <QUrl>
#include <QtMath>
#include <cmath>
#include <new>

#include "app/window/main_window.h"
#include "io/curve_file.h"
#include "io/output/meta_image_writer.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/ray_caster.h"
#include "tests/app/picture_measures.h"
#include "tests/app/window_fixture.h"
#include "widgets/otf_editor/canvas/curve_canvas.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/raw_layout_dialog.h"
#include "widgets/volume_view/volume_view_widget.h"

using namespace echolucent;

namespace {

/// Edits under one camera are made of samples that the ray caster keeps in 16 bits; the bound is an RMSE in levels.
constexpr double differenceOfKeptSamples = 0.03;

std::shared_ptr<const Volume> phantom(PhantomScene scene, std::uint64_t seed, double phase = 0) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = {72, 68, 70};
    config.spacing = Vec3(1.2, 1.2, 1.2);
    config.seed = seed;
    config.phase = phase;
    return std::make_shared<const Volume>(*makePhantom(config));
}

}  // namespace

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_shapes = m_folder.filePath("shapes.mha");
        m_moving = m_folder.filePath("moving.mha");
        QVERIFY(writeMetaImage(m_shapes.toStdString(), {phantom(PhantomScene::shapes, 5)}));
        QVERIFY(writeMetaImage(m_moving.toStdString(),
                               {phantom(PhantomScene::fetus, 3, 0.0), phantom(PhantomScene::fetus, 4, 0.5)}));
    }

    void init() {
        QFile::remove(settingsFile());
        m_window = std::make_unique<MainWindow>(settingsFile());
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        // A virtual display has no window manager that would make the window the active one.
        QApplication::setActiveWindow(m_window.get());
    }

    void cleanup() {
        if (m_window) m_window->otfEditor().setManualSaved();
        m_window.reset();
    }

    void opensAFileComputesItsOtfAndShowsIt() {
        open(m_shapes);
        OpenStudy& openStudy = m_window->openStudy();
        QVERIFY(m_window->windowTitle().contains("72×68×70"));
        const auto expected =
            adaptOpacity(*openStudy.volume(), openStudy.otf()->view, openStudy.otf()->config, {}, quietVoxels());
        QVERIFY(openStudy.voxelsOfOtf() != openStudy.volume());  // speckle is reduced
        QVERIFY(expected->tubesWithWeight > 20);
        QVERIFY(openStudy.otf()->curve == expected->curve);
        QVERIFY(m_window->otfEditor().state().adaptive == expected->curve);
        QVERIFY(m_window->otfEditor().activeCurve() == OpacityCurve(expected->curve));
        QVERIFY(coverage(shown()) > 0.1);
        QVERIFY2(difference(shown(), cast(expected->curve)) < 0.01, "the picture is not that of the curve");
    }

    void draggingANodeAndUndoingChangeCurveAndPicture() {
        open(m_shapes);
        OtfEditor& editor = m_window->otfEditor();
        QTest::keyClick(m_window.get(), Qt::Key_2);
        QCOMPARE(editor.state().active, CurveKind::manual);
        waitUntilIdle();
        const OtfEditorState before = editor.state();
        const Picture pictureBefore = shown();
        QVERIFY(difference(pictureBefore, cast(before.manual)) < 0.01);

        CurveCanvas& canvas = editor.canvas();
        const CurveNode node = before.manual.nodes[1];
        const CurveNode target{node.intensity - 0.1, node.opacity - 0.3};
        const QPoint from = canvas.axes().positionOf(node).toPoint();
        const QPoint to = canvas.axes().positionOf(target).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(&canvas, (from + to) / 2);
        QTest::mouseMove(&canvas, to);
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
        const CurveNode moved = editor.state().manual.nodes[1];
        QVERIFY(std::abs(moved.intensity - target.intensity) < 0.01);
        QVERIFY(std::abs(moved.opacity - target.opacity) < 0.01);
        waitUntilIdle();
        QVERIFY(difference(shown(), pictureBefore) > 1.0);
        QVERIFY(difference(shown(), cast(editor.state().manual)) < differenceOfKeptSamples);

        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(editor.state().manual == before.manual);
        waitUntilIdle();
        QVERIFY(difference(shown(), pictureBefore) < differenceOfKeptSamples);
    }

    void everyCurveCanBeTheActiveOne() {
        open(m_shapes);
        const OtfEditorState state = m_window->otfEditor().state();
        QSignalSpy active(&m_window->otfEditor(), &OtfEditor::activeCurveChanged);
        for (int key = Qt::Key_2; key <= Qt::Key_5; ++key) {
            QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key));
            waitUntilIdle();
            const CurveKind kind = allCurveKinds[static_cast<std::size_t>(key - Qt::Key_1)];
            QVERIFY(difference(shown(), cast(curveOf(state, kind))) < differenceOfKeptSamples);
            QVERIFY(difference(shown(), cast(state.adaptive)) > 0.1);
        }
        QCOMPARE(active.count(), 4);
    }

    void computeForThisViewTakesTheCamerasDirection() {
        open(m_shapes);
        Viewpoint turned;
        turned.azimuthDegrees = 20;
        turned.elevationDegrees = -10;
        lookFrom(*m_window, turned);
        QTest::keyClick(m_window.get(), Qt::Key_A);
        waitUntilIdle();
        const auto& otf = *m_window->openStudy().otf();
        QVERIFY(qAbs(otf.view.azimuthDegrees - 20) < 1e-6);
        QVERIFY(qAbs(otf.view.elevationDegrees + 10) < 1e-6);
        QVERIFY(otf.curve ==
                adaptOpacity(*m_window->openStudy().volume(), otf.view, otf.config, {}, quietVoxels())->curve);
    }

    void theNearCutMovesPictureAndTubes() {
        open(m_shapes);
        const Picture before = shown();
        auto* value = m_window->findChild<QAbstractSpinBox*>("view.nearCut.value");
        QVERIFY(value != nullptr);
        value->setFocus();
        value->selectAll();
        QTest::keyClicks(value, QLocale().toString(24.0, 'f', 1));
        QTest::keyClick(value, Qt::Key_Return);
        waitUntilIdle();
        QCOMPARE(m_window->volumeView().view().nearCutMm, 24.0);
        QVERIFY(difference(shown(), before) > 1.0);
        for (const TubeCore& tube : m_window->openStudy().otf()->tubes)
            if (tube.entryVoxel) QVERIFY(qAbs(((*tube.entryVoxel)[2] + 0.5) * 1.2 - 24.0) < 1.21);
    }

    void anotherPhaseIsAnotherVolumeUnderTheSameCamera() {
        open(m_moving);
        QCOMPARE(m_window->openStudy().study()->phases.size(), std::size_t(2));
        Viewpoint turned;
        turned.azimuthDegrees = 12;
        lookFrom(*m_window, turned);
        waitUntilIdle();
        const Picture before = shown();
        m_window->findChild<QAbstractSlider*>("view.phase")->setValue(1);
        waitUntilIdle();
        QCOMPARE(m_window->openStudy().phase(), 1);
        QVERIFY(qAbs(m_window->volumeView().view().azimuthDegrees - 12) < 1e-6);
        QVERIFY(difference(shown(), before) > 0.2);
        QVERIFY(difference(shown(), cast(m_window->openStudy().otf()->curve)) < 0.01);
    }

    void savesThePictureOnTheScreen() {
        open(m_shapes);
        const QString path = m_folder.filePath("picture.png");
        QVERIFY(m_window->savePicture(path));
        const QImage saved(path);
        const QImage screen = m_window->volumeView().screenImage();
        QCOMPARE(saved.size(), screen.size());
        int different = 0;
        for (int y = 0; y < saved.height(); ++y)
            for (int x = 0; x < saved.width(); ++x)
                different += saved.pixelColor(x, y) != screen.pixelColor(x, y) ? 1 : 0;
        QCOMPARE(different, 0);
        int bright = 0;
        for (int y = 0; y < saved.height(); ++y)
            for (int x = 0; x < saved.width(); ++x) bright += qGray(saved.pixel(x, y)) > 60 ? 1 : 0;
        QVERIFY(bright > saved.width() * saved.height() / 20);
        QVERIFY(!m_window->savePicture(m_folder.filePath("no such folder/picture.png")));
        QVERIFY(message()->text().contains("no such folder"));
    }

    void whatCannotBeReadIsSaidAndLosesNothing() {
        open(m_shapes);
        const SampledCurve curve = m_window->openStudy().otf()->curve;
        const QString bad = m_folder.filePath("broken.mha");
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "ObjectType = Image\nNDims = 3\nDimSize = 10 10 10\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\n"
            "ElementDataFile = LOCAL\nshort");
        file.close();
        QSignalSpy failed(&m_window->openStudy(), &OpenStudy::openFailed);
        m_window->open(bad);
        QVERIFY(failed.wait());
        waitUntilIdle();
        QVERIFY(message()->isVisible());
        QVERIFY(message()->text().contains("broken.mha"));
        QVERIFY(message()->text().contains("1000"));
        QVERIFY(difference(shown(), cast(curve)) < 0.01);
        QVERIFY(m_window->windowTitle().contains("72×68×70"));
    }

    void aStudyWhoseOtfFailsIsShownWithoutIt() {
        open(m_shapes);
        m_window->openStudy().setPipeline(
            [](const Volume&, const Viewpoint&, const AdaptiveOtfConfig&, const Progress&,
               const QuietVoxels&) -> std::optional<AdaptiveOtf> { throw std::bad_alloc(); });
        QSignalSpy failed(&m_window->openStudy(), &OpenStudy::otfFailed);
        m_window->open(m_moving);
        QVERIFY(failed.wait(20000));
        QVERIFY(message()->text().contains("needs more memory"));
        QVERIFY(m_window->otfEditor().state().adaptive.opacities.empty());
        waitUntilIdle();
        QCOMPARE(coverage(shown()), 0.0);
        QTest::keyClick(m_window.get(), Qt::Key_3);
        waitUntilIdle();
        QVERIFY(coverage(shown()) > 0.1);
        QVERIFY(difference(shown(), cast(m_window->otfEditor().state().linear)) < differenceOfKeptSamples);
        // The motion goes on without an OTF.
        const Picture before = shown();
        m_window->findChild<QSlider*>("motion.angle")->setValue(30);
        waitUntilIdle();
        QVERIFY(difference(shown(), before) > 0.01);
    }

    void aHeaderlessFileOffersToBeDescribed() {
        const QString raw = m_folder.filePath("headerless.bin");
        QFile file(raw);
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (int i = 0; i < 20 * 21 * 22; ++i) file.putChar(static_cast<char>(40 + i % 100));
        file.close();
        QSignalSpy failed(&m_window->openStudy(), &OpenStudy::openFailed);
        m_window->open(raw);
        QVERIFY(failed.wait());
        QVERIFY(message()->text().contains("headerless.bin"));
        QVERIFY(!message()->text().contains("--"));
        click<QAbstractButton>("message.action.0");
        auto* dialog = m_window->findChild<RawLayoutDialog*>("rawLayout");
        QVERIFY(dialog != nullptr);
        RawLayout layout;
        layout.size = {20, 21, 22};
        dialog->setValues(layout);
        QVERIFY(dialog->fits());
        QSignalSpy opened(&m_window->openStudy(), &OpenStudy::studyOpened);
        dialog->accept();
        QVERIFY(opened.wait());
        QCOMPARE(m_window->openStudy().volume()->storedValue(0), 40.0);
        QVERIFY(!m_window->openStudy().volume()->geometry().spacingKnown);
        QVERIFY(m_window->windowTitle().contains("spacing unknown"));
        // The next time nothing needs to be said.
        opened.clear();
        m_window->open(raw);
        QVERIFY(opened.wait());
        waitUntilIdle();
    }

    void curvesGoToFilesAndBack() {
        open(m_shapes);
        OtfEditor& editor = m_window->otfEditor();
        const ManualCurve curve{{{0.1, 0.0}, {0.4, 0.35}, {0.9, 0.7}}};
        const QString path = m_folder.filePath("curve.json");
        QVERIFY(writeCurve(path.toStdString(), curve));
        QVERIFY(m_window->openCurve(path));
        QVERIFY(editor.state().manual == curve);
        QCOMPARE(editor.state().active, CurveKind::manual);
        QVERIFY(!editor.isManualModified());
        editor.model().moveNode(1, {0.45, 0.25});
        QVERIFY(editor.isManualModified());
        QVERIFY(m_window->saveCurve(path));
        QVERIFY(!editor.isManualModified());
        QVERIFY(readCurve(path.toStdString()).value() == editor.state().manual);
    }

    void whatIsOpenIsNotOverwritten() {
        open(m_shapes);
        QFile volume(m_shapes);
        QVERIFY(volume.open(QIODevice::ReadOnly));
        const QByteArray before = volume.readAll();
        const QString link = m_folder.filePath("link.png");
        QVERIFY(QFile::link(m_shapes, link));
        for (const QString& path : {m_shapes, link}) {
            QVERIFY(!m_window->savePicture(path));
            QVERIFY(message()->text().contains("would overwrite"));
            QVERIFY(!m_window->saveCurve(path));
        }
        QFile after(m_shapes);
        QVERIFY(after.open(QIODevice::ReadOnly));
        QVERIFY(after.readAll() == before);
        QVERIFY(m_window->savePicture(m_folder.filePath("new.png")));
    }

    void anEditedCurveIsNotLostWithoutAsking() {
        open(m_shapes);
        m_window->otfEditor().model().moveNode(1, {0.45, 0.25});
        bool asked = false;
        QTimer::singleShot(0, this, [&] {
            auto* box = m_window->findChild<QMessageBox*>("unsavedCurve");
            asked = box != nullptr;
            if (box != nullptr) box->button(QMessageBox::Cancel)->click();
        });
        m_window->close();
        QVERIFY(asked);
        QVERIFY(m_window->isVisible());
    }

    void anAbsentSurfaceIsSaidAndTheInitialCurveUsed() {
        VolumeGeometry geometry;
        geometry.size = {40, 40, 40};
        const QString path = m_folder.filePath("constant.mha");
        QVERIFY(writeMetaImage(path.toStdString(), {std::make_shared<const Volume>(
                                                       geometry, Voxels(std::vector<std::uint8_t>(64000, 90)))}));
        open(path);
        const AdaptiveOtf& otf = *m_window->openStudy().otf();
        QVERIFY(QString::fromStdString(otf.message).contains("initial function is used"));
        QVERIFY(m_window->explanation().contains("initial function is used"));
        QVERIFY(message()->isVisible());
        QVERIFY(message()->text().contains("initial function is used"));
        for (int i = 0; i < 256; ++i)
            QVERIFY(qAbs(otf.curve.opacities[static_cast<std::size_t>(i)] - opacityAt(otf.config.initial, i / 255.0)) <
                    1e-12);
    }

    void everyControlHasAName() {
        open(m_shapes);
        QStringList nameless;
        for (QWidget* control : m_window->findChildren<QWidget*>()) {
            const bool isControl = qobject_cast<QAbstractButton*>(control) || qobject_cast<QAbstractSlider*>(control) ||
                                   qobject_cast<QAbstractSpinBox*>(control) || qobject_cast<QComboBox*>(control);
            // These are parts that Qt makes itself: scroll bars, a table's corner, the buttons of docks, menus and
            // tabs.
            const QString parent = control->parentWidget() ? control->parentWidget()->metaObject()->className() : "";
            const bool madeByQt = qobject_cast<QScrollBar*>(control) || parent == "QDockWidget" ||
                                  parent.startsWith("QTab") || parent.startsWith("QTable") || parent == "QMenuBar" ||
                                  parent == "QHeaderView" ||
                                  QString(control->metaObject()->className()) == "QTableCornerButton";
            if (isControl && !madeByQt && control->objectName().isEmpty())
                nameless << QString("%1 in %2").arg(control->metaObject()->className(), parent);
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
        for (const char* name : {"otfEditor.canvas", "otfEditor.nodeTable", "motion.play", "motion.angle",
                                 "adaptive.strength", "view3d", "status.renderer"})
            QVERIFY2(m_window->findChild<QWidget*>(name) != nullptr, name);
    }

    void remembersRecentFiles() {
        open(m_shapes);
        QCOMPARE(Settings(settingsFile()).recentFiles().value(0), m_shapes);
    }

private:
    QString settingsFile() const { return m_folder.filePath("settings.ini"); }
    MessageBar* message() const { return m_window->findChild<MessageBar*>("message"); }

    void open(const QString& path) {
        QSignalSpy computed(&m_window->openStudy(), &OpenStudy::otfComputed);
        m_window->open(path);
        QVERIFY(computed.wait(20000));
        waitUntilIdle();
    }
    void waitUntilIdle() {
        QTRY_VERIFY_WITH_TIMEOUT(m_window->idle() && m_window->volumeView().pictureIsFine(), 30000);
    }
    template <typename Button>
    void click(const QString& name) {
        auto* button = m_window->findChild<Button*>(name);
        QVERIFY2(button != nullptr, qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// The voxels that the picture is made of.
    QuietVoxels quietVoxels() const {
        const OpenStudy& openStudy = m_window->openStudy();
        return {openStudy.voxelsOfOtf().get(), openStudy.otf()->reduction};
    }
    Picture shown() const { return *m_window->volumeView().picture(); }
    /// What the ray caster makes of the volume shown with a curve, the window's settings otherwise.
    Picture cast(const OpacityCurve& curve) const {
        return *castRays(*m_window->openStudy().newestVoxels(), curve, m_window->volumeView().settings());
    }

    QTemporaryDir m_folder;
    QString m_shapes;
    QString m_moving;
    std::unique_ptr<MainWindow> m_window;
};

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    TestMainWindow test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_main_window.moc"
