#include "io/document/value_text.h"

#include <nlohmann/json.hpp>

#include "io/document/document_parts.h"
#include "io/json/json_document.h"

namespace echolucent {

namespace {

/// What `read` makes of the object that a text holds.
template <typename Read>
auto valueIn(std::string_view text, const Read& read) -> std::optional<decltype(read(std::declval<JsonFields&>()))> {
    const auto object = nlohmann::json::parse(text, nullptr, false);
    if (object.is_discarded()) return std::nullopt;
    JsonProblems problems{{}, std::nullopt};
    JsonFields fields(object, {}, problems);
    auto value = read(fields);
    return problems.first ? std::nullopt : std::optional(std::move(value));
}

}  // namespace

std::string textOf(const Look& look) { return lookJson(look).dump(); }
std::string textOf(const MethodChoice& method) { return methodJson(method).dump(); }
std::string textOf(const MotionChoice& motion) { return motionJson(motion).dump(); }

std::optional<Look> lookFromText(std::string_view text) { return valueIn(text, lookIn); }
std::optional<MethodChoice> methodFromText(std::string_view text) { return valueIn(text, methodIn); }
std::optional<MotionChoice> motionFromText(std::string_view text) {
    auto motion = valueIn(text, motionIn);
    return motion && problemOf(*motion).empty() ? motion : std::nullopt;
}

}  // namespace echolucent
