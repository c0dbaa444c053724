// A document in which every part differs from its default.
#pragma once

#include <limits>
#include <numbers>
#include <vector>

#include "processing/document/document.h"

namespace echolucent {

inline std::vector<ScalpelStroke> unusualStrokes() {
    ScalpelStroke eraser{
        .tool = ScalpelTool::eraser, .side = ScalpelSide::inside, .camera = {}, .places = {{0.1, -0.2}}};
    eraser.radius = 1.0 / 30.0;
    eraser.camera = {{1, 2, 3}, frameOf(Viewpoint{.elevationDegrees = 12.3}), Projection::perspective, 44.4, 29.9, 1e3};
    ScalpelStroke outline{.tool = ScalpelTool::polygon, .side = ScalpelSide::outside, .camera = {}, .places = {}};
    outline.places = {{0, 0}, {1.0 / 3.0, 0.1}, {0.2, 0.30000000000000004}};
    outline.depthMm = -12.000000000000002;
    return {eraser, outline};
}

/// Its numbers have no short decimal text.
inline Document unusualDocument() {
    Document document;
    StudyFile file{.path = "/data/a \"study\" \\ with ümlauts.dcm", .options = {}, .checksum = "xxh3-128:06b0"};
    file.bytes = 9'007'199'254'740'993;
    file.files = 3;
    file.options.series = "1.2.840.1";
    file.options.raw = RawLayout{{20, 21, 22}, "int16", true, 352, {0.1, 1.0 / 3.0, 2e-7}, true};
    file.options.raw->polar = PolarGeometry{.samples = 20,
                                            .rangeStartMm = 1.0 / 3.0,
                                            .rangeStepMm = 0.1,
                                            .lines = {PolarSpread::angles, {-0.1, 1.0 / 7.0}, 10.1},
                                            .planes = {PolarSpread::positions, {0.3, 2e-7}}};
    file.options.conversionMebibytes = 77;
    file.options.studyMebibytes = 1234;
    file.options.framesAsSlices = true;
    file.options.guessNoData = false;
    document.study = file;
    document.beam = {BeamAxis::minusX, BeamSource::person, {1.0 / 3.0, -0.7, 17.1}};
    Scene& scene = document.scene;
    scene.pose = {{std::numbers::pi * 50, -89.999999999999986, 1e-300}, {0.1 + 0.2, -1.0 / 3.0, 1e17}, 4.0 / 3.0};
    scene.side = {12.3, -4.5, 6.7};
    const ViewFrame front = frameOf(Viewpoint{.azimuthDegrees = 12.3});
    scene.front = {.depthMm = 18.04000000000001,
                   .direction = directionOf(viewAlong(front.forward, front.down, BeamAxis::minusX))};
    scene.front.source = FrontSource::found;
    scene.front.surface = CutSurface{.frame = front,
                                     .firstRightMm = -1.0 / 3.0,
                                     .firstDownMm = 0.1,
                                     .spacingMm = 2.0 / 7.0,
                                     .columns = 2,
                                     .rows = 3,
                                     .depthMm = {0.1f, -1.0f / 3.0f, 1e-30f, 4, 5, 6e20f}};
    scene.look = Look{};
    scene.look.mode = RenderMode::mean;
    scene.look.colourMap = ColourMap::ice;
    scene.look.depthColoured = true;
    scene.look.projection = Projection::perspective;
    scene.look.interpolation = Interpolation::nearest;
    scene.look.light = {100.0 / 3.0, -0.1};
    scene.look.step = 2.0 / 3.0;
    scene.phase = 3;
    scene.motionAngle = -17;
    scene.box = {true, {1.0 / 3.0, -2.5, 77}, {0.1, -1e-7, 1e9}, {1.0 / 7.0, 2, 3e-3}};
    scene.planes = Planes{.direction = {-170.1, 12.0 / 7.0, 0.3},
                          .offsetMm = {0.1, 0.2, -0.3},
                          .crops = {{{1, 2, 3}, {-0.1, 0.7, 1.0 / 9.0}, {}}},
                          .window = 0.3,
                          .level = -0.1,
                          .quiet = false,
                          .linesIn3d = true,
                          .turnsView = true};
    scene.strokes = unusualStrokes();
    LevoyConfig levoy;
    levoy.form = LevoyForm::boundaries;
    levoy.tissueOpacity = 2.0 / 3.0;
    KindlmannConfig kindlmann;
    kindlmann.emphasis = BoundaryEmphasis::drawn;
    kindlmann.drawn = {{-1.0 / 3.0, 0.1}, {0.2, 0.7}, {0.2, 0.0}};
    TemplateReference reference{"a scan", std::vector<double>(256, 0.0), SampledCurve{{0.1, 1.0 / 3.0, 0.7}}};
    reference.histogram[3] = 1.0 / 3.0;
    reference.histogram[200] = 2.0 / 3.0;
    TemplateConfig carried;
    carried.reference = reference;
    document.panes = {{.curve = CurveKind::linear},
                      {.curve = CurveKind::manual, .designer = kindlmann, .withoutTubes = {0, 7, 112}, .phase = 4},
                      {.curve = CurveKind::quartic, .designer = levoy, .motionOtf = MotionOtf::leastFlicker},
                      {.designer = carried}};
    document.curves.manual = {{{0.0, 1.0 / 7.0}, {0.3, 0.1}, {0.3, 0.9999999999999999}}};
    document.curves.linear = {1.0 / 3.0, 2.0 / 3.0, 0.7};
    document.curves.parabolic.scale = 0.1;
    document.curves.quartic.scale = 17.3;
    document.curves.adjustment = {-1.0 / 3.0, 0.7};
    document.method.initial = InitialKind::linear;
    document.method.initialScale = 0.55;
    document.method.config.grid.columns = 31;
    document.method.config.grid.withoutTubes = {0, 17, 464};
    document.method.config.detection = VarianceRule{};
    document.method.config.curve = ProductRule{.strength = 20.0 / 3.0};
    document.measurements = {{.id = 3,
                              .kind = MeasurementKind::angle,
                              .ground = MeasurementGround::surface,
                              .placesMm = {{0.1, 1.0 / 3.0, -2e-7}, {1e9, 0.30000000000000004, 5}, {7, 8, 9}},
                              .phase = 4,
                              .name = "AO∠",
                              .comment = "beside the \"spine\"\nagain in 2 weeks"},
                             {.id = 1, .placesMm = {{1, 2, 3}, {-1.0 / 7.0, 5, 6}}}};
    document.motion = {.axis = MotionAxis::screenHorizontal,
                       .scenario = MotionScenario::both,
                       .otf = MotionOtf::leastFlicker,
                       .pingPong = false,
                       .phasesPingPong = true,
                       .phaseRange = PhaseRange{2, 11},
                       .otfPhase = 7,
                       .speed = 1.0 / 3.0};
    document.comparison = {
        .layout = ComparisonLayout::wipe, .first = 1, .second = 0, .wipe = 1.0 / 3.0, .amplification = 7.1};
    return document;
}

}  // namespace echolucent
