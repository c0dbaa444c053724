#include "processing/designers/choice/designer_config.h"

#include <algorithm>

namespace echolucent {

namespace {

template <typename Ask>
auto ofEach(const Ask& ask) {
    return [&]<typename... Configs>(const std::variant<Configs...>*) {
        return std::array{ask(Configs{})...};
    }(static_cast<const DesignerConfig*>(nullptr));
}

const DesignerWords& wordsOf(Designer designer) {
    static const auto all = ofEach([](const auto& config) { return config.words; });
    return all.at(static_cast<std::size_t>(designer));
}

}  // namespace

std::string_view nameOf(Designer designer) { return wordsOf(designer).name; }
std::string_view labelOf(Designer designer) { return wordsOf(designer).label; }

std::optional<Designer> designerFromName(std::string_view name) {
    const auto found = std::ranges::find(allDesigners, name, [](Designer each) { return nameOf(each); });
    return found != allDesigners.end() ? std::optional(*found) : std::nullopt;
}

DesignerConfig defaultConfigOf(Designer designer) {
    return ofEach([](const auto& config) { return DesignerConfig(config); }).at(static_cast<std::size_t>(designer));
}

bool readsTubeCores(const DesignerConfig& config) {
    return std::visit(
        [](const auto& values) {
            if constexpr (requires { values.readsTubeCores(); }) return values.readsTubeCores();
            return false;
        },
        config);
}

}  // namespace echolucent
