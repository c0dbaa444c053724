// Files that are dropped on the window: what is opened, and what is said of the rest.
#include <QDropEvent>
#include <QMimeData>
#include <QSysInfo>

#include "app/study/dropped_files.h"
#include "tests/app/window_fixture.h"
#include "tests/io/written_files/dicom_files.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

namespace {

QList<QUrl> urlsOf(const QStringList& paths) {
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    return urls;
}

}  // namespace

class TestDroppedFiles : public QObject, private WindowFixture {
    Q_OBJECT

    bool drop(const QList<QUrl>& urls) {
        QMimeData data;
        data.setUrls(urls);
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &enter);
        QDropEvent dropped(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &dropped);
        return enter.isAccepted() && dropped.isAccepted();
    }

    /// A DICOM slice that lies at `place`, 1 mm apart, in a file without ending.
    static QString slice(const QString& folder, int place) {
        TestImage image;
        image.columns = image.rows = 16;
        image.instance = place + 1;
        makeSlice(image, place, 1);
        for (int pixel = 0; pixel < image.columns * image.rows; ++pixel)
            image.pixels8.push_back(static_cast<std::uint8_t>((7 * pixel + 3 * place) % 200));
        const QString path = QStringLiteral("%1/IM%2").arg(folder).arg(place);
        writeDicom(path.toStdString(), image);
        return path;
    }

private slots:
    void initTestCase() { lookAtNoPicture(); }

    void severalAreOneStudyOrAreRefused_data() {
        QTest::addColumn<QStringList>("dropped");
        QTest::addColumn<QString>("opened");
        QTest::addColumn<QString>("study");
        const QString none;
        QTest::newRow("one") << QStringList{"/a/b.mha"} << "/a/b.mha" << none;
        QTest::newRow("a folder") << QStringList{"/a/slices/"} << "/a/slices" << none;
        QTest::newRow("the same twice") << QStringList{"/a/b.mha", "/a/b.mha"} << "/a/b.mha" << none;
        QTest::newRow("marks of places") << QStringList{"/a %1/b %2 & <b>.mha"} << "/a %1/b %2 & <b>.mha" << none;
        QTest::newRow("data and header") << QStringList{"/a/b.raw", "/a/b.mhd"} << "/a/b.mhd" << none;
        QTest::newRow("header and parts") << QStringList{"/a/b.nhdr", "/a/1.gz", "/a/2.gz"} << "/a/b.nhdr" << none;
        QTest::newRow("a NIfTI pair") << QStringList{"/a/b.img", "/a/b.hdr"} << "/a/b.hdr" << none;
        QTest::newRow("a layout") << QStringList{"/a/b.raw", "/a/b.raw.echolucent.json"} << "/a/b.raw" << none;
        QTest::newRow("a session and its volume") << QStringList{"/a/b.mha", "/c/b.session.json"} << "/c/b.session.json"
                                                  << "/a/b.mha";
        QTest::newRow("slices") << QStringList{"/a/1.dcm", "/a/2.DCM"} << "/a" << none;
        QTest::newRow("slices without endings") << QStringList{"/a/IM0001", "/a/1.2.840.17"} << "/a" << none;
        QTest::newRow("a volume and its side-car") << QStringList{"/a/v.json", "/a/v.nii.gz"} << "/a/v.nii.gz" << none;
        QTest::newRow("a volume and all its side-cars")
            << QStringList{"/a/v.bval", "/a/v.nii.gz", "/a/v.json", "/a/v.bvec"} << "/a/v.nii.gz" << none;
        QTest::newRow("a session of a NIfTI volume") << QStringList{"/a/v.nii", "/a/w.json"} << "/a/w.json"
                                                     << "/a/v.nii";
        QTest::newRow("two folders") << QStringList{"/media/case/anna", "/media/case/berta/"} << none << none;
        QTest::newRow("words without endings") << QStringList{"/a/README", "/a/LICENSE"} << none << none;
        QTest::newRow("a slice and a word") << QStringList{"/a/1.dcm", "/a/README"} << none << none;
        QTest::newRow("slices of two folders") << QStringList{"/a/1.dcm", "/b/2.dcm"} << none << none;
        QTest::newRow("two volumes") << QStringList{"/a/1.mha", "/a/2.nrrd"} << none << none;
        QTest::newRow("two raw files") << QStringList{"/a/1.raw", "/a/2.raw"} << none << none;
        QTest::newRow("two sessions") << QStringList{"/a/1.json", "/a/2.json"} << none << none;
    }
    void severalAreOneStudyOrAreRefused() {
        QFETCH(QStringList, dropped);
        QFETCH(QString, opened);
        QFETCH(QString, study);
        const DroppedFiles files = droppedFiles(urlsOf(dropped));
        QCOMPARE(files.path, opened);
        QCOMPARE(files.study, study);
        QCOMPARE(!files.whyNot.isEmpty(), opened.isEmpty());
        if (opened.isEmpty()) QVERIFY2(files.whyNot.contains("one study"), qPrintable(files.whyNot));
    }

    void onlyFilesOfThisComputerAreOpened() {
        for (const char* address :
             {"http://elsewhere.example/b%20c.mha", "mtp://phone/b.mha", "file://elsewhere/b.mha"}) {
            const DroppedFiles files = droppedFiles({QUrl::fromLocalFile("/a/b.mha"), QUrl(address)});
            QCOMPARE(files.path, QString());
            QVERIFY2(files.whyNot.contains("is no file of this computer"), qPrintable(files.whyNot));
            QVERIFY2(files.whyNot.contains(address == QLatin1String("mtp://phone/b.mha") ? "phone" : "elsewhere"),
                     qPrintable(files.whyNot));
        }
        for (const QString& here : {QString("localhost"), QSysInfo::machineHostName()})
            QCOMPARE(droppedFiles({QUrl("file://" + here + "/a/b.mha")}).path, QString("/a/b.mha"));
        const DroppedFiles latin = droppedFiles({QUrl::fromEncoded("file:///a/f%E9tus.mha")});
        QCOMPARE(latin.path, QString());
        QVERIFY2(latin.whyNot.contains("UTF-8"), qPrintable(latin.whyNot));
        QCOMPARE(droppedFiles({QUrl::fromEncoded("file:///a/f%C3%A9tus.mha")}).path, QString::fromUtf8("/a/fétus.mha"));
    }

    void theWindowOpensThemAndAnswersForTheRest() {
        show();
        const QString name = QString::fromUtf8("超音波 %1 & <b>[*]\n") + QString(60, QChar(0x8d85));
        QDir folder(temporaryFolder().path());
        QVERIFY(folder.mkpath("%2 & [*]"));
        const QString path = folder.filePath("%2 & [*]/" + name + ".mha");
        QVERIFY(QFile::rename(file("small.mha", {smallPhantom(PhantomScene::shapes, 5)}), path));
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        QVERIFY(drop(urlsOf({path})));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QCOMPARE(window().openStudy().path(), path);
        QString shown = name + ".mha";
        shown.replace('\n', ' ').replace("[*]", "[*][*]");
        QVERIFY2(window().windowTitle().contains(shown), qPrintable(window().windowTitle()));
        waitUntilIdle();
        auto* message = child<MessageBar>("message");
        QVERIFY(folder.mkpath("case1") && folder.mkpath("case2"));
        const QString archive = folder.filePath("visit.zip");
        QFile zip(archive);
        QVERIFY(zip.open(QIODevice::WriteOnly));
        zip.write("PK\x03\x04 and more");
        zip.close();
        const QString gone = folder.filePath("gone %1.mha");
        const QString unreadable = folder.filePath(QString("f%1tus.mha").arg(QChar(QChar::ReplacementCharacter)));
        for (const auto& [urls, words] :
             {std::pair{urlsOf({archive}), "is a ZIP archive. Unpack it"},
              {urlsOf({gone}), "gone %1.mha: does not exist"},
              {urlsOf({unreadable}), "UTF-8"},
              {QList<QUrl>{QUrl("http://elsewhere.example/b.mha")}, "is no file of this computer"},
              {urlsOf({folder.filePath("case1"), folder.filePath("case2")}), "case1: is a folder"},
              {urlsOf({"/a/1.mha", "/a/2.mha"}), "Several things"}}) {
            QVERIFY(drop(urls));
            QTRY_VERIFY2_WITH_TIMEOUT(message->text().contains(words), qPrintable(message->text()), patience);
            QCOMPARE(window().openStudy().path(), path);
        }
        QStringList slices;
        for (int place = 0; place < 16; ++place) slices << slice(folder.filePath("case1"), place);
        QVERIFY(drop(urlsOf(slices)));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 2, patience);
        QCOMPARE(window().openStudy().path(), folder.filePath("case1"));
        QMimeData text;
        text.setText("words");
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &text, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &enter);
        QVERIFY(!enter.isAccepted());
        close();
    }
};

ECHOLUCENT_TEST_CLASS(TestDroppedFiles)
#include "test_dropped_files.moc"
