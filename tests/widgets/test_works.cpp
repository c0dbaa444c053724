#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <memory>
#include <optional>

#include "tests/qt_program/test_classes.h"
#include "widgets/threads/newest_wins_thread.h"

using namespace echolucent;

namespace {
NewestWinsThread::Deliver nothing(const Progress&) { return {}; }
}  // namespace

class TestWorks : public QObject {
    Q_OBJECT

private slots:
    void theMostUrgentIsShownAndOfThoseTheFirst() {
        Works works;
        QStringList cancelled;
        const auto work = [&](const QString& words, Urgency urgency) {
            return Work{words, urgency, true, [&, words] { cancelled << words; }};
        };
        Works::UnderWay movie(works, work("movie", Urgency::movie)), report(works, work("report", Urgency::report)),
            another(works, work("another", Urgency::report)), silent(works, work({}, Urgency::loading));
        QSignalSpy progressed(&works, &Works::progressed);
        QCOMPARE(works.words(), "");
        works.cancelShown();
        another.begin();
        silent.begin();
        report.begin();
        QCOMPARE(works.words(), "another");
        movie.begin();
        QCOMPARE(works.words(), "movie");
        report.setProgress(0.5);
        movie.setProgress(0.25);
        QCOMPARE(progressed.count(), 1);
        QCOMPARE(progressed.first().first().toDouble(), 0.25);
        works.cancelShown();
        movie.end();
        another.setWords({});
        works.cancelShown();
        QCOMPARE(cancelled, (QStringList{"movie", "report"}));
    }

    void whatBeginsAtRestKeepsNothingFromRest() {
        Works works;
        QSignalSpy changed(&works, &Works::changed);
        Works::UnderWay small(works, {.countsForRest = false}), large(works, {});
        QVERIFY(works.idle() && works.atRest());
        small.begin();
        small.begin();
        QVERIFY(!works.idle() && works.atRest());
        large.begin();
        QVERIFY(!works.idle() && !works.atRest());
        small.end();
        large.end();
        large.end();
        QVERIFY(works.idle() && works.atRest());
        QCOMPARE(changed.count(), 4);
    }

    void betweenAWorkAndTheOneThatFollowsNothingIsAtRest() {
        Works works;
        NewestWinsThread first(works, "first"), second(works, "second");
        Works::UnderWay waits(works, {});
        connect(&first, &NewestWinsThread::busyChanged, &second, [&](bool busy) {
            if (!busy) second.submit(&nothing);
        });
        connect(&second, &NewestWinsThread::busyChanged, &second, [&](bool busy) { waits.set(!busy); });
        QList<bool> rests;
        connect(&works, &Works::changed, &second, [&] { rests << works.idle(); });
        first.submit(&nothing);
        QVERIFY(!works.idle());
        QTRY_COMPARE(rests.size(), 5);  // both threads begin and end, and something waits
        waits.end();
        QCOMPARE(rests.count(true), 1);
        QVERIFY(works.idle());
    }

    void aThreadThatGoesIsUnderWayNoMore() {
        Works works;
        QSignalSpy changed(&works, &Works::changed);
        auto started = std::make_shared<QSemaphore>();
        {
            NewestWinsThread thread(works, "test", {.words = "test"});
            thread.submit([started](const Progress& progress) -> NewestWinsThread::Deliver {
                started->release();
                while (!progress.cancelled()) QThread::yieldCurrentThread();
                return {};
            });
            started->acquire();
            QCOMPARE(works.words(), "test");
            QCOMPARE(changed.count(), 1);
        }
        QVERIFY(works.idle());
        QCOMPARE(works.words(), "");
        QTRY_COMPARE(changed.count(), 2);
    }

    void itsCancelIsThatOfTheThreadUnlessItHasItsOwn() {
        Works works;
        bool delivered = false, cancelled = false;
        const auto untilCancelled = [&](const Progress& progress) -> NewestWinsThread::Deliver {
            while (!progress.cancelled()) QThread::yieldCurrentThread();
            return [&] { delivered = true; };
        };
        {
            NewestWinsThread thread(works, "test", {.words = "test"});
            thread.submit(untilCancelled);
            works.cancelShown();
            QTRY_VERIFY(works.idle());
        }
        NewestWinsThread thread(works, "test", {.words = "test", .cancel = [&] { cancelled = true; }});
        thread.submit(untilCancelled);
        works.cancelShown();
        QVERIFY(cancelled && !works.idle());
        QVERIFY(!delivered);
    }

    void whoHearsOfAChangeMayBeginAndEndWorks() {
        Works works;
        auto first = std::make_unique<Works::UnderWay>(works, Work{});
        Works::UnderWay second(works, {});
        connect(&works, &Works::changed, this, [&] {
            first.reset();
            second.begin();
        });
        first->begin();
        QVERIFY(!works.idle());
        works.disconnect(this);
        second.end();
        QVERIFY(works.idle());
    }

    void theWorksMayGoFirst() {
        auto works = std::make_unique<Works>();
        Works::UnderWay underWay(*works, {});
        underWay.begin();
        works.reset();
        underWay.setProgress(0.5);
        underWay.setWords("words");
        underWay.end();
        underWay.begin();
    }
};

ECHOLUCENT_TEST_CLASS(TestWorks)
#include "test_works.moc"
