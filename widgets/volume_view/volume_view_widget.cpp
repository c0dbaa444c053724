#include "widgets/volume_view/volume_view_widget.h"

#include <QVTKOpenGLWindow.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QApplication>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QSurfaceFormat>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "widgets/volume_view/progressive_caster.h"
#include "widgets/volume_view/scene/camera_pose.h"
#include "widgets/volume_view/scene/pointed_sample.h"
#include "widgets/volume_view/scene/volume_scene.h"
#include "widgets/volume_view/view_pointer.h"

namespace echolucent {

namespace {

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format = QVTKOpenGLWindow::defaultFormat();
    format.setSamples(0);
    format.setSwapInterval(0);  // a swap that waits would hold up the person's thread
    return format;
}

bool sameGrid(const VolumeGeometry& a, const VolumeGeometry& b) { return a.size == b.size && a.spacing == b.spacing; }

}  // namespace

struct VolumeViewWidget::Parts {
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve = PowerCurve{2, 1.0};
    Look look;
    CameraPose pose;
    CameraPose poseBeforeDrag;
    View fittedView;             ///< the view and ...
    double fittedAspect = 1.0;   ///< ... the shape of the picture that the zoom is measured against
    std::shared_ptr<const CastPicture> shown;
    std::optional<QPointF> cursor;  ///< while it rests over the picture, logical pixels
    bool scheduled = false;

    VolumeScene scene;
    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow;
    QVTKOpenGLWindow* window = nullptr;  ///< owned by the container
    QWidget* container = nullptr;
    ViewPointer* pointer = nullptr;
    // Last, so that its thread has ended before anything above is destroyed.
    ProgressiveCaster caster;
};

void VolumeViewWidget::prepareApplication() {
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    // Only the picture's window is native; its siblings go on being drawn by Qt.
    QCoreApplication::setAttribute(Qt::AA_DontCreateNativeWidgetSiblings);
}

VolumeViewWidget::VolumeViewWidget(QWidget* parent) : QWidget(parent), m_parts(std::make_unique<Parts>()) {
    setObjectName(QStringLiteral("view3d"));
    setAccessibleName(tr("3D view"));
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus);

    Parts& parts = *m_parts;
    parts.renderWindow->SetMultiSamples(0);
    parts.renderWindow->AddRenderer(parts.scene.renderer());
    parts.window = new QVTKOpenGLWindow(parts.renderWindow.Get());
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
    connect(&parts.caster, &ProgressiveCaster::delivered, this, &VolumeViewWidget::showPicture);
    connect(&parts.caster, &ProgressiveCaster::busyChanged, this, &VolumeViewWidget::updateBusy);
}

VolumeViewWidget::~VolumeViewWidget() {
    // The window releases what the scene holds in OpenGL while its context is still there.
    delete m_parts->container;
}

void VolumeViewWidget::connectPointer() {
    ViewPointer* pointer = m_parts->pointer;
    connect(pointer, &ViewPointer::dragStarted, this, [this] {
        m_parts->poseBeforeDrag = m_parts->pose;
        setFocus(Qt::MouseFocusReason);
        pointAt(std::nullopt);
    });
    connect(pointer, &ViewPointer::dragCancelled, this, [this] { followHand(m_parts->poseBeforeDrag); });
    connect(pointer, &ViewPointer::orbited, this,
            [this](double right, double down) { followHand(orbited(m_parts->pose, right, down)); });
    connect(pointer, &ViewPointer::panned, this,
            [this](double right, double down) { followHand(panned(m_parts->pose, right, down)); });
    connect(pointer, &ViewPointer::zoomed, this, [this](double factor) {
        if (!m_parts->volume) return;
        followHand(zoomed(m_parts->pose, factor, zoomLimits(m_parts->volume->geometry())));
    });
    connect(pointer, &ViewPointer::hovered, this, [this](const QPointF& position) { pointAt(position); });
    connect(pointer, &ViewPointer::left, this, [this] { pointAt(std::nullopt); });
    connect(pointer, &ViewPointer::filesDropped, this, &VolumeViewWidget::filesDropped);
    connect(pointer, &ViewPointer::keyPressed, this, [this](QKeyEvent* event) {
        QWidget* focused = QApplication::focusWidget();
        QCoreApplication::sendEvent(focused ? focused : this, event);
    });
}

void VolumeViewWidget::followHand(const CameraPose& pose) {
    if (!m_parts->volume || pose == m_parts->pose) return;
    m_parts->pose = pose;
    schedule();
    emit cameraChanged();
}

void VolumeViewWidget::setVolume(std::shared_ptr<const Volume> volume) {
    Parts& parts = *m_parts;
    if (volume == parts.volume) return;
    const bool keepsCamera = volume && parts.volume && sameGrid(volume->geometry(), parts.volume->geometry());
    const std::shared_ptr<const Volume> before = std::exchange(parts.volume, std::move(volume));
    parts.caster.clear();
    parts.shown.reset();
    parts.scene.setVolume(parts.volume);
    if (!parts.volume) {
        if (isVisible()) parts.renderWindow->Render();
        pointAt(std::nullopt);
    } else if (!keepsCamera) {
        resetView(parts.pose.view);
    }
    schedule();
}

void VolumeViewWidget::setCurve(const OpacityCurve& curve) {
    m_parts->curve = curve;
    schedule();
}

void VolumeViewWidget::setLook(const Look& look) {
    m_parts->look = look;
    m_parts->pose.projection = look.projection;
    schedule();
}

Look VolumeViewWidget::look() const { return m_parts->look; }

void VolumeViewWidget::setNearCut(double mm) {
    m_parts->pose.view.nearCutMm = mm;
    schedule();
}

void VolumeViewWidget::setBeamAxis(BeamAxis axis) {
    View& view = m_parts->pose.view;
    if (view.beamAxis == axis) return;
    const ViewFrame frame = frameOf(view);
    view = viewAlong(frame.forward, frame.down, axis, view.nearCutMm);
}

void VolumeViewWidget::setView(const View& view) {
    Parts& parts = *m_parts;
    const Vec3 centre = parts.volume ? parts.volume->geometry().centreMm() : parts.pose.focalPoint;
    parts.pose = turnedTo(parts.pose, view, centre);
    schedule();
}

View VolumeViewWidget::view() const { return m_parts->pose.view; }

void VolumeViewWidget::resetView(const View& view) {
    Parts& parts = *m_parts;
    parts.fittedView = view;
    parts.fittedAspect = aspect();
    parts.pose.view = view;
    if (parts.volume) parts.pose = fittedPose(parts.volume->geometry(), view, parts.look.projection, aspect());
    schedule();
}

RayCastSettings VolumeViewWidget::settings() const { return settingsFor(pixelSize()); }

RayCastSettings VolumeViewWidget::settingsFor(const QSize& pixels) const {
    const Parts& parts = *m_parts;
    RayCastSettings settings;
    settings.width = pixels.width();
    settings.height = pixels.height();
    settings.camera = cameraFor(parts.pose);
    if (parts.volume) settings.nearPlaneDepthMm = nearPlaneDepthMm(parts.pose.view, parts.volume->geometry());
    settings.step = parts.look.step;
    settings.interpolation = parts.look.interpolation;
    settings.colourMap = parts.look.colourMap;
    if (parts.look.shaded) settings.shading = parts.look.shading;
    return settings;
}

std::shared_ptr<const Picture> VolumeViewWidget::picture() const {
    return m_parts->shown ? m_parts->shown->picture : nullptr;
}

bool VolumeViewWidget::pictureIsFine() const { return m_parts->shown && m_parts->shown->fine; }

bool VolumeViewWidget::pictureIsCurrent() const {
    return m_parts->shown && samePicture(m_parts->shown->request, {m_parts->volume, m_parts->curve, settings()});
}

QString VolumeViewWidget::scaleText() const { return QString::fromStdString(m_parts->scene.scaleBar().text()); }

QImage VolumeViewWidget::screenImage() {
    Parts& parts = *m_parts;
    if (!parts.window->isValid()) return {};
    parts.window->makeCurrent();
    parts.renderWindow->Render();
    const int* size = parts.renderWindow->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    parts.renderWindow->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels.Get(), 0);
    const QImage fromBelow(pixels->GetPointer(0), size[0], size[1], 3 * size[0], QImage::Format_RGB888);
    return fromBelow.mirrored();  // a copy, VTK's rows go up
}

void VolumeViewWidget::schedule() {
    if (m_parts->scheduled) return;
    m_parts->scheduled = true;
    // Several changes in a row (a new volume, its curve, its view) make one picture.
    QMetaObject::invokeMethod(this, &VolumeViewWidget::requestPicture, Qt::QueuedConnection);
    updateBusy();
}

void VolumeViewWidget::requestPicture() {
    Parts& parts = *m_parts;
    parts.scheduled = false;
    const QSize pixels = pixelSize();
    if (parts.volume && isVisible() && !pixels.isEmpty()) {
        parts.caster.request({parts.volume, parts.curve, settings()});
    }
    updateBusy();
}

void VolumeViewWidget::showPicture(const std::shared_ptr<const CastPicture>& picture) {
    Parts& parts = *m_parts;
    parts.shown = picture;
    const PictureRequest& request = picture->request;
    parts.scene.setTransfer(request.curve, request.settings.colourMap);
    parts.scene.show(picture->screen, request.settings.camera);
    // Before its first paint the window draws by itself; drawing here as well would draw twice.
    if (parts.window->isExposed()) parts.renderWindow->Render();
    if (picture->fine && !parts.pointer->dragging()) pointAt(parts.cursor);
    emit pictureDelivered(picture->fine, picture->milliseconds);
}

void VolumeViewWidget::pointAt(std::optional<QPointF> position) {
    Parts& parts = *m_parts;
    if (!position && !parts.cursor) return;
    parts.cursor = position;
    std::optional<PointedSample> sample;
    if (position && parts.shown) {
        const PictureRequest& request = parts.shown->request;
        sample = samplePointedAt(request, position->x() * request.settings.width / width(),
                                 position->y() * request.settings.height / height());
    }
    if (sample) {
        emit pointed(sample->intensity, sample->opacity);
    } else {
        emit pointed(std::nullopt, std::nullopt);
    }
}

void VolumeViewWidget::updateBusy() {
    const bool busy = m_parts->caster.busy() || (m_parts->scheduled && m_parts->volume && isVisible());
    if (busy == std::exchange(m_busy, busy)) return;
    emit busyChanged(busy);
}

QSize VolumeViewWidget::pixelSize() const {
    return size() * m_parts->window->devicePixelRatio();
}

double VolumeViewWidget::aspect() const {
    return size().isEmpty() ? 1.0 : static_cast<double>(width()) / height();
}

void VolumeViewWidget::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    schedule();
}

void VolumeViewWidget::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_parts->caster.clear();
    updateBusy();
}

void VolumeViewWidget::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    refit();
    schedule();
}

/// What filled the picture before its shape changed fills it afterwards.
void VolumeViewWidget::refit() {
    Parts& parts = *m_parts;
    const double before = std::exchange(parts.fittedAspect, aspect());
    if (!parts.volume || parts.fittedAspect == before) return;
    const VolumeGeometry& geometry = parts.volume->geometry();
    const auto fittedHeight = [&](double ofAspect) {
        return fittedPose(geometry, parts.fittedView, parts.look.projection, ofAspect).heightMm;
    };
    parts.pose.heightMm *= fittedHeight(parts.fittedAspect) / fittedHeight(before);
}

void VolumeViewWidget::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_parts->pointer->cancelDrag()) return;
    QWidget::keyPressEvent(event);
}

void VolumeViewWidget::dragEnterEvent(QDragEnterEvent* event) {
    if (!localFiles(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void VolumeViewWidget::dropEvent(QDropEvent* event) {
    const QStringList files = localFiles(event->mimeData());
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    emit filesDropped(files);
}

}  // namespace echolucent
