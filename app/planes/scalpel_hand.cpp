#include "app/planes/scalpel_hand.h"

#include <algorithm>

#include "widgets/volume_view/lasso_pointer.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

constexpr Colour drawingColour{0xe8, 0xb0, 0x4b};

/// Height of a camera's picture in the plane of its focal point, mm.
double heightMmOf(const Camera& camera) {
    const PicturePlace centre{0, 0}, below{0, 1};
    const double depth = camera.frame.forward.dot(camera.focalPoint);
    return length(gridPlaceAt(camera, below, depth) - gridPlaceAt(camera, centre, depth));
}

}  // namespace

ScalpelHand::ScalpelHand(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    LassoPointer& lasso = m_parts.picture.lasso();
    connect(&lasso, &LassoPointer::drawn, this, &ScalpelHand::showDrawing);
    connect(&lasso, &LassoPointer::finished, this, &ScalpelHand::cut);
    connect(&m_parts.panel, &RoomPanel::toolChosen, this, &ScalpelHand::setTool);
    connect(&m_parts.panel, &RoomPanel::strokeTakenBack, this, &ScalpelHand::takeBack);
    connect(&m_parts.panel, &RoomPanel::allStrokesTakenBack, this, &ScalpelHand::takeAllBack);
    // A stroke belongs to one camera. If the camera moves, drop the drawing.
    const auto drop = [&lasso] { lasso.cancelDrawing(); };
    connect(&m_parts.model, &DocumentModel::poseChanged, this, drop);
    connect(&m_parts.model, &DocumentModel::motionAngleChanged, this, drop);
    connect(&m_parts.model, &DocumentModel::studyChanged, this, drop);
}

void ScalpelHand::setTool(std::optional<ScalpelTool> tool) {
    m_parts.picture.lasso().setTool(tool);
    if (tool) {
        m_last = *tool;
        m_parts.picture.setFocus();
    }
    m_parts.panel.setTool(tool);
    emit toolChanged();
}

std::optional<ScalpelTool> ScalpelHand::tool() const { return m_parts.picture.lasso().tool(); }

void ScalpelHand::toggle() { setTool(tool() ? std::nullopt : std::optional(m_last)); }

void ScalpelHand::showDrawing(const std::vector<PicturePlace>& places) {
    if (places.empty()) return m_parts.overlay.setDrawing(std::nullopt);
    m_parts.picture.setFocus(Qt::MouseFocusReason);  // so that it gets Enter and Escape
    PictureLine line{places, drawingColour, 2.0};
    if (tool() == ScalpelTool::eraser) {
        // As wide as the eraser cuts, in pixels of a plain screen.
        const double share = m_parts.panel.scalpel().eraserMm / heightMmOf(m_parts.picture.shownCamera());
        line.width = std::max(2.0, share * m_parts.picture.height());
        if (places.size() == 1) line.places.push_back(places.front());
    } else if (places.size() > 2) {
        line.places.push_back(places.front());
    }
    m_parts.overlay.setDrawing(line);
}

void ScalpelHand::cut(const std::vector<PicturePlace>& places) {
    if (!m_parts.picture.volume() || !tool()) return;
    const ScalpelSettings settings = m_parts.panel.scalpel();
    ScalpelStroke stroke;
    stroke.tool = *tool();
    stroke.camera = m_parts.picture.shownCamera();
    stroke.places = places;
    if (stroke.tool == ScalpelTool::eraser)
        stroke.radius = settings.eraserMm / 2.0 / heightMmOf(stroke.camera);
    else
        stroke.side = settings.side;
    if (settings.depthMm) {
        const auto nearest = nearestShownMm(stroke);
        if (!nearest) {
            emit nothingToCut();
            return;
        }
        stroke.depthMm = *nearest + *settings.depthMm;
    }
    if (!problemOf(stroke).empty()) return;  // nothing was drawn
    std::vector<ScalpelStroke> strokes = m_parts.model.document().scene.strokes;
    strokes.push_back(std::move(stroke));
    edit(strokes, tr("cut with the scalpel"));
}

/// The least depth of the visible places that the stroke cuts, in mm along the view from the grid origin. No value if
/// nothing is visible there.
std::optional<double> ScalpelHand::nearestShownMm(const ScalpelStroke& stroke) const {
    constexpr int across = 12;
    const double aspect = static_cast<double>(m_parts.picture.width()) / std::max(1, m_parts.picture.height());
    const Vec3& forward = stroke.camera.frame.forward;
    const double anyDepth = forward.dot(stroke.camera.focalPoint);
    std::optional<double> nearest;
    ScalpelStroke through = stroke;
    through.depthMm.reset();
    for (int row = 0; row < across; ++row)
        for (int column = 0; column < across; ++column) {
            const PicturePlace place{((column + 0.5) / across - 0.5) * aspect, (row + 0.5) / across - 0.5};
            if (!cutsAway(through, gridPlaceAt(stroke.camera, place, anyDepth))) continue;
            if (const auto shown = m_parts.picture.shownAt(place))
                nearest = std::min(nearest.value_or(forward.dot(*shown)), forward.dot(*shown));
        }
    // A narrow stroke may miss all places of the raster, so look along the stroke too.
    constexpr std::size_t mostAlong = 48;
    const std::size_t stride = stroke.places.size() / mostAlong + 1;
    for (std::size_t i = 0; i < stroke.places.size(); i += stride)
        if (const auto shown = m_parts.picture.shownAt(stroke.places[i]))
            nearest = std::min(nearest.value_or(forward.dot(*shown)), forward.dot(*shown));
    return nearest;
}

void ScalpelHand::takeBack(int stroke) {
    std::vector<ScalpelStroke> strokes = m_parts.model.document().scene.strokes;
    if (stroke < 0 || stroke >= static_cast<int>(strokes.size())) return;
    strokes.erase(strokes.begin() + stroke);
    edit(strokes, tr("remove a stroke"));
}

void ScalpelHand::takeAllBack() { edit({}, tr("remove all strokes")); }

void ScalpelHand::edit(const std::vector<ScalpelStroke>& strokes, const QString& what) {
    Document next = m_parts.model.document();
    next.scene.strokes = strokes;
    m_parts.model.edit(next, what);
}

}  // namespace echolucent
