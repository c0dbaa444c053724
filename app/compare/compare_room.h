// The room in which OTFs are compared under one camera, in the place of the review room.
#pragma once

#include <QObject>
#include <functional>

#include "app/compare/compare_controls.h"
#include "app/compare/compare_hand.h"
#include "app/compare/compare_measures.h"
#include "app/compare/compared_views.h"
#include "app/files/file_writing.h"
#include "app/motion/motion_player.h"
#include "widgets/escape_order.h"
#include "widgets/threads/works.h"

class QAction;
class QMainWindow;
class QStackedWidget;

namespace echolucent {

class MessageBar;
class Settings;
class StudyNames;

/// Puts the panes of the comparison into the window and takes them out, and hangs their units together.
class CompareRoom : public QObject {
    Q_OBJECT

public:
    struct Parts {
        QMainWindow& window;
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        MotionPlayer& player;
        QStackedWidget& rooms;  ///< the review room first
        PaneOtfs& otfs;
        ShownPanes& panes;
        CompareGrid& grid;
        ComparePanel& panel;
        MessageBar& messages;
        Settings& settings;
        StudyNames& names;
        std::function<QString(const QString& what)> proposedName;
    };
    /// All of them must outlive this.
    explicit CompareRoom(const Parts& parts, QObject* parent = nullptr);

    [[nodiscard]] bool shown() const { return m_views.shown(); }
    /// Shows the comparison, the standard one where there is none yet, or the review room again.
    void setShown(bool shown);
    [[nodiscard]] const ComparedViews& views() const { return m_views; }
    /// Adds its entries to the menu of the room, which is there.
    void createMenu();
    /// What Escape ends here: a drag, a pane that has the whole room.
    void addTo(EscapeOrder& escapes);
    /// Writes what is shown as a page, in the background, once every pane shows what it is to show and is measured; a
    /// message says where it could not be written. What plays is paused. Another study opened before is no page.
    void savePage(const QString& path);

signals:
    void shownChanged(bool shown);
    /// The hand has moved the camera.
    void cameraMoved();

private:
    [[nodiscard]] Work work();
    /// Ends what takes long, pictures and OTFs apart.
    void cancel();
    void chooseAndSavePage();
    void setWaitingPage(const QString& path);
    void writeWaitingPage();
    void giveUpPage(const QString& sentence);
    void leave();
    void showFigure(int number);
    void setUpWaitingFigure();

    Parts m_parts;
    ComparedViews m_views;
    CompareHand m_hand;
    CompareControls m_controls;
    CompareMeasures m_measures;
    QString m_waitingPage;  ///< path of the page that is to be written; empty where none is
    Works::UnderWay m_pageWaits;
    int m_figureWaits = 0;  ///< for the simulated scan and its OTF; 0 where none does
    // Last, so that its thread has ended before anything above is destroyed.
    FileWriting m_writing;
};

}  // namespace echolucent
