// The measuring tools: places marked in planes and on surfaces become measurements of the document.
#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/planes/box_in_3d.h"
#include "app/study/open_study.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/controls/message_bar.h"
#include "widgets/document/document_model.h"
#include "widgets/marking_pointer.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

class VolumeViewWidget;

/// While the hand has a tool, left clicks mark places in one plane. For a distance they also mark places on surfaces in
/// the 3D view. A press and drag in a plane marks two places. Places of one measurement belong to one pane and one
/// phase: marking elsewhere begins a new measurement. The hand can drag marks of finished measurements in planes, with
/// or without a tool. Until the first measurement is finished, planes say what the tool wants. Every finished
/// measurement and every drag is one step.
class MeasuringHand : public QObject {
    Q_OBJECT

public:
    using Panes = std::array<PlanePane*, 3>;  ///< A, B, C

    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Panes planes;
        VolumeViewWidget& picture;
        BoxIn3d& overlay;
        MessageBar& messages;
    };
    /// What the parameters refer to must outlive this object.
    explicit MeasuringHand(const Parts& parts, QObject* parent = nullptr);

    /// Takes a tool; no value puts the tool away. Drops marked places. If lengths cannot be measured, refuses the tool
    /// and tells the reason. If no study is open, refuses it without a word.
    void setTool(std::optional<MeasurementKind> tool);
    [[nodiscard]] std::optional<MeasurementKind> tool() const { return m_tool; }
    /// Takes a tool, or puts it away if the hand has it.
    void toggle(MeasurementKind tool);
    /// Drops the places marked so far; false if there are none.
    bool dropMarked();
    /// Ends the drag of a mark without change; false if there is none.
    bool cancelDrag();

signals:
    /// Also emitted if a tool was refused.
    void toolChanged();
    /// The last place of a measurement was marked in `pane`, a plane's pane or the picture, and it is in the document.
    void measured(QWidget* pane);

private:
    /// A mark of a finished measurement.
    struct Mark {
        int id;
        std::size_t place;  ///< index in the measurement's placesMm
    };
    void watchPlane(PlanePane& pane);
    void watchPicture();
    [[nodiscard]] MarkingPointer::Take offerInPlane(const PlanePane& pane, const QPointF& pixel);
    void pressInPlane(PlanePane& pane, const QPointF& pixel);
    void dragInPlane(PlanePane& pane, const QPointF& pixel);
    void releaseInPlane(PlanePane& pane, const QPointF& pixel);
    void hoverInPlane(PlanePane& pane, const QPointF& pixel);
    void markInPlane(PlanePane& pane, const QPointF& pixel);
    void markOnSurface(const QPointF& pixel);
    void mark(QObject* pane, const QPointF& pixel, const Vec3& gridMm, double mmPerPixel);
    void finish();
    [[nodiscard]] std::optional<Mark> markAt(const PlanePane& pane, const QPointF& pixel) const;
    void moveMark(PlanePane& pane, const QPointF& pixel);
    void dropWhereItEnded();
    void showMarking();
    void showHints();
    void tell(const QString& sentence);
    [[nodiscard]] PicturePlace placeIn3d(const QPointF& pixel) const;
    [[nodiscard]] Measurement marked() const;
    [[nodiscard]] const VolumeGeometry& geometry() const;

    Parts m_parts;
    std::optional<MeasurementKind> m_tool;
    QObject* m_pane = nullptr;  ///< the pane of the marked places: a plane's pane, or the picture
    bool m_hints = false;       ///< no measurement was finished since the tool was taken
    std::vector<Vec3> m_places;
    int m_phase = 0;                   ///< the phase of the marked places
    std::optional<QPointF> m_pointer;  ///< in m_pane, logical pixels
    QPointF m_pressedAt;
    std::optional<Mark> m_held;        ///< under a press; dragged once the hand has moved off
    std::optional<Document> m_before;  ///< the document when the drag of a mark began
};

}  // namespace echolucent
