// The coarse picture of a large study: it is seen while the study is being loaded, and goes when that has ended.
#include <sys/stat.h>

#include <QLabel>
#include <QSignalSpy>
#include <QTimer>
#include <cstdlib>
#include <fstream>
#include <string>

#include "app/window/theme.h"
#include "io/restricted/reader_process.h"
#include "io/restricted/restricted_reader.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/volume_view/still_picture.h"

using namespace echolucent;

namespace {

/// Grey levels of an image, by which two pictures are compared.
double meanDifference(const QImage& one, const QImage& other) {
    const QSize size(60, 40);
    const QImage a =
        one.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_Grayscale8);
    const QImage b =
        other.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_Grayscale8);
    double sum = 0;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / (size.width() * size.height());
}

}  // namespace

class TestLoadingPicture : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        m_small = file("small.mha", {smallPhantom(PhantomScene::shapes, 5)});
        m_large = largeFile();
    }
    void init() {
        show();
        useLook(Look{});
        open(m_small);
        useLook(Look{});
        waitUntilIdle();
    }
    void cleanup() {
        close();
        restricted::useReaderProgram({});
        qunsetenv("ECHOLUCENT_FALSE_READER");
        qunsetenv("ECHOLUCENT_FALSE_PIPE");
    }

    void isSeenUntilTheStudysOwnPictureIs() {
        const auto before = window().openStudy().volume();
        QSignalSpy coarse(&window().openStudy(), &OpenStudy::coarseVolumeRead);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        bool seenBeforeTheStudy = false, documentStayed = false;
        QImage shown;
        QTimer look;
        connect(&look, &QTimer::timeout, this, [&] {
            if (!still() || still()->isHidden() || seenBeforeTheStudy || !opened.isEmpty()) return;
            seenBeforeTheStudy = true;
            documentStayed = window().openStudy().volume() == before;
            shown = still()->image();
        });
        look.start(0);
        window().open(m_large);
        QVERIFY(opened.wait(30000));
        QVERIFY(seenBeforeTheStudy);
        QVERIFY(documentStayed);
        QCOMPARE(coarse.count(), 1);
        waitUntilIdle();
        QVERIFY(still()->isHidden());
        QVERIFY(window().openStudy().volume() != before);
        // What was seen is what is seen now, and not the study before.
        const QImage now = picture();
        QVERIFY2(meanDifference(shown, now) < 12, qPrintable(QString::number(meanDifference(shown, now))));
        const double light = meanDifference(shown, QImage(shown.size(), QImage::Format_RGB32));
        QVERIFY2(light > 10, qPrintable(QString::number(light)));  // a side of this scan is rather dark
        QVERIFY(!still()->accessibleName().isEmpty());
    }

    void goesWhereLoadingFails() {
        const auto before = window().openStudy().volume();
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        const QByteArray pipe = temporaryFolder().filePath("pipe").toLocal8Bit();
        QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
        qputenv("ECHOLUCENT_FALSE_PIPE", pipe);
        readBy("coarse-fails");
        window().open(m_large);
        QTRY_VERIFY_WITH_TIMEOUT(still() && still()->isVisible(), patience);
        QCOMPARE(child<QLabel>("status.activity")->text(), QStringLiteral("coarse picture, loading goes on"));
        QVERIFY(window().openStudy().loading());
        QVERIFY(!window().idle());
        QVERIFY(std::ofstream(pipe.toStdString()));  // it goes on
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patience);
        QTRY_VERIFY(still()->isHidden());
        QTRY_VERIFY(window().idle());
        QCOMPARE(window().openStudy().volume(), before);
        QCOMPARE(window().volumeView().volume(), before);
    }

    void goesOnCancel() {
        const auto before = window().openStudy().volume();
        readBy("coarse-stays");
        window().open(m_large);
        QTRY_VERIFY_WITH_TIMEOUT(still() && still()->isVisible(), patience);
        QTRY_VERIFY(child<QAbstractButton>("status.cancel")->isVisible());
        click("status.cancel");
        QTRY_VERIFY(still()->isHidden());
        QTRY_VERIFY(window().idle());
        QCOMPARE(window().openStudy().volume(), before);
    }

    void goesWhereAnotherStudyIsOpenedInstead() {
        readBy("coarse-stays");
        window().open(m_large);
        QTRY_VERIFY_WITH_TIMEOUT(still() && still()->isVisible(), patience);
        restricted::useReaderProgram({});
        window().open(m_small);
        QVERIFY(still()->isHidden());
        waitUntilIdle();
        QVERIFY(still()->isHidden());
    }

    void keepsItsProportionsInAViewOfAnotherShape() {
        QWidget view;
        view.resize(200, 100);
        StillPicture picture(view);
        QImage image(50, 50, QImage::Format_RGB32);
        image.fill(Qt::white);
        view.show();
        picture.showImage(image);
        const QImage seen = picture.grab().toImage().scaled(200, 100);
        QCOMPARE(seen.pixelColor(20, 50), QColor(Qt::black));
        QCOMPARE(seen.pixelColor(180, 50), QColor(Qt::black));
        for (const QPoint place : {QPoint(60, 5), QPoint(140, 5), QPoint(100, 50), QPoint(60, 95), QPoint(140, 95)})
            QCOMPARE(seen.pixelColor(place), QColor(Qt::white));
    }

private:
    StillPicture* still() { return window().findChild<StillPicture*>("view3d.coarse"); }
    QImage picture() { return window().volumeView().screenImage(); }
    /// The false reader of the tests in tests/restricted, in one of its ways.
    void readBy(const char* mode) {
        restricted::dismissReader();
        restricted::useReaderProgram((QApplication::applicationDirPath() + "/false-reader").toStdString());
        qputenv("ECHOLUCENT_FALSE_READER", mode);
    }

    /// A phantom of more than 2^25 voxels: a small one, of which every voxel stands for many.
    QString largeFile() {
        constexpr int edge = 324;
        const auto small = smallPhantom(PhantomScene::shapes, 7);
        const VolumeGeometry& geometry = small->geometry();
        std::string voxels;
        voxels.reserve(static_cast<std::size_t>(edge) * edge * edge);
        const auto of = [&](int place, int axis) {
            return place * geometry.size[static_cast<std::size_t>(axis)] / edge;
        };
        for (int z = 0; z < edge; ++z)
            for (int y = 0; y < edge; ++y)
                for (int x = 0; x < edge; ++x)
                    voxels.push_back(static_cast<char>(
                        static_cast<int>(small->storedValue(geometry.offset(of(x, 0), of(y, 1), of(z, 2))))));
        const QString path = temporaryFolder().filePath("large.mha");
        std::ofstream stream(path.toStdString(), std::ios::binary);
        stream << "ObjectType = Image\nNDims = 3\nDimSize = 324 324 324\nElementSpacing = 0.25 0.25 0.25\n"
               << "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
               << voxels;
        return path;
    }

    QString m_small, m_large;
};

ECHOLUCENT_TEST_CLASS(TestLoadingPicture)

#include "test_loading_picture.moc"
