// Files that the window opens and saves: proposed names, what is saved and said, what is never overwritten.
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>
#include <cmath>

#include "app/settings/settings.h"
#include "app/window/theme.h"
#include "io/document/curve_file.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/otf_editor.h"

using namespace echolucent;

class TestMainWindowFiles : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        teach();
        QVERIFY(m_out.isValid());
        wearTheme(Theme::dark);
        m_file = file("visit.7.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        open(m_file);
    }
    void cleanup() { close(); }

    void savesThePictureOnTheScreen() {
        const QString path = m_out.filePath("picture.png");
        QVERIFY(window().savePicture(path));
        const QImage saved(path);
        const QImage screen = window().volumeView().screenImage();
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
        QVERIFY(!window().savePicture(m_out.filePath("no such folder/picture.png")));
        QVERIFY(message()->text().contains("no such folder"));
    }

    void curvesGoToFilesAndBack() {
        OtfEditor& editor = window().otfEditor();
        const ManualCurve curve{{{0.1, 0.0}, {0.4, 0.35}, {0.9, 0.7}}};
        const QString path = m_out.filePath("curve.json");
        QVERIFY(writeCurve(path.toStdString(), curve));
        QVERIFY(window().openCurve(path));
        QVERIFY(editor.state().manual == curve);
        QCOMPARE(editor.state().active, CurveKind::manual);
        QVERIFY(!editor.isManualModified());
        editor.model().moveNode(1, {0.45, 0.25});
        QVERIFY(editor.isManualModified());
        QVERIFY(window().saveCurve(path));
        QVERIFY(!editor.isManualModified());
        QVERIFY(readCurve(path.toStdString()).value() == editor.state().manual);
        // The file leaves out what moves the rendered curve, and the message says so.
        Document next = window().document().document();
        next.curves.adjustment = {.threshold = 0.125, .transparency = -0.5};
        window().document().edit(next, "sliders");
        QVERIFY(window().saveCurve(path));
        QVERIFY(readCurve(path.toStdString()).value() == editor.state().manual);
        QCOMPARE(message()->text(),
                 QString("The manual curve was saved as curve.json (3 nodes). It leaves out what the "
                         "sliders change in the picture: threshold 12.5 %, transparency -50 %. A session "
                         "or a preset keeps that."));
    }

    void whatIsOpenIsNotOverwritten() {
        QFile volume(m_file);
        QVERIFY(volume.open(QIODevice::ReadOnly));
        const QByteArray before = volume.readAll();
        const QString link = m_out.filePath("link.png");
        QVERIFY(QFile::link(m_file, link));
        for (const QString& path : {m_file, link}) {
            QVERIFY(!window().savePicture(path));
            QVERIFY(message()->text().contains("would overwrite"));
            QVERIFY(!window().saveCurve(path));
        }
        QFile after(m_file);
        QVERIFY(after.open(QIODevice::ReadOnly));
        QVERIFY(after.readAll() == before);
        QVERIFY(window().savePicture(m_out.filePath("new.png")));
    }

    void theCurveThatIsShownIsSavedAndSaid_data() {
        QTest::addColumn<int>("key");
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("nodes");
        QTest::newRow("adaptive") << static_cast<int>(Qt::Key_1) << "adaptive" << 256;
        QTest::newRow("manual") << static_cast<int>(Qt::Key_2) << "manual" << 3;
        QTest::newRow("linear") << static_cast<int>(Qt::Key_3) << "piecewise linear" << 2;
        QTest::newRow("parabolic") << static_cast<int>(Qt::Key_4) << "parabolic" << 256;
        QTest::newRow("quartic") << static_cast<int>(Qt::Key_5) << "quartic" << 256;
    }
    void theCurveThatIsShownIsSavedAndSaid() {
        QFETCH(int, key);
        QFETCH(QString, name);
        QFETCH(int, nodes);
        window().otfEditor().model().moveNode(1, {0.45, 0.25});  // the manual curve is no other's
        QTest::keyClick(&window(), static_cast<Qt::Key>(key));
        const QString path = m_out.filePath(name + ".json");
        QVERIFY(window().saveCurve(path));
        const auto saved = readCurve(path.toStdString());
        QVERIFY(saved);
        QCOMPARE(static_cast<int>(saved->nodes.size()), nodes);
        for (int i = 0; i <= 510; ++i)
            QVERIFY(std::abs(opacityAt(*saved, i / 510.0) - opacityAt(window().otfEditor().activeCurve(), i / 510.0)) <
                    1e-4);
        QCOMPARE(message()->text(), QString("The %1 curve was saved as %1.json (%2 nodes).").arg(name).arg(nodes));
        QCOMPARE(message()->kind(), MessageKind::info);
        QCOMPARE(window().otfEditor().isManualModified(), name != "manual");
        // It is no longer said over the picture of another curve.
        QTest::keyClick(&window(), key == Qt::Key_3 ? Qt::Key_4 : Qt::Key_3);
        QVERIFY(!message()->isVisible());
    }

    void dialogsProposeANameAndRememberTheFolder() {
        QString proposed;
        QString folder;
        const auto accept = [&](const QString& path) {
            QTimer::singleShot(0, this, [&, path] {
                auto* dialog = window().findChild<QFileDialog*>("saveFile");
                QVERIFY(dialog != nullptr);
                proposed = QFileInfo(dialog->selectedFiles().value(0)).fileName();
                folder = dialog->directory().absolutePath();
                if (path.isEmpty()) return dialog->reject();
                dialog->selectFile(path);
                static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
            });
        };
        const QString other = m_out.filePath("other");
        QVERIFY(QDir().mkpath(other));
        accept(other + "/mine.png");
        QTest::keyClick(&window(), Qt::Key_P);
        QCOMPARE(proposed, "visit.7-picture.png");
        QCOMPARE(folder, QFileInfo(m_file).absolutePath());  // the study's own, the first time
        QVERIFY(QFile::exists(other + "/mine.png"));
        QVERIFY(QFile::copy(other + "/mine.png", other + "/visit.7-picture.png"));
        accept({});
        QTest::keyClick(&window(), Qt::Key_P);
        QCOMPARE(proposed, "visit.7-picture-2.png");  // what is there stays
        accept({});
        child<QWidget>("dock.otfEditor")->raise();
        QTRY_VERIFY(child<QWidget>("otfEditor.saveCurve")->isVisible());
        click("otfEditor.saveCurve");
        QCOMPARE(proposed, "visit.7-adaptive.json");
        QCOMPARE(folder, other);
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 60000);
        accept({});
        QTest::keyClick(&window(), Qt::Key_P);
        QCOMPARE(proposed, "simulated-scan-picture.png");
    }

    void anEditedCurveIsNotLostWithoutAsking() {
        window().otfEditor().model().moveNode(1, {0.45, 0.25});
        bool asked = false;
        QTimer::singleShot(0, this, [&] {
            auto* box = window().findChild<QMessageBox*>("unsavedCurve");
            asked = box != nullptr;
            if (box != nullptr) box->button(QMessageBox::Cancel)->click();
        });
        window().close();
        QVERIFY(asked);
        QVERIFY(window().isVisible());
    }

    void theQuestionAboutAnEditedCurveCutsNoWord() {
        window().otfEditor().model().moveNode(1, {0.45, 0.25});
        int looked = 0;
        QStringList cut;
        QTimer::singleShot(0, this, [&] {
            auto* box = window().findChild<QMessageBox*>("unsavedCurve");
            if (box == nullptr) qFatal("nothing was asked");
            for (QAbstractButton* button : box->buttons()) {
                ++looked;
                const bool inside = box->rect().contains(QRect(button->mapTo(box, QPoint(0, 0)), button->size()));
                if (!inside || button->width() < button->sizeHint().width()) cut << button->text();
            }
            box->button(QMessageBox::Cancel)->click();
        });
        window().close();
        QCOMPARE(looked, 3);
        QCOMPARE(cut, QStringList());
        QVERIFY(window().isVisible());
    }

    void aCurveOpenedAsAVolumeSaysWhatItIs() {
        const QString path = m_out.filePath("curve.json");
        const ManualCurve curve{{{0.2, 0.0}, {0.6, 0.5}}};
        QVERIFY(writeCurve(path.toStdString(), curve));
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(path);
        QVERIFY(failed.wait(patience));
        QCOMPARE(message()->text(), "curve.json: is an opacity curve, not a volume.");
        QCOMPARE(child<QPushButton>("message.action.0")->text(), "Open it as a curve");
        click("message.action.0");
        QVERIFY(window().otfEditor().activeCurve() == OpacityCurve(curve));
        waitUntilIdle();
    }

    void aTrackedSweepIsRefusedWithItsWaysOut() {
        QFile sweep(m_out.filePath("sweep.mha"));
        QVERIFY(sweep.open(QIODevice::WriteOnly));
        sweep.write(
            "ObjectType = Image\nNDims = 3\nDimSize = 4 4 2\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\n");
        for (const char* frame : {"0000", "0001"})
            sweep.write(QByteArray("Seq_Frame") + frame +
                        "_ProbeToTrackerTransform = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n");
        sweep.write("ElementDataFile = LOCAL\n" + QByteArray(32, 'x'));
        sweep.close();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(sweep.fileName());
        QVERIFY(failed.wait(patience));
        QVERIFY2(message()->text().contains("tracked 2D sweep of 2 frames"), qPrintable(message()->text()));
        QVERIFY2(message()->text().contains("Reconstruct a volume"), qPrintable(message()->text()));
        QVERIFY2(!message()->text().contains("--"), "an option of the command line is no way out here");
        QCOMPARE(child<QPushButton>("message.action.0")->text(), "Take the frames as slices");
        click("message.action.0");
        QTRY_COMPARE(window().openStudy().volume()->geometry().size[2], 2);
        waitUntilIdle();
    }

    void anErrorOfAFolderNamesTheFile() {
        const QString folder = m_out.filePath("slices");
        QVERIFY(QDir().mkpath(folder));
        QFile broken(folder + "/17.dcm");
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write(QByteArray(128, 0) + "DICM" + QByteArray("\x02\x00\x10\x00UI\xff\x7f", 8));
        broken.close();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(folder);
        QVERIFY(failed.wait(patience));
        QVERIFY2(message()->text().contains("17.dcm"), qPrintable(message()->text()));
        QVERIFY2(message()->text().startsWith("slices"), qPrintable(message()->text()));
        QVERIFY2(!message()->text().contains(m_out.path()), qPrintable(message()->text()));
    }

    void motionCurveAndMethodAreRemembered() {
        click("motion.mode.mean");
        auto* axis = child<QComboBox>("motion.axis");
        axis->setCurrentIndex(1);
        QTest::keyClick(&window(), Qt::Key_4);
        child<QWidget>("dock.method")->raise();
        auto* strength = child<QWidget>("adaptive.rampOpacity");
        QTRY_VERIFY(strength->isVisible());
        strength->setFocus();
        QTest::keyClick(strength, Qt::Key_Left);
        waitUntilIdle();
        const Document document = window().document().document();
        QVERIFY(document.method.config != AdaptiveOtfConfig{});
        window().close();
        MainWindow next(settingsFile());
        const Document& again = next.document().document();
        QVERIFY(again.motion == document.motion);
        QCOMPARE(again.motion.otf, MotionOtf::mean);
        QCOMPARE(again.panes.at(firstPane).curve, CurveKind::parabolic);
        QVERIFY(configOf(again) == configOf(document));
        QVERIFY(next.findChild<QRadioButton*>("motion.mode.mean")->isChecked());
        QVERIFY(next.findChild<QRadioButton*>("otfEditor.active.parabolic")->isChecked());
        // Opening a study keeps them too.
        QSignalSpy computed(&next.otfs(), &PaneOtfs::computed);
        next.open(m_file);
        QVERIFY(computed.wait(patience));
        QCOMPARE(again.motion.otf, MotionOtf::mean);
        QVERIFY(next.otfs().adaptive()->config == configOf(document));
        QTRY_VERIFY_WITH_TIMEOUT(next.idle(), 30000);
    }

    void remembersRecentFiles() { QCOMPARE(Settings(settingsFile()).recentFiles().value(0), m_file); }

private:
    MessageBar* message() { return child<MessageBar>("message"); }

    QTemporaryDir m_out;
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowFiles)

#include "test_main_window_files.moc"
