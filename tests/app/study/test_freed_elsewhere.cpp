// Memory is given back by another thread than the one that drops the last reference.
#include <QTest>
#include <atomic>
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

    void nothingStaysNothing() { QVERIFY(freedElsewhere(std::shared_ptr<const int>()) == nullptr); }
};

ECHOLUCENT_TEST_CLASS(TestFreedElsewhere)
#include "test_freed_elsewhere.moc"
