// Takes the 3D view's input: volume, curve, look and pose, and the hand's moves.
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <utility>

#include "widgets/camera_gestures.h"
#include "widgets/volume_view/volume_view_parts.h"

namespace echolucent {

namespace {

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format = QVTKOpenGLWindow::defaultFormat();
    format.setSamples(0);
    format.setSwapInterval(0);  // else a swap would wait and block the GUI thread
    return format;
}

bool sameGrid(const VolumeGeometry& a, const VolumeGeometry& b) { return a.size == b.size && a.spacing == b.spacing; }

}  // namespace

void VolumeViewWidget::prepareApplication() {
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    // Only the picture's window is native. Qt goes on drawing its siblings.
    QCoreApplication::setAttribute(Qt::AA_DontCreateNativeWidgetSiblings);
}

VolumeViewWidget::VolumeViewWidget(Works& works, QWidget* parent)
    : QWidget(parent), m_parts(std::make_unique<Parts>(works)) {
    setObjectName(QStringLiteral("view3d"));
    setAccessibleName(tr("3D view"));
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus);

    Parts& parts = *m_parts;
    parts.renderWindow->SetMultiSamples(0);
    parts.renderWindow->AddRenderer(parts.scene.renderer());
    parts.window = new QVTKOpenGLWindow(parts.renderWindow.Get());
    parts.window->setObjectName(QStringLiteral("view3d.surface"));
    parts.window->setFormat(surfaceFormat());
    // The hand moves the pose (ViewPointer), and the scene's camera follows with the picture.
    parts.renderWindow->GetInteractor()->SetInteractorStyle(nullptr);
    parts.container = QWidget::createWindowContainer(parts.window, this);
    parts.container->setObjectName(QStringLiteral("view3d.window"));
    parts.container->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(parts.container);
    parts.pointer = new ViewPointer(parts.window, this);
    connectPointer();
    // Filters that are installed later come first. So grips come before the camera, and the left button draws while a
    // tool is set.
    parts.grips = new GripPointer(
        parts.window, [this] { return shownCamera(); }, this);
    parts.lasso = new LassoPointer(parts.window, this);
    connect(parts.lasso, &LassoPointer::toolChanged, this, &VolumeViewWidget::showToolCursor);
    parts.meter = new FrameMeter(parts.window, this);
    connect(parts.meter, &FrameMeter::pictureDrawn, this, [this](double milliseconds) {
        m_parts->caster.drawn(milliseconds);
        emit pictureDrawn();
    });
    connect(parts.window, &QWindow::screenChanged, this, [this] {
        m_parts->scene.forgetCard();
        redrawSoon();
    });
    connect(&parts.caster, &ProgressiveCaster::delivered, this, &VolumeViewWidget::showPicture);
    connect(&parts.caster, &ProgressiveCaster::failed, this, [this] {
        redrawWithoutPicture();
        emit pictureFailed();
    });
}

VolumeViewWidget::~VolumeViewWidget() {
    // The window must free the scene's OpenGL objects while its context still exists.
    delete m_parts->container;
}

void VolumeViewWidget::connectPointer() {
    ViewPointer* pointer = m_parts->pointer;
    connect(pointer, &ViewPointer::dragStarted, this, [this] {
        m_parts->poseBeforeDrag = m_parts->pose;
        m_parts->lightBeforeDrag = m_parts->look.light;
        setFocus(Qt::MouseFocusReason);
        pointAt(std::nullopt);
    });
    connect(pointer, &ViewPointer::dragEnded, this, &VolumeViewWidget::dragEnded);
    connect(pointer, &ViewPointer::dragCancelled, this, [this] {
        setPose(m_parts->poseBeforeDrag, m_parts->beam);
        if (m_parts->lightBeforeDrag != m_parts->look.light) {
            m_parts->look.light = m_parts->lightBeforeDrag;
            schedule();
        }
        emit dragCancelled();
    });
    connect(pointer, &ViewPointer::orbited, this,
            [this](double right, double down) { followHand(orbited(camera(), right, down)); });
    connect(pointer, &ViewPointer::panned, this,
            [this](double right, double down) { followHand(panned(camera(), right, down)); });
    connect(pointer, &ViewPointer::zoomed, this, [this](double factor) {
        if (!m_parts->volume) return;
        followHand(zoomed(camera(), factor, zoomLimits(m_parts->volume->geometry())));
    });
    connect(pointer, &ViewPointer::zoomedAbout, this, [this](double right, double down, double factor) {
        if (!m_parts->volume) return;
        followHand(zoomedAbout(camera(), right, down, factor, zoomLimits(m_parts->volume->geometry())));
    });
    connect(pointer, &ViewPointer::lightMoved, this,
            [this](double right, double down) { moveLight(moved(m_parts->look.light, right, down)); });
    connect(pointer, &ViewPointer::hovered, this, [this](const QPointF& position) { pointAt(position); });
    connect(pointer, &ViewPointer::left, this, [this] { pointAt(std::nullopt); });
    connect(pointer, &ViewPointer::doubleClicked, this, &VolumeViewWidget::doubleClicked);
    connect(pointer, &ViewPointer::filesDropped, this, &VolumeViewWidget::filesDropped);
    connect(pointer, &ViewPointer::keyPressed, this, [this](QKeyEvent* event) {
        QWidget* focused = QApplication::focusWidget();
        QCoreApplication::sendEvent(focused ? focused : this, event);
    });
}

CameraPose VolumeViewWidget::camera() const {
    const Parts& parts = *m_parts;
    const DataBox box = parts.volume ? parts.volume->dataBox() : DataBox(VolumeGeometry{});
    return cameraPoseOf(parts.pose, parts.beam, box, parts.look.projection, aspect());
}

void VolumeViewWidget::followHand(const CameraPose& camera) {
    if (!m_parts->volume) return;
    const Pose moved = movedPose(m_parts->pose, this->camera(), camera, m_parts->volume->dataBox(), aspect());
    if (moved == m_parts->pose) return;
    setPose(moved, m_parts->beam);
    emit cameraChanged();
}

void VolumeViewWidget::moveLight(const LightDirection& light) {
    Look& look = m_parts->look;
    const bool seen = look.lighting != Lighting::flat && look.mode == RenderMode::direct;
    if (!m_parts->volume || !seen || light == look.light) return;
    look.light = light;
    schedule();
    emit lightChanged();
}

void VolumeViewWidget::setVolume(std::shared_ptr<const Volume> volume, std::shared_ptr<const Volume> measured) {
    Parts& parts = *m_parts;
    if (!measured) measured = volume;
    if (std::exchange(parts.measured, measured) != measured) emit measuredChanged();
    if (volume == parts.volume) return;
    if (volume && parts.volume && volume->isSameScanAs(*parts.volume)) {
        // Only the scalpel's cut has changed. The caster keeps what it knows, and the picture stays until the next one
        // is there.
        parts.volume = std::move(volume);
        parts.scene.setCut(parts.volume);
        schedule();
        return;
    }
    const bool keepsCamera = volume && parts.volume && sameGrid(volume->geometry(), parts.volume->geometry());
    const std::shared_ptr<const Volume> before = std::exchange(parts.volume, std::move(volume));
    parts.caster.clear();
    parts.shown.reset();
    parts.scene.setVolume(parts.volume);
    if (!parts.volume) {
        if (isVisible()) parts.renderWindow->Render();
        pointAt(std::nullopt);
    } else if (!keepsCamera) {
        parts.pose = wholeVolume(view());
    }
    schedule();
}

const std::shared_ptr<const Volume>& VolumeViewWidget::volume() const { return m_parts->volume; }

const std::shared_ptr<const Volume>& VolumeViewWidget::measured() const { return m_parts->measured; }

void VolumeViewWidget::setClassification(const Classification& classification) {
    if (classification == m_parts->classification) return;
    m_parts->classification = classification;
    schedule();
}

const Classification& VolumeViewWidget::classification() const { return m_parts->classification; }

void VolumeViewWidget::setLook(const Look& look) {
    if (look == m_parts->look) return;
    m_parts->look = look;
    schedule();
}

const Look& VolumeViewWidget::look() const { return m_parts->look; }

void VolumeViewWidget::setPlaying(bool playing) { m_parts->caster.setPlaying(playing); }

int VolumeViewWidget::keptFrames() const { return m_parts->caster.keptFrames(); }
std::size_t VolumeViewWidget::keptFrameBytes() const { return m_parts->caster.keptFrameBytes(); }

void VolumeViewWidget::setLimits(const Viewpoint& limits) {
    const Viewpoint before = m_parts->limits;
    if (limits.frontPlane == before.frontPlane && limits.cutSurface == before.cutSurface && limits.box == before.box)
        return;
    m_parts->limits = limits;
    schedule();
}

void VolumeViewWidget::setPose(const Pose& pose, BeamAxis beam) {
    if (pose == m_parts->pose && beam == m_parts->beam) return;
    m_parts->pose = pose;
    m_parts->beam = beam;
    schedule();
}

Pose VolumeViewWidget::pose() const { return m_parts->pose; }

bool VolumeViewWidget::dragging() const { return m_parts->pointer->dragging(); }

void VolumeViewWidget::setBeamAxis(BeamAxis axis) {
    if (m_parts->beam == axis) return;
    const ViewFrame frame = frameOf(view());
    const CameraPose before = camera();
    m_parts->pose.direction = directionOf(viewAlong(frame.forward, frame.down, axis));
    m_parts->beam = axis;
    // The height of the picture at magnification 1 depends on the beam.
    m_parts->pose.magnification *= camera().heightMm / before.heightMm;
}

void VolumeViewWidget::setView(const Viewpoint& view) {
    setLimits(view);
    setBeamAxis(view.beamAxis);
    m_parts->pose = turnedTo(m_parts->pose, view.beamAxis, directionOf(view));
    schedule();
}

Viewpoint VolumeViewWidget::view() const {
    Viewpoint view = viewpointOf(m_parts->beam, m_parts->pose.direction);
    view.frontPlane = m_parts->limits.frontPlane;
    view.cutSurface = m_parts->limits.cutSurface;
    view.box = m_parts->limits.box;
    return view;
}

void VolumeViewWidget::resetView(const Viewpoint& view) {
    setLimits(view);
    setPose(wholeVolume(view), view.beamAxis);
    schedule();
}

Pose VolumeViewWidget::wholeVolume(const Viewpoint& view) const {
    if (!m_parts->volume) return {directionOf(view), {0, 0, 0}, 1.0};
    Viewpoint limited = view;
    limited.box = m_parts->limits.box;
    return wholeVolume(limited, m_parts->volume->dataBox());
}

Pose VolumeViewWidget::wholeVolume(const Viewpoint& view, const DataBox& box) const {
    return wholeVolumePose(box, view, m_parts->look.projection, aspect());
}

void VolumeViewWidget::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    schedule();
}

void VolumeViewWidget::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_parts->caster.clear();
    m_parts->asks.end();
}

void VolumeViewWidget::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    schedule();
}

bool VolumeViewWidget::cancelDrag() { return m_parts->pointer->cancelDrag() || m_parts->grips->cancelDrag(); }

bool VolumeViewWidget::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && poseAfter(*static_cast<QKeyEvent*>(event))) {
        event->accept();  // the picture's keys come before the window's
        return true;
    }
    return QWidget::event(event);
}

void VolumeViewWidget::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && (cancelDrag() || m_parts->lasso->cancelDrawing())) return;
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && m_parts->lasso->closePolygon()) return;
    const std::optional<CameraPose> moved = poseAfter(*event);
    if (!moved) return QWidget::keyPressEvent(event);
    if (!dragging()) followHand(*moved);
}

QString VolumeViewWidget::spokenState() const {
    if (!m_parts->volume) return tr("no volume is shown");
    const ViewDirection& from = m_parts->pose.direction;
    const QString seen = tr("azimuth %1°, elevation %2°, roll %3° to the beam")
                             .arg(from.azimuth, 0, 'f', 0)
                             .arg(from.elevation, 0, 'f', 0)
                             .arg(from.roll, 0, 'f', 0);
    return caption().isEmpty() ? seen : seen + QStringLiteral(". ") + caption();
}

/// The camera after a key of the picture; no value for another key.
std::optional<CameraPose> VolumeViewWidget::poseAfter(const QKeyEvent& event) const {
    if (!m_parts->volume) return std::nullopt;
    const std::optional<CameraKey> key = cameraKeyOf(event);
    if (!key) return std::nullopt;
    switch (key->moves) {
        case CameraDrag::orbit: return orbited(camera(), key->shares.x(), key->shares.y());
        case CameraDrag::pan: return panned(camera(), key->shares.x(), key->shares.y());
        default: return zoomed(camera(), key->factor, zoomLimits(m_parts->volume->geometry()));
    }
}

void VolumeViewWidget::dragEnterEvent(QDragEnterEvent* event) {
    if (!filesIn(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void VolumeViewWidget::dropEvent(QDropEvent* event) {
    const QList<QUrl> files = filesIn(event->mimeData());
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    emit filesDropped(files);
}

}  // namespace echolucent
