// The list of measurements, with the document behind it.
#pragma once

#include <QObject>

#include "app/motion/motion_player.h"
#include "app/planes/measuring_hand.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/panels/measurements_panel.h"

namespace echolucent {

/// Lists the measurements of all phases, shows the place of one of them, and removes them.
class MeasurementControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        MotionPlayer& player;
        MeasuringHand& hand;
        MeasurementsPanel& panel;
    };
    /// What the parameters refer to must outlive this object.
    explicit MeasurementControls(const Parts& parts, QObject* parent = nullptr);

    /// Pauses a motion and shows the phase of a measurement. If it was measured in a plane, also shows a plane that
    /// holds all its places.
    void show(int id);
    void remove(int id);
    void removeAll();

private:
    void list();

    Parts m_parts;
};

}  // namespace echolucent
