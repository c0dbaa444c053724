// Saves the 3D view or all panes as one picture, in a size that a person chooses.
#pragma once

#include <QObject>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "app/files/file_writing.h"
#include "app/picture/document_view.h"
#include "app/picture/panes_picture.h"
#include "app/study/open_study.h"
#include "app/study/study_sides.h"
#include "widgets/dialogs/picture_dialog.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class CompareGrid;
class MessageBar;
class PaneGrid;
class PlanePane;
class Settings;
class ShownPanes;
class StudyNames;
class VolumeViewWidget;

/// Takes the state of the panes when it is asked, and makes and writes the picture in a thread. While the comparison is
/// shown, its panes are the panes. The file names no
/// patient; the window's own controls are not in it. The 3D picture is made with the OTF of its own volume and view: a
/// smoothing over time, as a motion shows it, is not in it. Compared panes keep the OTFs that they show, smoothed or
/// not.
class PanesSaving : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialogs
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        const PaneGrid& panes;
        std::array<PlanePane*, 3> planes;
        const VolumeViewWidget& picture;
        const CompareGrid& compared;
        const ShownPanes& otfs;  ///< what the compared panes show
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        const StudySides& sides;
        const DocumentView& shown;                                   ///< what the 3D view shows
        std::function<QString(const QString& what)> proposedName;    ///< for a file of the study, without an ending
        std::function<std::optional<std::size_t>()> rememberedSide;  ///< as CaptionFacts::remembered
    };
    /// The parts outlive this object, which belongs to the window.
    explicit PanesSaving(Parts parts);

    /// Asks for content, size and file. Does nothing if no study is open.
    void choose();
    /// Saves what the choice says. A message confirms it, or says what stands in the way: a picture that is being
    /// written, a 3D view that still shows the study before, a path that is a file of the study, panes that are hidden,
    /// a size without pixels or above PictureDialog::longestEdge.
    void save(const QString& path, const PictureChoice& choice);
    void cancel() { m_writing.cancel(); }

private:
    [[nodiscard]] PanesInPicture taken(const PictureChoice& choice) const;
    void tell(const QString& path, const Result<void>& written);

    Parts m_parts;
    FileWriting m_writing;  ///< last, so that its thread has ended before anything above is destroyed
};

}  // namespace echolucent
