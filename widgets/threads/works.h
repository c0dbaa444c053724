// What is under way in a window: what the status line shows of it, and when the window is at rest.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

namespace echolucent {

/// Works in the order in which a person waits for them, the most urgent first.
enum class Urgency { loading, nearCut, quietening, designing, movie, report, comparing, saving, unseen };

/// What is known of a work before it begins.
struct Work {
    QString words{};  ///< for the status line, as "loading"; empty if it is never shown there
    Urgency urgency = Urgency::unseen;
    bool countsForRest = true;  ///< false if it begins at rest only, so that it does not keep itself from beginning
    std::function<void()> cancel{};  ///< may be empty
};

/// The work, with this cancel if it has none.
[[nodiscard]] inline Work withCancel(Work work, std::function<void()> cancel) {
    if (!work.cancel) work.cancel = std::move(cancel);
    return work;
}

/// Knows all works that are under way. A work that follows another in one event begins before that one ends, so that
/// nobody sees a rest between them: see NewestWinsThread. For the GUI thread alone.
class Works : public QObject {
    Q_OBJECT

public:
    /// A work that begins and ends, again and again. It ends with this object, which may outlive the works.
    class UnderWay {
    public:
        UnderWay(Works& works, Work work) : m_works(&works), m_work(std::move(work)) {}
        /// That a work has ended so is told by the event loop, when its owner is gone.
        ~UnderWay();
        UnderWay(const UnderWay&) = delete;
        UnderWay& operator=(const UnderWay&) = delete;

        void begin() { set(true); }
        void end() { set(false); }
        /// Whether it is under way from now on.
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
    /// The same of what counts for rest.
    [[nodiscard]] bool atRest() const;
    /// Of the most urgent work that has words, and of those that are as urgent the one that began first; empty if there
    /// is none.
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

    std::vector<const UnderWay*> m_underWay;  ///< that which began first at the front
};

}  // namespace echolucent
