// The works under way in a window: what the status line shows, and when the window is at rest.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

namespace echolucent {

/// Kinds of work, the most urgent first: a person waits for them in this order.
enum class Urgency { loading, nearCut, quietening, designing, movie, report, comparing, saving, unseen };

/// What is known of a work before it begins.
struct Work {
    QString words{};  ///< for the status line, such as "loading"; empty if it is never shown there
    Urgency urgency = Urgency::unseen;
    bool countsForRest = true;       ///< false if it begins only at rest: it would otherwise prevent its own beginning
    std::function<void()> cancel{};  ///< may be empty
};

/// The work, with this cancel if it has none.
[[nodiscard]] inline Work withCancel(Work work, std::function<void()> cancel) {
    if (!work.cancel) work.cancel = std::move(cancel);
    return work;
}

/// Knows all works that are under way. If one work follows another in the same event, begin it before the first ends:
/// then nobody sees a rest between them (as NewestWinsThread does). For the GUI thread alone.
class Works : public QObject {
    Q_OBJECT

public:
    /// A work that begins and ends, again and again. It also ends when this object is destroyed. This object may
    /// outlive the Works.
    class UnderWay {
    public:
        UnderWay(Works& works, Work work) : m_works(&works), m_work(std::move(work)) {}
        /// Ends the work. If it was under way, the event loop emits changed() later, when the work's owner is gone.
        ~UnderWay();
        UnderWay(const UnderWay&) = delete;
        UnderWay& operator=(const UnderWay&) = delete;

        void begin() { set(true); }
        void end() { set(false); }
        /// Begins or ends the work.
        void set(bool underWay);
        void setWords(const QString& words);
        /// The share done, in [0,1].
        void setProgress(double share);

    private:
        friend class Works;
        [[nodiscard]] bool isKnown() const;
        QPointer<Works> m_works;
        Work m_work;
    };

    /// Whether nothing is under way.
    [[nodiscard]] bool idle() const { return m_underWay.empty(); }
    /// Whether no work that counts for rest is under way.
    [[nodiscard]] bool atRest() const;
    /// The words of the most urgent work that has words; empty if there is none. Among equally urgent works, the first
    /// to begin counts.
    [[nodiscard]] QString words() const;
    /// Cancels the work that words() names.
    void cancelShown();

signals:
    /// A work has begun or ended, or has other words.
    void changed();
    /// The share done of the work that words() names, in [0,1].
    void progressed(double share);

private:
    [[nodiscard]] const UnderWay* shown() const;

    std::vector<const UnderWay*> m_underWay;  ///< the first to begin is in front
};

}  // namespace echolucent
