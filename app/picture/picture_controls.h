// Connects the picture's panel and status line with the document.
#pragma once

#include <QObject>
#include <optional>

#include "app/settings/settings.h"
#include "app/study/open_study.h"
#include "widgets/document/document_model.h"
#include "widgets/paced_words.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

class OtfEditor;
class RunStatus;
class ViewPanel;

/// Settings in the panel become steps, and the panel shows the document. The look is remembered for the next start. The
/// renderer belongs to the machine, not to the document.
class PictureControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        const OpenStudy& openStudy;
        VolumeViewWidget& picture;
        ViewPanel& panel;
        OtfEditor& editor;
        RunStatus& status;
        Settings& settings;
    };
    explicit PictureControls(const Parts& parts, QObject* parent = nullptr);

    /// Takes the look and the renderer of the last start.
    void restore();
    void keep();
    /// Shows the whole volume, seen in a direction, as one step.
    void resetView(const ViewDirection& direction);
    /// Sets beam, look, exposure, front, side, curves, box, planes and strokes as in `opened`, the document that
    /// opening gave. The first pane gets the curve that it had, and the whole data fill the picture, seen from the
    /// side. One step.
    void resetAll(const Document& opened);
    void resetFront(const Front& front);
    /// Raises the speckle reduction by `levels`, or lowers it if `levels` is negative. Stops at the weakest and the
    /// strongest.
    void reduceSpeckle(int levels);
    /// Goes from flat to surface to depth light, and around again.
    void nextLighting();

private:
    void connectPanel();
    void connectPicture();
    [[nodiscard]] bool hasStudy() const;
    void setLook(const Look& look);
    void setBeamAxis(BeamAxis axis);
    void setDepth(Document& next, double mm, const VolumeGeometry& geometry);
    void showDocument();
    void takeRenderer();
    void tellPicture(const PictureReport& report);
    void showCost();

    Parts m_parts;
    std::optional<ViewDirection> m_goneFront;  ///< of the flat front that the slider moved last
    Pose m_goneFrom;                           ///< when the slider moved it
    PictureReport m_newest;                    ///< of the picture on the screen
    PacedWords m_cost{[this] { showCost(); }};
    std::optional<PictureReport> m_movement;  ///< of the newest picture that followed the hand and has a frame rate
};

}  // namespace echolucent
