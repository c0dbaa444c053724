// Writes what a person does to disk soon, in the program's own folder, without being asked.
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

/// Keeps one file for each session that is open or was left. A thread of its own writes it whole or not at all. A lock
/// beside the file says whose it is: the lock of a program that has died is free. Nothing is written while nothing
/// changes. A file that could not be written is tried again after the same interval, until it is written, forgotten or
/// superseded. Orders that are not known to be done are done at the end.
///
///              noteChange()                     interval over: write
///   [Clean] ----------------> [Change waits] --------------------------> [Written]
///      ^                            ^                                        |
///      |  forget(): no file         +----------- noteChange() ---------------+
class Autosave : public QObject {
    Q_OBJECT

public:
    /// A change is on disk after this time and the time of writing.
    static constexpr int standardIntervalMilliseconds = 4000;

    /// Calls `present` in this thread for the session to write.
    Autosave(Works& works, const QString& folder, std::function<SavedSession()> present, QObject* parent = nullptr);
    /// Removes the session's file, or, after keepAtEnd(true), writes it a last time and leaves it behind. Waits for
    /// that and for the open orders of the files that were left.
    ~Autosave() override;

    /// The time between a change and its writing, and between a failure and the next attempt.
    void setInterval(int milliseconds);
    /// Writes a session, in any thread. Tests put in a function that ends on command.
    using Write = std::function<Result<void>(const std::string& file, const SavedSession& session)>;
    void setWrite(Write write) { m_write = std::move(write); }
    /// Says that `present` may give another session than before. A change of only the phase shown and the frame of the
    /// motion is not written.
    void noteChange();
    /// A file that was left, with its lock held.
    struct Left {
        QString file;
        std::shared_ptr<QLockFile> lock;
    };
    /// The open session comes from `earlier`, a file that an earlier run left. That file goes only once this one holds
    /// the session, or once forget() is carried out. So a program that dies in between leaves one of the two.
    void replace(const Left& earlier) { m_earlier.push_back(earlier); }
    /// There is nothing to keep: removes the session's file and those that it replaces, and drops a waiting change.
    void forget();
    /// Writes the session's file a last time, leaves it behind and begins another one. Gives the file that is left.
    /// Once its lock has been released, a failed writing is not tried again.
    Left leaveBehind();
    /// Removes a file that this program or an earlier run left and nobody wants any more.
    void discard(const Left& left);
    /// Whether the file stays when this object ends.
    void keepAtEnd(bool keep) { m_keep = keep; }
    [[nodiscard]] QString file() const { return m_file->name; }
    /// Whether something of the session is on disk, or about to be.
    [[nodiscard]] bool keeps() const { return m_written.has_value() || m_timer.isActive(); }
    /// Whether a change waits to be written.
    [[nodiscard]] bool waits() const { return m_timer.isActive(); }
    [[nodiscard]] bool busy() const;

    static QString lockOf(const QString& file) { return file + QStringLiteral(".lock"); }

signals:
    /// A session, the open one or one that was left, is on disk as it was when writing began.
    void written();
    /// A session could not be written, and is tried again. Emitted once until a session is written again.
    void failed(const QString& sentence);

private:
    /// What to do with a file.
    struct Order {
        std::optional<SavedSession> session;  ///< what the file will hold; none to remove it
        std::vector<Left> earlier;            ///< files to remove once that is done
        std::shared_ptr<QLockFile> lock{};    ///< of a file that is discarded: held until it is gone
    };
    /// A session's file. It is wanted as long as somebody holds its lock.
    struct File {
        QString name;
        std::weak_ptr<QLockFile> lock;
        std::shared_ptr<const Order> due;  ///< the newest order that is not known to be done
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
    std::vector<Left> m_earlier;            ///< files that this session's file replaces, until that is ordered
    std::optional<SavedSession> m_written;  ///< the newest session that was ordered
    QTimer m_timer;                         ///< runs while a change waits
    QTimer m_again;                         ///< runs while a failed writing waits
    bool m_keep = false;
    bool m_failed = false;
    std::shared_ptr<QLockFile> m_lock;  ///< the lock of m_file
    std::unique_ptr<File> m_file;       ///< the file of the open session
    std::vector<std::unique_ptr<File>> m_leftBehind;
};

}  // namespace echolucent
