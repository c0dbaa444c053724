// The session of the window: saved, opened, kept by itself, and what earlier runs left of theirs.
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
#include "app/sessions/leftovers.h"
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

/// A session has a file once a person saved it or opened it from one, and is *changed* where it differs from that file;
/// without a file it is changed where it holds what a person made: strokes, measurements, snapshots, a box, a cut.
/// What an earlier run left is changed until it is saved. Every change is kept by Autosave, whatever a person does.
/// What was changed and is left, because another study is opened or the window closes, stays behind and is offered
/// again; so does whatever a person set, where the session that is opened has its own instead.
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
    /// The file of the session; empty where it has none.
    [[nodiscard]] QString file() const { return m_file; }
    /// Saves into the session's file, or asks for one where it has none.
    void save();
    /// Asks for a file, beside the session's file or the study, and saves into it.
    void chooseAndSave();
    /// What follows once the session is in its file.
    enum class Then { goOn, closeWindow };
    /// Begins to save, once the study's checksum is there; refused, with a sentence, in the study's folder and over its
    /// files.
    void saveAs(const QString& file, Then then = Then::goOn);
    /// What waits for the study's checksum, or for another file to be written, is not saved; what is being written is.
    void cancelSaving();
    [[nodiscard]] bool saving() const { return !m_orders.empty() || m_saving.busy(); }
    /// Asks where a session with a file was changed. False where the window stays, or closes by itself once the session
    /// is saved, as it does where one is being saved already.
    [[nodiscard]] bool mayClose();

    /// Whether nothing is written, nor about to be.
    [[nodiscard]] bool atRest() const {
        return !saving() && !m_autosave->busy() && !m_taking.busy() && !m_looking.isActive() && !m_autosave->waits();
    }

signals:
    /// The session is in its file.
    void saved();

private:
    [[nodiscard]] SavedSession present() const;
    void begin();
    void leave();
    void noteChange();
    /// Finds out what changed.
    void look();
    /// A session on its way to its file.
    struct Order {
        QString file;
        SavedSession session;
        std::vector<std::string> studyFiles;  ///< which the session never replaces
        int number = 0;                       ///< of the session that it is
    };
    void send(Order order);
    void writeNext();
    /// Whether a session is being written, or about to be, by its number.
    [[nodiscard]] bool isOnItsWay(int number) const;
    [[nodiscard]] Order takeFirst();
    /// The first order is in its file, which was written at a time.
    void takeSaved(const QDateTime& time);
    void takeUnsaved(const QString& sentence);
    void offerAnotherPlace(const Order& order, const QString& sentence);
    void saveElsewhere(Order order);
    /// Asks where somebody wrote the session's file since it was read or written here; false where it is to stay.
    [[nodiscard]] bool mayReplace();
    [[nodiscard]] QString chosenFile(const QString& named, const QString& folder);
    void offerLeftovers();
    void openLeftover();
    [[nodiscard]] QString proposedFolder() const;
    [[nodiscard]] bool holdsWork() const;

    Parts m_parts;
    Snapshots m_snapshots;
    QString m_file;
    std::optional<SavedSession> m_inFile;  ///< what the file holds; none where there is no file
    bool m_changed = false;
    bool m_between = false;      ///< another study's document takes the place of the present one
    bool m_left = false;         ///< what is open was left by an earlier run, and not saved since
    QTimer m_looking;            ///< runs while a change was not looked at: the document may change with every frame
    QDateTime m_fileTime;        ///< when the file was written that is known of; later is somebody else's
    int m_number = 0;            ///< of the session that is open: one more with each
    std::deque<Order> m_orders;  ///< the first is being written, or waits for the study's checksum
    Then m_then = Then::goOn;    ///< once the session is saved that is on its way
    std::deque<Leftover> m_leftovers;
    std::vector<std::pair<int, Leftover>> m_leftWhileSaving;  ///< with the number of their session; not offered
    std::unique_ptr<Autosave> m_autosave;
    Works::UnderWay m_underWay;  ///< while it is saving()
    NewestWinsThread m_taking, m_saving;
};

}  // namespace echolucent
