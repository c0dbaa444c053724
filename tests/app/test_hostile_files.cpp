// Every hostile file through the real window, one after the other: it says its sentence, asks nothing that would block,
// and goes on showing what was open.
#include <QDialog>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "app/window/theme.h"
#include "hostile_file.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestHostileFiles : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        wearTheme(Theme::dark);
        m_good = file("good.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        useLook(Look{});
        open(m_good);
        useLook(Look{});
        waitUntilIdle();
    }
    void cleanup() { close(); }

    void leaveWhatIsOpenAndEndInOneSentence() {
        const std::vector<HostileFile> rows = isLongRun() ? hostileFiles() : sampleOf(hostileFiles());
        QElapsedTimer since;
        qint64 longest = 0;  // of one row
        QTimer beat;
        connect(&beat, &QTimer::timeout, this, [&] { longest = std::max(longest, since.restart()); });
        std::vector<std::pair<qint64, QString>> longestOfRows;
        // The only row with two series: the window lists them, and says of each why it cannot be opened.
        const QString ofTwoSeries("dicom-series/parts-of-another-object-with-its-numbers");
        since.start();
        beat.start(1);
        const auto shown = window().openStudy().volume();
        for (const HostileFile& row : rows) {
            if (row.outcome != HostileOutcome::refused) continue;
            const QTemporaryDir folder;
            row.write(folder.path().toStdString());
            // Writing the row's files is no work of the window's.
            since.restart();
            longest = 0;
            QSignalSpy failed(&window().openStudy(), &OpenStudy::openFailed);
            const QString path =
                row.opened == "." ? folder.path() : folder.filePath(QString::fromStdString(row.opened));
            window().openStudy().open(path, row.options);
            const auto isAsked = [this] { return choice() != nullptr && choice()->isVisible(); };
            QTRY_VERIFY2_WITH_TIMEOUT(!failed.isEmpty() || isAsked(), row.name.c_str(), patience);
            if (isAsked()) {
                QCOMPARE(QString::fromStdString(row.name), ofTwoSeries);
                QTRY_VERIFY2(window().idle(), row.name.c_str());
                QVERIFY2(!choice()->findChild<QPushButton*>("series.open")->isEnabled(), row.name.c_str());
                QVERIFY2(!choice()->findChild<QLabel*>("series.why")->text().isEmpty(), row.name.c_str());
                QTest::keyClick(choice(), Qt::Key_Escape);
                QTRY_VERIFY2(choice() == nullptr, row.name.c_str());
                continue;
            }
            QTRY_VERIFY2(window().idle(), row.name.c_str());
            QCOMPARE(window().openStudy().volume(), shown);
            QVERIFY2(QApplication::activeModalWidget() == nullptr, row.name.c_str());
            QVERIFY2(QApplication::activePopupWidget() == nullptr, row.name.c_str());
            const QString text = window().findChild<MessageBar*>()->text();
            // What the sentence says of the command line's options is no part of the window's.
            QVERIFY2(!text.isEmpty() && !text.contains('\n'),
                     qPrintable(QString::fromStdString(row.name) + ": " + text));
            longestOfRows.emplace_back(std::max(longest, since.elapsed()), QString::fromStdString(row.name));
        }
        std::ranges::sort(longestOfRows, std::greater());
        QCOMPARE(window().openStudy().volume(), shown);
        QVERIFY(longestOfRows.size() > rows.size() / 2);
        const auto late = std::ranges::count_if(longestOfRows, [](const auto& row) { return row.first > 50; });
        std::printf(
            "%zu hostile files in one window, %lld of them with more than 50 ms between two beats; the longest:\n",
            longestOfRows.size(), static_cast<long long>(late));
        for (const auto& [milliseconds, name] :
             std::span(longestOfRows).first(std::min<std::size_t>(10, longestOfRows.size())))
            std::printf("%5lld ms  %s\n", static_cast<long long>(milliseconds), qPrintable(name));
        // A bound on a hang, not a measure of speed: several programs share the machine that runs the tests.
        QVERIFY2(longestOfRows.front().first < 2000, qPrintable(longestOfRows.front().second));
    }

private:
    [[nodiscard]] QDialog* choice() { return window().findChild<QDialog*>("series"); }

    QString m_good;
};

ECHOLUCENT_TEST_CLASS(TestHostileFiles, "leaveWhatIsOpenAndEndInOneSentence")

#include "test_hostile_files.moc"
