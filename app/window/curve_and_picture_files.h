// Curves and pictures that go to files and back.
#pragma once

#include <QImage>
#include <QObject>
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
    };
    /// All outlive this, which belongs to the window.
    explicit CurveAndPictureFiles(const Parts& parts);

    /// Opens a manual curve (JSON) and makes it active; the edit can be undone. False, with a message, where it cannot.
    bool openCurve(const QString& path);
    /// The same where a person asks for it: an edited curve is not lost without asking.
    void openCurveOfPerson(const QString& path);
    /// Saves the curve that is shown as nodes, and says which it is and how many nodes it has.
    bool saveCurve(const QString& path);
    /// Saves what the 3D view shows, measurements of its phase included, without any name of a patient or file in it.
    bool savePicture(const QString& path);
    void chooseAndSavePicture();
    /// Puts the same picture into the clipboard; says so where it may show names (burnedInTextNote()).
    void copyPicture();
    /// Of a file to be saved: the study's file and what the file will hold, without an ending.
    [[nodiscard]] QString proposedName(const QString& what) const;
    /// Asks where an edited manual curve would be lost. Returns false where it must not be.
    bool mayLoseManualCurve();

private:
    /// What the 3D view shows, converged, with the measurements of its phase.
    [[nodiscard]] QImage pictureToSave();
    /// What is to be said before a picture of the study leaves the window; empty where nothing is.
    [[nodiscard]] QString burnedInText() const;
    void chooseAndOpenCurve();
    /// A curve that is saved, and what it is called.
    struct SavedCurve {
        OpacityCurve curve;
        QString name, key;
        bool manual = false;
    };
    [[nodiscard]] SavedCurve curveOfKind(CurveKind kind) const;
    /// The curve that is rendered; where a designer's OTF is, that OTF's upper curve.
    [[nodiscard]] SavedCurve rendered() const;
    bool chooseAndSaveCurve(const SavedCurve& saved);
    bool saveCurve(const QString& path, const SavedCurve& saved);
    /// Fails where `path` is a file of the open study.
    [[nodiscard]] Result<void> mayOverwrite(const QString& path) const;
    bool report(const Result<void>& written);

    Parts m_parts;
    std::vector<KeptFiles> m_read;  ///< curves: only curves take their places
    QString m_told;                 ///< of a curve that was saved, while it is shown as it was saved
};

}  // namespace echolucent
