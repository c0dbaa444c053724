// The panel of planes and box, with the document behind it.
#pragma once

#include <QObject>

#include "app/document/document_model.h"
#include "app/document/hand_gesture.h"
#include "app/study/session.h"
#include "widgets/panels/room_panel.h"

namespace echolucent {

class RoomControls : public QObject {
    Q_OBJECT

public:
    /// All of them must outlive this.
    RoomControls(DocumentModel& model, int view, HandGesture& hand, Session& session, RoomPanel& panel,
                 QObject* parent = nullptr);

    void switchBox(bool on);
    void chooseFront(BoxSide front);

private:
    void show();
    void edit(const Document& next, const QString& what);
    void resizeBox(int axis, double mm);
    void makeWhole();
    void makeSlab(PlaneName plane, double thicknessMm);

    DocumentModel& m_model;
    int m_view;
    HandGesture& m_hand;
    Session& m_session;
    RoomPanel& m_panel;
};

}  // namespace echolucent
