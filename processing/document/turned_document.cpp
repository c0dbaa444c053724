#include "processing/document/turned_document.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace echolucent {

namespace {

/// 0 less the value: no zero gets a sign.
double reversed(double value) { return 0.0 - value; }

/// Turns what lies in a grid. The frames of pictures stay right-handed: their down and forward are mirrored with the
/// grid, and their right is what follows from these.
class GridTurn {
public:
    GridTurn(GridAxis axis, const VolumeGeometry& geometry) : m_axis(placeOf(axis)) {
        const auto of = static_cast<std::size_t>(m_axis);
        const double spacing = geometry.spacing[m_axis];
        m_sumMm = static_cast<double>(geometry.size[of] - 1) * spacing;
        // Blocks are counted from the other end: the one that holds fewer voxels is another.
        if (const auto& reduction = geometry.reduction) {
            const std::int64_t lacking = geometry.size[of] * reduction->by[of] - reduction->storedSize[of];
            m_sumMm -= static_cast<double>(lacking) * spacing / static_cast<double>(reduction->by[of]);
        }
    }

    [[nodiscard]] Vec3 direction(Vec3 vector) const {
        vector[m_axis] = reversed(vector[m_axis]);
        return vector;
    }
    [[nodiscard]] Vec3 place(Vec3 mm) const {
        mm[m_axis] = m_sumMm - mm[m_axis];
        return mm;
    }
    /// How far a place moves along a direction of the turned grid, beside the change of the direction.
    [[nodiscard]] double shiftAlong(const Vec3& turnedDirection) const { return m_sumMm * turnedDirection[m_axis]; }
    [[nodiscard]] ViewFrame frame(const ViewFrame& frame) const {
        return {Vec3(0, 0, 0) - direction(frame.right), direction(frame.down), direction(frame.forward)};
    }
    [[nodiscard]] BeamAxis beam(BeamAxis axis) const {
        const int number = static_cast<int>(axis);  // +x, -x, +y, -y, +z, -z
        return number / 2 == m_axis ? static_cast<BeamAxis>(number ^ 1) : axis;
    }
    /// Whether the down of a view along the beam would point up without half a turn about the beam.
    [[nodiscard]] bool turnsDownRound(BeamAxis before) const {
        const auto downAlong = [](BeamAxis axis) { return frameOf(Viewpoint{.beamAxis = axis}).down; };
        return direction(downAlong(before)).dot(downAlong(beam(before))) < 0.0;
    }
    /// Of the angles of ViewDirection; `before` is the beam's axis before the turn.
    [[nodiscard]] ViewDirection view(const ViewDirection& view, BeamAxis before) const {
        // With X = diag(-1,1,1), which reverses right: X Ry(a) Rx(e) Rz(r) X = Ry(-a) Rx(e) Rz(-r), and
        // Rz(180) Ry(-a) Rx(e) Rz(-r) = Ry(a) Rx(-e) Rz(180 - r).
        if (!turnsDownRound(before)) return {reversed(view.azimuth), view.elevation, reversed(view.roll)};
        return {view.azimuth, reversed(view.elevation), wrappedDegrees(180.0 - view.roll)};
    }

private:
    int m_axis;
    double m_sumMm = 0.0;  // of a place's coordinate along the axis before and after the turn
};

CutSurface turnedSurface(const CutSurface& surface, const GridTurn& turn) {
    CutSurface turned = surface;
    turned.frame = turn.frame(surface.frame);
    turned.firstRightMm = turn.shiftAlong(turned.frame.right) -
                          (surface.firstRightMm + surface.spacingMm * static_cast<double>(surface.columns - 1));
    turned.firstDownMm = surface.firstDownMm + turn.shiftAlong(turned.frame.down);
    const double deeper = turn.shiftAlong(turned.frame.forward);
    const auto columns = static_cast<std::ptrdiff_t>(surface.columns);
    turned.depthMm.change([&](std::vector<float>& depths) {
        for (float& depth : depths) depth = static_cast<float>(depth + deeper);
        for (auto row = depths.begin(); depths.end() - row >= columns; row += columns) std::reverse(row, row + columns);
    });
    return turned;
}

Box turnedBox(Box box, BeamAxis before, const GridTurn& turn) {
    box.direction = turn.view(box.direction, before);
    if (box.sizeMm != Vec3(0, 0, 0)) box.centreMm = turn.place(box.centreMm);
    return box;
}

Planes turnedPlanes(Planes planes, BeamAxis before, const GridTurn& turn) {
    planes.direction = turn.view(planes.direction, before);
    planes.offsetMm = turn.direction(planes.offsetMm);
    // The pictures of A and C have the right of the planes' direction. That of B has its down.
    for (const PlaneName plane : {PlaneName::a, PlaneName::c}) {
        double& pan = planes.crops[indexOf(plane)].panRightMm;
        pan = reversed(pan);
    }
    return planes;
}

ScalpelStroke turnedStroke(ScalpelStroke stroke, const GridTurn& turn) {
    stroke.camera.focalPoint = turn.place(stroke.camera.focalPoint);
    stroke.camera.frame = turn.frame(stroke.camera.frame);
    stroke.places.change([](auto& places) {
        for (auto& place : places) place[0] = reversed(place[0]);
    });
    if (stroke.depthMm) *stroke.depthMm += turn.shiftAlong(stroke.camera.frame.forward);
    return stroke;
}

/// The angle by which a motion has turned the view: it follows the angles of the view.
double turnedMotion(const Document& document, const GridTurn& turn) {
    // What is right and left in the picture changes places, and up and down do not.
    const MotionAxis axis = document.motion.axis;
    const bool keepsAngle = axis == MotionAxis::screenHorizontal ||
                            axis == (turn.turnsDownRound(document.beam.axis) ? MotionAxis::y : MotionAxis::x);
    return keepsAngle ? document.scene.motionAngle : reversed(document.scene.motionAngle);
}

/// Numbers of tube cores whose columns are counted from the other side; in rising order. Numbers that the grid does not
/// hold stay as they are.
std::vector<int> turnedTubes(std::vector<int> tubes, const TubeGrid& grid) {
    for (int& tube : tubes)
        if (tube < grid.columns * grid.rows) tube += grid.columns - 1 - 2 * (tube % grid.columns);
    std::ranges::sort(tubes);
    return tubes;
}

}  // namespace

Document turnedRound(Document document, GridAxis axis, const VolumeGeometry& geometry) {
    const GridTurn turn(axis, geometry);
    const BeamAxis before = document.beam.axis;
    Scene& scene = document.scene;
    scene.motionAngle = turnedMotion(document, turn);
    scene.pose.direction = turn.view(scene.pose.direction, before);
    scene.pose.offsetMm = turn.direction(scene.pose.offsetMm);
    scene.side = turn.view(scene.side, before);
    if (scene.front.depthMm > 0.0) scene.front.direction = turn.view(scene.front.direction, before);
    if (scene.front.surface) scene.front.surface = turnedSurface(*scene.front.surface, turn);
    scene.box = turnedBox(scene.box, before, turn);
    scene.planes = turnedPlanes(scene.planes, before, turn);
    scene.strokes.change([&](std::vector<ScalpelStroke>& strokes) {
        for (ScalpelStroke& stroke : strokes) stroke = turnedStroke(std::move(stroke), turn);
    });
    document.measurements.change([&](std::vector<Measurement>& measurements) {
        for (Measurement& measurement : measurements)
            for (Vec3& place : measurement.placesMm) place = turn.place(place);
    });
    TubeGrid& tubes = document.method.config.grid;
    tubes.withoutTubes = turnedTubes(std::move(tubes.withoutTubes), tubes);
    for (Pane& pane : document.panes) pane.withoutTubes = turnedTubes(std::move(pane.withoutTubes), tubes);
    document.beam.lean = turn.view(document.beam.lean, before);
    document.beam.axis = turn.beam(before);
    return document;
}

Document inGridOfStudy(Document document, std::optional<GridAxis> turned, const VolumeGeometry& geometry) {
    auto* file = std::get_if<StudyFile>(&document.study);
    if (file == nullptr) return document;
    const std::optional<GridAxis> made = std::exchange(file->turnedAxis, turned);
    if (!turned || made == turned) return document;
    if (made) document = turnedRound(std::move(document), *made, geometry);
    return turnedRound(std::move(document), *turned, geometry);
}

}  // namespace echolucent
