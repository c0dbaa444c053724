// The picture's panel and status line on the document.
#pragma once

#include <QObject>
#include <optional>

#include "app/settings/settings.h"
#include "widgets/document/document_model.h"
#include "widgets/paced_words.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

class OtfEditor;
class RunStatus;
class ViewPanel;

/// Makes steps of what is set in the panel, shows there what the document says, and remembers the look for the next
/// start. The renderer is a matter of the machine and no part of the document.
class PictureControls : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
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
    /// Shows the whole volume, seen along the beam, as a step of the document.
    void resetView();
    /// Look, cut, beam, view and curves as in `opened`, the document that opening gave; one step.
    void resetAll(const Document& opened);
    /// The cut as in `opened`.
    void resetCut(const Document& opened);
    /// Takes the speckle reduction so many levels on, back where it is negative, up to the ends.
    void reduceSpeckle(int levels);
    /// Flat, surface, depth, and around again.
    void nextLighting();

private:
    void connectPanel();
    void connectPicture();
    [[nodiscard]] bool hasStudy() const;
    void setLook(const Look& look);
    void setBeamAxis(BeamAxis axis);
    void showDocument();
    void takeRenderer();
    void tellPicture(const PictureReport& report);
    void showCost();

    Parts m_parts;
    PictureReport m_newest;  ///< of the picture on the screen
    PacedWords m_cost{[this] { showCost(); }};
    std::optional<PictureReport> m_movement;  ///< of the newest picture that followed the hand
};

}  // namespace echolucent
