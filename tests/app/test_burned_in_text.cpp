// What is said of text burnt into the pictures of a study before a picture of it leaves the window.
#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include "app/window/theme.h"
#include "tests/app/window_fixture.h"
#include "tests/io/written_files/dicom_files.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestBurnedInText : public QObject, private WindowFixture {
    Q_OBJECT

    /// A folder of slices that state this of text in their pixels, or nothing.
    QString slices(const QString& name, const std::string& stated) {
        QDir().mkpath(temporaryFolder().filePath(name));
        for (int slice = 0; slice < 24; ++slice) {
            TestImage image;
            image.columns = image.rows = 24;
            for (int place = 0; place < 24 * 24; ++place) {
                const bool inside = std::abs(slice - 12) < 6 && std::abs(place % 24 - 12) < 6 && place / 24 > 9;
                image.pixels8.push_back(static_cast<std::uint8_t>(inside ? 200 : 20 + place % 7));
            }
            image.instance = slice + 1;
            makeSlice(image, slice, 1);
            image.burnedInAnnotation = stated;
            writeDicom(temporaryFolder().filePath(QStringLiteral("%1/s%2.dcm").arg(name).arg(slice)).toStdString(),
                       image);
        }
        return temporaryFolder().filePath(name);
    }
    /// The note of a dialog that stands there, shown in whole; empty where it has none.
    static QString noteIn(const QDialog* dialog, const QString& objectName) {
        const auto* note = dialog->findChild<QLabel*>(objectName);
        if (note == nullptr) return {};
        if (!note->isVisible() || note->height() < note->heightForWidth(note->width())) return "cut";
        if (!note->accessibleName().contains("may show names")) return "not accessible";
        return note->text();
    }
    /// What each way of saving pictures says before it writes.
    QStringList notes() {
        QStringList said;
        QTimer::singleShot(0, this, [&] {
            auto* dialog = window().findChild<QFileDialog*>("saveFile");
            if (dialog == nullptr || !QTest::qWaitForWindowExposed(dialog)) qFatal("no dialog");
            said << noteIn(dialog, "saveFile.note");
            QTest::keyClick(dialog, Qt::Key_Escape);
        });
        QTest::keyClick(&window(), Qt::Key_P);
        for (const char* command : {"file.saveMovie", "file.savePictureSeries"}) {
            child<QAction>(command)->trigger();
            auto* dialog = window().findChild<QDialog*>("movieDialog");
            if (dialog == nullptr || !QTest::qWaitForWindowExposed(dialog)) qFatal("no dialog");
            said << noteIn(dialog, "movieDialog.note");
            QTest::keyClick(dialog, Qt::Key_Escape);
            if (!QTest::qWaitFor([&] { return window().findChild<QDialog*>("movieDialog") == nullptr; }))
                qFatal("the dialog stays");
        }
        QTimer::singleShot(0, this, [&] {
            auto* dialog = window().findChild<QDialog*>("report");
            if (dialog == nullptr || !QTest::qWaitForWindowExposed(dialog)) qFatal("no dialog");
            said << noteIn(dialog, "report.note");
            QTest::keyClick(dialog, Qt::Key_Escape);
        });
        child<QAction>("file.saveReport")->trigger();
        window().findChild<MessageBar*>("message")->dismiss();
        QApplication::clipboard()->clear();
        child<QAction>("edit.copyPicture")->trigger();
        if (QApplication::clipboard()->image().isNull()) qFatal("nothing was copied");
        said << window().findChild<MessageBar*>("message")->text();
        return said;
    }

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        teach();
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});
    }
    void cleanup() { close(); }

    void isSaidBeforeAnythingIsSaved() {
        open(slices("cine", "YES"));
        const QStringList said = notes();
        QCOMPARE(said.size(), 5);
        const QString note =
            "The file declares text in its pictures: what is saved may show names burnt into the pictures.";
        for (const QString& words : said) QVERIFY2(words.endsWith(note), qPrintable(words));
        // Curves hold no pictures.
        bool noted = true;
        QTimer::singleShot(0, this, [&] {
            auto* dialog = window().findChild<QFileDialog*>("saveFile");
            noted = dialog->findChild<QLabel*>("saveFile.note") != nullptr;
            dialog->reject();
        });
        child<QWidget>("dock.otfEditor")->raise();
        QTRY_VERIFY(child<QWidget>("otfEditor.saveCurve")->isVisible());
        click("otfEditor.saveCurve");
        QVERIFY(!noted);
    }

    void isNotSaidOfPicturesThatAreDeclaredFreeOfIt() {
        open(slices("free", "NO"));
        QCOMPARE(notes(), QStringList({"", "", "", "", "The picture was copied."}));
    }

    void isNotSaidOfFormatsWithoutSuchAnEntry() {
        open(file("scan.mha", {smallPhantom(PhantomScene::shapes, 5)}));
        QCOMPARE(notes(), QStringList({"", "", "", "", "The picture was copied."}));
    }
};

ECHOLUCENT_TEST_CLASS(TestBurnedInText)

#include "test_burned_in_text.moc"
