// Saving a case report: what is asked, what is taken from the window, and what is left to a thread of its own.
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

/// Takes the panes once nothing moves there any more, one in each turn of the event loop, so that nothing waits for all
/// of them: planes as they stand on the screen, and of the 3D view the picture that is saved by itself
/// (pictureToKeep()), without the lines of the render box and of the planes. The page is made and written in a thread
/// of its own.
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
        std::function<QString(const QString& what)> proposedName;  ///< of a file of the study, without an ending
        std::function<QString()> explanation;                      ///< of the 3D view, paragraphs
    };
    /// All outlive this, which belongs to the window.
    explicit ReportSaving(const Parts& parts);

    /// Asks what the report is to hold and where it is to go. Does nothing where no study is open.
    void choose();
    /// Saves a report of the window as it will be at rest, with the patient read from the study's files or without. A
    /// motion that plays is paused. While one is being made, it says so and does nothing. Where another study opens
    /// before all panes were taken, there is no report.
    void save(const QString& path, bool withPatient);
    /// Ends what save() began, and says so; where it was not whole before, no file is left.
    void cancel();

private:
    struct Wanted {
        QString path;
        bool withPatient = false;
    };
    /// What was taken of the window so far.
    struct Taken {
        CaseReport report;
        std::size_t panes = 0;  ///< looked at
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
    std::optional<Taken> m_taken;  ///< while the panes are at rest; anew where that ends before all is taken
    bool m_takesSoon = false;
    std::optional<Wanted> m_wanted;            ///< until the panes are taken
    Works::UnderWay m_waits;                   ///< as long as it is wanted
    std::optional<PictureReport> m_converged;  ///< how the newest converged picture was made
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
