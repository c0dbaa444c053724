// One picture of all panes, or a large one of the 3D view: what it shows, how large it is, what is said.
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>
#include <array>
#include <cmath>

#include "app/compare/compare_room.h"
#include "app/picture/panes_saving.h"
#include "app/window/window_faces.h"
#include "tests/app/planes/measuring_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

class TestPanesSaving : public QObject, private MeasuringFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() {
        showWindow();
        openPoints();
        Document next = document();
        next.measurements = {{.id = 1, .placesMm = {at(0), at(1)}, .name = "LV"}};
        next.scene.planes = planesHolding(next.scene.planes, next.measurements[0].placesMm, next.beam.axis, dataBox());
        window().document().edit(next, "measure");
        waitUntilIdle();
        m_path = temporaryFolder().filePath("panes.png");
        QFile::remove(m_path);
    }
    void cleanup() { close(); }

    void allPanesStandAsOnTheScreenInTheSizeAskedFor() {
        const auto* grid = child<PaneGrid>("panes");
        key(Qt::Key_M);  // its hint is no part of the picture
        const QImage image = saved({.allPanes = true, .width = 2 * grid->width()});
        QCOMPARE(image.size(), grid->size() * 2);
        QCOMPARE(image.dotsPerMeterX(), 3780);  // of a plain screen
        for (const char* name : {"planes.a", "planes.b", "planes.c"}) {
            const PlanePane& each = pane(name);
            const QImage part = partOf(image, each, 2);
            // The samples are those of the screen, more densely.
            QVERIFY2(difference(part.scaled(each.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
                                each.image()) < 12.0,
                     name);
            QCOMPARE(QColor(part.pixel(1, part.height() / 2)), colourOfFrame(each));
        }
        int drawn = 0;
        for (const char* name : {"planes.a", "planes.b", "planes.c"}) {
            const QImage part = partOf(image, pane(name), 2);
            QVERIFY(inColour(part, coloursOverPictures().accent) < 20);
            if (!liesInPlane({at(0), at(1)}, pane(name).mapping().view, 1e-6)) continue;
            ++drawn;
            QVERIFY2(inColour(part, measurementColour) > 200, name);
        }
        QVERIFY(drawn >= 1);
        const QImage of3d = partOf(image, window().volumeView(), 2);
        const QImage screen = window().volumeView().screenImage();
        QVERIFY(difference(of3d.scaled(screen.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation), screen) < 8.0);
        QVERIFY(inColour(of3d, measurementColour) > 200);
    }

    void the3dPictureIsMadeAnewInItsSize() {
        key(Qt::Key_F2);
        waitUntilIdle();
        const QSize screen = window().volumeView().size();
        const QImage image = saved({.allPanes = false, .width = 2000});
        QCOMPARE(image.width(), 2000);
        QVERIFY(std::abs(image.height() - 2000.0 * screen.height() / screen.width()) <= 1.0);
        QVERIFY(difference(image.scaled(screen, Qt::IgnoreAspectRatio, Qt::SmoothTransformation),
                           window().volumeView().screenImage()) < 8.0);
        // The measurement is in it, with lines as much wider as the picture.
        QVERIFY(inColour(image, measurementColour) > 400);
        // Its caption is that of the picture that P saves.
        lookFrom(window(), {.azimuthDegrees = 25, .elevationDegrees = 10});
        waitUntilIdle();
        std::array<QImage, 2> byP, large;
        for (const Face face : {Face::review, Face::teach}) {
            window().faces().choose(face);
            waitUntilIdle();
            const auto at = static_cast<std::size_t>(face);
            QVERIFY(window().savePicture(m_path));
            byP.at(at) = captionOf(QImage(m_path));
            large.at(at) = captionOf(saved({.allPanes = false, .width = window().volumeView().width()}));
        }
        // Teach adds that the curve is of another view, on a line of its own.
        QVERIFY(wordsIn(byP[1]) > wordsIn(byP[0]) + 100);
        for (const std::size_t face : {0U, 1U}) {
            const int words = wordsIn(large.at(face)), expected = wordsIn(byP.at(face));
            QVERIFY2(std::abs(words - expected) < expected / 3, qPrintable(QString("%1, %2").arg(words).arg(expected)));
        }
    }

    void onlyPanesThatAreShownAreSaved() {
        auto* action = child<QAction>("file.savePanes");
        QVERIFY(action->isEnabled());
        key(Qt::Key_F5);
        QVERIFY(action->isEnabled());  // compared panes are saved too
        window().document().change("pair", [](Document& next) { next.comparison.layout = ComparisonLayout::wipe; });
        QVERIFY(!action->isEnabled());
        QVERIFY2(action->toolTip().contains("P saves it"), qPrintable(action->toolTip()));
        window().document().steps().undo();
        window().compareRoom().setShown(false);
        QVERIFY(action->isEnabled());
        for (const int width : {0, PictureDialog::longestEdge + 1}) {
            window().panesSaving().save(m_path, {.allPanes = true, .width = width});
            QVERIFY2(message().contains("nothing was saved"), qPrintable(message()));
        }
        QVERIFY(!QFile::exists(m_path));
        // A plane that has the whole room is the picture.
        doubleClick(pane("planes.b"));
        waitUntilIdle();
        const PlanePane& b = pane("planes.b");
        const QImage image = saved({.allPanes = true, .width = b.width()});
        QCOMPARE(image.size(), b.size());
        QVERIFY(difference(image, b.image().scaled(b.size())) < 12.0);
        QCOMPARE(QColor(image.pixel(0, image.height() / 2)), colourOfFrame(b));
        window().panesSaving().save(m_path, {.allPanes = false, .width = 800});
        QCOMPARE(message(), "No pane is shown that could be saved, so nothing was saved.");
    }

    void theDialogAsksForContentAndSize() {
        QTimer::singleShot(0, this, [&] {
            auto* dialog = window().findChild<PictureDialog*>("pictureDialog");
            if (dialog == nullptr) qFatal("no dialog");
            QVERIFY(dialog->findChild<QRadioButton*>("pictureDialog.allPanes")->isChecked());
            dialog->findChild<QComboBox*>("pictureDialog.size")->setCurrentIndex(2);
            QCOMPARE(dialog->choice(), (PictureChoice{true, PictureDialog::pageWidth, 300}));
            QTimer::singleShot(0, this, [&] {
                auto* files = window().findChild<QFileDialog*>("saveFile");
                if (files == nullptr) qFatal("no dialog of files");
                files->selectFile(m_path);
                static_cast<QDialog*>(files)->done(QDialog::Accepted);
            });
            QTest::mouseClick(dialog->findChild<QPushButton*>("pictureDialog.save"), Qt::LeftButton);
        });
        child<QAction>("file.savePanes")->trigger();
        waitUntilIdle();
        const QImage image(m_path);
        QCOMPARE(image.width(), PictureDialog::pageWidth);
        // It prints as wide as a page, with letters and lines that can be read there.
        QCOMPARE(image.dotsPerMeterX(), 11811);
        QCOMPARE(image.dotsPerMeterY(), 11811);
        // The frame of a plane is 1.5 pixels of a plain screen wide: 4.7 of 300 dots per inch.
        const double scale = double{PictureDialog::pageWidth} / child<PaneGrid>("panes")->width();
        const PlanePane& a = pane("planes.a");
        const QRgb frame = image.pixel(qRound(a.x() * scale) + 1, qRound((a.y() + a.height() / 2.0) * scale));
        int width = 0;
        while (image.pixel(qRound(a.x() * scale) + 1 + width, qRound((a.y() + a.height() / 2.0) * scale)) == frame)
            ++width;
        QVERIFY2(width >= 3 && width <= 4, qPrintable(QString::number(width)));
        QCOMPARE(message(), "The picture was saved as panes.png.");
        // Without planes there is no choice.
        PictureDialog alone({.of3d = {400, 300}, .ofPanes = {400, 300}, .planesAreShown = false});
        QVERIFY(!alone.findChild<QRadioButton*>("pictureDialog.allPanes")->isEnabled());
        QCOMPARE(alone.choice(), (PictureChoice{false, 800}));
        const auto* save = alone.findChild<QPushButton*>("pictureDialog.save");
        QVERIFY(save->isEnabled());
        // A low and wide pane in the width of a page is fine, a tall and narrow one is not.
        PictureDialog tall({.of3d = {30, 300}, .ofPanes = {30, 300}, .planesAreShown = false});
        tall.findChild<QComboBox*>("pictureDialog.size")->setCurrentIndex(2);
        QVERIFY(!tall.findChild<QPushButton*>("pictureDialog.save")->isEnabled());
        QVERIFY(tall.findChild<QPushButton*>("pictureDialog.save")->toolTip().contains("12000"));
        PictureDialog none({.of3d = {}, .ofPanes = {}, .planesAreShown = false});
        QVERIFY(!none.findChild<QPushButton*>("pictureDialog.save")->isEnabled());
        QCOMPARE(none.findChild<QLabel*>("pictureDialog.pixels")->text(), "No pane is shown.");
    }

    void aCancelledPictureAndAFileOfTheStudyAreNotWritten() {
        window().panesSaving().save(m_path, {.allPanes = true, .width = 2008});
        QVERIFY(!window().idle());
        window().panesSaving().save(m_path, {.allPanes = true, .width = 2008});
        QCOMPARE(message(), "A picture is being written. Wait for it, or cancel it.");
        window().panesSaving().cancel();
        waitUntilIdle();
        QVERIFY(!QFile::exists(m_path));
        QCOMPARE(message(), "Writing panes.png was cancelled; no file is left of it.");

        const QString study = window().openStudy().path();
        QFile file(study);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        window().panesSaving().save(study, {.allPanes = true, .width = 800});
        waitUntilIdle();
        QVERIFY(file.seek(0));
        QCOMPARE(file.readAll(), before);
        QVERIFY2(!message().contains("was saved"), qPrintable(message()));
    }

private:
    QImage saved(const PictureChoice& choice) {
        window().panesSaving().save(m_path, choice);
        if (window().idle()) qFatal("nothing is being written");
        waitUntilIdle();
        return QImage(m_path);
    }
    static QImage captionOf(const QImage& picture) { return picture.copy(0, 0, picture.width(), 60); }
    /// The number of pixels as bright as words.
    static int wordsIn(const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) count += qGray(image.pixel(x, y)) > 150;
        return count;
    }
    QColor colourOfFrame(const PlanePane& pane) {
        const QImage shown = const_cast<PlanePane&>(pane).grab().toImage();
        return shown.pixelColor(0, shown.height() / 2);
    }
    static QImage partOf(const QImage& picture, const QWidget& pane, int scale) {
        return picture.copy(QRect(pane.geometry().topLeft() * scale, pane.size() * scale));
    }
    /// The mean difference of grey levels, of 255.
    static double difference(const QImage& one, const QImage& other) {
        if (one.size() != other.size()) return 255.0;
        double sum = 0.0;
        for (int y = 0; y < one.height(); ++y)
            for (int x = 0; x < one.width(); ++x) sum += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y)));
        return sum / one.width() / one.height();
    }
    static int inColour(const QImage& image, const QColor& colour) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor is(image.pixel(x, y));
                count += std::abs(is.red() - colour.red()) + std::abs(is.green() - colour.green()) +
                             std::abs(is.blue() - colour.blue()) <
                         30;
            }
        return count;
    }

    QString m_path;
};

ECHOLUCENT_TEST_CLASS(TestPanesSaving)
#include "test_panes_saving.moc"
