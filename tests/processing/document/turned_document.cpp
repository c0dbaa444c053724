// Documents of a grid that is counted from the other end of an axis: all that they hold stays on the anatomy.
#include "processing/document/turned_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "processing/picture/picture_place.h"
#include "processing/sampling/sampler.h"
#include "processing/scene/box.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/volume/block_mean.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

constexpr std::array allBeams{BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                              BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};
constexpr std::array allGridAxes{GridAxis::x, GridAxis::y, GridAxis::z};
const VolumeGeometry grid = gridOf({9, 11, 13}, {0.7, 0.9, 1.1});
const DataBox data{{0.3, -0.2, 1.1}, {5.1, 7.7, 11.9}};

/// What turning round does to places and directions of the grid; without an axis nothing.
struct Mirror {
    std::optional<GridAxis> axis;
    [[nodiscard]] Vec3 place(Vec3 mm) const {
        if (axis)
            mm[placeOf(*axis)] = grid.boxMaxMm()[placeOf(*axis)] + grid.boxMinMm()[placeOf(*axis)] - mm[placeOf(*axis)];
        return mm;
    }
    [[nodiscard]] Vec3 direction(Vec3 vector) const {
        if (axis) vector[placeOf(*axis)] *= -1;
        return vector;
    }
    [[nodiscard]] DataBox box(const DataBox& box) const {
        const Vec3 one = place(box.lowMm), other = place(box.highMm);
        return {Vec3(std::min(one[0], other[0]), std::min(one[1], other[1]), std::min(one[2], other[2])),
                Vec3(std::max(one[0], other[0]), std::max(one[1], other[1]), std::max(one[2], other[2]))};
    }
    /// The sign of a picture's right.
    [[nodiscard]] double right() const { return axis ? -1.0 : 1.0; }
};

std::vector<Vec3> somePlaces() {
    std::mt19937 random(7);
    std::vector<Vec3> places;
    for (int i = 0; i < 300; ++i) {
        Vec3 share;
        for (double& each : share.val) each = static_cast<double>(random() % 10007) / 10007;
        places.push_back(grid.boxMinMm() + (grid.boxMaxMm() - grid.boxMinMm()).mul(share));
    }
    return places;
}

/// A document in which all that has a place or a direction is set.
Document documentAlong(BeamAxis beam) {
    Document document;
    document.study = StudyFile{.path = "left.nrrd", .options = {}, .checksum = {}};
    document.beam = {beam, BeamSource::file, {3, -4, 5}};
    Scene& scene = document.scene;
    scene.pose = {{20, -8, 33}, {0.4, -0.9, 1.3}, 1.4};
    scene.side = {12, -7, 95};
    scene.motionAngle = 17;
    scene.front.depthMm = 2.3;
    scene.front.direction = ViewDirection{10, 11, -12};
    CutSurface surface{.frame = frameOf(viewpointOf(beam, {15, 6, -3})), .columns = 3, .rows = 2};
    surface.spacingMm = 6;
    surface.firstRightMm = surface.frame.right.dot(grid.centreMm()) - 5;
    surface.firstDownMm = surface.frame.down.dot(grid.centreMm()) - 2;
    const auto middle = static_cast<float>(surface.frame.forward.dot(grid.centreMm()));
    surface.depthMm = {middle - 4, middle - 1, middle + 2, middle - 3, middle, middle - 2};
    scene.front.surface = surface;
    scene.box = {true, {12, 3, -20}, {2.5, 4.1, 6.2}, {3, 4, 7}};
    scene.planes.direction = {-14, 9, 21};
    scene.planes.offsetMm = {0.2, -0.6, 1.2};
    scene.planes.crops = {{{0.3, -0.4, 1.2}, {-0.5, 0.6, 1.5}, {0.7, 0.8, 2}}};
    ScalpelStroke outline{
        .camera = {{2, 4, 6}, frameOf(viewpointOf(beam, {30, 5, 7})), Projection::perspective, 9, 30, 25},
        .places = {{-0.2, -0.1}, {0.25, 0.0}, {0.1, 0.3}},
        .depthMm = {}};
    outline.depthMm = outline.camera.frame.forward.dot(grid.centreMm());
    ScalpelStroke eraser{
        .tool = ScalpelTool::eraser,
        .camera = {{3, 5, 7}, frameOf(viewpointOf(beam, {-10, 0, 2})), Projection::parallel, 12, 30, 9},
        .places = {{-0.2, 0.1}, {0.2, -0.1}},
        .radius = 0.1};
    scene.strokes = {outline, eraser};
    document.measurements = {{.id = 1, .placesMm = {{1.1, 2.2, 3.3}, {4.4, 5.5, 6.6}}},
                             {.id = 2, .kind = MeasurementKind::angle, .placesMm = {{1, 7, 3}, {2, 2, 9}, {5, 1, 4}}}};
    document.method.config.grid.columns = 5;
    document.method.config.grid.rows = 4;
    document.method.config.grid.withoutTubes = {0, 6, 19};
    document.panes.push_back({.withoutTubes = {3, 4, 12}});
    return document;
}

void expectSameFrame(const ViewFrame& before, const ViewFrame& after, const Mirror& mirror, const char* what) {
    EXPECT_LT(length(mirror.direction(before.forward) - after.forward), 1e-12) << what;
    EXPECT_LT(length(mirror.direction(before.down) - after.down), 1e-12) << what;
    EXPECT_LT(length(mirror.direction(before.right) * mirror.right() - after.right), 1e-12) << what;
}

/// Whether pictures show each place where they showed it, but that left and right change.
void expectSamePictures(const Document& before, const Document& after, const Mirror& mirror) {
    const auto cameraOf = [](const Document& document, const DataBox& box) {
        return cameraFor(cameraPoseOf(shownPose(document), document.beam.axis, box, Projection::perspective, 1.3));
    };
    const Camera camera = cameraOf(before, data), turned = cameraOf(after, mirror.box(data));
    for (const Vec3& place : somePlaces()) {
        const auto seen = placeInPicture(camera, place), seenAfter = placeInPicture(turned, mirror.place(place));
        ASSERT_TRUE(seen && seenAfter);
        EXPECT_NEAR((*seen)[0] * mirror.right(), (*seenAfter)[0], 1e-9);
        EXPECT_NEAR((*seen)[1], (*seenAfter)[1], 1e-9);
    }
    for (const PlaneName plane : allPlaneNames) {
        const PlaneView view = planeViewOf(before.scene.planes, plane, before.beam.axis, data, 1.3);
        const PlaneView other = planeViewOf(after.scene.planes, plane, after.beam.axis, mirror.box(data), 1.3);
        EXPECT_NEAR(view.heightMm, other.heightMm, 1e-9);
        EXPECT_NEAR(0.0, other.frame.forward.dot(mirror.place(view.centreMm) - other.centreMm), 1e-9);
        // Plane B shows what it showed, but from the other side: its right is the down of the planes' direction.
        const double right = plane == PlaneName::b ? 1.0 : mirror.right();
        for (const Vec3& place : somePlaces()) {
            const Vec3 from = place - view.centreMm, to = mirror.place(place) - other.centreMm;
            EXPECT_NEAR(view.frame.right.dot(from) * right, other.frame.right.dot(to), 1e-9);
            EXPECT_NEAR(view.frame.down.dot(from), other.frame.down.dot(to), 1e-9);
        }
    }
}

/// Whether the same places are cut away: by front, box and scalpel.
void expectSameCuts(const Document& before, const Document& after, const Mirror& mirror) {
    const auto isBeforePlane = [](const Document& document, const Vec3& place) {
        const Viewpoint view = withFrontAcross(viewpointOf(document.beam.axis, document.scene.front.direction),
                                               document.scene.front.depthMm);
        return frameOf(view).forward.dot(place) < nearPlaneDepthMm(view, grid);
    };
    std::array<int, 5> cut{};
    for (const Vec3& place : somePlaces()) {
        const auto cutIn = [&](const Document& document, const Vec3& at) {
            const Scene& scene = document.scene;
            return std::array{isBeforePlane(document, at), scene.front.surface->cutsAway(at),
                              !orientedBoxOf(scene.box, document.beam.axis).contains(at),
                              cutsAway(scene.strokes[0], at), cutsAway(scene.strokes[1], at)};
        };
        const auto expected = cutIn(before, place);
        EXPECT_EQ(expected, cutIn(after, mirror.place(place)));
        for (std::size_t i = 0; i < cut.size(); ++i) cut[i] += expected[i] ? 1 : 0;
    }
    for (const int count : cut) EXPECT_TRUE(count > 3 && count < 297) << "cuts all or nothing: " << count;
}

void expectSameTubes(const Document& before, const Document& after, const Mirror& mirror) {
    for (const std::size_t pane : {std::size_t{0}, std::size_t{1}}) {
        const TubeGrid tubes = configOf(before, pane).grid, turned = configOf(after, pane).grid;
        ASSERT_EQ(tubes.withoutTubes.size(), turned.withoutTubes.size());
        EXPECT_TRUE(std::ranges::is_sorted(turned.withoutTubes));
        const auto axes = tubeAxes(grid, otfViewpointOf(before, pane), tubes, 3);
        const auto others = tubeAxes(grid, otfViewpointOf(after, pane), turned, 3);
        for (const TubeAxis& axis : axes) {
            const int place = axis.row * tubes.columns + (mirror.axis ? tubes.columns - 1 - axis.column : axis.column);
            const TubeAxis& other = others.at(static_cast<std::size_t>(place));
            EXPECT_LT(length(mirror.place(axis.pointMm) - other.pointMm), 1e-9);
            EXPECT_EQ(axis.entryVoxel.has_value(), other.entryVoxel.has_value());
        }
    }
}

void expectSameAnatomy(const Document& before, const Document& after, const Mirror& mirror) {
    EXPECT_EQ(problemOf(after), "");
    expectSameFrame(frameOf(viewAlongBeam(before.beam)), frameOf(viewAlongBeam(after.beam)), mirror, "beam");
    EXPECT_LT(length(mirror.direction(frameOf({.beamAxis = before.beam.axis}).forward) -
                     frameOf({.beamAxis = after.beam.axis}).forward),
              1e-12);
    expectSameFrame(frameOf(viewpointOf(before.beam.axis, before.scene.side)),
                    frameOf(viewpointOf(after.beam.axis, after.scene.side)), mirror, "side");
    expectSamePictures(before, after, mirror);
    expectSameCuts(before, after, mirror);
    expectSameTubes(before, after, mirror);
    for (std::size_t i = 0; i < before.measurements.size(); ++i)
        for (std::size_t place = 0; place < before.measurements[i].placesMm.size(); ++place)
            EXPECT_LT(
                length(mirror.place(before.measurements[i].placesMm[place]) - after.measurements[i].placesMm[place]),
                1e-12);
}

TEST(TurnedDocument, AllThatItHoldsStaysOnTheAnatomyAndASecondTurnUndoesTheFirst) {
    for (const BeamAxis beam : allBeams)
        for (const GridAxis axis : allGridAxes) {
            SCOPED_TRACE(std::string(nameOf(beam)) + " " + std::string(nameOf(axis)));
            const Document document = documentAlong(beam);
            const Document turned = turnedRound(document, axis, grid);
            expectSameAnatomy(document, turned, {axis});
            const Document twice = turnedRound(turned, axis, grid);
            expectSameAnatomy(document, twice, {std::nullopt});
            EXPECT_EQ(twice.scene.motionAngle, 17);
            EXPECT_EQ(twice.beam.axis, beam);
            EXPECT_EQ(twice.panes, document.panes);
        }
}

TEST(TurnedDocument, AMotionTurnsTheViewTheSameWayThroughTheBody) {
    for (const MotionAxis motion : {MotionAxis::x, MotionAxis::y, MotionAxis::z, MotionAxis::screenVertical,
                                    MotionAxis::screenHorizontal, MotionAxis::picturePlane})
        for (const GridAxis axis : allGridAxes) {
            Document document = documentAlong(BeamAxis::plusZ);
            document.motion.axis = motion;
            expectSamePictures(document, turnedRound(document, axis, grid), {axis});
        }
}

TEST(TurnedDocument, AMeasurementHitsTheSameVoxels) {
    std::mt19937 random(3);
    std::vector<float> values(static_cast<std::size_t>(grid.voxelCount()));
    for (float& value : values) value = static_cast<float>(random() % 1000);
    const Document document = documentAlong(BeamAxis::plusY);
    for (const GridAxis axis : allGridAxes) {
        std::vector<float> turnedValues(values.size());
        for (std::int64_t z = 0; z < 13; ++z)
            for (std::int64_t y = 0; y < 11; ++y)
                for (std::int64_t x = 0; x < 9; ++x) {
                    std::array<std::int64_t, 3> to{x, y, z};
                    const auto of = static_cast<std::size_t>(placeOf(axis));
                    to[of] = grid.size[of] - 1 - to[of];
                    turnedValues[static_cast<std::size_t>(grid.offset(to[0], to[1], to[2]))] =
                        values[static_cast<std::size_t>(grid.offset(x, y, z))];
                }
        const Volume before(grid, values, 1000.0), after(grid, turnedValues, 1000.0);
        const Document turned = turnedRound(document, axis, grid);
        for (std::size_t i = 0; i < document.measurements.size(); ++i) {
            EXPECT_NEAR(*measuredValue(document.measurements[i], grid), *measuredValue(turned.measurements[i], grid),
                        1e-9);
            for (std::size_t place = 0; place < document.measurements[i].placesMm.size(); ++place)
                EXPECT_NEAR(
                    *VolumeSampler(before).intensityAt(grid.voxelFromGridMm(document.measurements[i].placesMm[place])),
                    *VolumeSampler(after).intensityAt(grid.voxelFromGridMm(turned.measurements[i].placesMm[place])),
                    1e-9);
        }
    }
}

TEST(TurnedDocument, AMeasurementOfAReducedVolumeStaysWhereItWas) {
    const Reduction reduction{{2, 2, 3}, {9, 11, 13}};
    const VolumeGeometry before = reducedGeometry(grid, reduction);
    for (const GridAxis axis : allGridAxes) {
        VolumeGeometry turnedGrid = grid;
        const int of = placeOf(axis);
        turnedGrid.origin[of] = grid.boxMaxMm()[of] + grid.boxMinMm()[of];
        turnedGrid.direction(of, of) = -1;
        const VolumeGeometry after = reducedGeometry(turnedGrid, reduction);
        const Document document = documentAlong(BeamAxis::plusZ), turned = turnedRound(document, axis, after);
        const auto inPatient = [](const Document& from, const VolumeGeometry& geometry) {
            return geometry.origin + geometry.direction * from.measurements[0].placesMm[1];
        };
        EXPECT_LT(length(inPatient(document, before) - inPatient(turned, after)), 1e-12);
    }
}

TEST(TurnedDocument, IsTurnedOnceAndOnlyIfTheStudyWas) {
    const auto axisOf = [](const Document& document) { return turnedAxisOf(document.study); };
    const Document own = documentAlong(BeamAxis::plusZ);
    EXPECT_EQ(inGridOfStudy(own, std::nullopt, grid), own) << "a right-handed study";
    const Document turned = inGridOfStudy(own, GridAxis::y, grid);
    EXPECT_EQ(axisOf(turned), GridAxis::y);
    EXPECT_NE(turned.measurements, own.measurements);
    EXPECT_EQ(inGridOfStudy(turned, GridAxis::y, grid), turned) << "it was made on the turned grid";
    // Of a study that is turned round along another axis, the file's own grid lies in between.
    const Document other = inGridOfStudy(turned, GridAxis::x, grid);
    EXPECT_EQ(axisOf(other), GridAxis::x);
    expectSameAnatomy(own, other, {GridAxis::x});
    // The grid of a right-handed study has no other grid behind it.
    const Document unmarked = inGridOfStudy(turned, std::nullopt, grid);
    EXPECT_EQ(axisOf(unmarked), std::nullopt);
    EXPECT_EQ(unmarked.measurements, turned.measurements);
    Document simulated = own;
    simulated.study = SimulatedScan{};
    EXPECT_EQ(inGridOfStudy(simulated, GridAxis::x, grid), simulated);
}

}  // namespace
}  // namespace echolucent
