// The coarse picture of a large study, shown while the study loads.
#pragma once

#include <QImage>
#include <QObject>

#include "app/picture/document_view.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

class StillPicture;
class VolumeViewWidget;

/// Makes a picture of a study before OpenStudy has read all of it, in its own thread. Lays it over the 3D view until
/// the study's own first picture is drawn there, or the loading ends without one. The picture is no part of the
/// document. The open study stays below it, with its messages.
class LoadingPicture : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        DocumentView& documentView;
        VolumeViewWidget& picture;
    };
    /// What the parameters refer to must outlive this object.
    explicit LoadingPicture(const Parts& parts, QObject* parent = nullptr);

signals:
    /// The coarse picture lies over the 3D view.
    void shown();

private:
    void make(const CoarseVolume& coarse);
    void show(const QImage& image);
    void end();

    Parts m_parts;
    StillPicture* m_still = nullptr;  ///< made with the first picture, in the 3D view
    bool m_opened = false;            ///< the study is open, and its first picture is being made
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

}  // namespace echolucent
