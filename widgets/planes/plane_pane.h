// A pane that shows plane A, B or C, and takes the gestures of the hand.
#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "processing/scene/box.h"
#include "processing/scene/planes.h"
#include "processing/scene/shown_measurement.h"
#include "widgets/accessibility/spoken_widget.h"
#include "widgets/planes/box_grips.h"
#include "widgets/planes/grey_image.h"
#include "widgets/planes/plane_mapping.h"
#include "widgets/planes/plane_resampler.h"
#include "widgets/planes/tube_core_drawing.h"

class QPainter;
class QToolButton;

namespace echolucent {

/// All that a pane shows beside its image.
struct PlaneScene {
    Planes planes{};
    BeamAxis beam = BeamAxis::plusZ;
    DataBox data{};
    double unitMm = 1.0;       ///< length of a step through parallel planes
    bool lengthsKnown = true;  ///< if false, lengths in mm are marked as a guess
    double brightness = 1.0;   ///< of the look
    BoxScene box{};
    std::array<QString, 4> letters{};              ///< letters at the edges: left, right, top, bottom
    bool lettersNameProbe = false;                 ///< one of them says "probe"
    std::optional<QPointF> towardsProbe{};         ///< in the picture, right and down, length 1; no value: not seen
    QString lie{};                                 ///< how the plane lies to the beam, in words; empty: unknown
    std::vector<ShownMeasurement> measurements{};  ///< those that lie in the plane are drawn
    friend bool operator==(const PlaneScene&, const PlaneScene&) = default;
};

/// A left click or drag moves the reference point, a left drag at the rim turns the planes about it. The wheel steps
/// through parallel planes, and over the front's line it moves the front by a unit along its own forward; Ctrl + wheel
/// zooms about the cursor. A middle or Shift + left drag pans. A right drag sets window (to the right) and level
/// (down). Left and Right turn by 1 degree, with Shift by 10, Up and Down step by a unit, Page up and Page down by ten,
/// + and - zoom, Home resets. A double click asks for the whole room. Escape ends a drag without change. The pane does
/// not change the planes: it says how they would be. Objects: planes.a, planes.b, planes.c, each with .reset and
/// .maximise.
class PlanePane : public QWidget, public SpokenWidget {
    Q_OBJECT

public:
    explicit PlanePane(PlaneName plane, QWidget* parent = nullptr);

    [[nodiscard]] PlaneName plane() const { return m_plane; }
    void setScene(const PlaneScene& scene);
    /// Shows nothing, and ignores the hand until the next scene.
    void clear();
    [[nodiscard]] const std::optional<PlaneScene>& scene() const { return m_scene; }
    /// The picture that the pane wants, at its present size in device pixels; no value if it shows nothing.
    [[nodiscard]] std::optional<PlaneRequest> wanted(const std::shared_ptr<const Volume>& volume) const;
    void setSamples(const std::shared_ptr<const PlaneSamples>& samples);
    [[nodiscard]] const QImage& image() const { return m_image; }
    [[nodiscard]] GreyScale greys() const;
    /// What the pane draws over its image, on a transparent ground, with `scale` (> 0) pixels in a pixel of the pane.
    /// Letters and lines are `words` (> 0) times as large as in the pane. Without what only a hand at work needs: hint,
    /// measurement in progress, rim, focus.
    [[nodiscard]] QImage drawings(double scale, double words = 1.0) const;
    /// Dims what the pane shows, because another study is about to take its place.
    void setDimmed(bool dimmed);
    [[nodiscard]] bool dragging() const { return m_drag != Drag::none; }
    /// A click that the pane does not get: a double click that it begins takes no planes back.
    void passOver();
    /// Ends a drag without change. False if there is none.
    bool cancelDrag();

    /// Draws the measurement in progress too.
    void setMarking(const std::optional<ShownMeasurement>& marking);
    /// Draws tube cores too. Saved pictures go without them.
    void setTubeCores(const PlaneTubeCores& tubeCores);
    [[nodiscard]] const PlaneTubeCores& tubeCores() const { return m_tubeCores; }
    /// Shows a sentence that tells what the tool in the hand wants; empty for none.
    void setHint(const QString& sentence);
    [[nodiscard]] const QString& hint() const { return m_hint; }
    /// What the lower left corner says: "offset −2.5 mm", the distance of the plane from the middle of the data along
    /// its view. Needs a scene.
    [[nodiscard]] QString offsetWords() const;
    /// The cursor while a tool is in the hand or a mark lies under the cursor. The rim is not shown then. No value: the
    /// pane's own cursor.
    void setToolCursor(std::optional<Qt::CursorShape> cursor);

    /// Where places of the grid are seen now. Needs a scene.
    [[nodiscard]] PlaneMapping mapping() const;
    /// The drawing of the box, and its grips.
    [[nodiscard]] const BoxDrawing& drawing() const;

    /// The offset of the plane, and how it lies to the beam.
    [[nodiscard]] QString spokenState() const override;
    [[nodiscard]] std::vector<SpokenAction> spokenActions() const override;

    /// The rim is the part nearer than this to the pane's border, in logical pixels.
    static constexpr double rim = 24.0;

    [[nodiscard]] QSize sizeHint() const override { return {320, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {96, 72}; }

signals:
    /// The hand asks for other planes. `what` names the step. During a drag dragging() is true, and dragEnded() or
    /// dragCancelled() follows.
    void changed(const echolucent::Planes& next, const QString& what);
    /// The hand asks for another render box or another front. Otherwise as changed().
    void boxDragged(const echolucent::BoxGrip& grip, const echolucent::BoxDrag& next, const QString& what);
    void dragEnded(const QString& what);
    /// The drag was ended without change: restore the planes and the box as before it.
    void dragCancelled();
    /// A double click, or a click on the button: this pane asks for the whole room, or gives it back.
    void maximiseRequested();
    /// The last click was the first of a double click: take its step back.
    void clickTakenBack(const echolucent::Planes& before, const QString& what);
    /// The pane changed its size, was shown or hidden: it wants another picture.
    void wantsOther();
    /// The place under the cursor, grid mm; no value if the cursor is elsewhere.
    void pointed(const std::optional<echolucent::Vec3>& gridMm);
    /// The wheel asks to move the front along its own forward, mm.
    void frontWheeled(double mm, const QString& what);

protected:
    /// While the pane has the focus, its keys are no shortcuts of the window.
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { none, reference, turn, pan, greys, grip };
    void createButtons();
    void placeButtons();
    [[nodiscard]] Drag leftDragAt(const QPointF& pixel);
    [[nodiscard]] static QString stepName(const BoxGrip& grip);
    [[nodiscard]] Qt::CursorShape cursorOf(const BoxGrip& grip) const;
    [[nodiscard]] bool atRim(const QPointF& pixel) const;
    [[nodiscard]] QPointF referencePixel() const;
    void dragTo(const QPointF& pixel);
    void ask(const Planes& next, const QString& what);
    void showCursor(const QPointF& pixel);
    void turn(double degrees);
    void zoom(double factor, const QPointF& about);
    void reset();
    void makeImage();
    void paintLines(QPainter& painter, double words = 1.0) const;
    void paintBox(QPainter& painter, double words = 1.0) const;
    void paintMeasured(QPainter& painter, bool withMarking, double words = 1.0) const;
    void paintFrame(QPainter& painter, double width) const;
    void paintWords(QPainter& painter, const QSizeF& pane) const;
    void paintHint(QPainter& painter) const;
    void paintRim(QPainter& painter) const;

    PlaneName m_plane;
    std::optional<PlaneScene> m_scene;
    bool m_dimmed = false;
    std::shared_ptr<const PlaneSamples> m_samples;
    QImage m_image;
    mutable std::optional<BoxDrawing> m_drawing;  ///< kept for the present scene and size, once drawing() was called
    GreyScale m_greys;                            ///< of the image
    QToolButton* m_reset = nullptr;
    QToolButton* m_maximise = nullptr;

    Drag m_drag = Drag::none;
    QString m_what;                ///< name of the step that the drag makes
    Planes m_before;               ///< when the drag began
    Planes m_beforeClick;          ///< when the first press of what may become a double click came
    QPointF m_from;                ///< where the drag began
    BoxGrip m_grip;                ///< the dragged part of the box
    BoxScene m_boxBefore;          ///< when the drag began
    PlaneMapping m_mappingBefore;  ///< when the drag began
    bool m_pointerAtRim = false;
    std::optional<ShownMeasurement> m_marking;
    PlaneTubeCores m_tubeCores;
    QString m_hint;
    std::optional<Qt::CursorShape> m_toolCursor;
};

}  // namespace echolucent
