// Requests, shows and reports the 3D view's pictures.
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "processing/picture/picture_request.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster/ray_caster.h"
#include "widgets/casting/qualities.h"
#include "widgets/volume_view/scene/graphics_card/card_renderer.h"
#include "widgets/volume_view/scene/pointed_sample.h"
#include "widgets/volume_view/volume_view_parts.h"

namespace echolucent {

namespace {
/// The settings of a look at this size, as settingsAt() takes them.
RayCastSettings lookSettings(const Look& look, const QSize& pixels) {
    RayCastSettings settings = rayCastSettings(look);
    settings.width = pixels.width();
    settings.height = pixels.height();
    return settings;
}
}  // namespace

RayCastSettings VolumeViewWidget::settings() const { return settingsFor(pixelSize()); }

RayCastSettings VolumeViewWidget::settingsFor(const QSize& pixels) const {
    return settingsAt(convergedQuality, presentRequest(pixels).settings);
}

PictureRequest VolumeViewWidget::presentRequest(const QSize& pixels) const {
    const Parts& parts = *m_parts;
    PictureRequest request{{{parts.volume, parts.classification}}, lookSettings(parts.look, pixels)};
    request.settings.camera = cameraFor(camera());
    if (parts.volume) request.settings = limitedTo(parts.limits, parts.volume->geometry(), request.settings);
    return request;
}

void VolumeViewWidget::setRenderer(RendererChoice choice) {
    if (choice == m_parts->scene.rendererChoice()) return;
    m_parts->scene.setRenderer(choice);
    schedule();
}

bool VolumeViewWidget::isByCard() const { return m_parts->shown && m_parts->shown->byCard; }

QString VolumeViewWidget::rendererName() const { return isByCard() ? tr("graphics card") : tr("software renderer"); }

QString VolumeViewWidget::rendererRemark() const {
    const VolumeScene& scene = m_parts->scene;
    if (scene.openGlRenderer().empty()) return {};
    const std::string why = scene.whySoftware();
    if (!why.empty()) return QString::fromStdString(why);
    return tr("OpenGL: %1").arg(QString::fromStdString(scene.openGlRenderer()));
}

bool VolumeViewWidget::graphicsCardUsable() const { return m_parts->scene.graphicsCardAtHand(); }

void VolumeViewWidget::setCaption(const QString& text) {
    if (text.toStdString() == m_parts->scene.caption()) return;
    m_parts->scene.setCaption(text.toStdString());
    redrawSoon();
}

void VolumeViewWidget::setDimmed(bool dimmed) {
    Parts& parts = *m_parts;
    if (std::exchange(parts.dimmed, dimmed) == dimmed) return;
    parts.scene.setDimmed(dimmed);
    if (parts.shown && isVisible()) render(false);
}

bool VolumeViewWidget::dimmed() const { return m_parts->dimmed; }

void VolumeViewWidget::setOverlay(const Overlay& overlay) {
    if (overlay == m_parts->scene.overlay()) return;
    m_parts->scene.setOverlay(overlay);
    redrawSoon();
}

const Overlay& VolumeViewWidget::overlay() const { return m_parts->scene.overlay(); }

LassoPointer& VolumeViewWidget::lasso() { return *m_parts->lasso; }

GripPointer& VolumeViewWidget::grips() { return *m_parts->grips; }

MarkingPointer* VolumeViewWidget::createMarkingPointer(MarkingPointer::Offer offer, QObject* parent) {
    return new MarkingPointer(*m_parts->window, std::move(offer), parent);
}

void VolumeViewWidget::setToolCursor(bool on) {
    m_toolCursor = on;
    showToolCursor();
}

void VolumeViewWidget::showToolCursor() {
    m_parts->grips->setCursorBeside(m_toolCursor || m_parts->lasso->tool() ? Qt::CrossCursor : Qt::ArrowCursor);
}

Camera VolumeViewWidget::shownCamera() const { return m_parts->scene.camera(); }

QString VolumeViewWidget::caption() const { return QString::fromStdString(m_parts->scene.caption()); }

VolumeScene& VolumeViewWidget::scene() { return m_parts->scene; }

std::shared_ptr<const Picture> VolumeViewWidget::picture() const {
    return m_parts->shown ? m_parts->shown->panes.front().picture : nullptr;
}

bool VolumeViewWidget::pictureIsFine() const {
    return m_parts->shown && m_parts->shown->converged() && !m_parts->scene.cardGoesOn();
}

bool VolumeViewWidget::pictureIsCurrent() const {
    if (!m_parts->shown) return false;
    PictureRequest shown = m_parts->shown->request;
    // requestPicture() sets findDepth only in the request, and it changes nothing that is seen.
    shown.settings.findDepth = false;
    return samePicture(shown, presentRequest(pixelSize()));
}

bool VolumeViewWidget::pictureIsOnScreen() const {
    return !m_parts->window->isExposed() || !m_parts->meter->waitsForScreen();
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

QImage VolumeViewWidget::convergedImage() {
    Parts& parts = *m_parts;
    // A card's picture never leaves the window.
    if (parts.volume && parts.window->isValid() && (isByCard() || !pictureIsFine() || !pictureIsCurrent())) {
        const RayCastSettings converged = settings();
        try {
            const std::optional<Picture> picture = castRays(*parts.volume, parts.classification, converged);
            parts.scene.show(std::make_shared<const ScreenPicture>(screenPicture(*picture)), converged.camera);
        } catch (const std::bad_alloc&) {
            emit pictureFailed();  // then the picture on the screen is saved
        }
    }
    // Grips and the like are no part of a saved picture.
    const Overlay overlay = parts.scene.overlay();
    parts.scene.setOverlay({});
    parts.scene.setDimmed(false);
    const QImage image = screenImage();
    parts.scene.setOverlay(overlay);
    parts.scene.setDimmed(parts.dimmed);
    if (overlay != Overlay{} || parts.dimmed) redrawSoon();
    return image;
}

void VolumeViewWidget::schedule() {
    if (m_parts->volume && isVisible()) m_parts->asks.begin();
    // Several changes in a row (a new volume, its curve, its view) make one picture.
    if (std::exchange(m_parts->scheduled, true)) return;
    QMetaObject::invokeMethod(this, &VolumeViewWidget::requestPicture, Qt::QueuedConnection);
}

void VolumeViewWidget::requestPicture() {
    Parts& parts = *m_parts;
    parts.scheduled = false;
    const QSize pixels = pixelSize();
    if (parts.volume && isVisible() && !pixels.isEmpty()) {
        PictureRequest request = presentRequest(pixels);
        request.settings.findDepth = parts.scene.wantsDepth();
        parts.caster.request(request, parts.scene.rendererInUse() == RendererChoice::graphicsCard);
    }
    if (!parts.caster.quickPictureComes()) redrawWithoutPicture();  // the request was equal to the newest one
    if (!parts.scheduled) parts.asks.end();
}

void VolumeViewWidget::showPicture(const std::shared_ptr<const CastPicture>& picture) {
    Parts& parts = *m_parts;
    parts.shown = picture;
    const PictureRequest& request = picture->request;
    parts.scene.setTransfer(request.panes.front().classification, request.settings.colourMap);
    const CastPane& pane = picture->panes.front();
    if (pane.card)
        parts.scene.show(pane.card, pane.known);
    else
        parts.scene.show(pane.screen, request.settings.camera);
    render(picture->followsHand);
    reportOnceDrawn();
}

/// A card draws the picture at rest in several drawings, so that the window goes on meanwhile.
void VolumeViewWidget::reportOnceDrawn() {
    Parts& parts = *m_parts;
    if (!parts.scene.cardGoesOn()) {
        parts.cardDraws.end();
        report(*parts.shown);
        return;
    }
    parts.cardDraws.begin();
    if (std::exchange(parts.drawsOn, parts.shown.get()) == parts.shown.get()) return;
    // A timer lets the hand's events through first. A newer picture does this anew.
    QTimer::singleShot(0, this, [this, picture = parts.shown] {
        if (m_parts->drawsOn == picture.get()) m_parts->drawsOn = nullptr;
        if (picture != m_parts->shown) return;
        if (m_parts->scene.cardGoesOn()) render(false);
        reportOnceDrawn();
    });
}

/// A drag changes caption and lines with every move of the hand. If the drag also changes the picture, draw picture,
/// caption and lines in one go: one drawing of all takes no longer than one of the lines.
void VolumeViewWidget::redrawSoon() {
    if (!m_parts->shown || std::exchange(m_parts->toRedraw, true)) return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            if (!m_parts->scheduled && !m_parts->caster.quickPictureComes()) redrawWithoutPicture();
        },
        Qt::QueuedConnection);
}

void VolumeViewWidget::redrawWithoutPicture() {
    if (!std::exchange(m_parts->toRedraw, false) || !m_parts->shown) return;
    render(false);
    // Another card begins the picture anew.
    if (m_parts->scene.cardGoesOn()) reportOnceDrawn();
}

void VolumeViewWidget::render(bool followsHand) {
    Parts& parts = *m_parts;
    parts.toRedraw = false;
    // The window draws its first paint by itself. Drawing here as well would draw twice.
    if (!parts.window->isExposed()) return;
    QElapsedTimer timer;
    timer.start();
    if (parts.shown->byCard && !parts.shown->followsHand) parts.scene.setCardPatience(CardRenderer::bandMilliseconds);
    parts.renderWindow->Render();
    parts.scene.setCardPatience(std::numeric_limits<double>::infinity());
    parts.meter->rendered(static_cast<double>(timer.nsecsElapsed()) * 1e-6, followsHand);
    // Only after a drawing is it known that there is a graphics card, or that it failed.
    const bool byCard = parts.scene.rendererInUse() == RendererChoice::graphicsCard;
    if (byCard != isByCard()) schedule();
}

void VolumeViewWidget::report(const CastPicture& picture) {
    Parts& parts = *m_parts;
    if (picture.converged() && !parts.pointer->dragging()) pointAt(parts.cursor);
    PictureReport report{.quality = QString::fromLatin1(qualities[picture.quality].name),
                         .converged = picture.converged(),
                         .followsHand = picture.followsHand,
                         .rays = {picture.settings.width, picture.settings.height},
                         .step = picture.settings.step,
                         .castMilliseconds = picture.milliseconds,
                         .drawMilliseconds = parts.meter->drawingMilliseconds(),
                         .framesPerSecond = parts.meter->framesPerSecond()};
    // What the casting thread did was only to prepare.
    if (picture.byCard) {
        parts.caster.drawnByCard(picture.settings, parts.scene.cardMilliseconds());
        report.castMilliseconds += parts.scene.cardMilliseconds();
    }
    emit pictureDelivered(report);
}

void VolumeViewWidget::pointAt(std::optional<QPointF> position) {
    Parts& parts = *m_parts;
    if (!position && !parts.cursor) return;
    parts.cursor = position;
    std::optional<PointedSample> sample;
    if (position && parts.shown) {
        // The rays and steps of the shown picture, not of the requested one.
        const RayCastSettings& shown = parts.shown->settings;
        sample = samplePointedAt(parts.shown->request.panes.front(), shown, position->x() * shown.width / width(),
                                 position->y() * shown.height / height());
    }
    if (sample) {
        const RenderMode mode = parts.shown->settings.mode;
        // The picture may show quiet voxels, but the values told are those of the voxels that were read. Modes that use
        // a whole ray keep the picture's value.
        if (mode == RenderMode::direct && parts.measured != parts.volume)
            sample->intensity = measuredAt(*parts.measured, sample->gridMm).value_or(sample->intensity);
        const bool classified = mode == RenderMode::direct;
        emit pointed(sample->intensity, classified ? std::optional(sample->opacity) : std::nullopt);
    } else {
        emit pointed(std::nullopt, std::nullopt);
    }
}

std::optional<Vec3> VolumeViewWidget::shownAt(const PicturePlace& place, double step) const {
    const Parts& parts = *m_parts;
    if (!parts.shown) return std::nullopt;
    RayCastSettings settings = parts.shown->settings;
    settings.step = step;
    const auto sample =
        samplePointedAt(parts.shown->request.panes.front(), settings, settings.width / 2.0 + place[0] * settings.height,
                        settings.height / 2.0 + place[1] * settings.height);
    return sample ? std::optional(sample->gridMm) : std::nullopt;
}

QSize VolumeViewWidget::pixelSize() const { return size() * m_parts->window->devicePixelRatio(); }

double VolumeViewWidget::aspect() const { return size().isEmpty() ? 1.0 : static_cast<double>(width()) / height(); }

}  // namespace echolucent
