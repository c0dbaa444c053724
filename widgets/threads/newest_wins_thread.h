// One worker thread that runs one job at a time, of which only the newest matters.
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>
#include <vector>

#include "processing/progress.h"
#include "widgets/threads/works.h"

class QThread;

namespace echolucent {

/// Runs jobs in a QThread of its own. While one runs, a newer one replaces whatever waits.
///
///            submit(a)                        done, not superseded: deliver
///   [Idle] -------------> [Running a] -----------------------------------> [Idle]
///                           |      ^
///                 submit(b) |      | a ended (result dropped if a was cancelled): start b
///                           v      |
///                        [Superseded]      shut down in any state: cancel, end the thread, wait
///
/// Values and shared_ptr<const ...> captured by the job are all that crosses the threads. The worker gives way to the
/// GUI thread where there are fewer cores than threads that want one.
///
/// While it is busy, it is a work that is under way. What follows it, begun by busyChanged(false), begins before the
/// work ends.
class NewestWinsThread : public QObject {
    Q_OBJECT

public:
    /// What is done with a job's result, in this object's thread; may be empty.
    using Deliver = std::function<void()>;
    /// The work, in the worker thread. Polls progress.cancelled(); an ended job returns an empty Deliver.
    using Job = std::function<Deliver(const Progress&)>;

    /// What a newer job does to this one while it runs.
    enum class WhenSuperseded {
        cancel,  ///< it is cancelled and its result dropped
        finish,  ///< it runs to its end and is delivered (short jobs that must not starve under a stream of requests)
    };

    /// If the work has no cancel, it is cancel().
    NewestWinsThread(Works& works, const QString& name, Work work = {});
    /// Cancels what runs and waits for it; nothing is delivered afterwards.
    ~NewestWinsThread() override;

    /// Starts the job, or keeps it as the one that starts next, in place of any job kept before.
    void submit(Job job, WhenSuperseded whenSuperseded = WhenSuperseded::cancel);
    /// Cancels the running job and forgets the waiting one; what ran is not delivered.
    void cancel();
    /// To be called by the running job: what is done with something that it has before its end, in this object's
    /// thread; nothing where the job was cancelled meanwhile.
    void deliverMeanwhile(Deliver deliver);
    /// Of its work, for the status line.
    void setWords(const QString& words) { m_work.setWords(words); }
    /// True from submit() until the last job was delivered or dropped.
    [[nodiscard]] bool busy() const { return m_running || m_waiting.has_value(); }

signals:
    void busyChanged(bool busy);
    /// Share done of the running job, in [0,1], at most about 30 times a second.
    void progressed(double share);

protected:
    /// Takes what the worker left for this thread.
    bool event(QEvent* event) override;

private:
    using CancelFlag = std::shared_ptr<std::atomic<bool>>;
    struct Waiting {
        Job job;
        WhenSuperseded whenSuperseded;
    };
    /// A job on its way to the worker.
    struct Order {
        Job job;
        CancelFlag cancelFlag;
    };
    /// A job that has ended, on its way back.
    struct Ended {
        CancelFlag cancelFlag;
        Deliver deliver;
    };
    /// What a job delivers before its end.
    struct Meanwhile {
        CancelFlag cancelFlag;
        Deliver deliver;
    };
    /// The share done, something before the end, or the end of a job.
    using News = std::variant<double, Meanwhile, Ended>;

    void start(Waiting next);
    void ended(const Ended& job);
    void work();
    void tell(News news);

    Works::UnderWay m_work;
    bool m_running = false;
    WhenSuperseded m_runningWhenSuperseded = WhenSuperseded::cancel;
    CancelFlag m_cancelFlag;
    std::optional<Waiting> m_waiting;

    // What crosses the threads, under one mutex of the standard library's: the thread sanitizer sees it, and does not
    // see the queue of events in Qt's library, which is not instrumented.
    std::mutex m_mutex;
    std::condition_variable m_changed;  ///< an order came, the thread is to end, or it has ended
    std::optional<Order> m_order;
    std::vector<News> m_news;
    bool m_toEnd = false, m_hasEnded = false;
    CancelFlag m_workersFlag;  ///< of the running job; for the worker alone
    std::unique_ptr<QThread> m_thread;
};

}  // namespace echolucent
