// Studies in the real main window: their OTF, their picture, what curve, view, cut and phase make of it, and what
// cannot be read.
#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFile>
#include <QLocale>
#include <QScrollBar>
#include <QSignalSpy>
#include <cmath>
#include <new>

#include "io/writers/meta_image_writer.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/app/picture_measures.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/dialogs/raw_layout_dialog.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/otf_editor.h"
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

class TestMainWindow : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_shapes = file("shapes.mha", {phantom(PhantomScene::shapes, 5)});
        m_moving = file("moving.mha", {phantom(PhantomScene::fetus, 3, 0.0), phantom(PhantomScene::fetus, 4, 0.5)});
    }
    void init() { show(lookAtStart()); }
    void cleanup() { close(); }

    void opensAFileComputesItsOtfAndShowsIt() {
        open(m_shapes);
        OpenStudy& openStudy = window().openStudy();
        QVERIFY(window().windowTitle().contains("72×68×70"));
        const auto otf = window().otfs().adaptive();
        const auto expected = adaptOpacity(*openStudy.volume(), otf->view, otf->config, {}, quietVoxels());
        QVERIFY(quietVoxels().volume != openStudy.volume().get());  // speckle is reduced
        QVERIFY(expected->tubesWithWeight > 20);
        QVERIFY(otf->curve == expected->curve);
        QVERIFY(window().otfEditor().state().adaptive == expected->curve);
        QVERIFY(window().otfEditor().activeCurve() == OpacityCurve(expected->curve));
        QVERIFY(coverage(shown()) > 0.1);
        QVERIFY2(difference(shown(), cast(expected->curve)) < 0.01, "the picture is not that of the curve");
    }

    void draggingANodeAndUndoingChangeCurveAndPicture() {
        open(m_shapes);
        OtfEditor& editor = window().otfEditor();
        QTest::keyClick(&window(), Qt::Key_2);
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

        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(editor.state().manual == before.manual);
        waitUntilIdle();
        QVERIFY(difference(shown(), pictureBefore) < differenceOfKeptSamples);
    }

    void everyCurveCanBeTheActiveOne() {
        open(m_shapes);
        const OtfEditorState state = window().otfEditor().state();
        QSignalSpy active(&window().otfEditor(), &OtfEditor::activeCurveChanged);
        for (int key = Qt::Key_2; key <= Qt::Key_5; ++key) {
            QTest::keyClick(&window(), static_cast<Qt::Key>(key));
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
        lookFrom(window(), turned);
        QTest::keyClick(&window(), Qt::Key_A);
        waitUntilIdle();
        const auto& otf = *window().otfs().adaptive();
        QVERIFY(qAbs(otf.view.azimuthDegrees - 20) < 1e-6);
        QVERIFY(qAbs(otf.view.elevationDegrees + 10) < 1e-6);
        QVERIFY(otf.curve ==
                adaptOpacity(*window().openStudy().volume(), otf.view, otf.config, {}, quietVoxels())->curve);
    }

    void theNearCutMovesPictureAndTubes() {
        open(m_shapes);
        const Picture before = shown();
        auto* value = window().findChild<QAbstractSpinBox*>("view.nearCut.value");
        QVERIFY(value != nullptr);
        value->setFocus();
        value->selectAll();
        QTest::keyClicks(value, QLocale().toString(24.0, 'f', 1));
        QTest::keyClick(value, Qt::Key_Return);
        waitUntilIdle();
        QCOMPARE(frontDepthMm(window().volumeView().view()), 24.0);
        QVERIFY(difference(shown(), before) > 1.0);
        int entered = 0;
        for (const TubeCore& tube : window().otfs().adaptive()->tubes) {
            if (!tube.entryVoxel) continue;
            ++entered;
            QVERIFY(qAbs(((*tube.entryVoxel)[2] + 0.5) * 1.2 - 24.0) < 1.21);
        }
        QVERIFY(entered > 20);
    }

    void anotherPhaseIsAnotherVolumeUnderTheSameCamera() {
        open(m_moving);
        QCOMPARE(window().openStudy().study()->phases.size(), std::size_t(2));
        Viewpoint turned;
        turned.azimuthDegrees = 12;
        lookFrom(window(), turned);
        waitUntilIdle();
        const Picture before = shown();
        window().findChild<QAbstractSlider*>("motion.phase")->setValue(1);
        waitUntilIdle();
        QCOMPARE(window().openStudy().phase(), 1);
        QVERIFY(qAbs(window().volumeView().view().azimuthDegrees - 12) < 1e-6);
        QVERIFY(difference(shown(), before) > 0.2);
        QVERIFY(difference(shown(), cast(window().otfs().adaptive()->curve)) < 0.01);
    }

    void whatCannotBeReadIsSaidAndLosesNothing() {
        open(m_shapes);
        const SampledCurve curve = window().otfs().adaptive()->curve;
        const QString bad = temporaryFolder().filePath("broken.mha");
        QFile broken(bad);
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write(
            "ObjectType = Image\nNDims = 3\nDimSize = 10 10 10\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\n"
            "ElementDataFile = LOCAL\nshort");
        broken.close();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(bad);
        QVERIFY(failed.wait(patience));
        waitUntilIdle();
        QVERIFY(message()->isVisible());
        QVERIFY(message()->text().contains("broken.mha"));
        QVERIFY(message()->text().contains("1000"));
        QVERIFY(difference(shown(), cast(curve)) < 0.01);
        QVERIFY(window().windowTitle().contains("72×68×70"));
    }

    void aStudyWhoseOtfFailsIsShownWithoutIt() {
        open(m_shapes);
        window().otfs().setRun([](const DesignerConfig&, const DesignerInput&,
                                  const Progress&) -> std::optional<Design> { throw std::bad_alloc(); });
        QSignalSpy failed(&window().otfs(), &PaneOtfs::failed);
        window().open(m_moving);
        QVERIFY(failed.wait(patience));
        QVERIFY(message()->text().contains("needs more memory"));
        QVERIFY(window().otfEditor().state().adaptive.opacities.empty());
        waitUntilIdle();
        QCOMPARE(coverage(shown()), 0.0);
        QTest::keyClick(&window(), Qt::Key_3);
        waitUntilIdle();
        QVERIFY(coverage(shown()) > 0.1);
        QVERIFY(difference(shown(), cast(window().otfEditor().state().linear)) < differenceOfKeptSamples);
        // The motion goes on without an OTF.
        const Picture before = shown();
        window().findChild<QSlider*>("motion.angle")->setValue(30);
        waitUntilIdle();
        QVERIFY(difference(shown(), before) > 0.01);
    }

    void aHeaderlessFileOffersToBeDescribed() {
        const QString raw = temporaryFolder().filePath("headerless.bin");
        QFile headerless(raw);
        QVERIFY(headerless.open(QIODevice::WriteOnly));
        for (int i = 0; i < 20 * 21 * 22; ++i) headerless.putChar(static_cast<char>(40 + i % 100));
        headerless.close();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(raw);
        QVERIFY(failed.wait(patience));
        QVERIFY(message()->text().contains("headerless.bin"));
        QVERIFY(!message()->text().contains("--"));
        click("message.action.0");
        auto* dialog = window().findChild<RawLayoutDialog*>("rawLayout");
        QVERIFY(dialog != nullptr);
        RawLayout layout;
        layout.size = {20, 21, 22};
        dialog->setValues(layout);
        QVERIFY(dialog->fits());
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        dialog->accept();
        QVERIFY(opened.wait(patience));
        QCOMPARE(window().openStudy().volume()->storedValue(0), 40.0);
        QVERIFY(!window().openStudy().volume()->geometry().spacingKnown);
        QVERIFY(window().windowTitle().contains("spacing unknown"));
        // The next time nothing needs to be said.
        opened.clear();
        window().open(raw);
        QVERIFY(opened.wait(patience));
        waitUntilIdle();
    }

    void anAbsentSurfaceIsSaidAndTheInitialCurveUsed() {
        VolumeGeometry geometry;
        geometry.size = {40, 40, 40};
        const QString path = temporaryFolder().filePath("constant.mha");
        QVERIFY(writeMetaImage(path.toStdString(), {std::make_shared<const Volume>(
                                                       geometry, Voxels(std::vector<std::uint8_t>(64000, 90)))}));
        open(path);
        const AdaptiveOtf& otf = *window().otfs().adaptive();
        QVERIFY(QString::fromStdString(otf.message).contains("initial function is used"));
        QVERIFY(window().explanation().contains("initial function is used"));
        QVERIFY(message()->isVisible());
        QVERIFY(message()->text().contains("initial function is used"));
        for (int i = 0; i < 256; ++i)
            QVERIFY(qAbs(otf.curve.opacities[static_cast<std::size_t>(i)] - opacityAt(otf.config.initial, i / 255.0)) <
                    1e-12);
    }

    void everyControlHasAName() {
        open(m_shapes);
        QStringList nameless;
        for (QWidget* control : window().findChildren<QWidget*>()) {
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
            QVERIFY2(window().findChild<QWidget*>(name) != nullptr, name);
    }

private:
    MessageBar* message() { return child<MessageBar>("message"); }
    /// The voxels that the picture is made of.
    QuietVoxels quietVoxels() {
        const auto otf = window().otfs().of(PaneOtfs::adaptiveOfScene);
        return {otf->asked.shown.get(), otf->asked.reduction};
    }
    Picture shown() { return *window().volumeView().picture(); }
    /// What the ray caster makes of the volume shown with a curve, the window's settings otherwise.
    Picture cast(const OpacityCurve& curve) {
        return *castRays(*window().openStudy().newestVoxels(), curve, window().volumeView().settings());
    }

    QString m_shapes;
    QString m_moving;
};

ECHOLUCENT_TEST_CLASS(TestMainWindow)

#include "test_main_window.moc"
