// The files opened last with their small pictures, and numbers where names would be shown.
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>

#include "app/study/recent_pictures.h"
#include "app/study/study_names.h"
#include "tests/app/telling_names.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestRecentFiles : public QObject, private WindowFixture {
    Q_OBJECT

    QString m_jane, m_other;

    [[nodiscard]] QDir pictures() { return QDir(Settings(settingsFile()).dataFolder() + "/recent"); }
    [[nodiscard]] QStringList pictureNames() { return pictures().entryList(QDir::Files); }
    [[nodiscard]] QMenu& recentMenu() {
        auto* menu = child<QMenu>("file.recent");
        emit menu->aboutToShow();
        return *menu;
    }
    /// What the program shows of a name, all windows and the list of recent files together.
    [[nodiscard]] QStringList wordsWith(const QString& name) {
        (void)recentMenu();
        return allWords().filter(name);
    }
    void begin() {
        pictures().removeRecursively();
        show();
        useLook(Look{});
    }

private slots:
    void initTestCase() {
        m_jane = file("DOE^JANE-1980.mha", {smallPhantom(PhantomScene::shapes, 5)});
        m_other = file("walnut.mha", {smallPhantom(PhantomScene::fetus, 3)});
    }
    void init() { begin(); }
    void cleanup() { close(); }

    void aStudyAtRestLeavesItsSmallPicture() {
        open(m_jane);
        QCOMPARE(pictureNames().size(), 1);
        QVERIFY(!pictureNames().first().contains("DOE", Qt::CaseInsensitive));
        const QImage picture(pictures().filePath(pictureNames().first()));
        QCOMPARE(picture.size(), QSize(RecentPictures::edge, RecentPictures::edge));
        // It is the middle of the picture that stands on the screen.
        const std::shared_ptr<const Picture> shown = window().volumeView().picture();
        const std::vector<std::uint8_t> rgb = overBackground(*shown, {0, 0, 0});
        const int side = std::min(shown->width, shown->height);
        double onScreen = 0.0, kept = 0.0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto at = 3 * static_cast<std::size_t>((y + (shown->height - side) / 2) * shown->width + x +
                                                             (shown->width - side) / 2);
                onScreen += rgb[at] / (255.0 * side * side);
            }
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                kept += qRed(picture.pixel(x, y)) / (255.0 * picture.width() * picture.height());
        QVERIFY2(onScreen > 0.01, qPrintable(QString::number(onScreen)));
        QVERIFY2(std::abs(onScreen - kept) < 0.01, qPrintable(QString("%1 %2").arg(onScreen).arg(kept)));
    }

    void thePictureFollowsTheView() {
        open(m_jane);
        const auto bytes = [this] {
            QFile file(pictures().filePath(pictureNames().value(0)));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = bytes();
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 70, .elevationDegrees = 0});
        QTRY_VERIFY(!window().idle());
        waitUntilIdle();
        QVERIFY(!bytes().isEmpty());
        QVERIFY(bytes() != before);
        QCOMPARE(pictureNames().size(), 1);
    }

    void theMenuShowsThePicturesAndOpensByKeys() {
        open(m_jane);
        open(m_other);
        QTest::mouseClick(window().menuBar(), Qt::LeftButton, {},
                          window().menuBar()->actionGeometry(window().menuBar()->actions().first()).center());
        auto* fileMenu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(fileMenu != nullptr);
        fileMenu->setActiveAction(child<QMenu>("file.recent")->menuAction());
        QTest::keyClick(fileMenu, Qt::Key_Right);
        auto* menu = child<QMenu>("file.recent");
        QTRY_VERIFY(menu->isVisible());
        QAction* second = menu->findChild<QAction*>("file.recent.2");
        QVERIFY(second != nullptr);
        QVERIFY2(second->text().startsWith("&2  DOE^JANE-1980.mha\t"), qPrintable(second->text()));
        for (const QString name : {"file.recent.1", "file.recent.2"}) {
            const QAction* action = menu->findChild<QAction*>(name);
            const QImage icon = action->icon().pixmap(48, 48).toImage();
            QVERIFY(icon != QImage());
            int lit = 0;
            for (int y = 0; y < icon.height(); ++y)
                for (int x = 0; x < icon.width(); ++x) lit += qGray(icon.pixel(x, y)) > 20 ? 1 : 0;
            QVERIFY2(lit > 100, qPrintable(QString("%1: %2").arg(name).arg(lit)));
            QVERIFY(menu->actionGeometry(const_cast<QAction*>(action)).height() >= 48);
        }
        QTest::keyClick(menu, Qt::Key_2);
        QTRY_COMPARE(window().openStudy().path(), m_jane);
        waitUntilIdle();
    }

    void clearingTheListRemovesThePictures() {
        open(m_jane);
        open(m_other);
        QCOMPARE(pictureNames().size(), 2);
        QMenu& menu = recentMenu();
        menu.findChild<QAction*>("file.recent.clear")->trigger();
        waitUntilIdle();
        QCOMPARE(pictureNames(), QStringList());
        QCOMPARE(recentMenu().actions().size(), 1);
        // The study that is open left the list with all others.
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 20, .elevationDegrees = 0});
        QTRY_VERIFY(!window().idle());
        waitUntilIdle();
        QCOMPARE(pictureNames(), QStringList());
    }

    void whatLeavesTheListLeavesNoPicture() {
        open(m_jane);
        Settings settings(settingsFile());
        QCOMPARE(pictureNames().size(), 1);
        close();
        for (int i = 0; i < Settings::recentFilesLimit; ++i) settings.addRecentFile(QString("/nowhere/%1.mha").arg(i));
        QVERIFY(settings.save());
        showAgain();
        open(m_other);
        QCOMPARE(pictureNames(), QStringList(Settings::hashOf(m_other) + ".png"));
    }

    void aPictureThatCannotBeKeptIsLeftOut() {
        // A file stands where the folder is to be.
        QFile inTheWay(Settings(settingsFile()).dataFolder());
        QDir(inTheWay.fileName()).removeRecursively();
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        open(m_jane);
        QVERIFY(recentMenu().findChild<QAction*>("file.recent.1") != nullptr);
        QVERIFY(inTheWay.remove());
    }

    void numbersStandForNamesEverywhere() {
        open(m_jane);
        QVERIFY(!wordsWith("DOE").isEmpty());  // so that the search is seen to find
        QAction* numbers = child<QAction>("view.numbersForNames");
        QVERIFY(!numbers->isChecked());
        numbers->trigger();
        QVERIFY2(wordsWith("DOE").isEmpty(), qPrintable(wordsWith("DOE").join('\n')));
        QVERIFY2(wordsWith("JANE").isEmpty(), qPrintable(wordsWith("JANE").join('\n')));
        QVERIFY2(window().windowTitle().startsWith("Echolucent · Study 1 · "), qPrintable(window().windowTitle()));

        // What is said of files that are saved, and the names that are proposed.
        const QString curve = QFileInfo(m_jane).absolutePath() + "/DOE^JANE-1980-mine.json";
        QVERIFY(window().saveCurve(curve));
        QCOMPARE(child<MessageBar>("message")->text(), "The adaptive curve was saved as *.json (256 nodes).");
        QVERIFY(!window().savePicture(m_jane));  // it is the study's own file
        QVERIFY(child<MessageBar>("message")->text().contains("Study 1"));
        QCOMPARE(wordsWith("DOE"), QStringList());
        QString proposed;
        QTimer::singleShot(0, this, [&] {
            auto* dialog = window().findChild<QFileDialog*>("saveFile");
            if (dialog == nullptr) qFatal("no dialog");
            proposed = QFileInfo(dialog->selectedFiles().value(0)).fileName();
            dialog->reject();
        });
        QTest::keyClick(&window(), Qt::Key_P);
        QCOMPARE(proposed, "study-1-picture.png");
        QVERIFY(QFile::remove(curve));
    }

    void filesThatFailToOpenAreCalledByNumbers_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("nothing known") << "ROE-RICHARD.xyz" << QByteArray("no volume");
        QTest::newRow("short") << "ROE-RICHARD.nrrd"
                               << QByteArray("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\nencoding: raw\n\nx");
        QTest::newRow("its data file is not there")
            << "ROE-RICHARD.mhd"
            << QByteArray(
                   "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\n"
                   "ElementDataFile = ROE-RICHARD-voxels.raw\n");
        QTest::newRow("a curve") << "ROE-RICHARD.json" << QByteArray("{\"nodes\": [[0, 0], [1, 1]]}");
    }
    void filesThatFailToOpenAreCalledByNumbers() {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        open(m_other);
        child<QAction>("view.numbersForNames")->trigger();
        const QString path = temporaryFolder().filePath(name);
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(path);
        QVERIFY(failed.wait(patience));
        waitUntilIdle();
        QVERIFY(!child<MessageBar>("message")->text().isEmpty());
        QCOMPARE(wordsWith("ROE"), QStringList());
        QCOMPARE(wordsWith("RICHARD"), QStringList());
        QVERIFY2(child<MessageBar>("message")->text().startsWith("Study 2: "),
                 qPrintable(child<MessageBar>("message")->text()));
        // The message changes with the switch while it is shown.
        child<QAction>("view.numbersForNames")->trigger();
        window().open(path);
        QVERIFY(failed.wait(patience));
        QVERIFY(!wordsWith("RICHARD").isEmpty());
        child<QAction>("view.numbersForNames")->trigger();
        QCOMPARE(wordsWith("RICHARD"), QStringList());
        QVERIFY(QFile::remove(path));
    }

    void numbersStayOverStarts() {
        open(m_jane);
        open(m_other);
        child<QAction>("view.numbersForNames")->trigger();
        QVERIFY(window().windowTitle().contains("Study 2"));
        window().close();
        close();
        QFile settings(settingsFile());
        QVERIFY(settings.open(QIODevice::ReadOnly));
        QVERIFY(settings.readAll().contains(Settings::hashOf(m_jane).toLatin1()));
        showAgain();
        QVERIFY(child<QAction>("view.numbersForNames")->isChecked());
        QVERIFY(wordsWith("DOE").isEmpty());
        open(m_jane);
        QVERIFY2(window().windowTitle().contains("Study 1 "), qPrintable(window().windowTitle()));
    }
};

ECHOLUCENT_TEST_CLASS(TestRecentFiles)
#include "test_recent_files.moc"
