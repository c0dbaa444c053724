// What the window shows from the moment a study is asked for until its picture is there.
#pragma once

#include <QObject>
#include <array>

#include "app/picture/document_view.h"
#include "app/study/open_study.h"

namespace echolucent {

class CompareGrid;
class OpeningLabel;
class PlanePane;
class StudyNames;
class VolumeViewWidget;
class Works;

/// Dims the old pictures before anything of the new study is read, and lays its name and progress on them. The 3D view
/// stays dimmed while it shows the study before, and the label stays until the new study's first picture is on the
/// screen. If nothing is opened, all is as before.
///
///                asked for            opened                      first picture drawn
///   [at rest] -------------> [asked] ---------> [awaits a picture] ------------------> [at rest]
///       ^                       |
///       +-----------------------+  failed, cancelled, or a question first
class ComingStudy : public QObject {
    Q_OBJECT

public:
    struct Parts {
        OpenStudy& openStudy;
        Works& works;
        DocumentView& documentView;
        VolumeViewWidget& picture;
        std::array<PlanePane*, 3> planes;
        CompareGrid& compared;
        QWidget& rooms;  ///< around all pictures
        OpeningLabel& label;
        StudyNames& names;
    };
    /// What the parameters refer to must outlive this object.
    explicit ComingStudy(const Parts& parts, QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void begin();
    void follow();
    void nameStudy();

    Parts m_parts;
    bool m_asked = false;   ///< a study is being loaded
    bool m_awaits = false;  ///< a study is open, and its first picture is not drawn yet
};

}  // namespace echolucent
