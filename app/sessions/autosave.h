// What a person does is on disk soon, in the program's own folder, without being asked for.
#pragma once

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "processing/document/saved_session.h"
#include "processing/result.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// One file for each session that is open or was left, written whole or not at all in a thread of its own, with a lock
/// beside it that says whose it is: the lock of a program that has died is free. Nothing is written while nothing
/// changes. What could not be written is tried again after the same interval, until it is written, forgotten or
/// superseded; what was ordered and is not known to be done is done at the end.
///
///              noteChange()                     interval over: write
///   [Clean] ----------------> [Change waits] --------------------------> [Written]
///      ^                            ^                                        |
///      |  forget(): no file         +----------- noteChange() ---------------+
class Autosave : public QObject {
    Q_OBJECT

public:
    /// A change is on disk so many milliseconds later, and as much more as writing takes.
    static constexpr int standardIntervalMilliseconds = 4000;

    /// `present` is asked in this thread for what is to be written.
    Autosave(Works& works, const QString& folder, std::function<SavedSession()> present, QObject* parent = nullptr);
    /// Removes its file, or, after keepAtEnd(), writes it a last time and leaves it behind. Waits until that is done,
    /// and what is still to be done with the files that were left.
    ~Autosave() override;

    /// Between a change and its being written, and between a failure and the next attempt.
    void setInterval(int milliseconds);
    /// What writes a session, in whatever thread; tests put one in its place that ends on command.
    using Write = std::function<Result<void>(const std::string& file, const SavedSession& session)>;
    void setWrite(Write write) { m_write = std::move(write); }
    /// What `present` gives may be other than before. The phase shown and the frame of the motion alone are not written
    /// anew.
    void noteChange();
    /// A file that is kept, whose lock is held.
    struct Left {
        QString file;
        std::shared_ptr<QLockFile> lock;
    };
    /// The session is what an earlier run left: its file goes once the session is in this one's, and not before, so
    /// that a program that dies in between finds one of the two; also where forget() says that nothing is to be kept.
    void replace(const Left& earlier) { m_earlier.push_back(earlier); }
    /// There is nothing to keep: what was written is removed.
    void forget();
    /// Leaves behind what was kept for the session up to now, which is written anew, and begins another file. Gives
    /// what is left. Where its lock has been let go of, what could not be written is not tried again.
    Left leaveBehind();
    /// What was left is not wanted any more, by this program or an earlier run: its file goes.
    void discard(const Left& left);
    /// Whether the file stays when this ends.
    void keepAtEnd(bool keep) { m_keep = keep; }
    [[nodiscard]] QString file() const { return m_file->name; }
    /// Whether something of the session is on disk, or about to be.
    [[nodiscard]] bool keeps() const { return m_written.has_value() || m_timer.isActive(); }
    /// Whether a change waits to be written.
    [[nodiscard]] bool waits() const { return m_timer.isActive(); }
    [[nodiscard]] bool busy() const;

    static QString lockOf(const QString& file) { return file + QStringLiteral(".lock"); }

signals:
    void busyChanged(bool busy);
    /// The newest of what was there when writing began is on disk.
    void written();
    /// It could not be written, and is tried again: a sentence. Told once until it works again.
    void failed(const QString& sentence);

private:
    /// What is to become of a file.
    struct Order {
        std::optional<SavedSession> session;  ///< what it is to hold; none where it is to go
        std::vector<Left> earlier;            ///< what goes once that is done
    };
    /// A session's file. It is wanted as long as somebody has its lock.
    struct File {
        QString name;
        std::weak_ptr<QLockFile> lock;
        std::shared_ptr<const Order> due;  ///< the newest that is not known to be done
        std::unique_ptr<NewestWinsThread> thread;
    };

    void beginFile();
    void write();
    void tryAgain();
    Order newOrder(std::optional<SavedSession> session);
    void order(std::optional<SavedSession> session);
    void carryOut(File& file);
    void ended(File& file, const std::shared_ptr<const Order>& order, const QString& problem);
    bool own(const std::shared_ptr<QLockFile>& lock) const;
    static QString carriedOut(const Write& write, const QString& file, const Order& order);

    Works& m_works;
    QString m_folder;
    std::function<SavedSession()> m_present;
    Write m_write;
    std::vector<Left> m_earlier;            ///< what this session's file takes the place of, until that is ordered
    std::optional<SavedSession> m_written;  ///< newest that was ordered
    QTimer m_timer;                         ///< runs while a change waits
    QTimer m_again;                         ///< runs while what could not be written waits
    bool m_keep = false;
    bool m_failed = false;
    std::shared_ptr<QLockFile> m_lock;                ///< of the present file
    std::unique_ptr<File> m_file;                     ///< the present one
    std::vector<std::unique_ptr<File>> m_leftBehind;  ///< those that were left behind
};

}  // namespace echolucent
