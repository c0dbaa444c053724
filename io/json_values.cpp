#include "io/json_values.h"

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

ordered_json rawLayoutJson(const RawLayout& layout) {
    return {{"size", layout.size},
            {"type", layout.type},
            {"byte_order", layout.bigEndian ? "big" : "little"},
            {"header_bytes", layout.headerBytes},
            {"spacing_mm", {layout.spacing[0], layout.spacing[1], layout.spacing[2]}},
            {"spacing_known", layout.spacingKnown}};
}

RawLayout rawLayoutIn(JsonFields& fields) {
    RawLayout layout;
    constexpr double largestEdge = 1e15;  // as --raw-size; the file's own size limits the product
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
    return layout;
}

}  // namespace echolucent
