#include "widgets/newest_wins_thread.h"

#include <chrono>
#include <utility>

namespace echolucent {

NewestWinsThread::NewestWinsThread(const QString& name, QObject* parent) : QObject(parent), m_worker(new QObject) {
    m_thread.setObjectName(name);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start();
}

NewestWinsThread::~NewestWinsThread() {
    m_waiting.reset();
    if (m_cancelFlag) m_cancelFlag->store(true, std::memory_order_relaxed);
    m_thread.quit();
    m_thread.wait();
}

void NewestWinsThread::submit(Job job, WhenSuperseded whenSuperseded) {
    Waiting next{std::move(job), whenSuperseded};
    if (!m_running) {
        start(std::move(next));
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
    auto run = [this, flag = m_cancelFlag, job = std::move(next.job)] {
        using Clock = std::chrono::steady_clock;
        auto lastReport = Clock::time_point{};
        Progress progress;
        progress.cancel = flag.get();
        progress.report = [this, &lastReport](double share) {
            if (const auto now = Clock::now(); now - lastReport >= std::chrono::milliseconds(33)) {
                lastReport = now;
                QMetaObject::invokeMethod(
                    this, [this, share] { emit progressed(share); }, Qt::QueuedConnection);
            }
        };
        Deliver deliver = job(progress);
        QMetaObject::invokeMethod(
            this, [this, flag, deliver = std::move(deliver)] { ended(flag, deliver); }, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(m_worker, std::move(run), Qt::QueuedConnection);
}

void NewestWinsThread::ended(const std::shared_ptr<std::atomic<bool>>& cancelFlag, const Deliver& deliver) {
    m_running = false;
    const bool wanted = !cancelFlag->load(std::memory_order_relaxed);
    // The next job starts before the delivery, so that the worker never waits for the person's thread.
    if (m_waiting) start(*std::exchange(m_waiting, std::nullopt));
    if (wanted && deliver) deliver();
    if (!busy()) emit busyChanged(false);
}

}  // namespace echolucent
