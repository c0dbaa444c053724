// A 3D view that shows the first pane of the document.
#pragma once

#include <QObject>

#include "app/otf/shown_panes.h"
#include "widgets/document/document_model.h"

namespace echolucent {

class VolumeViewWidget;

/// Shows the document and its computed OTF in a widget, and makes steps of what the hand does there. The picture
/// follows the document alone. Several of these views show one document: turning one turns all.
class DocumentView : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    DocumentView(DocumentModel& model, OpenStudy& openStudy, ShownPanes& panes, VolumeViewWidget& widget,
                 QObject* parent = nullptr);

    /// Whether the widget still shows the study before. It does until the first pane is ready: a picture never mixes
    /// the voxels of one study with the values of another. What the hand does there meanwhile is no step.
    [[nodiscard]] bool held() const { return m_study != m_openStudy.study(); }
    /// Whether the widget was given what the document says. True also if no study is open.
    [[nodiscard]] bool isCurrent() const { return m_isCurrent; }

signals:
    /// The widget was given the open study: it no longer shows the one before (held()).
    void studyGiven();
    /// The hand has moved the camera.
    void cameraMoved();

private:
    void follow();
    void showPose();
    void takePose();
    void takeLight();

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    ShownPanes& m_panes;
    VolumeViewWidget& m_widget;
    const Study* m_study = nullptr;  ///< shown by the widget; compared by address only
    bool m_isCurrent = true;
};

}  // namespace echolucent
