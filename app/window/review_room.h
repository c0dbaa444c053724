// The room for reviewing a volume: the panes and their tools.
#pragma once

#include <QObject>
#include <QPointer>
#include <array>

#include "app/planes/box_in_3d.h"
#include "app/planes/document_planes.h"
#include "app/planes/measurement_controls.h"
#include "app/planes/measuring_hand.h"
#include "app/planes/room_controls.h"
#include "app/planes/scalpel_hand.h"
#include "app/settings/settings.h"
#include "widgets/escape_order.h"
#include "widgets/planes/pane_grid.h"

class QMainWindow;
class QMenu;

namespace echolucent {

class VolumeViewWidget;
class Works;

/// Connects the panes: layouts by key, a pane that takes the whole room, planes and the 3D view.
class ReviewRoom : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        MotionPlayer& player;
        PaneGrid& panes;
        std::array<PlanePane*, 3> planes;
        VolumeViewWidget& picture;
        RoomPanel& panel;
        MeasurementsPanel& measurements;
        MessageBar& messages;
        Settings& settings;
    };
    explicit ReviewRoom(const Parts& parts, QObject* parent = nullptr);

    /// Adds the menu of the room, with its keys, before the menu of the OTF.
    void createMenu(QMainWindow& window);
    /// Adds what Escape ends in the room: drags in planes, the tool in the hand, a pane that has the whole room.
    void addTo(EscapeOrder& escapes);
    /// Whether no tool is in the hand.
    [[nodiscard]] bool handIsFree() const { return !m_scalpel.tool() && !m_measuring.tool(); }
    /// What lies over the 3D view.
    [[nodiscard]] BoxIn3d& overlay() { return m_boxIn3d; }
    void showFrontIn3d(bool shown) { m_boxIn3d.showFront(shown); }
    void restore();
    void keep();

signals:
    /// As ScalpelHand::nothingToCut.
    void nothingToCut();
    /// As DocumentPlanes::pointed.
    void pointed(std::optional<double> intensity);

private:
    void addLayouts(QMenu& menu);
    void addPlanes(QMenu& menu);
    void addBox(QMenu& menu);
    void addScalpel(QMenu& menu);
    void addMeasuring(QMenu& menu);
    void askForName(QWidget* pane);

    Parts m_parts;
    DocumentPlanes m_planes;
    RoomControls m_controls;
    BoxIn3d m_boxIn3d;
    ScalpelHand m_scalpel;
    MeasuringHand m_measuring;
    MeasurementControls m_measurements;
    QPointer<QWidget> m_measuredIn;  ///< the pane of the last measurement made
};

}  // namespace echolucent
