// The 3D view: a volume seen with an opacity curve, turned by hand.
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
    double drawMilliseconds = 0.0;  ///< in the GUI thread, of the picture before this one; 0 where it is not known yet
    std::optional<double> framesPerSecond = {};  ///< drawn in the newest movement; empty before the first
};

/// Shows what the ray caster makes of a volume, in VTK's scene, with an orientation marker and a scale bar. Pictures
/// are made in another thread, quick ones first and better ones, up to the converged picture, when nothing newer waits
/// (see ProgressiveCaster); this thread never waits for one. On the screen picture, camera, marker and scale bar always
/// belong together. An unchanged view costs nothing. Where a graphics card renders instead, it does so in this thread,
/// and every picture is the best it can make.
///
/// Mouse: left drag orbits, middle or Shift + left drag pans, wheel (about the cursor) or right drag zooms, Ctrl + left
/// drag moves the light where there is one; Escape ends a drag without change. Keys: Ctrl + arrows orbit by 1°, with
/// Shift by 10°, Shift + arrows pan, plus and minus zoom. The picture lies in an OpenGL window of its own inside
/// this widget (twice as cheap as a QOpenGLWidget where OpenGL is software): no sibling widget can be drawn over it,
/// QWidget::grab() does not see it (screenImage() does), and it must not be put in a dock that moves it to another
/// window.
class VolumeViewWidget : public QWidget {
    Q_OBJECT

public:
    /// What is made for a picture is a work, from a change until the converged picture is there.
    explicit VolumeViewWidget(Works& works, QWidget* parent = nullptr);
    ~VolumeViewWidget() override;
    /// Chooses the OpenGL that VTK needs; call before the QApplication is made.
    static void prepareApplication();

    /// Null empties the view. The pose is kept where size and spacing are those of the volume before; otherwise it is
    /// that of the default camera of the present view.
    /// Pointed values are read from `measured`, whose grid is the volume's; null stands for the volume itself.
    void setVolume(std::shared_ptr<const Volume> volume, std::shared_ptr<const Volume> measured = nullptr);
    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// What pointed values are read from; null before there is a volume.
    [[nodiscard]] const std::shared_ptr<const Volume>& measured() const;
    void setClassification(const Classification& classification);
    /// What the next picture is rendered with.
    [[nodiscard]] const Classification& classification() const;
    void setLook(const Look& look);
    [[nodiscard]] const Look& look() const;
    /// Cuts off what is nearer than this many millimetres (>= 0) behind the volume's foremost point along the view; the
    /// plane follows the camera.
    void setNearCut(double mm);
    /// Cuts off what lies before a surface too; it stays where it is in the volume.
    void setCutSurface(const std::optional<CutSurface>& surface);
    /// Shows only what lies in a box; it stays where it is in the volume.
    void setBox(const std::optional<OrientedBox>& box);
    /// Sets the camera by a pose relative to the beam; the near cut stays.
    void setPose(const Pose& pose, BeamAxis beam);
    [[nodiscard]] Pose pose() const;
    /// The pose of the default camera of a view: the widget's box, or the whole volume where it has none, fills the
    /// picture. The second also of a volume of another geometry, which is to be shown next.
    [[nodiscard]] Pose wholeVolume(const Viewpoint& view) const;
    [[nodiscard]] Pose wholeVolume(const Viewpoint& view, const DataBox& box) const;
    /// Width / height; 1 while the view has no size.
    [[nodiscard]] double aspect() const;
    /// Whether a motion plays: its frames are cast in high quality and kept, and come from memory in its next turn.
    void setPlaying(bool playing);
    /// Frames of the motion that are kept in memory.
    [[nodiscard]] int keptFrames() const;
    [[nodiscard]] std::size_t keptFrameBytes() const;
    /// True while the hand drags; what it has moved so far may still be taken back.
    [[nodiscard]] bool dragging() const;
    /// Ends a drag without change; false where there is none.
    bool cancelDrag();
    /// Tells the view in another beam axis's frame. The picture stays as it is.
    void setBeamAxis(BeamAxis axis);
    /// Turns the camera to a view about the volume's centre and takes its near cut; zoom and place in the picture stay.
    void setView(const Viewpoint& view);
    /// From where the person looks now, near cut included.
    [[nodiscard]] Viewpoint view() const;
    /// Takes the default camera of a view, which shows the whole volume.
    void resetView(const Viewpoint& view);

    /// What the converged picture of the present state is made with, at the view's size or, for saving, at another one.
    [[nodiscard]] RayCastSettings settings() const;
    [[nodiscard]] RayCastSettings settingsFor(const QSize& pixels) const;

    /// The newest picture cast, null before the first and where the graphics card renders; it may be smaller than the
    /// view before it is converged.
    [[nodiscard]] std::shared_ptr<const Picture> picture() const;
    /// True where the newest picture is converged, or the graphics card's.
    [[nodiscard]] bool pictureIsFine() const;
    /// True where the newest picture, of whatever quality, is one of the present volume, curve, look and camera.
    [[nodiscard]] bool pictureIsCurrent() const;
    /// True where the newest picture has been drawn and the screen shows it, or nobody can see the view.
    [[nodiscard]] bool pictureIsOnScreen() const;
    /// What is on the screen, marker and scale bar included, in device pixels; null before the widget was ever drawn.
    [[nodiscard]] QImage screenImage();
    /// The same once the picture is converged, for saving. Where it is not there yet it is cast now, while the person
    /// waits.
    [[nodiscard]] QImage convergedImage();
    /// Says in the picture what was done to it; an empty text says nothing.
    void setCaption(const QString& text);
    [[nodiscard]] QString caption() const;
    /// Lines and words over the picture, which are no part of it: saved pictures go without them, but for measurements,
    /// which are painted anew (widgets/picture_labels/measurement_drawing.h). They are drawn once the event
    /// loop runs again, with whatever else has changed until then.
    void setOverlay(const Overlay& overlay);
    [[nodiscard]] const Overlay& overlay() const;
    /// What the scalpel draws over the picture, and what can be held there.
    [[nodiscard]] LassoPointer& lasso();
    [[nodiscard]] GripPointer& grips();
    /// Who marks places over the picture is offered presses before all others; pixels are those of this widget.
    [[nodiscard]] MarkingPointer* createMarkingPointer(MarkingPointer::Offer offer, QObject* parent);
    /// Whether the cursor over the picture is that of a tool; with the scalpel it always is. Over what can be held it
    /// is a hand.
    void setToolCursor(bool on);
    /// The camera of the picture that is shown.
    [[nodiscard]] Camera shownCamera() const;
    /// The place of the grid, mm, that the picture shows there, known along the ray to `step` (units, above 0); empty
    /// where it shows nothing.
    [[nodiscard]] std::optional<Vec3> shownAt(const PicturePlace& place, double step = 1.0) const;
    /// What the scale bar says; a sentence where the volume's spacing is unknown.
    [[nodiscard]] QString scaleText() const;
    /// Chooses who renders. The graphics card can be chosen also where OpenGL is software, which is slow (see
    /// graphicsCardUsable()).
    void setRenderer(RendererChoice choice);
    /// What rendered the newest picture, for the status line.
    [[nodiscard]] QString rendererName() const;
    /// OpenGL's name, or why the graphics card does not render although it might, as a sentence; for a tool tip.
    [[nodiscard]] QString rendererRemark() const;
    /// Whether there is a real graphics card. Known once the first picture was delivered.
    [[nodiscard]] bool graphicsCardUsable() const;

    /// For pickers.
    [[nodiscard]] VolumeScene& scene();

    [[nodiscard]] QSize sizeHint() const override { return {800, 640}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void measuredChanged();  ///< by setVolume(): the next picture is of another phase, or of what a scalpel left of it
    void cameraChanged();    ///< the person has moved the camera: pose() is another
    /// The hand has let go; what it moved stays. Wheel turns have no end.
    void dragEnded();
    /// Escape has ended the drag; pose() and look() are again as before it.
    void dragCancelled();
    void lightChanged();  ///< by the person
    void doubleClicked();
    /// The newest picture was made and drawn into the window's frame buffer.
    void pictureDelivered(const echolucent::PictureReport& report);
    /// It is on the screen.
    void pictureDrawn();
    /// The newest picture needs more memory than there is; the one before stays, and every change tries again.
    void pictureFailed();
    /// Normalised intensity and opacity (per reference step) of what is seen under the cursor; empty where nothing is,
    /// and no opacity in a mode in which the curve plays no part.
    void pointed(std::optional<double> intensity, std::optional<double> opacity);
    void filesDropped(const QStringList& files);

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
    [[nodiscard]] bool rendersLive() const;
    void showPicture(const std::shared_ptr<const CastPicture>& picture);
    void showLive(const PictureRequest& request);
    void render(bool followsHand);
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
