#include <QSignalSpy>
#include <QStringList>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

#include "tests/qt_program/test_classes.h"
#include "widgets/threads/newest_wins_thread.h"

using echolucent::NewestWinsThread;
using echolucent::patience;
using echolucent::Progress;
using echolucent::Works;
using WhenSuperseded = NewestWinsThread::WhenSuperseded;

namespace {

/// A door that a job waits at until the test opens it, and that tells the test when a job stands before it.
class Gate {
public:
    void passThrough() {
        std::unique_lock lock(m_mutex);
        ++m_arrived;
        m_changed.notify_all();
        m_changed.wait(lock, [&] { return m_open; });
    }
    void awaitArrivals(int count) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_arrived >= count; });
    }
    int arrived() {
        const std::lock_guard lock(m_mutex);
        return m_arrived;
    }
    void open() {
        const std::lock_guard lock(m_mutex);
        m_open = true;
        m_changed.notify_all();
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_arrived = 0;
    bool m_open = false;
};

/// A job that ends only when it is cancelled.
NewestWinsThread::Job untilCancelled(const std::shared_ptr<Gate>& started, std::atomic<int>* cancelled = nullptr) {
    started->open();
    return [started, cancelled](const Progress& progress) -> NewestWinsThread::Deliver {
        started->passThrough();
        while (!progress.cancelled()) std::this_thread::yield();
        if (cancelled) ++*cancelled;
        return {};
    };
}

}  // namespace

class NewestWinsThreadTest : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
#ifdef Q_OS_LINUX
    void jobsAndTheThreadsTheyStartGiveWayToThisThread() {
        int inJob = 0, inItsThread = 0;
        const int here = getpriority(PRIO_PROCESS, 0);
        bool delivered = false;
        NewestWinsThread thread(m_works, "test");
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver {
            inJob = getpriority(PRIO_PROCESS, 0);
            std::thread([&] { inItsThread = getpriority(PRIO_PROCESS, 0); }).join();
            return [&] { delivered = true; };
        });
        QTRY_VERIFY(delivered);
        QVERIFY2(inJob > here || here >= 19, "a higher number is less urgent; there is none above 19");
        QCOMPARE(inItsThread, inJob);
        QCOMPARE(getpriority(PRIO_PROCESS, 0), here);
    }
#endif

    void deliversInTheThreadItLivesIn() {
        NewestWinsThread thread(m_works, "test");
        QThread* ranIn = nullptr;
        QThread* deliveredIn = nullptr;
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver {
            ranIn = QThread::currentThread();
            return [&] { deliveredIn = QThread::currentThread(); };
        });
        QVERIFY(thread.busy());
        QTRY_VERIFY_WITH_TIMEOUT(deliveredIn != nullptr, patience);
        QCOMPARE(deliveredIn, QThread::currentThread());
        QVERIFY(ranIn != nullptr && ranIn != QThread::currentThread());
        QVERIFY(!thread.busy());
    }

    void deliversBeforeTheEndOfAJobWhatItHasMeanwhile() {
        NewestWinsThread thread(m_works, "test");
        auto gate = std::make_shared<Gate>();
        QStringList delivered;
        thread.submit([&, gate](const Progress&) -> NewestWinsThread::Deliver {
            thread.deliverMeanwhile([&] {
                delivered << "meanwhile";
                gate->open();
            });
            gate->passThrough();  // which the delivery opens
            return [&] { delivered << "end"; };
        });
        QTRY_VERIFY_WITH_TIMEOUT(!thread.busy(), patience);
        QCOMPARE(delivered, QStringList({"meanwhile", "end"}));
    }

    void deliversNothingThatAJobHasAfterItWasCancelled() {
        NewestWinsThread thread(m_works, "test");
        auto gate = std::make_shared<Gate>();
        bool delivered = false;
        thread.submit([&, gate](const Progress&) -> NewestWinsThread::Deliver {
            gate->passThrough();
            thread.deliverMeanwhile([&] { delivered = true; });
            return {};
        });
        gate->awaitArrivals(1);
        thread.cancel();
        gate->open();
        QTRY_VERIFY_WITH_TIMEOUT(!thread.busy(), patience);
        QVERIFY(!delivered);
    }

    void onlyTheNewestOfManyIsDelivered() {
        NewestWinsThread thread(m_works, "test");
        auto gate = std::make_shared<Gate>();
        std::vector<int> delivered;
        std::atomic<int> ran = 0;
        const auto job = [&](int number) {
            return [&, number, gate](const Progress&) -> NewestWinsThread::Deliver {
                ++ran;
                gate->passThrough();
                return [&delivered, number] { delivered.push_back(number); };
            };
        };
        thread.submit(job(0));
        gate->awaitArrivals(1);
        for (int number = 1; number <= 50; ++number) thread.submit(job(number));
        gate->open();
        QTRY_VERIFY_WITH_TIMEOUT(!thread.busy(), patience);
        QCOMPARE(delivered, std::vector<int>{50});
        QCOMPARE(ran.load(), 2);  // the first and the newest; those between never started
    }

    void twoHundredRestartsDeliverTheLast() {
        NewestWinsThread thread(m_works, "test");
        int staleDelivered = 0;
        for (int restart = 0; restart < 200; ++restart) {
            auto started = std::make_shared<Gate>();
            auto endless = untilCancelled(started);
            thread.submit([endless, &staleDelivered](const Progress& progress) -> NewestWinsThread::Deliver {
                endless(progress);
                return [&staleDelivered] { ++staleDelivered; };
            });
            // Every third runs when the next replaces it; the others are replaced while they wait.
            if (restart % 3 == 0) QTRY_COMPARE_WITH_TIMEOUT(started->arrived(), 1, patience);
        }
        bool last = false;
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver { return [&] { last = true; }; });
        QTRY_VERIFY_WITH_TIMEOUT(last, patience);
        QCOMPARE(staleDelivered, 0);
        QVERIFY(!thread.busy());
    }

    void aStaleResultIsNotDeliveredAlthoughItWasFinished() {
        NewestWinsThread thread(m_works, "test");
        Gate finished;
        finished.open();
        int first = 0, second = 0;
        // Ends without looking at the flag; its result is on the way when the newer job comes.
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver {
            finished.passThrough();
            return [&] { ++first; };
        });
        finished.awaitArrivals(1);
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver { return [&] { ++second; }; });
        QTRY_COMPARE_WITH_TIMEOUT(second, 1, patience);
        QCOMPARE(first, 0);
    }

    void finishJobsAreDeliveredUnderAStreamOfRequests() {
        NewestWinsThread thread(m_works, "test");
        std::vector<int> delivered;
        int next = 0;
        // Every delivery finds a newer request already waiting: a stream that never pauses.
        std::function<void()> request = [&] {
            const int number = next++;
            thread.submit(
                [&, number](const Progress& progress) -> NewestWinsThread::Deliver {
                    return [&, number, cancelled = progress.cancelled()] {
                        QVERIFY(!cancelled);
                        delivered.push_back(number);
                        if (next < 100) request();
                    };
                },
                WhenSuperseded::finish);
        };
        request();
        request();
        QTRY_VERIFY_WITH_TIMEOUT(!thread.busy() && next >= 100, patience);
        QCOMPARE(delivered.size(), std::size_t{100});
        QVERIFY(std::is_sorted(delivered.begin(), delivered.end()));
    }

    void aFinishJobRunsOnWhenSupersededAndIsDeliveredFirst() {
        NewestWinsThread thread(m_works, "test");
        Gate gate;
        std::vector<QString> delivered;
        bool sawCancel = true;
        thread.submit(
            [&](const Progress& progress) -> NewestWinsThread::Deliver {
                gate.passThrough();
                return [&, cancelled = progress.cancelled()] {
                    sawCancel = cancelled;
                    delivered.push_back("coarse");
                };
            },
            WhenSuperseded::finish);
        gate.awaitArrivals(1);
        thread.submit(
            [&](const Progress&) -> NewestWinsThread::Deliver { return [&] { delivered.push_back("next"); }; });
        gate.open();
        QTRY_COMPARE_WITH_TIMEOUT(delivered, (std::vector<QString>{"coarse", "next"}), patience);
        QVERIFY(!sawCancel);
    }

    void cancelDropsWhatRunsAndWhatWaits() {
        NewestWinsThread thread(m_works, "test");
        QSignalSpy busyChanges(&thread, &NewestWinsThread::busyChanged);
        Gate gate;
        int delivered = 0;
        const auto job = [&](const Progress&) -> NewestWinsThread::Deliver {
            gate.passThrough();
            return [&] { ++delivered; };
        };
        thread.submit(job, WhenSuperseded::finish);
        gate.awaitArrivals(1);
        thread.submit(job, WhenSuperseded::finish);
        thread.cancel();
        gate.open();
        QTRY_VERIFY_WITH_TIMEOUT(!thread.busy(), patience);
        QCOMPARE(delivered, 0);
        QCOMPARE(busyChanges.size(), 2);
        QCOMPARE(busyChanges.at(0).at(0).toBool(), true);
        QCOMPARE(busyChanges.at(1).at(0).toBool(), false);
    }

    void worksAgainAfterCancel() {
        NewestWinsThread thread(m_works, "test");
        auto started = std::make_shared<Gate>();
        thread.submit(untilCancelled(started));
        started->awaitArrivals(1);
        thread.cancel();
        bool delivered = false;
        thread.submit([&](const Progress&) -> NewestWinsThread::Deliver { return [&] { delivered = true; }; });
        QTRY_VERIFY_WITH_TIMEOUT(delivered, patience);
    }

    void closingWhileRunningCancelsAndWaits() {
        for (int round = 0; round < 50; ++round) {
            std::atomic<int> cancelled = 0;
            int delivered = 0;
            {
                NewestWinsThread thread(m_works, "test");
                auto started = std::make_shared<Gate>();
                auto endless = untilCancelled(started, &cancelled);
                thread.submit([&, endless](const Progress& progress) -> NewestWinsThread::Deliver {
                    endless(progress);
                    return [&] { ++delivered; };
                });
                started->awaitArrivals(1);
                thread.submit([&](const Progress&) -> NewestWinsThread::Deliver { return [&] { ++delivered; }; });
            }
            QCOMPARE(cancelled.load(), 1);  // already here: the destructor has waited
            QCoreApplication::processEvents();
            QCOMPARE(delivered, 0);
        }
    }

    void closingBeforeTheJobStartedIsSafe() {
        for (int round = 0; round < 200; ++round) {
            int delivered = 0;
            {
                NewestWinsThread thread(m_works, "test");
                thread.submit([&](const Progress&) -> NewestWinsThread::Deliver { return [&] { ++delivered; }; });
            }
            QCoreApplication::processEvents();
            QCOMPARE(delivered, 0);
        }
    }

    void progressIsToldInThisThread() {
        NewestWinsThread thread(m_works, "test");
        QSignalSpy shares(&thread, &NewestWinsThread::progressed);
        thread.submit([](const Progress& progress) -> NewestWinsThread::Deliver {
            progress.at(0.25);
            return {};
        });
        QTRY_COMPARE_WITH_TIMEOUT(shares.size(), 1, patience);
        QCOMPARE(shares.at(0).at(0).toDouble(), 0.25);
    }
};

ECHOLUCENT_TEST_CLASS(NewestWinsThreadTest)
#include "test_newest_wins_thread.moc"
