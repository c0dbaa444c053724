// Connects the panel of steps and snapshots with the document.
#pragma once

#include <QObject>

#include "app/sessions/snapshots.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class HistoryPanel;
class MessageBar;

/// Choosing a snapshot makes it the document, as one step.
class HistoryControls : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    HistoryControls(DocumentModel& model, Snapshots& snapshots, HistoryPanel& panel, MessageBar& messages);

private:
    void show();
    void keep();
    void choose(int snapshot);
    void remove(int snapshot);

    DocumentModel& m_model;
    Snapshots& m_snapshots;
    HistoryPanel& m_panel;
    MessageBar& m_messages;
};

}  // namespace echolucent
