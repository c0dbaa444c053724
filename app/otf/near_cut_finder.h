// Looks for the near cut that opens the fluid, makes it, says so, and offers the way back.
#pragma once

#include <QObject>

#include "app/otf/otf_computing.h"

namespace echolucent {

class MessageBar;
class RunStatus;
class ViewPanel;

class NearCutFinder : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        int view;
        Session& session;
        OtfComputing& computing;
        ViewPanel& panel;  ///< rounds the cut as people set it
        RunStatus& status;
        MessageBar& messages;
    };
    explicit NearCutFinder(const Parts& parts, QObject* parent = nullptr);

    /// Looks in the view that the document shows now.
    void find();

private:
    void take(const NearCutSuggestion& suggestion);
    void endProgress();
    void cutAt(double mm, const ViewDirection& direction);

    Parts m_parts;
    Viewpoint m_looksFrom;
    bool m_looking = false;
};

}  // namespace echolucent
