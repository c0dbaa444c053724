#include "tests/app/stress/document_changes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "processing/designers/choice/designer.h"
#include "processing/document/panes.h"
#include "processing/picture/look.h"

namespace echolucent {

namespace {

ViewDirection anyDirection(RandomChoice& choice) {
    if (choice.chance(0.2)) return {};
    return {choice.between(-180, 180), choice.between(-90, 90), choice.between(-180, 180)};
}

Vec3 placeIn(const DataBox& box, RandomChoice& choice) {
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = choice.between(box.lowMm[axis], box.highMm[axis]);
    return place;
}

double lengthOf(const DataBox& box) { return std::max({box.sizeMm()[0], box.sizeMm()[1], box.sizeMm()[2]}); }

/// Another value of a row, in what its control offers and not far from the present one.
ParameterValue anotherValue(const AnyParameter& row, const ParameterValue& present, RandomChoice& choice) {
    if (const bool* flag = std::get_if<bool>(&present)) return !*flag;
    if (std::holds_alternative<std::string>(present)) return std::string(choice.of(row.choices).name);
    const ParameterRange offered = row.offeredRange();
    const double now = *numberOf(present), spread = 0.3 * std::max(1.0, std::abs(now));
    const double next = choice.between(std::max(offered.least, now - spread), std::min(offered.largest, now + spread));
    if (std::holds_alternative<std::int64_t>(present)) return static_cast<std::int64_t>(std::llround(next));
    return next;
}

template <typename Values>
Values withAnotherRow(const ParameterTable<Values>& table, const Values& values, RandomChoice& choice) {
    if (table.empty()) return values;
    const Parameter<Values>& row = choice.of(table.rows);
    const auto present = row.get(values);
    if (!present) return values;
    Values next = values;
    if (!row.set(next, anotherValue(row, *present, choice)) || !problemIn(table, next).empty()) return values;
    return next;
}

/// A bowed surface of a few nodes, somewhere in the upper half of the data.
CutSurface anySurface(const StudyBounds& bounds, RandomChoice& choice) {
    CutSurface surface;
    surface.frame = frameOf(viewpointOf(BeamAxis::plusZ, anyDirection(choice)));
    surface.columns = 2 + choice.below(6);
    surface.rows = 2 + choice.below(6);
    surface.spacingMm = lengthOf(bounds.box) / std::max(surface.columns, surface.rows);
    const Vec3 centre = bounds.box.centreMm();
    surface.firstRightMm = surface.frame.right.dot(centre) - 0.5 * surface.spacingMm * (surface.columns - 1);
    surface.firstDownMm = surface.frame.down.dot(centre) - 0.5 * surface.spacingMm * (surface.rows - 1);
    const double depth = surface.frame.forward.dot(centre);
    std::vector<float> depths(static_cast<std::size_t>(surface.columns * surface.rows));
    for (float& each : depths) each = static_cast<float>(depth - choice.between(0, 0.4) * lengthOf(bounds.box));
    surface.depthMm = std::move(depths);
    return surface;
}

ScalpelStroke anyStroke(const Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    ScalpelStroke stroke;
    const Viewpoint view = viewpointOf(document.beam.axis, document.scene.pose.direction);
    stroke.camera = defaultCamera(bounds.box, view, 1.2);
    stroke.tool =
        choice.of(std::array{ScalpelTool::freehand, ScalpelTool::polygon, ScalpelTool::box, ScalpelTool::eraser});
    const bool eraser = stroke.tool == ScalpelTool::eraser;
    // What an outline leaves out is a whole volume soon.
    stroke.side = !eraser && choice.chance(0.1) ? ScalpelSide::outside : ScalpelSide::inside;
    const std::array<double, 2> middle{choice.between(-0.4, 0.4), choice.between(-0.4, 0.4)};
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < 3 + choice.below(30); ++i)
        places.push_back({middle[0] + choice.between(-0.1, 0.1), middle[1] + choice.between(-0.1, 0.1)});
    stroke.places = std::move(places);
    if (eraser) stroke.radius = choice.between(0.01, 0.05);
    if (choice.chance(0.5)) stroke.depthMm = stroke.camera.frame.forward.dot(placeIn(bounds.box, choice));
    return stroke;
}

void changeFront(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    Front& front = document.scene.front;
    switch (choice.below(4)) {
        case 0: front = {.depthMm = choice.between(0, 0.6 * lengthOf(bounds.box))}; break;
        case 1:
            front = {.depthMm = choice.between(1, 0.6 * lengthOf(bounds.box)), .direction = anyDirection(choice)};
            break;
        case 2: front = {.surface = anySurface(bounds, choice)}; break;
        default: front = {};
    }
}

void changeBox(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    Box& box = document.scene.box;
    if (choice.chance(0.3)) {
        box.on = !box.on && box.sizeMm[0] > 0;
        return;
    }
    box.on = true;
    box.direction = anyDirection(choice);
    box.centreMm = placeIn(bounds.box, choice);
    for (int axis = 0; axis < 3; ++axis) box.sizeMm[axis] = choice.between(0.1, 1.2) * bounds.box.sizeMm()[axis];
}

void changeStrokes(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    auto& strokes = document.scene.strokes;
    if (strokes.size() > 8 || (!strokes.empty() && choice.chance(0.3))) {
        if (choice.chance(0.3)) return strokes.clear();
        return strokes.change(
            [&](auto& list) { list.erase(list.begin() + choice.below(static_cast<int>(list.size()))); });
    }
    strokes.push_back(anyStroke(document, bounds, choice));
}

void changeMeasurements(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    auto& measurements = document.measurements;
    if (measurements.size() > 12 || (!measurements.empty() && choice.chance(0.3)))
        return measurements.change(
            [&](auto& list) { list.erase(list.begin() + choice.below(static_cast<int>(list.size()))); });
    Measurement next;
    for (const Measurement& each : measurements) next.id = std::max(next.id, each.id + 1);
    next.kind = choice.chance(0.5) ? MeasurementKind::distance : MeasurementKind::angle;
    next.ground = choice.chance(0.7) ? MeasurementGround::plane : MeasurementGround::surface;
    if (next.ground == MeasurementGround::surface) next.kind = MeasurementKind::distance;
    for (std::size_t i = 0; i < placesNeeded(next.kind); ++i) next.placesMm.push_back(placeIn(bounds.box, choice));
    next.phase = choice.below(bounds.phases);
    measurements.push_back(next);
}

Pane anyPane(const StudyBounds& bounds, RandomChoice& choice) {
    Pane pane;
    pane.curve = choice.of(allCurveKinds);
    if (choice.chance(0.4)) pane.designer = defaultConfigOf(choice.of(allDesigners));
    if (choice.chance(0.2)) pane.withoutTubes = {choice.below(9)};
    if (choice.chance(0.2)) pane.phase = choice.below(bounds.phases);
    if (choice.chance(0.2)) pane.motionOtf = choice.of(std::array{MotionOtf::oneOtf, MotionOtf::eachView});
    if (choice.chance(0.3)) pane.linear = LinearCurve{.slope = choice.between(0, 2)};
    if (choice.chance(0.3)) {
        pane.method = configOf(choice.of(std::array{MethodReading::asPublished, MethodReading::firstVersion}));
        if (choice.chance(0.5)) pane.method = withAnotherRow(methodParameters(), *pane.method, choice);
        pane.method->initial = AdaptiveOtfConfig{}.initial;  // plays no part in a document
    }
    return pane;
}

void changePanes(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    if (choice.chance(0.4)) {
        document = withPaneCount(document, static_cast<std::size_t>(1 + choice.below(static_cast<int>(mostPanes))));
    } else {
        const auto place = static_cast<std::size_t>(choice.below(static_cast<int>(document.panes.size())));
        Pane pane = anyPane(bounds, choice);
        if (place == firstPane) {
            pane.phase.reset();
            pane.motionOtf.reset();
            pane.method.reset();
        }
        document = withPane(document, place, pane);
    }
}

void changeComparison(Document& document, const StudyBounds&, RandomChoice& choice) {
    const int panes = static_cast<int>(document.panes.size());
    Comparison& comparison = document.comparison;
    if (panes > 1) {
        comparison.layout =
            choice.of(std::array{ComparisonLayout::sideBySide, ComparisonLayout::difference, ComparisonLayout::wipe});
        comparison.first = choice.below(panes);
        comparison.second = (comparison.first + 1) % panes;
    }
    comparison.wipe = choice.between(0, 1);
    comparison.amplification = choice.between(leastAmplification, largestAmplification);
    comparison.colours = choice.chance(0.5);
}

void changeDesigner(Document& document, const StudyBounds&, RandomChoice& choice) {
    const auto place = static_cast<std::size_t>(choice.below(static_cast<int>(document.panes.size())));
    std::optional<DesignerConfig>& designer = document.panes[place].designer;
    if (choice.chance(0.3)) {
        designer.reset();
    } else if (!designer || choice.chance(0.4)) {
        designer = defaultConfigOf(choice.of(allDesigners));
    } else {
        std::visit([&](auto& config) { config = withAnotherRow(parametersOf(config), config, choice); }, *designer);
        if (!problemOf(*designer).empty()) designer.reset();
    }
}

void changeMethod(Document& document, const StudyBounds&, RandomChoice& choice) {
    MethodChoice& method = document.method;
    if (choice.chance(0.3))
        method = withAnotherRow(initialFunctionParameters(), method, choice);
    else if (choice.chance(0.2))
        method = {};
    else
        method.config = withAnotherRow(methodParameters(), method.config, choice);
    method.config.initial = AdaptiveOtfConfig{}.initial;  // plays no part in a document
}

void changeLook(Document& document, const StudyBounds&, RandomChoice& choice) {
    if (choice.chance(0.1))
        document.scene.look = choice.chance(0.5) ? Look{} : lookAtStart();
    else
        document.scene.look = withAnotherRow(lookParameters(), document.scene.look, choice);
    // Finer steps only take longer.
    document.scene.look.step = std::max(0.5, document.scene.look.step);
}

void changeCurves(Document& document, const StudyBounds&, RandomChoice& choice) {
    CurveSet& curves = document.curves;
    switch (choice.below(5)) {
        case 0: {
            std::vector<CurveNode> nodes(static_cast<std::size_t>(2 + choice.below(6)));
            for (CurveNode& node : nodes) node = {choice.between(0, 1), choice.between(0, 1)};
            std::ranges::sort(nodes, {}, &CurveNode::intensity);
            curves.manual.nodes = std::move(nodes);
            break;
        }
        case 1:
            curves.linear.lower = choice.between(0, 0.5);
            curves.linear.upper = choice.between(0.5, 1);
            curves.linear.slope = choice.between(0, 2);
            break;
        case 2: curves.parabolic.scale = choice.between(0, 2); break;
        case 3: curves.quartic.scale = choice.between(0, 2); break;
        default: curves.adjustment = {choice.between(-0.5, 0.5), choice.between(-1, 1)};
    }
}

void changePose(Document& document, const StudyBounds&, RandomChoice& choice) {
    Pose& pose = document.scene.pose;
    switch (choice.below(4)) {
        case 0: pose.direction = anyDirection(choice); break;
        case 1: pose.magnification = choice.between(0.3, 4); break;
        case 2: pose.offsetMm = {choice.between(-20, 20), choice.between(-20, 20), choice.between(-20, 20)}; break;
        default: pose = {};
    }
}

void changePlanes(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    Planes& planes = document.scene.planes;
    planes = withReferencePoint(planes, placeIn(bounds.box, choice), bounds.box);
    planes.direction = anyDirection(choice);
    planes.window = choice.between(0.1, 2);
    planes.level = choice.between(0, 1);
    planes.quiet = choice.chance(0.5);
    planes.linesIn3d = choice.chance(0.5);
    choice.of(planes.crops) = {choice.between(-10, 10), choice.between(-10, 10), choice.between(0.5, 4)};
}

void changeSide(Document& document, const StudyBounds&, RandomChoice& choice) {
    document.scene.side = anyDirection(choice);
}

void changeBeam(Document& document, const StudyBounds&, RandomChoice& choice) {
    document.beam.axis = choice.of(std::array{BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY,
                                              BeamAxis::plusZ, BeamAxis::minusZ});
    document.beam.source = BeamSource::person;
}

void changeMotion(Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    MotionChoice& motion = document.motion;
    switch (choice.below(5)) {
        case 0: motion.pingPong = !motion.pingPong; break;
        case 1: motion.otfPhase = choice.below(bounds.phases); break;
        case 2: {
            const int first = choice.below(bounds.phases);
            motion.phaseRange = PhaseRange{first, first + choice.below(bounds.phases - first)};
            break;
        }
        case 3: motion.speed = choice.of(std::array{0.25, 0.5, 1.0, 4.0}); break;
        default: motion.phasesPingPong = !motion.phasesPingPong;
    }
}

struct Change {
    const char* what;
    void (*how)(Document&, const StudyBounds&, RandomChoice&);
};
constexpr std::array changes{Change{"front", changeFront},       Change{"box", changeBox},
                             Change{"strokes", changeStrokes},   Change{"measurements", changeMeasurements},
                             Change{"panes", changePanes},       Change{"comparison", changeComparison},
                             Change{"designer", changeDesigner}, Change{"method", changeMethod},
                             Change{"look", changeLook},         Change{"curves", changeCurves},
                             Change{"pose", changePose},         Change{"planes", changePlanes},
                             Change{"side", changeSide},         Change{"beam", changeBeam},
                             Change{"motion", changeMotion}};
constexpr std::array changesOfPanes{Change{"panes", changePanes},           Change{"panes", changePanes},
                                    Change{"comparison", changeComparison}, Change{"designer", changeDesigner},
                                    Change{"method", changeMethod},         Change{"curves", changeCurves}};

ChangedDocument changedBy(const Change& change, const Document& document, const StudyBounds& bounds,
                          RandomChoice& choice) {
    ChangedDocument changed{document, QStringLiteral("stress: %1").arg(change.what)};
    change.how(changed.document, bounds, choice);
    if (!problemOf(changed.document).empty()) changed.document = document;
    return changed;
}

}  // namespace

ChangedDocument changedByChance(const Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    return changedBy(choice.of(changes), document, bounds, choice);
}

ChangedDocument withChangedPanes(const Document& document, const StudyBounds& bounds, RandomChoice& choice) {
    return changedBy(choice.of(changesOfPanes), document, bounds, choice);
}

}  // namespace echolucent
