// The list of measurements, with the document behind it.
#pragma once

#include <QObject>

#include "app/motion/motion_player.h"
#include "app/planes/measuring_hand.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/panels/measurements_panel.h"

namespace echolucent {

/// Lists the measurements of all phases, shows the place of one of them, names and removes them. All letters of a name
/// or a comment that are typed in one go are one step.
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
    void setName(int id, const QString& typed);
    void setComment(int id, const QString& typed);
    void remove(int id);
    void removeAll();

private:
    void list();
    void setText(int id, std::string Measurement::*member, const std::string& text, const QString& what);

    Parts m_parts;
    DocumentModel::Gesture m_typing = -1;  ///< of the letters that are one step; the hand's gestures are above 0
};

}  // namespace echolucent
