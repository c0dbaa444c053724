// From the moment a study is asked for the old pictures are dimmed, and the new study's name stands on them.
#include <QAction>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <cmath>

#include "app/window/theme.h"
#include "io/restricted/reader_process.h"
#include "io/restricted/restricted_reader.h"
#include "processing/picture/annotation_layout.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/opening_label.h"
#include "widgets/planes/plane_pane.h"

using namespace echolucent;

namespace {

double brightnessOf(const QImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    return sum / (static_cast<double>(image.width()) * image.height());
}

}  // namespace

class TestComingStudy : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        wearTheme(Theme::dark);
        m_old = file("old.mha", {smallPhantom(PhantomScene::shapes, 5)});
        m_new = file("new.mha", {smallPhantom(PhantomScene::fetus, 2)});
        m_broken = temporaryFolder().filePath("broken.mha");
        QFile broken(m_broken);
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("ObjectType = Image\nNDims = 3\n") > 0);
    }
    void init() {
        show();
        useLook(Look{});
        open(m_old);
        m_title = window().windowTitle();
        m_picture = view().screenImage();
    }
    void cleanup() {
        close();
        restricted::useReaderProgram({});
        qunsetenv("ECHOLUCENT_FALSE_READER");
    }

    void isDimmedBeforeAnythingIsRead() {
        for (const char* way : {"open", "recent", "dropped", "simulated"}) {
            if (window().openStudy().path() != m_old) open(m_old);
            const QImage bright = view().screenImage();
            ask(way);
            // No event of the loader can have come yet.
            QVERIFY2(view().dimmed(), way);
            const QString name = way == QLatin1String("simulated") ? "Simulated scan" : "new.mha";
            QVERIFY(label()->isVisible());
            QCOMPARE(child<QLabel>("opening.name")->text(), name);
            QVERIFY2(window().windowTitle().contains("opening " + name, Qt::CaseInsensitive),
                     qPrintable(window().windowTitle()));
            QVERIFY(window().openStudy().path() == m_old);
            QVERIFY(!window().idle());
            QVERIFY(std::abs(brightnessOf(view().screenImage()) - (1 - oldPictureShade) * brightnessOf(bright)) < 1.0);
            // The label lies over the picture.
            const QRect place(view().mapTo(&window(), QPoint(0, 0)), view().size());
            QVERIFY(place.contains(QRect(label()->mapTo(&window(), QPoint(0, 0)), label()->size())));
            waitUntilIdle();
            QVERIFY(!view().dimmed());
            QTRY_VERIFY(!label()->isVisible());
            QVERIFY2(!window().windowTitle().contains("opening"), qPrintable(window().windowTitle()));
            QVERIFY(window().windowTitle() != m_title);
        }
    }

    void nothingOldStandsUnderTheNewName() {
        bool dimmed = false, refused = false;
        QVERIFY(window().openStudy().volume() == view().volume());
        connect(&window().openStudy(), &OpenStudy::studyOpened, &window(), [&] {
            if (window().openStudy().volume() == view().volume()) return;
            dimmed = view().dimmed() && label()->isVisible();
            // The file would have the new study's name and the old one's picture.
            refused = !window().savePicture(temporaryFolder().filePath("refused.png"));
        });
        window().open(m_new);
        waitUntilIdle();
        QVERIFY(dimmed);
        QVERIFY(refused);
        QVERIFY(!QFile::exists(temporaryFolder().filePath("refused.png")));
        QTRY_VERIFY(!label()->isVisible());
        QVERIFY(!view().dimmed());
    }

    void comesBackWhereOpeningFails() {
        QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
        window().open(m_broken);
        QVERIFY(view().dimmed());
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patience);
        QTRY_VERIFY(window().idle());
        asBefore();
        // The trouble stays until the next study is asked for.
        auto* message = child<MessageBar>("message");
        QVERIFY(message->text().contains("broken.mha"));
        message->setConfirmationMilliseconds(0);
        QVERIFY(window().savePicture(temporaryFolder().filePath("kept.png")));
        QVERIFY2(message->text().contains("The 3D picture was saved as kept.png."), qPrintable(message->text()));
        QCOMPARE(message->kind(), MessageKind::info);
        QTRY_VERIFY(message->text().contains("broken.mha"));
        QCOMPARE(message->kind(), MessageKind::error);
        window().open(m_new);
        QVERIFY2(message->text().isEmpty(), qPrintable(message->text()));
        waitUntilIdle();
    }

    void comesBackOnCancelAndSavedPicturesAreNeverDimmed() {
        const QString plain = temporaryFolder().filePath("plain.png"), meanwhile = temporaryFolder().filePath("m.png");
        QVERIFY(window().savePicture(plain));
        restricted::dismissReader();
        restricted::useReaderProgram((QApplication::applicationDirPath() + "/false-reader").toStdString());
        qputenv("ECHOLUCENT_FALSE_READER", "coarse-stays");
        window().open(m_new);
        QTRY_VERIFY(child<QAbstractButton>("status.cancel")->isVisible());
        QVERIFY(view().dimmed());
        QVERIFY(window().savePicture(meanwhile));
        QCOMPARE(QImage(meanwhile), QImage(plain));
        QVERIFY(view().dimmed());
        click("status.cancel");
        QTRY_VERIFY(window().idle());
        asBefore();
    }

    void planesAndComparedPanesAreDimmedToo() {
        child<QAction>("room.quad")->trigger();
        waitUntilIdle();
        auto* plane = child<PlanePane>("planes.a");
        const double bright = brightnessOf(plane->grab().toImage());
        window().open(m_broken);
        QVERIFY(brightnessOf(plane->grab().toImage()) < 0.5 * bright);
        QTRY_VERIFY(window().idle());
        QCOMPARE(brightnessOf(plane->grab().toImage()), bright);
        QTest::keyClick(&window(), Qt::Key_F5);
        waitUntilIdle();
        auto* pane = child<QWidget>("compare.pane1");
        const double compared = brightnessOf(pane->grab().toImage());
        window().open(m_broken);
        QVERIFY(brightnessOf(pane->grab().toImage()) < 0.5 * compared);
        QVERIFY(label()->isVisible());
        QTRY_VERIFY(window().idle());
        QCOMPARE(brightnessOf(pane->grab().toImage()), compared);
        QVERIFY(!label()->isVisible());
    }

private:
    VolumeViewWidget& view() { return window().volumeView(); }
    OpeningLabel* label() { return child<OpeningLabel>("opening"); }
    void ask(const QString& way) {
        if (way == "open") return window().open(m_new);
        if (way == "simulated") return child<QAction>("file.openSimulatedScan")->trigger();
        if (way == "recent") {
            auto* menu = child<QMenu>("file.recent");
            emit menu->aboutToShow();
            return child<QAction>("file.recent.2")->trigger();
        }
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(m_new)});
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &enter);
        QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window(), &drop);
    }
    void asBefore() {
        QVERIFY(!view().dimmed());
        QVERIFY(!label()->isVisible());
        QCOMPARE(window().windowTitle(), m_title);
        QCOMPARE(view().screenImage(), m_picture);
    }

    QString m_old, m_new, m_broken, m_title;
    QImage m_picture;
};

ECHOLUCENT_TEST_CLASS(TestComingStudy)

#include "test_coming_study.moc"
