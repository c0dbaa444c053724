// Saves, opens and autosaves the window's session, and keeps what is left of sessions that nobody saved.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/sessions/autosave.h"
#include "app/sessions/left_unsaved.h"
#include "app/sessions/shown_study.h"
#include "app/sessions/snapshots.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/works.h"

class QMainWindow;

namespace echolucent {

class MessageBar;
class OtfEditor;
class OpenStudy;
class Settings;
class StudyNames;

/// A session has a file once a person saved it or opened it from one. It is *changed* if it differs from that file.
/// Without a file it is changed if it holds a person's work: strokes, measurements, snapshots, a box, another front or
/// another number of panes than on opening. Panes that are only looked at do not count, and are not kept. A session
/// that an earlier run left is changed until it is saved. Autosave keeps every change, whatever a person does. If a
/// person leaves a changed session, by opening another study or closing the window, it stays behind and is offered
/// again. A session whose curves, look, method or side a person changed stays behind too if an opened session replaces
/// them by its own.
class SessionKeeping : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        ShownStudy& shown;
        Settings& settings;
        OtfEditor& editor;
        MessageBar& messages;
        StudyNames& names;
    };
    explicit SessionKeeping(const Parts& parts);
    ~SessionKeeping() override;

    [[nodiscard]] Snapshots& snapshots() { return m_snapshots; }
    [[nodiscard]] Autosave& autosave() { return *m_autosave; }
    [[nodiscard]] LeftUnsaved& leftUnsaved() { return *m_left; }
    /// The file of the session; empty for none.
    [[nodiscard]] QString file() const { return m_file; }
    /// Saves into the session's file; asks for one if there is none.
    void save();
    /// Asks for a file, beside the session's file or the study, and saves into it.
    void chooseAndSave();
    /// What to do once the session is saved.
    enum class Then { goOn, closeWindow };
    /// Saves once the study's checksum is there. Refused, with a sentence, in the study's folder and over its files.
    void saveAs(const QString& file, Then then = Then::goOn);
    /// Drops the sessions that wait for the study's checksum or for another file. A file that is being written is
    /// finished.
    void cancelSaving();
    [[nodiscard]] bool saving() const { return !m_orders.empty() || m_saving.busy(); }
    /// Whether the window may close at once. If a session with a file was changed, asks the person. False if the window
    /// must stay. False too if a session is being saved: the window closes by itself once that is done.
    [[nodiscard]] bool mayClose();

    /// The next study that opens is one to look at for a while, such as a lesson's. The session is put aside, with its
    /// file and its snapshots; if it was changed it stays on disk, as if it had been left. What is done meanwhile is
    /// not kept. If another study is opened instead of coming back, the session that was put aside is left as usual.
    /// If no study is open, nothing is put aside, and what is done meanwhile is not kept either.
    void putAside() { m_puttingAside = true; }
    /// The next study that opens is that of the session that was put aside. It goes on as it was.
    void takeBack() { m_takingBack = true; }
    [[nodiscard]] bool isAside() const { return m_aside.has_value(); }

    /// Whether nothing is being written or about to be.
    [[nodiscard]] bool atRest() const {
        return !saving() && !m_autosave->busy() && !m_left->looking() && !m_looking.isActive() && !m_autosave->waits();
    }

signals:
    /// A session is in its file.
    void saved();

private:
    [[nodiscard]] SavedSession present() const;
    void begin();
    void leave();
    void noteChange();
    /// Finds out whether the session changed.
    void look();
    /// A session that was put aside.
    struct Aside {
        std::vector<Snapshot> snapshots;
        QString file;
        std::optional<SavedSession> inFile;
        bool fromLeft = false;
        QDateTime fileTime;
        std::optional<Leftover> left{};  ///< its file on disk, if it was changed or holds a look or curves of its own
        bool changed = false;
    };
    void leaveAside();
    void goOn();
    /// A session on its way to its file.
    struct Order {
        QString file;
        SavedSession session;
        std::vector<std::string> studyFiles;  ///< the session never replaces these
        int number = 0;                       ///< of the session
    };
    void send(Order order);
    void writeNext();
    /// Whether the session of this number is being written or about to be.
    [[nodiscard]] bool isOnItsWay(int number) const;
    [[nodiscard]] Order takeFirst();
    /// The first order is in its file, which was written at `time`.
    void takeSaved(const QDateTime& time);
    void takeUnsaved(const QString& sentence);
    void offerAnotherPlace(const Order& order, const QString& sentence);
    void saveElsewhere(Order order);
    /// Asks if somebody else wrote the session's file since it was read or written here. False if that file must stay.
    [[nodiscard]] bool mayReplace();
    [[nodiscard]] QString chosenFile(const QString& named, const QString& folder);
    [[nodiscard]] QString proposedFolder() const;
    [[nodiscard]] bool holdsWork() const;
    /// Whether the session has no file, and curves, look, method or side that an opened session would replace.
    [[nodiscard]] bool holdsSettings() const;

    Parts m_parts;
    Snapshots m_snapshots;
    QString m_file;
    std::optional<SavedSession> m_inFile;  ///< what the file holds; no value without a file or if m_fromLeft is true
    bool m_changed = false;
    bool m_puttingAside = false, m_takingBack = false;
    std::optional<Aside> m_aside;
    bool m_between = false;      ///< while another study's document replaces the present one
    bool m_fromLeft = false;     ///< the open session comes from an earlier run and was not saved since
    QTimer m_looking;            ///< runs until look() has seen a change: the document may change with every frame
    QDateTime m_fileTime;        ///< last known time of writing the file; a later one is somebody else's
    int m_number = 0;            ///< of the open session; grows by one with each
    std::deque<Order> m_orders;  ///< the first is being written, or waits for the study's checksum
    Then m_then = Then::goOn;    ///< what to do once the session that is being saved is in its file
    std::vector<std::pair<int, Leftover>> m_leftWhileSaving;  ///< with the number of their session; not offered
    std::unique_ptr<Autosave> m_autosave;
    std::unique_ptr<LeftUnsaved> m_left;
    Works::UnderWay m_underWay;  ///< under way while saving() is true
    NewestWinsThread m_saving;
};

}  // namespace echolucent
