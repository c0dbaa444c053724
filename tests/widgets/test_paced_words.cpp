// Words that change with every picture: the first and the last are told, few of those between.
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/paced_words.h"

using namespace echolucent;

class TestPacedWords : public QObject {
    Q_OBJECT

private slots:
    void theFirstIsToldAtOnce() {
        int told = 0;
        PacedWords words([&] { ++told; });
        words.tell();
        QCOMPARE(told, 1);
    }

    void theLastIsToldAndNotAllBefore() {
        int truth = 0, shown = 0, told = 0;
        PacedWords words([&] {
            shown = truth;
            ++told;
        });
        for (truth = 1; truth < 1000; ++truth) words.tell();
        truth = 1000;
        words.tell();
        QTRY_COMPARE(shown, 1000);
        QVERIFY2(told < 1000, "this loop takes far less than the pace");
    }

    void whatIsToldNowIsNotToldAgain() {
        int told = 0;
        PacedWords words([&] { ++told; });
        words.tell();
        words.tell();
        words.tellNow();
        QCOMPARE(told, 2);
        // What waits behind a timer that was started later is told later.
        int toldLater = 0;
        PacedWords later([&] { ++toldLater; });
        later.tell();
        later.tell();
        QTRY_COMPARE(toldLater, 2);
        QCOMPARE(told, 2);
    }
};

ECHOLUCENT_TEST_CLASS(TestPacedWords)
#include "test_paced_words.moc"
