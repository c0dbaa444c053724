#include "app/planes/box_in_3d.h"

#include <algorithm>

#include "app/picture/picture_to_keep.h"
#include "app/planes/measurement_overlay.h"
#include "app/planes/scene_colour.h"
#include "processing/document/box_editing.h"
#include "widgets/planes/plane_colours.h"
#include "widgets/volume_view/grip_pointer.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {

constexpr double stemShare = 0.08;    // of the data's extent along the front's forward
constexpr double handleRadius = 7.0;  // plain pixels
constexpr double faceRadius = 5.0, edgeRadius = 3.5, cornerRadius = 3.5, centreRadius = 4.0;  // plain pixels

/// Where the faces of a grip meet: the middle of a face or of an edge, a corner, or the centre.
Vec3 placeOf(const OrientedBox& box, const std::vector<BoxFace>& faces) {
    Vec3 place = box.centreMm;
    for (const BoxFace& face : faces) place += outwardNormal(box, face) * (0.5 * box.sizeMm[face.axis]);
    return place;
}

/// Every combination of faces that meet: 6 faces, 12 edges, 8 corners, and the centre.
std::vector<std::vector<BoxFace>> allGrips() {
    std::vector<std::vector<BoxFace>> grips;
    for (int right = -1; right <= 1; ++right)
        for (int down = -1; down <= 1; ++down)
            for (int forward = -1; forward <= 1; ++forward) {
                std::vector<BoxFace> faces;
                if (right != 0) faces.push_back({0, right});
                if (down != 0) faces.push_back({1, down});
                if (forward != 0) faces.push_back({2, forward});
                grips.push_back(std::move(faces));
            }
    return grips;
}

}  // namespace

BoxIn3d::BoxIn3d(DocumentModel& model, OpenStudy& openStudy, VolumeViewWidget& picture, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_picture(picture) {
    connect(&m_model, &DocumentModel::changed, this, &BoxIn3d::show);
    connect(&m_openStudy, &OpenStudy::volumeChanged, this, &BoxIn3d::show);
    connect(&m_picture, &VolumeViewWidget::measuredChanged, this, &BoxIn3d::show);
    GripPointer& grips = m_picture.grips();
    connect(&grips, &GripPointer::dragStarted, this, [this](std::size_t grip) {
        m_holdsFront = m_hasHandle && grip == 0;
        m_held = m_holdsFront ? Grip{} : m_grips.at(grip - (m_hasHandle ? 1 : 0));
        m_before = m_model.document();
        m_picture.setFocus(Qt::MouseFocusReason);
    });
    connect(&grips, &GripPointer::dragged, this, [this](std::size_t, const Vec3& mm) { drag(mm); });
    connect(&grips, &GripPointer::dragEnded, this, [this] {
        m_before.reset();
        m_model.commitPreview();
    });
    // What the hand holds belongs to the study before.
    connect(&m_openStudy, &OpenStudy::aboutToReplace, &grips, &GripPointer::cancelDrag);
    connect(&grips, &GripPointer::dragCancelled, this, [this] {
        m_before.reset();
        m_model.cancelPreview();
    });
}

void BoxIn3d::setDrawing(const std::optional<PictureLine>& drawing) {
    m_drawing = drawing;
    show();
}

void BoxIn3d::showFront(bool shown) {
    m_frontIsShown = shown;
    show();
}

void BoxIn3d::setMarking(const Overlay& marking) {
    if (marking == m_marking) return;
    m_marking = marking;
    show();
}

void BoxIn3d::setTubeCores(const Overlay& tubeCores) {
    if (tubeCores == m_tubeCores) return;
    m_tubeCores = tubeCores;
    show();
}

void BoxIn3d::show() {
    Overlay overlay;
    if (m_openStudy.volume()) {
        append(overlay, m_tubeCores);
        if (m_model.document().scene.planes.linesIn3d) addPlanes(overlay);
        std::vector<Vec3> places = addBox(overlay);
        const std::optional<Vec3> handle = addFront(overlay);
        m_hasHandle = handle.has_value();
        if (handle) places.insert(places.begin(), *handle);
        m_picture.grips().setGrips(std::move(places));
        addMeasurements(overlay);
    }
    if (m_drawing) overlay.pictureLines.push_back(*m_drawing);
    m_picture.setOverlay(overlay);
}

void BoxIn3d::addMeasurements(Overlay& overlay) const {
    append(overlay, overlayOf(measurementsIn(m_picture, m_openStudy, m_model.document())));
    append(overlay, m_marking);
}

void BoxIn3d::addPlanes(Overlay& overlay) const {
    const Document& document = m_model.document();
    const DataBox data = m_openStudy.volume()->dataBox();
    const OrientedBox whole = orientedBoxOf(data);
    const Planes& planes = document.scene.planes;
    for (const PlaneName plane : allPlaneNames) {
        const BoxSection section =
            sectionOf(whole, referencePointOf(planes, data), frameOf(plane, planes, document.beam.axis).forward);
        for (std::size_t i = 0; i < section.corners.size(); ++i)
            overlay.spaceLines.push_back({section.corners[i], section.corners[(i + 1) % section.corners.size()],
                                          sceneColourOf(colourOf(plane)), 1.5});
    }
}

/// The box. The result is where the hand holds it, in the order of m_grips; empty if there is no box.
std::vector<Vec3> BoxIn3d::addBox(Overlay& overlay) {
    const Document& document = m_model.document();
    const Box& set = document.scene.box;
    m_grips.clear();
    if (!set.on) return {};
    const OrientedBox box = orientedBoxOf(set, document.beam.axis);
    const Vec3 looking = frameOf(viewpointOf(document)).forward;
    const auto facesViewer = [&](const BoxFace& face) { return outwardNormal(box, face).dot(looking) < 0.0; };
    m_grips = allGrips();
    // The hand holds the grip nearest to the viewer.
    std::ranges::stable_sort(m_grips, {}, [&](const Grip& grip) { return looking.dot(placeOf(box, grip)); });
    std::vector<Vec3> places;
    for (const Grip& grip : m_grips) {
        const Vec3 place = placeOf(box, grip);
        places.push_back(place);
        const bool seen = grip.empty() || std::ranges::any_of(grip, facesViewer);
        const double radius = grip.empty()       ? centreRadius
                              : grip.size() == 1 ? faceRadius
                              : grip.size() == 2 ? edgeRadius
                                                 : cornerRadius;
        if (seen) overlay.discs.push_back({place, sceneColourOf(boxColour()), radius});
        if (grip.size() != 2) continue;
        // The edge of this grip goes along the axis that none of its faces has.
        const int along = 3 - grip[0].axis - grip[1].axis;
        const Vec3 half = outwardNormal(box, {along, 1}) * (0.5 * box.sizeMm[along]);
        overlay.spaceLines.push_back(
            {place - half, place + half, sceneColourOf(seen ? boxColour() : boxBehindColour()), 1.5});
    }
    return places;
}

/// The outline of a flat front within the data, or the middle lines of a bowed one; and its handle, a disc on a stem
/// that stands on the front. The result is where the hand holds it; no value if no front is shown.
std::optional<Vec3> BoxIn3d::addFront(Overlay& overlay) const {
    const Document& document = m_model.document();
    const Front& front = document.scene.front;
    if (!m_frontIsShown || !cuts(front)) return std::nullopt;
    const Volume& volume = *m_openStudy.volume();
    const OrientedBox data = orientedBoxOf(volume.dataBox());
    const Colour colour = sceneColourOf(frontColour());
    const Vec3 forward = forwardOf(front, document.beam.axis);
    const CutSurface surface = surfaceOfFront(document, volume);
    const auto onFront = [&](const Vec3& place) {
        return place + forward * (surface.depthAt(place) - forward.dot(place));
    };
    const Vec3 middle = onFront(data.centreMm);
    if (!front.surface) {
        const std::vector<Vec3> corners = sectionOf(data, middle, forward).corners;
        for (std::size_t i = 0; i < corners.size(); ++i)
            overlay.spaceLines.push_back({corners[i], corners[(i + 1) % corners.size()], colour, 1.5});
    } else {
        for (const Vec3& across : {surface.frame.right, surface.frame.down}) {
            SpacePath line{.places = {}, .colour = colour};
            const double reach = data.extentAlong(across) / 2.0;
            constexpr int steps = 32;
            for (int i = 0; i <= steps; ++i)
                line.places.push_back(onFront(data.centreMm + across * (reach * (2.0 * i / steps - 1.0))));
            overlay.spacePaths.push_back(std::move(line));
        }
    }
    const Vec3 handle = middle - forward * (stemShare * data.extentAlong(forward));
    overlay.spaceLines.push_back({middle, handle, colour, 3.0});
    overlay.discs.push_back({handle, colour, handleRadius});
    return handle;
}

/// Moves the front along its own forward until the handle's picture follows the hand. If one looks along that way, the
/// front goes deeper as the hand goes down.
void BoxIn3d::dragFront(const Vec3& mm) {
    const Document& before = *m_before;
    const Front& front = before.scene.front;
    const VolumeGeometry& geometry = m_openStudy.volume()->geometry();
    const ViewFrame view = frameOf(viewpointOf(before));
    const Vec3 forward = forwardOf(front, before.beam.axis);
    const Vec3 seen = forward - view.forward * view.forward.dot(forward);
    constexpr double leastSeen = 0.06;
    const double moved = seen.dot(seen) > leastSeen ? mm.dot(seen) / seen.dot(seen) : mm.dot(view.down);
    Document next = m_model.document();
    next.scene.front = movedBy(front, moved, before.beam.axis, geometry);
    m_model.preview(next, tr("front"));
}

void BoxIn3d::drag(const Vec3& mm) {
    if (!m_before) return;
    if (m_holdsFront) return dragFront(mm);
    const Document& before = *m_before;
    const OrientedBox start = orientedBoxOf(before.scene.box, before.beam.axis);
    const Vec3 looking = frameOf(viewpointOf(before)).forward;
    OrientedBox box = start;
    if (m_held.empty()) box.centreMm += mm;
    for (const BoxFace& face : m_held) {
        const Vec3 normal = outwardNormal(start, face);
        // The face moves along its normal until its picture follows the hand. A face seen head on cannot.
        const Vec3 seen = normal - looking * looking.dot(normal);
        const double squared = seen.dot(seen);
        constexpr double leastSeen = 0.02;
        if (squared < leastSeen) continue;
        box = withFaceMoved(box, face, mm.dot(seen) / squared, m_openStudy.volume()->geometry().unit());
    }
    // The drag changes the box alone. Other changes since it began stay.
    Document next = m_model.document();
    next.scene.box = movedBox(before.scene.box, box, before.beam.axis);
    m_model.preview(next, m_held.empty() ? tr("move box") : tr("size of the box"));
}

}  // namespace echolucent
