// The scalpel: drawings over the 3D view become strokes of the document.
#pragma once

#include <QObject>
#include <optional>

#include "app/planes/box_in_3d.h"
#include "widgets/document/document_model.h"
#include "widgets/panels/room_panel.h"

namespace echolucent {

class VolumeViewWidget;

class ScalpelHand : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        VolumeViewWidget& picture;
        BoxIn3d& overlay;
        RoomPanel& panel;
    };
    /// What the parameters refer to must outlive this object.
    explicit ScalpelHand(const Parts& parts, QObject* parent = nullptr);

    void setTool(std::optional<ScalpelTool> tool);
    [[nodiscard]] std::optional<ScalpelTool> tool() const;
    /// Puts the tool away. If the hand has none, takes the last one.
    void toggle();
    void takeBack(int stroke);
    void takeAllBack();

signals:
    void toolChanged();
    /// A stroke with a depth was drawn over an empty part of the picture, so there is no surface to count the depth
    /// from.
    void nothingToCut();

private:
    void showDrawing(const std::vector<PicturePlace>& places);
    void cut(const std::vector<PicturePlace>& places);
    [[nodiscard]] std::optional<double> nearestShownMm(const ScalpelStroke& stroke) const;
    void edit(const std::vector<ScalpelStroke>& strokes, const QString& what);

    Parts m_parts;
    ScalpelTool m_last = ScalpelTool::freehand;
};

}  // namespace echolucent
