// The session of the window: saved, opened, kept by itself, and what earlier runs left of theirs.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <memory>
#include <optional>

#include "app/document/document_model.h"
#include "app/sessions/autosave.h"
#include "app/sessions/leftovers.h"
#include "app/sessions/snapshots.h"
#include "app/study/shown_study.h"

class QMainWindow;

namespace echolucent {

class MessageBar;
class OtfEditor;
class Session;
class Settings;
class StudyNames;

/// A session has a file once a person saved it or opened it from one, and is *changed* where it differs from that file;
/// without a file it is changed where it holds what a person made: strokes, measurements, snapshots, a box, a cut.
/// Every change is kept by Autosave, whatever a person does. What was changed and is left, because another study is
/// opened or the window closes, stays behind and is offered again.
class SessionKeeping : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        Session& session;
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
    [[nodiscard]] bool changed() const { return m_changed; }

    /// Saves into the session's file, or asks for one where it has none.
    void save();
    void chooseAndSave();
    /// Begins to save; refused, with a sentence, in the study's folder and over its files.
    void saveAs(const QString& file);
    /// Asks where a session with a file was changed. False where the window stays, or closes by itself once the session
    /// is saved.
    [[nodiscard]] bool mayClose();

    [[nodiscard]] bool busy() const { return m_saving.busy() || m_autosave->busy() || m_taking.busy(); }

signals:
    void busyChanged();
    /// The session is in its file.
    void saved();

private:
    [[nodiscard]] SavedSession present() const;
    void begin();
    void leave();
    void noteChange();
    void takeSaved(const QString& file, const SavedSession& session);
    void offerAnotherPlace(const QString& sentence);
    void offerLeftovers();
    void openLeftover();
    [[nodiscard]] QString proposedFile() const;
    [[nodiscard]] bool holdsWork() const;

    Parts m_parts;
    Snapshots m_snapshots;
    QString m_file;
    std::optional<SavedSession> m_inFile;  ///< what the file holds; none where there is no file
    bool m_changed = false;
    bool m_between = false;  ///< another study's document takes the place of the present one
    bool m_closing = false;  ///< the window closes once the session is saved
    std::deque<Leftover> m_leftovers;
    std::optional<Leftover> m_taken;  ///< what is open now, until it is kept anew
    std::unique_ptr<Autosave> m_autosave;
    NewestWinsThread m_taking, m_saving;
};

}  // namespace echolucent
