#include "io/curve_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

using nlohmann::json;
constexpr const char* formatName = "echolucent-opacity-curve";

tl::unexpected<Failure> wrong(const std::string& path, const std::string& key, const std::string& problem) {
    return fail(FailureKind::unreadable, path, key, problem,
                "Correct the file, or save the curve again from the program.");
}

Result<json> parsed(const std::string& path, const std::string& text) {
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        return wrong(path, "",
                     fmt::format("is not JSON: it breaks in line {}", 1 + std::count(text.begin(), end, '\n')));
    } catch (const json::exception&) {
        return wrong(path, "", "holds a number too large for JSON readers");
    }
}

Result<double> shareFrom(const std::string& path, const json& node, const std::string& place, const char* key) {
    const std::string element = place + "." + key;
    const auto found = node.find(key);
    if (found == node.end()) return wrong(path, element, "is missing");
    if (!found->is_number()) return wrong(path, element, "must be a number");
    const double value = found->get<double>();
    if (!(value >= 0.0 && value <= 1.0)) return wrong(path, element, fmt::format("must lie in [0, 1], not {}", value));
    return value;
}

}  // namespace

Result<ManualCurve> readCurve(const std::string& path) {
    const auto text = readWholeFile(path, std::size_t{1} << 20);
    if (!text) return tl::unexpected(text.error());
    const auto object = parsed(path, *text);
    if (!object) return tl::unexpected(object.error());
    if (!object->is_object()) return wrong(path, "", "must be a JSON object");
    if (object->value("format", json()) != formatName)
        return wrong(path, "format", fmt::format("must be \"{}\"", formatName));
    if (object->value("version", json()) != 1) return wrong(path, "version", "must be 1");
    const auto nodes = object->find("nodes");
    if (nodes == object->end() || !nodes->is_array() || nodes->empty())
        return wrong(path, "nodes", "must be a list of at least one node");
    ManualCurve curve;
    for (std::size_t index = 0; index < nodes->size(); ++index) {
        const json& node = (*nodes)[index];
        const std::string place = fmt::format("nodes[{}]", index);
        if (!node.is_object()) return wrong(path, place, "must be an object with intensity and opacity");
        const auto intensity = shareFrom(path, node, place, "intensity");
        if (!intensity) return tl::unexpected(intensity.error());
        const auto opacity = shareFrom(path, node, place, "opacity");
        if (!opacity) return tl::unexpected(opacity.error());
        if (!curve.nodes.empty() && *intensity < curve.nodes.back().intensity)
            return wrong(path, place + ".intensity", "must not be below the one before it");
        curve.nodes.push_back({*intensity, *opacity});
    }
    return curve;
}

Result<void> writeCurve(const std::string& path, const ManualCurve& curve) {
    nlohmann::ordered_json object{{"format", formatName}, {"version", 1}};
    object["nodes"] = nlohmann::ordered_json::array();
    for (const CurveNode& node : curve.nodes)
        object["nodes"].push_back({{"intensity", node.intensity}, {"opacity", node.opacity}});
    return writeFileAtomically(path, object.dump(2) + "\n");
}

}  // namespace echolucent
