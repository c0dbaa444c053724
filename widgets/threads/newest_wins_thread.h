// One worker thread that runs one job at a time. Only the newest job matters.
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

/// Runs jobs in its own QThread. While a job runs, a newer job replaces the one that waits.
///
///            submit(a)                        done, not superseded: deliver
///   [Idle] -------------> [Running a] -----------------------------------> [Idle]
///                           |      ^
///                 submit(b) |      | a ended (result dropped if a was cancelled): start b
///                           v      |
///                        [Superseded]      shut down in any state: cancel, end the thread, wait
///
/// Only values and shared_ptr<const ...> that the job captures cross the threads, or a reference to what guards itself
/// (app/otf/kept_surfaces.h). If threads want more cores than there are, the worker gives way to the GUI thread.
///
/// While this object is busy, its work is under way in Works. If a receiver of busyChanged(false) begins another work,
/// that work begins before this one ends.
class NewestWinsThread : public QObject {
    Q_OBJECT

public:
    /// Takes a job's result, in this object's thread; may be empty.
    using Deliver = std::function<void()>;
    /// Runs in the worker thread. Polls progress.cancelled(); a cancelled job returns an empty Deliver.
    using Job = std::function<Deliver(const Progress&)>;

    /// What happens to the running job if a newer one is submitted.
    enum class WhenSuperseded {
        cancel,  ///< the job is cancelled and its result dropped
        finish,  ///< the job ends and is delivered: for short jobs that a stream of requests must not starve
    };

    /// If `work` has no cancel, cancel() is used.
    NewestWinsThread(Works& works, const QString& name, Work work = {});
    /// Cancels the running job and waits for it; delivers nothing afterwards.
    ~NewestWinsThread() override;

    /// Starts the job. If one runs, keeps this one to start next, in place of any other kept job.
    void submit(Job job, WhenSuperseded whenSuperseded = WhenSuperseded::cancel);
    /// Cancels the running job and forgets the waiting one. The result of the running job is dropped.
    void cancel();
    /// The running job calls this to deliver something before its end. `deliver` runs in this object's thread, but not
    /// if the job was cancelled meanwhile.
    void deliverMeanwhile(Deliver deliver);
    /// The words of its work, for the status line.
    void setWords(const QString& words) { m_work.setWords(words); }
    /// True from submit() until the last job has ended. Already false while that job's result is delivered.
    [[nodiscard]] bool busy() const { return m_running || m_waiting.has_value(); }

signals:
    void busyChanged(bool busy);
    /// Share done of the running job, in [0,1]. Emitted about 30 times a second at most.
    void progressed(double share);

protected:
    /// Takes the news that the worker left for this thread.
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
    /// A delivery of a job before its end.
    struct Meanwhile {
        CancelFlag cancelFlag;
        Deliver deliver;
    };
    /// The share done, a delivery before the end, or the end of a job.
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

    // The members below cross the threads, under a mutex of the standard library. The thread sanitizer sees this mutex.
    // It does not see the event queue of Qt, whose library is not instrumented.
    std::mutex m_mutex;
    std::condition_variable m_changed;  ///< an order came, the thread must end, or the thread has ended
    std::optional<Order> m_order;
    std::vector<News> m_news;
    bool m_toEnd = false, m_hasEnded = false;
    CancelFlag m_workersFlag;  ///< of the running job; only the worker uses it
    std::unique_ptr<QThread> m_thread;
};

}  // namespace echolucent
