// The 3D view: shows a volume with an opacity curve. The hand turns it.
#pragma once

#include <QImage>
#include <QSize>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>

#include "processing/classification.h"
#include "processing/picture/look.h"
#include "processing/picture/picture.h"
#include "processing/picture/picture_place.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/picture/renderer_choice.h"
#include "processing/scene/pose.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"
#include "widgets/camera_gestures.h"
#include "widgets/marking_pointer.h"

namespace echolucent {

struct CastPicture;
struct Overlay;
class GripPointer;
class LassoPointer;
struct PictureRequest;
class VolumeScene;
class Works;

/// How a picture was made and what it cost.
struct PictureReport {
    QString quality;           ///< name of its quality, in English
    bool converged = false;    ///< nothing better follows
    bool followsHand = false;  ///< the first picture of a change, not one that refines it
    QSize rays;
    double step = 1.0;              ///< units between samples
    double castMilliseconds = 0.0;  ///< in the casting thread
    double drawMilliseconds = 0.0;  ///< in the GUI thread, of the picture before this one; 0 if not known yet
    std::optional<double> framesPerSecond = {};  ///< drawn in the newest movement; empty before the first
};

/// Shows the ray caster's pictures of a volume in VTK's scene, with an orientation marker and a scale bar. Another
/// thread makes the pictures: quick ones first. Better ones follow, up to the converged picture, while nothing newer
/// waits (see ProgressiveCaster). This thread never waits for one. On the screen picture, camera, marker and scale bar
/// always belong together. An unchanged view costs nothing. If a graphics card draws instead, it does so in this
/// thread, and the other one prepares what it draws.
///
/// Mouse: left drag orbits, middle or Shift + left drag pans, wheel (about the cursor) or right drag zooms, Ctrl + left
/// drag moves the light if there is one; Escape ends a drag without change. Keys: Ctrl + arrows orbit by 1°, with Shift
/// by 10°, Shift + arrows pan, plus and minus zoom. The picture lies in an OpenGL window of its own inside this widget,
/// which is twice as cheap as a QOpenGLWidget if OpenGL is software. So no sibling widget can be drawn over it, and
/// QWidget::grab() does not see it (screenImage() does). It must not be put in a dock that moves it to another window.
class VolumeViewWidget : public QWidget, public SpokenWidget {
    Q_OBJECT

public:
    /// Making a picture counts as a work, from a change until the converged picture is there.
    explicit VolumeViewWidget(Works& works, QWidget* parent = nullptr);
    ~VolumeViewWidget() override;
    /// Chooses the OpenGL that VTK needs; call before the QApplication is made.
    static void prepareApplication();

    /// Null empties the view. If size and spacing are those of the volume before, the pose stays. Else it becomes that
    /// of the present view's default camera. Pointed values are read from `measured`, whose grid is the volume's. Null:
    /// from the volume itself.
    void setVolume(std::shared_ptr<const Volume> volume, std::shared_ptr<const Volume> measured = nullptr);
    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// The volume from which pointed values are read; null before there is one.
    [[nodiscard]] const std::shared_ptr<const Volume>& measured() const;
    void setClassification(const Classification& classification);
    /// The classification of the next picture.
    [[nodiscard]] const Classification& classification() const;
    void setLook(const Look& look);
    [[nodiscard]] const Look& look() const;
    /// Shows only what lies behind the front and in the box of a viewpoint. Both stay in the volume. The viewpoint's
    /// direction plays no part.
    void setLimits(const Viewpoint& limits);
    /// Sets the camera by a pose relative to the beam. Front and box stay.
    void setPose(const Pose& pose, BeamAxis beam);
    [[nodiscard]] Pose pose() const;
    /// The pose of the default camera of a view. The first function fits the widget's box into the picture, or the
    /// whole volume if there is no box. The second fits the view's box, or `box` if the view has none; it also serves a
    /// volume of another geometry that is shown next.
    [[nodiscard]] Pose wholeVolume(const Viewpoint& view) const;
    [[nodiscard]] Pose wholeVolume(const Viewpoint& view, const DataBox& box) const;
    /// Width / height; 1 while the view has no size.
    [[nodiscard]] double aspect() const;
    /// While a motion plays, its frames are cast in high quality and kept. They come from memory in its next turn.
    void setPlaying(bool playing);
    /// Frames of the motion that are kept in memory.
    [[nodiscard]] int keptFrames() const;
    [[nodiscard]] std::size_t keptFrameBytes() const;
    /// True while the hand drags the camera or the light. What has moved so far may still be taken back.
    [[nodiscard]] bool dragging() const;
    /// Ends a drag of the camera, the light or a grip without change; false if there is none.
    bool cancelDrag();
    /// Expresses the view relative to another beam axis. The picture stays.
    void setBeamAxis(BeamAxis axis);
    /// Turns the camera to a view about the volume's centre and takes the view's near cut. Zoom and place in the
    /// picture stay.
    void setView(const Viewpoint& view);
    /// From where the person looks now, near cut included.
    [[nodiscard]] Viewpoint view() const;
    /// Takes the default camera of a view, which shows the whole volume, or the box if there is one.
    void resetView(const Viewpoint& view);

    /// The settings of the converged picture of the present state, at the view's size or, for saving, at another one.
    [[nodiscard]] RayCastSettings settings() const;
    [[nodiscard]] RayCastSettings settingsFor(const QSize& pixels) const;

    /// The newest picture cast. Null before the first, if the graphics card draws, and for a kept frame of a motion.
    /// Before it is converged, it may be smaller than the view.
    [[nodiscard]] std::shared_ptr<const Picture> picture() const;
    /// True if the newest picture is converged.
    [[nodiscard]] bool pictureIsFine() const;
    /// True if the newest picture, of any quality, shows the present volume, curve, look and camera.
    [[nodiscard]] bool pictureIsCurrent() const;
    /// True if the screen shows the newest picture, or nobody can see the view.
    [[nodiscard]] bool pictureIsOnScreen() const;
    /// The picture on the screen with marker and scale bar, in device pixels; null before the widget was ever drawn.
    [[nodiscard]] QImage screenImage();
    /// The converged picture on the screen without the overlay, for saving. If it is not there yet, it is cast now,
    /// while the person waits. If memory is short, emits pictureFailed() and takes the picture on the screen.
    [[nodiscard]] QImage convergedImage();
    /// Dims the picture on the screen, because another is about to take its place. It is drawn at once. Saved pictures
    /// are not dimmed.
    void setDimmed(bool dimmed);
    [[nodiscard]] bool dimmed() const;
    /// Words in the picture that say what was done to it. An empty text shows nothing.
    void setCaption(const QString& text);
    [[nodiscard]] QString caption() const;
    /// Lines and words over the picture. Saved pictures go without them. Measurements are painted into saved pictures
    /// anew (widgets/picture_labels/measurement_drawing.h). The overlay is drawn once the event loop runs again, with
    /// whatever else has changed until then.
    void setOverlay(const Overlay& overlay);
    [[nodiscard]] const Overlay& overlay() const;
    /// The pointers for the scalpel's strokes, and for places that the hand can hold.
    [[nodiscard]] LassoPointer& lasso();
    [[nodiscard]] GripPointer& grips();
    /// A pointer that offers presses to `offer` before all others. Its pixels are those of this widget.
    [[nodiscard]] MarkingPointer* createMarkingPointer(MarkingPointer::Offer offer, QObject* parent);
    /// Whether the cursor over the picture is a tool's. With the scalpel it always is. Over a grip it is a hand.
    void setToolCursor(bool on);
    /// The camera of the picture that is shown.
    [[nodiscard]] Camera shownCamera() const;
    /// The place (grid mm) that the picture shows at `place`, sought with samples `step` units (above 0) apart along
    /// the ray. Empty if the picture shows nothing there.
    [[nodiscard]] std::optional<Vec3> shownAt(const PicturePlace& place, double step = 1.0) const;
    /// The scale bar's words; a sentence if the volume's spacing is unknown.
    [[nodiscard]] QString scaleText() const;
    /// Chooses who renders. The graphics card can be chosen even if OpenGL is software, but then it is slow (see
    /// graphicsCardUsable()).
    void setRenderer(RendererChoice choice);
    /// What rendered the newest picture, for the status line.
    [[nodiscard]] QString rendererName() const;
    /// For a tool tip: OpenGL's name, or a sentence that says why the graphics card does not render.
    [[nodiscard]] QString rendererRemark() const;
    /// Whether there is a real graphics card; known once the first picture was delivered.
    [[nodiscard]] bool graphicsCardUsable() const;

    [[nodiscard]] VolumeScene& scene();

    /// From where the scan is seen, and the caption.
    [[nodiscard]] QString spokenState() const override;
    [[nodiscard]] std::vector<SpokenAction> spokenActions() const override { return cameraActions(); }

    [[nodiscard]] QSize sizeHint() const override { return {800, 640}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void measuredChanged();  ///< by setVolume(): the next picture shows another phase, or what a scalpel left
    void cameraChanged();    ///< the person has moved the camera, so pose() has changed
    /// The hand has let go, and what it moved stays. Wheel turns have no end.
    void dragEnded();
    /// Escape has ended the drag. pose() and look() are as before it.
    void dragCancelled();
    void lightChanged();  ///< by the person
    void doubleClicked();
    /// The newest picture was made and drawn into the window's frame buffer.
    void pictureDelivered(const echolucent::PictureReport& report);
    /// The screen shows the picture.
    void pictureDrawn();
    /// The newest picture needs more memory than there is. The one before stays, and every change tries again.
    void pictureFailed();
    /// Intensity and opacity of what the cursor points at. No intensity if it points at nothing, no opacity in modes
    /// without a curve.
    void pointed(std::optional<double> intensity, std::optional<double> opacity);
    void filesDropped(const QList<QUrl>& files);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    struct Parts;
    void connectPointer();
    void followHand(const CameraPose& camera);
    [[nodiscard]] CameraPose camera() const;
    [[nodiscard]] std::optional<CameraPose> poseAfter(const QKeyEvent& event) const;
    void moveLight(const LightDirection& light);
    void schedule();
    void requestPicture();
    [[nodiscard]] PictureRequest presentRequest(const QSize& pixels) const;
    [[nodiscard]] bool isByCard() const;
    void showPicture(const std::shared_ptr<const CastPicture>& picture);
    void render(bool followsHand);
    void reportOnceDrawn();
    void redrawSoon();
    void redrawWithoutPicture();
    void report(const CastPicture& picture);
    void pointAt(std::optional<QPointF> position);
    void showToolCursor();
    [[nodiscard]] QSize pixelSize() const;

    std::unique_ptr<Parts> m_parts;
    bool m_toolCursor = false;  ///< as setToolCursor()
};

}  // namespace echolucent
