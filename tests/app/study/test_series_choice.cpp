// A folder of several series: which one is opened is asked, with small pictures, by real keys and clicks.
#include <QAction>
#include <QApplication>
#include <QByteArray>
#include <QColor>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QIODevice>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QObject>
#include <QPushButton>
#include <QRect>
#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/sessions/session_keeping.h"
#include "io/writers/enhanced_us_writer.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

/// A volume of bytes whose value grows along x.
std::shared_ptr<const Volume> ramp(std::array<std::int64_t, 3> size) {
    VolumeGeometry geometry;
    geometry.size = size;
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = static_cast<std::uint8_t>(255 * (i % static_cast<std::size_t>(size[0])) /
                                              static_cast<std::size_t>(size[0]));
    return std::make_shared<const Volume>(geometry, Voxels(std::move(voxels)));
}

}  // namespace

class TestSeriesChoice : public QObject, private WindowFixture {
    Q_OBJECT

    QTemporaryDir m_series;

    void write(const QString& name, std::array<std::int64_t, 3> size) {
        QVERIFY(writeEnhancedUs(m_series.filePath(name).toStdString(), {ramp(size)}, {}));
    }
    /// Puts all slices of a file at one depth, so that they are no volume.
    static void flatten(const QString& path) {
        const QByteArray position(
            "\x20\x00\x01\x93"
            "FD\x18\x00",
            8);
        change(path, [&](QByteArray& bytes) {
            for (qsizetype at = 0; (at = bytes.indexOf(position, at)) >= 0; at += 32)
                bytes.replace(at + 24, 8, QByteArray(8, 0));
        });
    }
    template <typename Edit>
    static void change(const QString& path, const Edit& edit) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        edit(bytes);
        file.seek(0);
        QCOMPARE(file.write(bytes), bytes.size());
    }
    [[nodiscard]] QDialog* dialog() { return window().findChild<QDialog*>("series"); }
    [[nodiscard]] QListWidget* list() { return dialog()->findChild<QListWidget*>("series.list"); }
    [[nodiscard]] std::int64_t depthOfStudy() { return window().openStudy().volume()->geometry().size[2]; }
    void ask() {
        window().open(m_series.path());
        QTRY_VERIFY(dialog() && dialog()->isVisible());
        QTRY_VERIFY(window().idle());
    }

private slots:
    void initTestCase() {
        lookAtNoPicture();
        write("a.dcm", {32, 28, 24});
        write("b.dcm", {32, 28, 20});
    }
    void init() {
        show();
        useLook(Look{});
        open(file("before.mha", {smallPhantom(PhantomScene::shapes, 1)}));
    }
    void cleanup() { close(); }

    void theSeriesAreOfferedWithTheirPicturesAndEnterOpensOne() {
        ask();
        QCOMPARE(list()->count(), 2);
        QVERIFY(list()->item(0)->text().contains("24 frames"));
        QVERIFY(list()->item(1)->text().contains("20 frames"));
        for (int row = 0; row < 2; ++row) {
            const QImage picture = list()->item(row)->icon().pixmap(96, 96).toImage();
            QVERIFY2(qGray(picture.pixel(90, 48)) > qGray(picture.pixel(10, 48)) + 100, "the ramp rises to the right");
        }
        QCOMPARE(depthOfStudy(), 58);  // what was open stays until a series is chosen
        QTest::keyClick(list(), Qt::Key_Down);
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 20);
        QTRY_VERIFY(!dialog());
        const auto* study = std::get_if<StudyFile>(&window().document().document().study);
        QVERIFY(study && !study->options.series.empty());  // a document names the series that it is about
    }

    void theOthersAreOfferedAfterASessionToo() {
        ask();
        QTest::keyClick(list(), Qt::Key_Down);
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 20);
        waitUntilIdle();
        const QTemporaryDir folder;
        const QString session = folder.filePath("b.session.json");
        const auto save = [this](const QString& path) {
            QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
            window().sessionKeeping().saveAs(path);
            return saved.wait(patience);
        };
        QVERIFY(save(session));
        close();
        show();
        useLook(Look{});
        open(session);
        QCOMPARE(depthOfStudy(), 20);
        auto* others = child<QAction>("file.chooseSeries");
        QVERIFY(others->isEnabled());
        others->trigger();
        QTRY_VERIFY(dialog() && dialog()->isVisible() && window().idle());
        QCOMPARE(list()->count(), 2);
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 24);
        // A session of a study that lies beside no other offers none.
        open(file("alone.mha", {smallPhantom(PhantomScene::shapes, 2)}));
        QVERIFY(save(folder.filePath("alone.session.json")));
        open(folder.filePath("alone.session.json"));
        QVERIFY(!others->isEnabled());
    }

    void theSessionOfAFolderIsProposedBesideIt() {
        ask();
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 24);
        QTRY_VERIFY(!dialog());
        QApplication::setActiveWindow(&window());
        waitUntilIdle();
        QString proposed;
        QTimer::singleShot(0, this, [&] {
            auto* chosen = window().findChild<QFileDialog*>("saveFile");
            if (chosen == nullptr) qFatal("no dialog");
            proposed = chosen->selectedFiles().value(0);
            chosen->reject();
        });
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(proposed, m_series.path() + ".session.json");
    }

    void aFolderIsCalledByItsNameWhateverThatHolds() {
        const QTemporaryDir above;
        const QString folder = above.filePath("50%1 %2");
        QVERIFY(QDir().mkdir(folder));
        for (const char* name : {"a.dcm", "b.dcm"}) QVERIFY(QFile::copy(m_series.filePath(name), folder + '/' + name));
        window().open(folder);
        QTRY_VERIFY(dialog() && dialog()->isVisible());
        QStringList told;
        for (const QLabel* label : dialog()->findChildren<QLabel*>()) told << label->text();
        QVERIFY2(told.contains("50%1 %2 holds 2 series. Which one is to be opened?"), qPrintable(told.join('\n')));
        QTRY_VERIFY(window().idle());
    }

    void aDoubleClickOpens() {
        ask();
        const QRect row = list()->visualItemRect(list()->item(0));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row.center());
        QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, row.center());
        QTRY_COMPARE(depthOfStudy(), 24);
    }

    void aSeriesThatCannotBeReadLeavesTheOthersWithinReach() {
        QTemporaryDir folder;
        QVERIFY(writeEnhancedUs(folder.filePath("a.dcm").toStdString(), {ramp({32, 28, 24})}, {}));
        QVERIFY(writeEnhancedUs(folder.filePath("b.dcm").toStdString(), {ramp({32, 28, 20})}, {}));
        flatten(folder.filePath("b.dcm"));
        window().open(folder.path());  // the only volume opens at once
        QTRY_COMPARE(depthOfStudy(), 24);
        auto* again = window().findChild<QAction*>("file.chooseSeries");
        QTRY_VERIFY(again->isEnabled());
        again->trigger();
        QTRY_VERIFY(dialog() && dialog()->isVisible());
        QTest::keyClick(list(), Qt::Key_Down);
        QVERIFY(!dialog()->findChild<QPushButton*>("series.open")->isEnabled());
        const QString why = dialog()->findChild<QLabel*>("series.why")->text();
        QVERIFY2(why.contains("Image Position") && why.endsWith("Export the volume again."), qPrintable(why));
        QVERIFY2(!why.contains(folder.path()), qPrintable(why));
    }

    void theOnlyVolumeThatFailsOnReadingSaysWhyAndLeavesTheOthersWithinReach() {
        QTemporaryDir folder;
        QVERIFY(writeEnhancedUs(folder.filePath("a.dcm").toStdString(), {ramp({32, 28, 24})}, {}));
        QVERIFY(writeEnhancedUs(folder.filePath("b.dcm").toStdString(), {ramp({32, 28, 20})}, {}));
        // What no list of series looks at: how the pixels are to be shown.
        change(folder.filePath("a.dcm"), [](QByteArray& bytes) { bytes.replace("MONOCHROME2", "MONOCHROMEX"); });
        flatten(folder.filePath("b.dcm"));
        window().open(folder.path());
        QTRY_VERIFY(dialog() && dialog()->isVisible());
        QTRY_COMPARE(list()->count(), 2);
        const auto whyOf = [this](int row) {
            list()->setCurrentRow(row);
            return dialog()->findChild<QLabel*>("series.why")->text();
        };
        QVERIFY2(whyOf(0).contains("MONOCHROMEX"), qPrintable(whyOf(0)));
        QVERIFY(!dialog()->findChild<QPushButton*>("series.open")->isEnabled());
        QVERIFY2(whyOf(1).contains("Image Position"), qPrintable(whyOf(1)));
        QCOMPARE(depthOfStudy(), 58);  // what was open stays
    }

    void escapeLeavesWhatWasOpen() {
        ask();
        QTest::keyClick(dialog(), Qt::Key_Escape);
        QTRY_VERIFY(!dialog());
        waitUntilIdle();
        QCOMPARE(depthOfStudy(), 58);
    }

    void theMenuAsksAgainForAnotherSeriesOfTheFolder() {
        auto* again = window().findChild<QAction*>("file.chooseSeries");
        QVERIFY(!again->isEnabled());
        ask();
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 24);
        QTRY_VERIFY(again->isEnabled());
        again->trigger();
        QTRY_VERIFY(dialog() && dialog()->isVisible());
        QTest::keyClick(list(), Qt::Key_Down);
        QTest::keyClick(dialog(), Qt::Key_Return);
        QTRY_COMPARE(depthOfStudy(), 20);
    }
};

ECHOLUCENT_TEST_CLASS(TestSeriesChoice)
#include "test_series_choice.moc"
