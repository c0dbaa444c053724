// Memory is given back by another thread than the one that drops the last reference.
#include <QTest>
#include <atomic>
#include <future>
#include <thread>

#include "app/study/freed_elsewhere.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

/// Tells the thread in which it is let go.
struct Watched {
    std::atomic<std::thread::id>& freedIn;
    explicit Watched(std::atomic<std::thread::id>& where) : freedIn(where) {}
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;
    ~Watched() { freedIn = std::this_thread::get_id(); }
};

}  // namespace

class TestFreedElsewhere : public QObject {
    Q_OBJECT

private slots:
    void theLastReferenceIsLetGoByAnotherThread() {
        std::atomic<std::thread::id> freedIn{};
        auto made = std::make_shared<const Watched>(freedIn);
        const Watched* address = made.get();
        std::shared_ptr<const Watched> first = freedElsewhere(std::move(made)), second = first;
        QCOMPARE(first.get(), address);
        first.reset();
        QVERIFY2(freedIn.load() == std::thread::id(), "somebody still looks at it");
        QCOMPARE(second.get(), address);
        second.reset();
        QTRY_VERIFY(freedIn.load() != std::thread::id());
        QVERIFY(freedIn.load() != std::this_thread::get_id());
    }

    void whoeverElseHoldsItKeepsIt() {
        std::atomic<std::thread::id> freedIn{};
        auto made = std::make_shared<const Watched>(freedIn);
        freedElsewhere(made).reset();
        // The thread drops its own reference only.
        QTRY_COMPARE(made.use_count(), 1);
        QVERIFY(freedIn.load() == std::thread::id());
        made.reset();
        QVERIFY2(freedIn.load() == std::this_thread::get_id(), "without it memory is given back by whoever drops it");
    }

    void whoDropsTheLastReferenceDoesNotWait() {
        // The first is let go only after all others were dropped: who waited for it would wait for ever.
        std::promise<void> allDropped;
        struct Slow {
            explicit Slow(std::future<void> when) : until(std::move(when)) {}
            Slow(const Slow&) = delete;
            Slow& operator=(const Slow&) = delete;
            ~Slow() { until.wait(); }
            std::future<void> until;
        };
        std::atomic<std::thread::id> freedIn[3]{};
        freedElsewhere(std::make_shared<const Slow>(allDropped.get_future())).reset();
        for (auto& each : freedIn) freedElsewhere(std::make_shared<const Watched>(each)).reset();
        for (const auto& each : freedIn) QVERIFY(each.load() == std::thread::id());
        allDropped.set_value();
        QTRY_VERIFY(freedIn[2].load() != std::thread::id());
        QVERIFY2(freedIn[0].load() == freedIn[2].load(), "one thread lets go of all");
    }

    void whatHoldsAnotherIsLetGoWithIt() {
        struct Holder {
            std::shared_ptr<const Watched> held;
        };
        std::atomic<std::thread::id> freedIn{};
        freedElsewhere(std::make_shared<const Holder>(Holder{freedElsewhere(std::make_shared<const Watched>(freedIn))}))
            .reset();
        QTRY_VERIFY(freedIn.load() != std::thread::id());
    }

    void theEndOfTheThreadWaitsUntilAllIsLetGo() {
        constexpr int many = 200;
        std::atomic<std::thread::id> freedIn[many]{}, late{};
        std::shared_ptr<WaitingToBeFreed> waiting;
        {
            const FreeingThread thread;
            waiting = thread.waiting();
            for (auto& each : freedIn) waiting->add(std::make_shared<const Watched>(each));
        }
        for (const auto& each : freedIn)
            QVERIFY(each.load() != std::thread::id() && each.load() != std::this_thread::get_id());
        waiting->add(std::make_shared<const Watched>(late));
        QVERIFY2(late.load() == std::this_thread::get_id(), "after its end nobody else is there");
    }

    void nothingStaysNothing() { QVERIFY(freedElsewhere(std::shared_ptr<const int>()) == nullptr); }
};

ECHOLUCENT_TEST_CLASS(TestFreedElsewhere)
#include "test_freed_elsewhere.moc"
