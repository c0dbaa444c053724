#include "app/planes/measuring_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/planes/measurement_overlay.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

/// The hand holds a mark within this distance, in logical pixels: targets are 16 pixels wide.
constexpr double markReach = 8.0;
/// Units within which VolumeViewWidget::shownAt() finds the place of a surface along the ray.
constexpr double surfaceStep = 0.1;
/// A place within this distance of the last one, in pixels, is the same place: the second press of a double click.
constexpr double samePlace = 1.0;

QString stepName(const Measurement& measurement) {
    return QStringLiteral("%1 %2").arg(textOf(nameOf(measurement.kind))).arg(measurement.id);
}

/// What a tool wants after `marked` places.
QString hintOf(MeasurementKind tool, std::size_t marked) {
    if (tool == MeasurementKind::distance)
        return marked == 0 ? MeasuringHand::tr("Click the two ends of the distance")
                           : MeasuringHand::tr("Click the other end");
    return marked == 0   ? MeasuringHand::tr("Click three places; the angle is at the second")
           : marked == 1 ? MeasuringHand::tr("Click the place of the angle")
                         : MeasuringHand::tr("Click the third place");
}

/// Why a place without data cannot be marked.
QString refusalOf(const Volume& volume, const Vec3& gridMm) {
    return volume.isCut() && holdsData(volume.withCut(nullptr), gridMm)
               ? MeasuringHand::tr("That place was cut away. Mark a place that is shown.")
               : MeasuringHand::tr("That place lies outside the scan. Mark a place in it.");
}

}  // namespace

MeasuringHand::MeasuringHand(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    for (PlanePane* pane : m_parts.planes) watchPlane(*pane);
    watchPicture();
    connect(&m_parts.model, &DocumentModel::studyChanged, this, [this] { setTool(std::nullopt); });
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, [this] { setTool(std::nullopt); });
    connect(&m_parts.model, &DocumentModel::changed, this, &MeasuringHand::dropWhereItEnded);
}

void MeasuringHand::watchPlane(PlanePane& pane) {
    auto* pointer = new MarkingPointer(
        pane, [this, &pane](const QPointF& pixel) { return offerInPlane(pane, pixel); }, this);
    connect(pointer, &MarkingPointer::pressed, this, [this, &pane](const QPointF& at) { pressInPlane(pane, at); });
    connect(pointer, &MarkingPointer::dragged, this, [this, &pane](const QPointF& at) { dragInPlane(pane, at); });
    connect(pointer, &MarkingPointer::released, this, [this, &pane](const QPointF& at) { releaseInPlane(pane, at); });
    connect(pointer, &MarkingPointer::hovered, this, [this, &pane](const QPointF& at) { hoverInPlane(pane, at); });
    connect(pointer, &MarkingPointer::left, this, [this, &pane] {
        if (m_pane != &pane) return;
        m_pointer.reset();
        showMarking();
    });
}

void MeasuringHand::watchPicture() {
    MarkingPointer* pointer = m_parts.picture.createMarkingPointer(
        [this](const QPointF&) {
            return m_tool && m_parts.openStudy.volume() ? MarkingPointer::Take::click : MarkingPointer::Take::no;
        },
        this);
    connect(pointer, &MarkingPointer::clicked, this, &MeasuringHand::markOnSurface);
    connect(pointer, &MarkingPointer::hovered, this, [this](const QPointF& at) {
        if (m_pane != &m_parts.picture) return;
        m_pointer = at;
        showMarking();
    });
}

void MeasuringHand::setTool(std::optional<MeasurementKind> tool) {
    cancelDrag();
    dropMarked();
    tell({});
    if (tool && m_parts.openStudy.volume()) {
        // Test any measurement now, so that the hand learns of a refusal before it marks places.
        const Measurement any{.placesMm = {{0, 0, 0}, {1, 0, 0}}};
        if (const auto value = measuredValue(any, geometry()); !value) {
            tell(QString::fromStdString(value.error().sentence()));
            tool.reset();
        }
    }
    m_tool = m_parts.openStudy.volume() ? tool : std::nullopt;
    m_hints = m_tool.has_value();
    showHints();
    emit toolChanged();  // this puts the scalpel away before the cursor becomes that of this tool
    for (PlanePane* pane : m_parts.planes) pane->setToolCursor(m_tool ? std::optional(Qt::CrossCursor) : std::nullopt);
    m_parts.picture.setToolCursor(m_tool.has_value());
}

void MeasuringHand::toggle(MeasurementKind tool) { setTool(m_tool == tool ? std::nullopt : std::optional(tool)); }

MarkingPointer::Take MeasuringHand::offerInPlane(const PlanePane& pane, const QPointF& pixel) {
    if (!pane.scene()) return MarkingPointer::Take::no;
    // If a measurement has begun, a press marks its next place, even over a mark.
    m_held = m_places.empty() ? markAt(pane, pixel) : std::nullopt;
    return m_held || m_tool ? MarkingPointer::Take::drag : MarkingPointer::Take::no;
}

void MeasuringHand::pressInPlane(PlanePane& pane, const QPointF& pixel) {
    pane.setFocus(Qt::MouseFocusReason);  // so that it gets Escape
    m_pressedAt = pixel;
    if (!m_held) markInPlane(pane, pixel);
}

void MeasuringHand::dragInPlane(PlanePane& pane, const QPointF& pixel) {
    const bool left = m_before || (pixel - m_pressedAt).manhattanLength() >= MarkingPointer::clickReach;
    if (m_held && left) return moveMark(pane, pixel);
    if (m_pane != &pane || m_held) return;
    m_pointer = pixel;
    showMarking();
}

void MeasuringHand::releaseInPlane(PlanePane& pane, const QPointF& pixel) {
    const std::optional<Mark> held = std::exchange(m_held, std::nullopt);
    if (std::exchange(m_before, std::nullopt)) return m_parts.model.commitPreview();
    const bool left = (pixel - m_pressedAt).manhattanLength() >= MarkingPointer::clickReach;
    // With a tool, a click on a mark marks a place there.
    if (held ? m_tool && !left : left && m_pane == &pane) markInPlane(pane, pixel);
}

void MeasuringHand::hoverInPlane(PlanePane& pane, const QPointF& pixel) {
    const bool overMark = pane.scene() && m_places.empty() && markAt(pane, pixel);
    pane.setToolCursor(overMark ? std::optional(Qt::OpenHandCursor)
                       : m_tool ? std::optional(Qt::CrossCursor)
                                : std::nullopt);
    if (m_pane != &pane) return;
    m_pointer = pixel;
    showMarking();
}

void MeasuringHand::markInPlane(PlanePane& pane, const QPointF& pixel) {
    const Vec3 place = pane.mapping().gridAt(pixel);
    const Volume& volume = *m_parts.openStudy.volume();
    if (!holdsData(volume, place)) return tell(refusalOf(volume, place));
    mark(&pane, pixel, place, pane.mapping().mmPerPixel());
}

void MeasuringHand::markOnSurface(const QPointF& pixel) {
    if (m_tool == MeasurementKind::angle)
        return tell(tr("Angles are measured in planes, so nothing was marked. F3 shows planes A, B and C."));
    if (m_parts.picture.look().mode == RenderMode::mean)
        return tell(tr("Means show no surface, so nothing was marked. Choose another mode."));
    // Until the OTF of a phase is there, the picture still shows the phase before.
    if (m_parts.picture.measured() != m_parts.openStudy.volume() || !m_parts.picture.pictureIsCurrent())
        return tell(tr("The picture of this volume is not there yet, so nothing was marked. Click again once it is."));
    const std::optional<Vec3> place = m_parts.picture.shownAt(placeIn3d(pixel), surfaceStep);
    if (!place)
        return tell(tr("Nothing shows where you clicked, so nothing was marked. Click on what the picture shows."));
    m_parts.picture.setFocus(Qt::MouseFocusReason);
    const Camera camera = m_parts.picture.shownCamera();
    const auto seenAtDepth = [&](const QPointF& at) {
        return gridPlaceAt(camera, placeIn3d(at), camera.frame.forward.dot(*place));
    };
    mark(&m_parts.picture, pixel, *place, length(seenAtDepth(pixel + QPointF(1, 0)) - seenAtDepth(pixel)));
}

void MeasuringHand::mark(QObject* pane, const QPointF& pixel, const Vec3& gridMm, double mmPerPixel) {
    tell({});
    const int phase = phaseOf(m_parts.model.document(), firstPane);
    if (m_pane != pane || m_phase != phase) m_places.clear();
    if (!m_places.empty() && length(gridMm - m_places.back()) < samePlace * mmPerPixel) return;
    m_pointer = pixel;
    m_pane = pane;
    m_phase = phase;
    m_places.push_back(gridMm);
    if (m_places.size() == placesNeeded(*m_tool)) finish();
    showMarking();
}

Measurement MeasuringHand::marked() const {
    return {.kind = *m_tool,
            .ground = m_pane == &m_parts.picture ? MeasurementGround::surface : MeasurementGround::plane,
            .placesMm = m_places,
            .phase = m_phase};
}

void MeasuringHand::finish() {
    Measurement next = marked();
    auto* pane = qobject_cast<QWidget*>(m_pane);
    dropMarked();
    if (const auto value = measuredValue(next, geometry()); !value)
        return tell(QString::fromStdString(value.error().sentence()));
    m_hints = false;
    Document document = m_parts.model.document();
    for (const Measurement& each : document.measurements) next.id = std::max(next.id, each.id + 1);
    document.measurements.push_back(next);
    m_parts.model.edit(document, stepName(next));
    emit measured(pane);
}

bool MeasuringHand::dropMarked() {
    if (m_places.empty()) return false;
    m_places.clear();
    m_pane = nullptr;
    m_pointer.reset();
    showMarking();
    return true;
}

/// Drops marked places if another phase or another plane is shown: nobody could go on with them.
void MeasuringHand::dropWhereItEnded() {
    if (m_places.empty()) return;
    if (!m_parts.openStudy.volume()) {
        dropMarked();
        return;
    }
    const auto* pane = qobject_cast<PlanePane*>(m_pane);
    const bool left =
        pane && (!pane->scene() || !liesInPlane(m_places, pane->mapping().view, planeReachUnits * geometry().unit()));
    if (left || m_phase != phaseOf(m_parts.model.document(), firstPane))
        dropMarked();
    else
        showMarking();
}

std::optional<MeasuringHand::Mark> MeasuringHand::markAt(const PlanePane& pane, const QPointF& pixel) const {
    const PlaneMapping mapping = pane.mapping();
    std::optional<Mark> nearest;
    double least = markReach;
    for (const Measurement& each : m_parts.model.document().measurements) {
        // A place of a surface would leave the surface if it moved in a plane.
        if (each.ground != MeasurementGround::plane) continue;
        const bool drawn = std::ranges::any_of(pane.scene()->measurements,
                                               [&](const ShownMeasurement& shown) { return shown.id == each.id; });
        if (!drawn || !liesInPlane(each.placesMm, mapping.view, planeReachUnits * geometry().unit())) continue;
        for (std::size_t i = 0; i < each.placesMm.size(); ++i) {
            const QPointF from = pixel - mapping.seenAt(each.placesMm[i]);
            const double distance = std::sqrt(QPointF::dotProduct(from, from));
            if (distance > least) continue;
            least = distance;
            nearest = Mark{each.id, i};
        }
    }
    return nearest;
}

void MeasuringHand::moveMark(PlanePane& pane, const QPointF& pixel) {
    if (!m_before) m_before = m_parts.model.document();
    const auto before = std::ranges::find(m_before->measurements, m_held->id, &Measurement::id);
    Document next = m_parts.model.document();
    std::vector<Measurement> measurements = next.measurements;
    const auto moved = std::ranges::find(measurements, m_held->id, &Measurement::id);
    if (before == m_before->measurements.end() || moved == measurements.end()) return;
    const PlaneMapping mapping = pane.mapping();
    // A place beside the plane keeps its distance from it.
    const Vec3 place = before->placesMm[m_held->place] + mapping.gridAt(pixel) - mapping.gridAt(m_pressedAt);
    moved->placesMm[m_held->place] = place;
    if (!holdsData(*m_parts.openStudy.volume(), place) || !measuredValue(*moved, geometry())) return;
    const QString what = tr("move %1").arg(stepName(*moved));
    next.measurements = std::move(measurements);
    m_parts.model.preview(next, what);
}

bool MeasuringHand::cancelDrag() {
    m_held.reset();
    if (!std::exchange(m_before, std::nullopt)) return false;
    m_parts.model.cancelPreview();
    return true;
}

/// Shows the marks so far, with a line to the pointer.
void MeasuringHand::showMarking() {
    Overlay in3d;
    for (PlanePane* pane : m_parts.planes) {
        if (m_pane != pane || m_places.empty()) {
            pane->setMarking(std::nullopt);
            continue;
        }
        Measurement begun = marked();
        begun.id = 0;
        // No line to the pointer if a click there would mark nothing.
        const std::optional<Vec3> next = m_pointer ? std::optional(pane->mapping().gridAt(*m_pointer)) : std::nullopt;
        if (next && holdsData(*m_parts.openStudy.volume(), *next)) begun.placesMm.push_back(*next);
        std::optional<ShownMeasurement> shown = shownMeasurement(begun, geometry());
        // If the pointer is still on a place, there is no value yet.
        if (!shown) shown = ShownMeasurement{.kind = begun.kind, .placesMm = m_places};
        pane->setMarking(shown);
    }
    if (m_pane == &m_parts.picture && !m_places.empty()) {
        in3d = overlayOf({{.placesMm = m_places}});
        if (const auto from = placeInPicture(m_parts.picture.shownCamera(), m_places.back()); from && m_pointer)
            in3d.pictureLines.push_back(rubberLine(*from, placeIn3d(*m_pointer)));
    }
    m_parts.overlay.setMarking(in3d);
    showHints();
}

void MeasuringHand::showHints() {
    for (PlanePane* pane : m_parts.planes)
        pane->setHint(m_hints && m_tool ? hintOf(*m_tool, m_pane == pane ? m_places.size() : 0) : QString());
}

void MeasuringHand::tell(const QString& sentence) {
    const QString topic = QStringLiteral("measuring");
    m_parts.messages.takeBack(topic);
    if (!sentence.isEmpty()) m_parts.messages.showMessage(MessageKind::info, sentence, MessageEnd::soon(topic));
}

PicturePlace MeasuringHand::placeIn3d(const QPointF& pixel) const {
    const double height = std::max(1, m_parts.picture.height());
    return {(pixel.x() - m_parts.picture.width() / 2.0) / height,
            (pixel.y() - m_parts.picture.height() / 2.0) / height};
}

const VolumeGeometry& MeasuringHand::geometry() const { return m_parts.openStudy.volume()->geometry(); }

}  // namespace echolucent
