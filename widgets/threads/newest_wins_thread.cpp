#include "widgets/threads/newest_wins_thread.h"

#include <QCoreApplication>
#include <QEvent>
#include <QThread>
#include <chrono>
#include <utility>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

namespace echolucent {

namespace {

/// Long work gives way to threads that a hand waits for: the GUI thread, and the threads of a software OpenGL that draw
/// for it. Threads that a job starts inherit this priority. Those of oneTBB inherit it if a job is the first to ask for
/// them.
void giveWay() {
#ifdef Q_OS_LINUX
    constexpr int steps = 5;  // a third of the GUI thread's share if both want one core
    // Applies to this thread alone. Qt's priorities do nothing in Linux's usual scheduling.
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);
#else
    QThread::currentThread()->setPriority(QThread::LowPriority);
#endif
}

}  // namespace

NewestWinsThread::NewestWinsThread(Works& works, const QString& name, Work work)
    : m_work(works, withCancel(std::move(work), [this] { cancel(); })),
      m_thread(QThread::create([this] { this->work(); })) {
    m_thread->setObjectName(name);
    m_thread->start();
}

NewestWinsThread::~NewestWinsThread() {
    m_waiting.reset();
    if (m_cancelFlag) m_cancelFlag->store(true, std::memory_order_relaxed);
    {
        std::unique_lock lock(m_mutex);
        m_toEnd = true;
        m_changed.notify_all();
        // QThread::wait() alone would suffice, but the thread sanitizer does not see it.
        m_changed.wait(lock, [this] { return m_hasEnded; });
    }
    m_thread->wait();
}

void NewestWinsThread::submit(Job job, WhenSuperseded whenSuperseded) {
    Waiting next{std::move(job), whenSuperseded};
    if (!m_running) {
        start(std::move(next));
        m_work.begin();
        emit busyChanged(true);
        return;
    }
    if (m_runningWhenSuperseded == WhenSuperseded::cancel) m_cancelFlag->store(true, std::memory_order_relaxed);
    m_waiting = std::move(next);
}

void NewestWinsThread::cancel() {
    m_waiting.reset();
    if (m_running) m_cancelFlag->store(true, std::memory_order_relaxed);
}

void NewestWinsThread::start(Waiting next) {
    m_running = true;
    m_runningWhenSuperseded = next.whenSuperseded;
    m_cancelFlag = std::make_shared<std::atomic<bool>>(false);
    {
        const std::lock_guard lock(m_mutex);
        m_order = Order{std::move(next.job), m_cancelFlag};
    }
    m_changed.notify_all();
}

void NewestWinsThread::work() {
    using Clock = std::chrono::steady_clock;
    giveWay();
    while (true) {
        Order order;
        {
            std::unique_lock lock(m_mutex);
            m_changed.wait(lock, [this] { return m_order.has_value() || m_toEnd; });
            if (m_toEnd) {
                m_hasEnded = true;
                m_changed.notify_all();
                return;
            }
            order = *std::exchange(m_order, std::nullopt);
        }
        auto lastReport = Clock::time_point{};
        Progress progress;
        progress.cancel = order.cancelFlag.get();
        progress.report = [this, &lastReport](double share) {
            if (const auto now = Clock::now(); now - lastReport >= std::chrono::milliseconds(33)) {
                lastReport = now;
                tell(share);
            }
        };
        m_workersFlag = order.cancelFlag;
        Deliver deliver = order.job(progress);
        order.job = {};
        tell(Ended{std::move(order.cancelFlag), std::move(deliver)});
    }
}

void NewestWinsThread::deliverMeanwhile(Deliver deliver) { tell(Meanwhile{m_workersFlag, std::move(deliver)}); }

void NewestWinsThread::tell(News news) {
    QEvent* event = nullptr;
    {
        const std::lock_guard lock(m_mutex);
        m_news.push_back(std::move(news));
        // The event is made under the lock and first read under it (event()). The thread sanitizer does not see that
        // the event queue orders the two.
        event = new QEvent(QEvent::User);
    }
    QCoreApplication::postEvent(this, event);
}

bool NewestWinsThread::event(QEvent* event) {
    std::vector<News> news;
    bool told = false;
    {
        const std::lock_guard lock(m_mutex);
        told = event->type() == QEvent::User;
        if (told) news.swap(m_news);
    }
    for (const News& each : news) {
        if (const double* share = std::get_if<double>(&each)) {
            emit progressed(*share);
            m_work.setProgress(*share);
        } else if (const auto* meanwhile = std::get_if<Meanwhile>(&each)) {
            if (!meanwhile->cancelFlag->load(std::memory_order_relaxed)) meanwhile->deliver();
        } else
            ended(std::get<Ended>(each));
    }
    return told || QObject::event(event);
}

void NewestWinsThread::ended(const Ended& job) {
    m_running = false;
    const bool wanted = !job.cancelFlag->load(std::memory_order_relaxed);
    // The next job starts before the delivery, so that the worker never waits for the GUI thread.
    if (m_waiting) start(*std::exchange(m_waiting, std::nullopt));
    if (wanted && job.deliver) job.deliver();
    if (!busy()) emit busyChanged(false);
    if (!busy()) m_work.end();
}

}  // namespace echolucent
