// Movies and series of pictures of the motion: asks how, writes them in a thread of its own, and tells what became of
// them.
#pragma once

#include <QObject>
#include <functional>

#include "app/files/file_writing.h"
#include "app/motion/frame_files.h"
#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "widgets/dialogs/movie_dialog.h"
#include "widgets/document/document_model.h"

class QWidget;

namespace echolucent {

class MessageBar;
class StudyNames;
class Works;
enum class MessageKind;

/// Writes one movie or series at a time, of the document and the phases as they were when it was begun; the window
/// stays usable. Ended by cancel(), or with this, it leaves no file.
class MovieFiles : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialog
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        std::function<QSize()> viewPixels;                         ///< of the 3D view, device pixels
        std::function<QString(const QString& what)> proposedName;  ///< of a file of the study, without an ending
    };
    /// All outlive this, which belongs to the window.
    explicit MovieFiles(Parts parts);

    /// Opens the dialog (movieDialog). Where nothing is open nothing happens; while one is being written, it says so.
    void ask(FrameOutput output);
    /// Begins to write. What was chosen is checked once more.
    void begin(FrameOutput output, const MovieChoice& choice);
    [[nodiscard]] bool busy() const { return m_writing.busy(); }
    /// Ends what is being written, within a frame.
    void cancel() { m_writing.cancel(); }

signals:
    /// What was begun has ended: the sentence that says so, and whether it was written.
    void ended(bool written, const QString& sentence);

private:
    [[nodiscard]] FrameOrder orderOf(FrameOutput output, const MovieChoice& choice) const;
    [[nodiscard]] MovieChoice proposal(FrameOutput output) const;
    [[nodiscard]] int frameCount() const;
    [[nodiscard]] MovieHindrance hindrance(FrameOutput output, const MovieChoice& choice) const;
    [[nodiscard]] QString whatPlays() const;
    [[nodiscard]] QString choosePath(FrameOutput output, const QString& present) const;
    [[nodiscard]] QString namesOf(const std::vector<std::string>& files) const;
    void tell(const QString& names, const Result<void>& written);
    void tell(bool written, MessageKind kind, const QString& sentence);

    Parts m_parts;
    FrameOutput m_output = FrameOutput::movie;  ///< of what is being written
    MovieChoice m_last;                         ///< what was chosen last: size and labels are proposed again
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
