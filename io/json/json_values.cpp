#include "io/json/json_values.h"

#include <nlohmann/json.hpp>

namespace echolucent {

using nlohmann::ordered_json;

ordered_json manualCurveJson(const ManualCurve& curve) {
    ordered_json nodes = ordered_json::array();
    for (const CurveNode& node : curve.nodes)
        nodes.push_back({{"intensity", node.intensity}, {"opacity", node.opacity}});
    return nodes;
}

ManualCurve manualCurveIn(JsonFields& fields, const char* key) {
    ManualCurve curve;
    for (JsonFields& node : fields.list(key)) {
        curve.nodes.push_back({node.number("intensity", 0, 1), node.number("opacity", 0, 1)});
        const std::size_t count = curve.nodes.size();
        if (count > 1 && curve.nodes[count - 1].intensity < curve.nodes[count - 2].intensity)
            node.wrong("intensity", "must not be below the one before it");
    }
    if (curve.nodes.empty()) fields.wrong(key, "must be a list of at least one node");
    return curve;
}

namespace {

ordered_json polarAxisJson(const PolarAxis& axis) {
    if (axis.spread == PolarSpread::positions) return {{"positions_mm", axis.values}};
    return {{"angles_radians", axis.values}, {"radius_mm", axis.radiusMm}};
}

PolarAxis polarAxisIn(JsonFields fields) {
    PolarAxis axis;
    const bool angular = fields.has("angles_radians");
    if (angular == fields.has("positions_mm"))
        fields.wrong("angles_radians", "must stand alone, or positions_mm instead");
    axis.spread = angular ? PolarSpread::angles : PolarSpread::positions;
    axis.values = fields.numbers(angular ? "angles_radians" : "positions_mm");
    if (angular) axis.radiusMm = fields.number("radius_mm");
    return axis;
}

}  // namespace

ordered_json polarJson(const PolarGeometry& polar) {
    return {{"range_start_mm", polar.rangeStartMm},
            {"range_step_mm", polar.rangeStepMm},
            {"lines", polarAxisJson(polar.lines)},
            {"planes", polarAxisJson(polar.planes)}};
}

PolarGeometry polarIn(JsonFields fields, std::int64_t samples) {
    PolarGeometry polar;
    polar.samples = samples;
    polar.rangeStartMm = fields.number("range_start_mm");
    polar.rangeStepMm = fields.number("range_step_mm");
    polar.lines = polarAxisIn(fields.object("lines"));
    polar.planes = polarAxisIn(fields.object("planes"));
    return polar;
}

ordered_json rawLayoutJson(const RawLayout& layout) {
    ordered_json object{{"size", layout.size},
                        {"type", layout.type},
                        {"byte_order", layout.bigEndian ? "big" : "little"},
                        {"header_bytes", layout.headerBytes},
                        {"spacing_mm", {layout.spacing[0], layout.spacing[1], layout.spacing[2]}},
                        {"spacing_known", layout.spacingKnown}};
    if (layout.polar) object["polar"] = polarJson(*layout.polar);
    return object;
}

RawLayout rawLayoutIn(JsonFields& fields) {
    RawLayout layout;
    constexpr double largestEdge = 1e15;  // as for --raw-size; the file's own size limits the product
    layout.size = fields.size("size", largestEdge);
    if (fields.has("type")) layout.type = fields.text("type");
    if (fields.has("byte_order")) {
        const std::string order = fields.text("byte_order");
        if (order != "little" && order != "big") fields.wrong("byte_order", "must be little or big");
        layout.bigEndian = order == "big";
    }
    if (fields.has("header_bytes"))
        layout.headerBytes = fields.whole("header_bytes", 0, std::numeric_limits<std::int64_t>::max());
    if (fields.has("spacing_mm")) {
        layout.spacing = fields.vector("spacing_mm");
        for (int axis = 0; axis < 3; ++axis)
            if (!(layout.spacing[axis] > 0)) fields.wrong("spacing_mm", "must be three numbers above 0");
    }
    if (fields.has("spacing_known")) layout.spacingKnown = fields.flag("spacing_known");
    if (fields.has("polar")) layout.polar = polarIn(fields.object("polar"), layout.size[0]);
    return layout;
}

}  // namespace echolucent
