#include "io/document/design_json.h"

#include <array>
#include <utility>
#include <vector>

#include "io/json_document.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t mostEmphasisNodes = 64;

void writeMore(const KindlmannConfig& config, ordered_json& object) {
    std::vector<std::array<double, 2>> nodes;
    for (const EmphasisNode& node : config.drawn) nodes.push_back({node.position, node.opacity});
    object["drawn"] = nodes;
}
template <typename Config>
void writeMore(const Config&, ordered_json&) {}

void readMore(JsonFields& fields, KindlmannConfig& config) {
    if (!fields.has("drawn")) return;
    config.drawn.clear();
    for (const auto& [position, opacity] : fields.pairs("drawn", mostEmphasisNodes))
        config.drawn.push_back({position, opacity});
}
template <typename Config>
void readMore(JsonFields&, Config&) {}

}  // namespace

ordered_json designJson(const DesignerConfig& config) {
    ordered_json object{{"designer", nameOf(designerOf(config))}};
    std::visit(
        [&](const auto& values) {
            object["parameters"] = parametersJson(parametersOf(values), values);
            writeMore(values, object);
        },
        config);
    return object;
}

DesignerConfig designIn(JsonFields& fields) {
    DesignerConfig config = defaultConfigOf(fields.choice("designer", &designerFromName));
    std::visit(
        [&](auto& values) {
            if (fields.has("parameters")) fields.object("parameters").parameters(parametersOf(values), values);
            readMore(fields, values);
        },
        config);
    return config;
}

}  // namespace echolucent
