// Presets in the real window: chosen, saved, renamed, removed, exported and imported, with their small pictures.
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cstdlib>
#include <vector>

#include "app/window/theme.h"
#include "io/document/preset_file.h"
#include "processing/designers/choice/designer_config.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestPresets : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        QVERIFY(m_out.isValid());
        wearTheme(Theme::dark);
        m_file = file("visit.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        QFile::remove(presetsFile());
        show();
        useLook(Look{});
        open(m_file);
        click("presets.open");
        waitForPictures();
    }
    void cleanup() { close(); }

    void eachHasAPictureOfThisVolume() {
        std::vector<QImage> pictures;
        for (int row = 0; row < list()->count(); ++row) {
            const QImage picture = pictureOf(row);
            int bright = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) bright += qGray(picture.pixel(x, y)) > 40 ? 1 : 0;
            QVERIFY2(bright > picture.width() * picture.height() / 50, qPrintable(list()->item(row)->text()));
            QVERIFY2(std::ranges::find(pictures, picture) == pictures.end(), qPrintable(list()->item(row)->text()));
            pictures.push_back(picture);
        }
        QCOMPARE(static_cast<int>(pictures.size()), static_cast<int>(standardPresets().size()));
        lookFrom(window(), Viewpoint{.azimuthDegrees = 70});
        waitForPictures();
        QVERIFY(pictureOf(0) != pictures[0]);
    }

    void noPictureIsMadeWhileNobodySeesThem() {
        click("presets.open");
        QVERIFY(!list()->isVisible());
        const QImage before = pictureOf(0);
        lookFrom(window(), Viewpoint{.azimuthDegrees = 70});
        waitUntilIdle();
        QVERIFY(pictureOf(0) == before);
        click("presets.open");
        waitForPictures();
        QVERIFY(pictureOf(0) != before);
    }

    void aClickChoosesAndIsOneStep() {
        const Document before = document();
        const int slicer = rowOf("Slicer's fetal curve");
        clickRow(slicer);
        QCOMPARE(document().panes.at(firstPane).curve, CurveKind::manual);
        QVERIFY(document().curves.manual == CurveSet{}.manual);
        QCOMPARE(document().scene.look.lighting, Lighting::surface);
        QCOMPARE(child<QLabel>("presets.current")->text(), QString("Slicer's fetal curve"));
        QVERIFY(child<QAbstractButton>("otfEditor.active.manual")->isChecked());
        clickRow(slicer);  // a second click changes nothing
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document() == before);
        QCOMPARE(child<QLabel>("presets.current")->text(), QString("changed"));
        waitUntilIdle();
    }

    void theKeyboardChoosesToo() {
        list()->setFocus();
        list()->setCurrentRow(0);
        QTest::keyClick(list(), Qt::Key_Right);
        QCOMPARE(list()->currentRow(), 1);
        QVERIFY(withPreset(document(), firstPane, standardPresets()[1]) != document());
        QTest::keyClick(list(), Qt::Key_Return);
        QVERIFY(withPreset(document(), firstPane, standardPresets()[1]) == document());
        waitForPictures();
    }

    void ofAPaneWithADesignerItSaysWhichCurveItKeeps() {
        window().document().edit(withDesigner(document(), firstPane, defaultConfigOf(allDesigners.back())), "designer");
        click("presets.save");
        const QString said = child<MessageBar>("message")->text();
        QVERIFY2(said.startsWith("The preset holds the adaptive curve, which the OTF of "), qPrintable(said));
        waitUntilIdle();
    }

    void savedRenamedAndKeptForTheNextStart() {
        Document next = document();
        next.curves.adjustment.threshold = 0.125;
        window().document().edit(next, "threshold");
        click("presets.save");
        const int row = static_cast<int>(standardPresets().size());
        QCOMPARE(list()->count(), row + 1);
        type("  Standard ");  // the name of one of the program's
        QTRY_COMPARE(list()->item(row)->text(), QString("Standard (2)"));
        child<QAction>("presets.rename")->trigger();
        type("Face, soft");
        QTRY_COMPARE(list()->item(row)->text(), QString("Face, soft"));
        QTRY_COMPARE(child<QLabel>("presets.current")->text(), QString("Face, soft"));
        waitForPictures();
        window().close();
        MainWindow again(settingsFile());
        auto* there = again.findChild<QListWidget*>("presets.list");
        QCOMPARE(there->count(), row + 1);
        QCOMPARE(there->item(row)->text(), QString("Face, soft"));
        QVERIFY(again.findChild<QToolButton*>("presets.open")->isChecked());
        const auto kept = readPresets(presetsFile().toStdString());
        QVERIFY(kept && kept->size() == 1);
        QCOMPARE(kept->front().curves.adjustment.threshold, 0.125);
    }

    void whatIsRemovedCanBeTakenBack() {
        click("presets.save");
        type("Mine");
        const int row = static_cast<int>(standardPresets().size());
        QTRY_COMPARE(list()->item(row)->text(), QString("Mine"));
        child<QAction>("presets.remove")->trigger();
        QCOMPARE(list()->count(), row);
        QCOMPARE(message()->text(), QString("The preset “Mine” was removed."));
        QCOMPARE(child<QPushButton>("message.action.0")->text(),
                 QString("Bring back"));  // the history has no such step
        click("message.action.0");
        QCOMPARE(list()->count(), row + 1);
        QCOMPARE(list()->item(row)->text(), QString("Mine"));
        waitForPictures();
    }

    void theProgramsOwnAreNeitherRenamedNorRemoved() {
        list()->setCurrentRow(2);
        QVERIFY(!child<QAction>("presets.rename")->isEnabled());
        QVERIFY(!child<QAction>("presets.remove")->isEnabled());
        QVERIFY(child<QAction>("presets.export")->isEnabled());
    }

    void exportedAndImported() {
        const QString path = m_out.filePath("from here.json");
        QTimer::singleShot(0, this, [this, path] {
            auto* dialog = window().findChild<QFileDialog*>("saveFile");
            QVERIFY(dialog != nullptr);
            QCOMPARE(QFileInfo(dialog->selectedFiles().value(0)).fileName(), QString("See-through.json"));
            dialog->selectFile(path);
            static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
        });
        list()->setCurrentRow(rowOf("See-through"));
        child<QAction>("presets.export")->trigger();
        const auto exported = readPresets(path.toStdString());
        QVERIFY(exported && exported->size() == 1);
        // Opened as a volume, the file says what it is and offers what it is for.
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(path);
        QVERIFY(failed.wait(patience));
        QCOMPARE(message()->text(), QString("from here.json: holds presets, not a volume."));
        QCOMPARE(child<QPushButton>("message.action.0")->text(), QString("Import them as presets"));
        click("message.action.0");
        const int row = static_cast<int>(standardPresets().size());
        QCOMPARE(list()->count(), row + 1);
        QCOMPARE(list()->item(row)->text(), QString("See-through (2)"));
        QCOMPARE(message()->text(), QString("1 preset was imported."));
        waitForPictures();
        // From kept samples a picture may differ by a level or two.
        const QImage one = pictureOf(row), other = pictureOf(rowOf("See-through"));
        for (int y = 0; y < one.height(); ++y)
            for (int x = 0; x < one.width(); ++x)
                QVERIFY(std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) <= 2);
    }

    void aFrameOfTheMotionIsPicturedAsItIsSeen() {
        click("presets.open");
        Document next = document();
        next.motion.axis = MotionAxis::x;
        window().document().edit(next, "axis");
        window().document().showFrame(40, 0);
        waitUntilIdle();
        click("presets.open");
        waitForPictures();
        const QImage turned = pictureOf(0);
        // The same view without the motion.
        Document posed = document();
        posed.scene.pose = shownPose(posed);
        posed.scene.motionAngle = 0;
        window().document().edit(posed, "pose");
        window().document().showFrame(0, 0);
        waitForPictures();
        const QImage still = pictureOf(0);
        double apart = 0;
        for (int y = 0; y < still.height(); ++y)
            for (int x = 0; x < still.width(); ++x)
                apart += std::abs(qGray(still.pixel(x, y)) - qGray(turned.pixel(x, y)));
        // The OTF's direction may differ, the place of nothing does.
        QVERIFY2(apart / (still.width() * still.height()) < 4.0, qPrintable(QString::number(apart)));
    }

    void closedTheGalleryKeepsNoVolume() {
        const std::weak_ptr<const Volume> before = window().openStudy().volume();
        click("presets.open");
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 60000);
        QTRY_VERIFY(before.expired());
    }

    void theFirstIsKeptInAFolderThatIsNotThereYet() {
        const QString folder = m_out.filePath("account/new");
        MainWindow fresh(folder + "/settings.ini");
        fresh.findChild<QAbstractButton*>("presets.save")->click();
        QVERIFY2(QFile::exists(folder + "/settings-presets.json"),
                 qPrintable(fresh.findChild<MessageBar*>("message")->text()));
        // Another window has saved one meanwhile: both are kept.
        MainWindow other(folder + "/settings.ini");
        fresh.findChild<QAbstractButton*>("presets.save")->click();
        other.findChild<QAbstractButton*>("presets.save")->click();
        QCOMPARE(readPresets((folder + "/settings-presets.json").toStdString())->size(), 3U);
    }

    void aFileThatCannotBeReadIsLeftAsItIs() {
        QFile broken(presetsFile());
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("{\"format\": \"echolucent-presets\", \"version\": 1, \"presets\": [{}]}");
        broken.close();
        MainWindow again(settingsFile());
        auto* bar = again.findChild<MessageBar*>("message");
        QVERIFY2(bar->text().contains("presets[0].name"), qPrintable(bar->text()));
        bar->dismiss();
        again.findChild<QAbstractButton*>("presets.save")->click();
        QVERIFY2(bar->text().contains("settings-presets.json"), qPrintable(bar->text()));
        QCOMPARE(again.findChild<QListWidget*>("presets.list")->count(), static_cast<int>(standardPresets().size()));
        QVERIFY(broken.open(QIODevice::ReadOnly));
        QVERIFY(broken.readAll().contains("[{}]"));
        QVERIFY(QFile::remove(presetsFile()));
    }

private:
    QListWidget* list() { return child<QListWidget>("presets.list"); }
    MessageBar* message() { return child<MessageBar>("message"); }
    const Document& document() { return window().document().document(); }
    QString presetsFile() { return Settings(settingsFile()).presetsFile(); }
    void waitForPictures() { QTRY_VERIFY_WITH_TIMEOUT(window().idle(), 30000); }
    QImage pictureOf(int row) {
        return list()->item(row)->icon().pixmap(QSize(184, 138)).toImage().convertToFormat(QImage::Format_RGB888);
    }
    int rowOf(const QString& name) { return list()->row(list()->findItems(name, Qt::MatchExactly).value(0)); }
    void clickRow(int row) {
        const QRect place = list()->visualItemRect(list()->item(row));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, place.center());
    }
    void type(const QString& name) {
        auto* field = list()->findChild<QLineEdit*>();
        QVERIFY(field != nullptr);
        field->selectAll();
        QTest::keyClicks(field, name);
        QTest::keyClick(field, Qt::Key_Return);
        // The name is taken when the field is gone, and the gallery is filled anew.
        QTRY_VERIFY(list()->findChild<QLineEdit*>() == nullptr);
        QCoreApplication::processEvents();
    }

    QTemporaryDir m_out;
    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestPresets)

#include "test_presets.moc"
