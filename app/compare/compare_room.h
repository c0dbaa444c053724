// The comparison room: it shows OTFs under one camera, in the place of the review room.
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/compare/compare_hand.h"
#include "app/compare/compare_measures.h"
#include "app/compare/compared_views.h"
#include "app/compare/lesson_figures.h"
#include "app/files/file_writing.h"
#include "app/motion/motion_player.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/escape_order.h"
#include "widgets/threads/works.h"

class QMainWindow;
class QMenu;
class QStackedWidget;

namespace echolucent {

class MessageBar;
class Settings;
class StudyNames;

/// Puts the panes of the comparison into the window and takes them out. Connects the parts of the comparison. Choices
/// in the panel become steps.
class CompareRoom : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        MotionPlayer& player;
        QStackedWidget& rooms;  ///< the review room, then the comparison
        PaneOtfs& otfs;
        ShownPanes& panes;
        KeptSurfaces& surfaces;
        CompareGrid& grid;
        ComparePanel& panel;
        OtfEditor& editor;
        MessageBar& messages;
        Settings& settings;
        StudyNames& names;
        std::function<QString(const QString& what)> proposedName;
        std::function<QStringList()> explainView;                 ///< as explainView() of the document
        std::function<QStringList(std::size_t pane)> explainOtf;  ///< as explainOtf() of a pane
    };
    /// What the parameters refer to must outlive this object.
    explicit CompareRoom(const Parts& parts, QObject* parent = nullptr);

    [[nodiscard]] bool shown() const { return m_views.shown(); }
    /// Shows the comparison, or the review room again. If nothing is compared yet, four panes are looked at
    /// (DocumentModel::lookAtPanes()): looking changes nothing that is kept. If the document gets several panes of its
    /// own, by a step, an undo, a snapshot or a session, the comparison is shown; if it loses them, it is left.
    void setShown(bool shown);
    [[nodiscard]] const ComparedViews& views() const { return m_views; }
    /// On the full screen texts are for a projector, and each pane shows its OTF.
    void setFullScreen(bool full) { m_views.setFullScreen(full); }
    /// The pane that had the focus last since the comparison is shown; else the first.
    [[nodiscard]] std::size_t explainedPane() const;
    /// The panes as they are shown, for a file. Null while one of them is not final.
    [[nodiscard]] QImage image() const;
    /// Adds its entries to the room menu, which must exist.
    void createMenu();
    /// Lets Escape end a drag here, or bring a pane back that has the whole room.
    void addTo(EscapeOrder& escapes);
    /// Pauses a motion and writes the comparison as a page, in the background. Waits until every pane shows what the
    /// document asks for and is measured. A message tells of a failure. If another study is opened, the room is left or
    /// the work is cancelled while the page waits, it is not written. Does nothing if the room is hidden or another
    /// page is being written.
    void savePage(const QString& path);

signals:
    void shownChanged(bool shown);
    void explainedPaneChanged();
    /// The hand has moved the camera.
    void cameraMoved();

private:
    [[nodiscard]] Work work();
    void connectPanel();
    void showInPanel();
    /// Ends measuring and writing, and drops a page or a figure that waits. Pictures and OTFs go on.
    void cancel();
    void chooseAndSavePage();
    void setWaitingPage(const QString& path);
    void writeWaitingPage();
    void giveUpPage(const QString& sentence);
    void leave();
    void followPanes();
    void addFigures(QMenu& menu, const QString& ending, const std::optional<SimulatedScan>& scan);

    Parts m_parts;
    ComparedViews m_views;
    CompareHand m_hand;
    CompareMeasures m_measures;
    QString m_waitingPage;  ///< path of the page to write; empty if none waits
    Works::UnderWay m_pageWaits;
    LessonFigures m_figures;
    std::size_t m_explained = firstPane;
    bool m_hasPanes = false;  ///< whether the document has several panes of its own
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
