// Saves a case report: asks for its content, takes the panes from the window, writes the page in a thread.
#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <optional>

#include "app/files/file_writing.h"
#include "app/motion/motion_player.h"
#include "app/otf/pane_otfs.h"
#include "app/report/case_report.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

class QWidget;

namespace echolucent {

/// What a person has typed for a report.
struct ReportWords {
    std::string impression{}, comment{};  ///< UTF-8
    bool withPatient = false;
    Patient patient{};          ///< as typed
    bool restFromFiles = true;  ///< what is empty there is as the study's files say
    bool withAppendix = false;
};

class MessageBar;
class OtfEditor;
class PlanePane;
class ReportDialog;
class Settings;
class StudyNames;

/// The files that may say whose study it is.
struct PatientSource {
    std::vector<std::string> files;
    std::string series;
};

/// Takes the panes once nothing moves there any more. It takes one in each turn of the event loop, so that the window
/// stays responsive. Planes are taken as they stand on the screen. Of the 3D view it takes pictureToKeep(), the picture
/// without the lines of the render box and of the planes. A thread of its own makes and writes the page.
class ReportSaving : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QWidget& window;  ///< parent of the dialogs
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        const PaneOtfs& otfs;
        MotionPlayer& player;
        std::array<PlanePane*, 3> planes;
        VolumeViewWidget& picture;
        const OtfEditor& editor;
        Settings& settings;
        MessageBar& messages;
        StudyNames& names;
        std::function<QString(const QString& what)> proposedName;  ///< name for a file of the study, without an ending
        std::function<QString()> explanation;                      ///< what the 3D view shows and why, in paragraphs
    };
    /// The parts outlive this object, which belongs to the window.
    explicit ReportSaving(const Parts& parts);

    /// Asks for the report's content and its file. Does nothing if no study is open. Impression and comment are
    /// proposed again until another study opens; the patient never is.
    void choose();
    /// Saves a report of the window as it will be at rest, with or without the patient. A path that
    /// ends with ".pdf" becomes a PDF, any other HTML. Pauses a motion that plays. Does nothing if no study is open. If
    /// a report is being made already, a message says so and nothing is begun. If another study opens before all panes
    /// were taken, a message says that there is no report.
    void save(const QString& path, const ReportWords& words);
    /// Ends what save() began; a message says so. No file is left unless it was whole before the call.
    void cancel();

private:
    struct Wanted {
        QString path;
        ReportWords words;
    };
    /// What was taken from the window so far.
    struct Taken {
        CaseReport report;
        std::size_t panes = 0;  ///< number of panes looked at; hidden ones count, but are not taken
    };
    [[nodiscard]] Work work();
    [[nodiscard]] std::optional<PatientSource> patientSource() const;
    void showPatientOfFiles(ReportDialog& dialog);
    void followRest();
    void takeNextSoon();
    void takeNext();
    void write();
    void endUnwritten(const QString& sentence);
    [[nodiscard]] CaseReport windowState() const;
    [[nodiscard]] std::optional<ReportPane> pane(std::size_t index) const;
    [[nodiscard]] std::vector<ReportTime> times() const;
    void tell(const QString& path, const Result<void>& written);

    Parts m_parts;
    QString m_impression, m_comment;  ///< as typed last for the open study
    std::optional<Taken> m_taken;  ///< set while the panes are at rest; begins anew if they move before all are taken
    bool m_takesSoon = false;
    std::optional<Wanted> m_wanted;            ///< until the panes are taken
    Works::UnderWay m_waits;                   ///< as long as a report is wanted
    std::optional<PictureReport> m_converged;  ///< how the newest converged picture was made
    // Last, so that their threads have ended before anything above is destroyed.
    NewestWinsThread m_reading;
    FileWriting m_writing;
};

}  // namespace echolucent
