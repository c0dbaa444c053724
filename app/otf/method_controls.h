// The adaptive method's panel on the document.
#pragma once

#include <QObject>

#include "widgets/document/document_model.h"
#include "widgets/hand_gesture.h"

namespace echolucent {

class MethodPanel;

/// Makes steps of what is set in the panel, and shows there what the document says.
class MethodControls : public QObject {
    Q_OBJECT

public:
    /// All outlive this.
    MethodControls(DocumentModel& model, HandGesture& hand, MethodPanel& panel, QObject* parent = nullptr);

private:
    void takeFromPanel();
    void showDocument();

    DocumentModel& m_model;
    HandGesture& m_hand;
    MethodPanel& m_panel;
};

}  // namespace echolucent
