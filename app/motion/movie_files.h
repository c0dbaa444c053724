// Movies and picture series of the motion: asks how, writes them in a thread, and tells how it ended.
#pragma once

#include <QObject>
#include <functional>

#include "app/files/file_writing.h"
#include "app/motion/frame_files.h"
#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "app/study/study_sides.h"
#include "widgets/dialogs/movie_dialog.h"
#include "widgets/document/document_model.h"

class QWidget;

namespace echolucent {

class MessageBar;
class StudyNames;
class Works;
enum class MessageKind;

/// Writes one movie or series at a time. It shows document and phases as they were at the start. The window stays
/// usable. If cancel() or the end of this object stops the writing, no file is left.
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
        const StudySides& sides;
        std::function<QSize()> viewPixels;                         ///< the size of the 3D view in device pixels
        std::function<QString(const QString& what)> proposedName;  ///< for a file of the study, without an ending
        std::function<std::vector<PaneFace>()> compared;           ///< FrameOrder::compared
    };
    /// What the parameters refer to must outlive this object, which belongs to the window.
    explicit MovieFiles(Parts parts);

    /// Opens the dialog (movieDialog). Does nothing if no study is open. If files are being written, says so.
    void ask(FrameOutput output);
    /// Begins to write. Checks the choice once more: if something stands in its way, ends at once with a message and
    /// ended(false). Does nothing if no study is open or files are being written.
    void begin(FrameOutput output, const MovieChoice& choice);
    [[nodiscard]] bool busy() const { return m_writing.busy(); }
    /// Ends the writing, within a frame.
    void cancel() { m_writing.cancel(); }

signals:
    /// The writing has ended: whether the files were written, and the sentence that tells it.
    void ended(bool written, const QString& sentence);

private:
    [[nodiscard]] FrameOrder orderOf(FrameOutput output, const MovieChoice& choice) const;
    [[nodiscard]] MovieChoice proposal(FrameOutput output) const;
    [[nodiscard]] HeldFrames heldInMovie() const;
    [[nodiscard]] int frameCount() const;
    [[nodiscard]] MovieHindrance hindrance(FrameOutput output, const MovieChoice& choice) const;
    [[nodiscard]] QString whatPlays() const;
    [[nodiscard]] QString choosePath(FrameOutput output, const QString& present) const;
    [[nodiscard]] QString namesOf(const std::vector<std::string>& files) const;
    void tell(const QString& names, const Result<void>& written);
    void tell(bool written, MessageKind kind, const QString& sentence);

    Parts m_parts;
    FrameOutput m_output = FrameOutput::movie;  ///< of the files being written
    MovieChoice m_last;                         ///< the last choice: its size, length and labels are proposed again
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
