// Saves and opens curves, and saves pictures.
#pragma once

#include <QImage>
#include <QObject>
#include <functional>
#include <optional>
#include <vector>

#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "io/output/overwriting.h"
#include "processing/document/curve_set.h"
#include "processing/result.h"
#include "widgets/document/document_model.h"

class QWidget;

namespace echolucent {

class MessageBar;
class DocumentView;
class OtfEditor;
class StudyNames;
class VolumeViewWidget;

class CurveAndPictureFiles : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialogs
        DocumentModel& model;
        OpenStudy& openStudy;
        OtfEditor& editor;
        VolumeViewWidget& picture;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        const DocumentView& shown;  ///< what the picture shows
        /// The compared panes as they are shown; null while one of them is not final. No value if the comparison is not
        /// shown.
        std::function<std::optional<QImage>()> compared;
    };
    /// The parts outlive this object, which belongs to the window.
    explicit CurveAndPictureFiles(const Parts& parts);

    /// Opens a manual curve (JSON) and makes it active; this can be undone. False, with a message, if it cannot be
    /// opened.
    bool openCurve(const QString& path);
    /// openCurve(), but asks the person first if an edited curve would be lost.
    void openCurveOfPerson(const QString& path);
    /// Saves the rendered curve as nodes. A message says which curve it is and how many nodes it has. False, with a
    /// message, if it cannot be written or the path is a file of the study.
    bool saveCurve(const QString& path);
    /// Saves the picture of the 3D view with the measurements of its phase; while the comparison is shown, all its
    /// panes with what stands below them. No name of a patient or a file is stored beside it. A message confirms it.
    /// False, with a message, if it cannot be written, the path is a file of the study, the 3D view still shows the
    /// study before, or a compared pane is not final.
    bool savePicture(const QString& path);
    void chooseAndSavePicture();
    /// Copies the picture of savePicture() to the clipboard. A message confirms it, and warns if the picture may show
    /// names (burnedInTextNote()).
    void copyPicture();
    /// The name proposed for a file to save: the study's file and the content `what`, without an ending.
    [[nodiscard]] QString proposedName(const QString& what) const;
    /// Asks the person if an edited manual curve would be lost. False if the curve must be kept.
    bool mayLoseManualCurve();

private:
    /// The converged picture of the 3D view, with the measurements of its phase.
    [[nodiscard]] QImage pictureToSave(const std::optional<QImage>& compared, const QString& what);
    /// A note to read before a picture of the study leaves the window; empty for none.
    [[nodiscard]] QString burnedInText() const;
    void chooseAndOpenCurve();
    struct SavedCurve {
        OpacityCurve curve;
        QString name, key;
        bool manual = false;
        bool ofDesigner = false;
    };
    [[nodiscard]] SavedCurve curveOfKind(CurveKind kind) const;
    /// The rendered curve; for the OTF of a designer, that OTF's upper curve.
    [[nodiscard]] SavedCurve rendered() const;
    /// What a picture with this curve shows and the file of the curve does not hold, in sentences; empty for nothing.
    [[nodiscard]] QString leftOut(const SavedCurve& saved) const;
    bool chooseAndSaveCurve(const SavedCurve& saved);
    bool saveCurve(const QString& path, const SavedCurve& saved);
    /// Fails if `path` is a file of the open study.
    [[nodiscard]] Result<void> mayOverwrite(const QString& path) const;
    bool report(const Result<void>& written, const QString& topic);
    bool isThere(const QString& what);

    Parts m_parts;
    std::vector<KeptFiles> m_read;  ///< curves read; only curves may replace them
};

}  // namespace echolucent
