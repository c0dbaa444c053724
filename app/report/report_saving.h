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
#include "widgets/threads/works.h"
#include "widgets/volume_view/volume_view_widget.h"

class QWidget;

namespace echolucent {

class MessageBar;
class OtfEditor;
class PlanePane;
class Settings;
class StudyNames;

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

    /// Asks for the report's content and its file. Does nothing if no study is open.
    void choose();
    /// Saves a report of the window as it will be at rest, with or without the patient of the study's files. Pauses a
    /// motion that plays. Does nothing if no study is open. If a report is being made already, a message says so and
    /// nothing is begun. If another study opens before all panes were taken, a message says that there is no report.
    void save(const QString& path, bool withPatient);
    /// Ends what save() began; a message says so. No file is left unless it was whole before the call.
    void cancel();

private:
    struct Wanted {
        QString path;
        bool withPatient = false;
    };
    /// What was taken from the window so far.
    struct Taken {
        CaseReport report;
        std::size_t panes = 0;  ///< number of panes looked at; hidden ones count, but are not taken
    };
    [[nodiscard]] Work work();
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
    std::optional<Taken> m_taken;  ///< set while the panes are at rest; begins anew if they move before all are taken
    bool m_takesSoon = false;
    std::optional<Wanted> m_wanted;            ///< until the panes are taken
    Works::UnderWay m_waits;                   ///< as long as a report is wanted
    std::optional<PictureReport> m_converged;  ///< how the newest converged picture was made
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
