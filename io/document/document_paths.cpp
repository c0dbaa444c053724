#include "io/document/document_paths.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/document/document_object.h"
#include "io/json/json_fields.h"
#include "io/json/json_parameters.h"
#include "processing/adaptive/method_parameters.h"

namespace echolucent {

namespace {

using nlohmann::ordered_json;
using Pointer = ordered_json::json_pointer;

/// Keys of a pane that are missing in a file if they hold nothing.
constexpr std::array keysOfSomePanes{"designer", "method", "linear", "phase", "motion_otf"};
/// Keys of the document that are no value of it.
constexpr std::array keysOfFile{"format", "version"};

/// The JSON of the document with every key that a file may leave out, and without those of the file.
ordered_json wholeObject(const Document& document) {
    ordered_json object = documentJson(document);
    for (const char* key : keysOfFile) object.erase(key);
    const auto add = [](ordered_json& part, const char* key, const ordered_json& value) {
        if (!part.contains(key)) part[key] = value;
    };
    add(object["scene"], "exposure", 1.0);
    add(object["scene"]["planes"], "turns_view", false);
    add(object["comparison"], "colours", false);
    add(object["method"]["parameters"], "without_tubes", ordered_json::array());
    for (ordered_json& pane : object["panes"]) {
        for (const char* key : keysOfSomePanes) add(pane, key, nullptr);
        add(pane, "without_tubes", ordered_json::array());
    }
    for (ordered_json& measurement : object["measurements"])
        for (const char* key : {"name", "comment"}) add(measurement, key, "");
    return object;
}

/// The steps of a path, with the point and the brackets: ["scene", "front"], or ["panes", 1]. No value if it is none.
std::optional<Pointer> pointerOf(std::string_view path) {
    if (path.empty() || path.size() > longestDocumentPath) return std::nullopt;
    Pointer pointer;
    const auto isDigit = [](char letter) { return letter >= '0' && letter <= '9'; };
    const auto isKey = [&](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || isDigit(letter) || letter == '_';
    };
    std::size_t at = 0;
    while (at < path.size()) {
        const std::size_t begin = at;
        while (at < path.size() && isKey(path[at])) ++at;
        if (at == begin || isDigit(path[begin])) return std::nullopt;  // a number stands in brackets
        pointer /= std::string(path.substr(begin, at - begin));
        while (at < path.size() && path[at] == '[') {
            const std::size_t end = path.find(']', at);
            if (end == std::string_view::npos) return std::nullopt;
            std::size_t number = 0;
            const auto [stop, error] = std::from_chars(path.data() + at + 1, path.data() + end, number);
            if (error != std::errc{} || stop != path.data() + end) return std::nullopt;
            pointer /= number;
            at = end + 1;
        }
        if (at == path.size()) return pointer;
        if (path[at] != '.' || ++at == path.size()) return std::nullopt;
    }
    return std::nullopt;
}

/// The value at a pointer whose steps into lists are numbers and into objects are keys; null if there is none.
ordered_json* find(ordered_json& object, std::string_view path) {
    const auto pointer = pointerOf(path);
    if (!pointer) return nullptr;
    try {
        return &object.at(*pointer);
    } catch (const ordered_json::exception&) {
        return nullptr;
    }
}

tl::unexpected<Failure> namesNothing(std::string_view path) {
    return fail(FailureKind::wrongUsage, {}, JsonFields::shortened(std::string(path)),
                "names no value of this document", "docs/document.md says how a value is named.");
}

std::string joined(const std::string& place, const std::string& key) { return place.empty() ? key : place + "." + key; }

/// Puts the values of `part` in the place of those of `object`.
void take(ordered_json& object, const ordered_json& part) {
    for (const auto& [key, value] : part.items()) {
        ordered_json& present = object[key];
        // A study is named in one of several ways.
        if (value.is_object() && present.is_object() && key != "study")
            take(present, value);
        else
            present = value;
    }
}

/// The place of the first value of `wanted` that `held` does not have. Empty if it has all of them; "" is no place.
std::optional<std::string> firstMissing(const ordered_json& wanted, const ordered_json& held,
                                        const std::string& place) {
    if (wanted.is_object()) {
        if (!held.is_object()) return place;
        for (const auto& [key, value] : wanted.items()) {
            const auto found = held.find(key);
            if (found == held.end()) return joined(place, key);
            if (auto missing = firstMissing(value, *found, joined(place, key))) return missing;
        }
        return std::nullopt;
    }
    if (wanted.is_array()) {
        if (!held.is_array() || held.size() != wanted.size()) return place;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (auto missing = firstMissing(wanted[i], held[i], fmt::format("{}[{}]", place, i))) return missing;
        return std::nullopt;
    }
    return wanted == held ? std::nullopt : std::optional(place);
}

/// Whether `path` is a parameter that may lose its meaning by a choice of another one.
bool dependsOnChoice(const std::string& path) {
    return path.starts_with("scene.look.") || path.starts_with("method.parameters.") ||
           path.find("].designer.parameters.") != std::string::npos || path.find("].method.") != std::string::npos;
}

/// The text of any value; what is no UTF-8 in a file's name is replaced.
std::string textOfAny(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void addAim(ordered_json& method) {
    if (!method.is_object() || method.contains("aim")) return;
    static const ordered_json standard = parametersJson(methodParameters(), methodParameters().standard);
    method["aim"] = standard.at("aim");
}

/// Reads the document of a whole object. Parameters that are not in `given` and that a choice in it leaves without a
/// meaning are dropped.
Result<Document> readWhole(ordered_json object, const ordered_json& given) {
    object["format"] = documentFormatName;
    object["version"] = documentVersion;
    if (ordered_json& panes = object["panes"]; panes.is_array())
        for (ordered_json& pane : panes)
            for (const char* key : keysOfSomePanes)
                if (pane.is_object() && pane.contains(key) && pane[key].is_null()) pane.erase(key);
    // Without this key a document means the curve of bright surfaces; here it has its default if it gets a meaning.
    addAim(object["method"]["parameters"]);
    if (ordered_json& panes = object["panes"]; panes.is_array())
        for (ordered_json& pane : panes)
            if (pane.is_object() && pane.contains("method")) addAim(pane["method"]);
    for (;;) {
        auto read = documentOf(nlohmann::json::parse(textOfAny(object)), {}, {});
        if (read) return read;
        Failure& failure = read.error();
        ordered_json whole = given;
        const bool stale = dependsOnChoice(failure.element) && find(object, failure.element) != nullptr &&
                           find(whole, failure.element) == nullptr;
        if (!stale) {
            failure.kind = FailureKind::wrongUsage;
            failure.remedy.clear();
            return read;
        }
        const std::size_t point = failure.element.rfind('.');
        find(object, failure.element.substr(0, point))->erase(failure.element.substr(point + 1));
    }
}

/// The document of `object`, which `document` became by the values of `given`; these must stand in it.
Result<Document> readHolding(const Document& document, const ordered_json& object, const ordered_json& given) {
    auto read = readWhole(object, given);
    if (!read) return read;
    if (!given.contains("study")) read->study = document.study;  // its path may be no UTF-8
    const ordered_json held = wholeObject(*read);
    if (const auto missing = firstMissing(given, held, {})) {
        ordered_json whole = held;
        return fail(FailureKind::wrongUsage, {}, JsonFields::shortened(*missing),
                    find(whole, *missing) != nullptr ? "cannot be this as the document is set"
                                                     : "names no value of this document");
    }
    return read;
}

/// A JSON text of bounded size and depth; no value if it is none.
std::optional<ordered_json> parsed(std::string_view text) {
    if (text.size() > longestDocumentPart || nestsTooDeep(text)) return std::nullopt;
    try {
        return ordered_json::parse(text);
    } catch (const ordered_json::exception&) {
        return std::nullopt;
    }
}

ordered_json partBetweenObjects(const ordered_json& from, const ordered_json& to) {
    ordered_json part = ordered_json::object();
    for (const auto& [key, value] : to.items()) {
        const auto before = from.find(key);
        if (before != from.end() && *before == value) continue;
        if (before != from.end() && before->is_object() && value.is_object())
            part[key] = partBetweenObjects(*before, value);
        else
            part[key] = value;
    }
    return part;
}

void listPaths(const ordered_json& value, const std::string& place, std::vector<std::string>& paths) {
    const bool ofObjects = value.is_array() && !value.empty() && value.front().is_object();
    if (value.is_object()) {
        for (const auto& [key, each] : value.items()) listPaths(each, joined(place, key), paths);
    } else if (ofObjects) {
        for (std::size_t i = 0; i < value.size(); ++i) listPaths(value[i], fmt::format("{}[{}]", place, i), paths);
    } else {
        paths.push_back(place);
    }
}

/// Of a list or an object the number of its entries.
DocumentValue plainValue(const ordered_json& value) {
    if (value.is_null()) return {};
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>();
    if (value.is_string()) return value.get<std::string>();
    return static_cast<double>(value.size());
}

}  // namespace

Result<DocumentValue> valueAt(const Document& document, std::string_view path) {
    if (auto value = valuesAt(document, {std::string(path)}).front()) return *std::move(value);
    return namesNothing(path);
}

std::vector<std::optional<DocumentValue>> valuesAt(const Document& document, const std::vector<std::string>& paths) {
    if (paths.empty()) return {};
    ordered_json object = wholeObject(document);
    std::vector<std::optional<DocumentValue>> values;
    for (const std::string& path : paths) {
        const ordered_json* value = find(object, path);
        values.push_back(value ? std::optional(plainValue(*value)) : std::nullopt);
    }
    return values;
}

Result<std::string> textAt(const Document& document, std::string_view path) {
    ordered_json object = wholeObject(document);
    const ordered_json* value = find(object, path);
    if (value == nullptr) return namesNothing(path);
    return textOfAny(*value);
}

Result<Document> withValueAt(const Document& document, std::string_view path, std::string_view value) {
    ordered_json object = wholeObject(document);
    ordered_json* present = find(object, path);
    if (present == nullptr) return namesNothing(path);
    if (value.size() > longestDocumentPart)
        return fail(FailureKind::wrongUsage, {}, std::string(path), "is set to too long a text");
    *present = parsed(value).value_or(ordered_json(std::string(value)));
    // Only what stands on the way to the value is given: an entry of a list keeps its neighbours.
    ordered_json given = *present;
    for (Pointer pointer = *pointerOf(path); !pointer.empty(); pointer.pop_back()) {
        const Pointer above = pointer.parent_pointer();
        ordered_json around;
        if (object.at(above).is_array()) {
            around = object.at(above);
            around.at(std::stoul(pointer.back())) = given;
        } else {
            around = ordered_json{{pointer.back(), given}};
        }
        given = std::move(around);
    }
    return readHolding(document, object, given);
}

Result<Document> withPart(const Document& document, std::string_view part, const std::string& file,
                          const std::string& place) {
    const auto refuse = [&](Failure failure) {
        failure.file = file;
        if (!place.empty()) failure.element = joined(place, failure.element);
        if (failure.element == place + ".") failure.element = place;
        return tl::unexpected(std::move(failure));
    };
    const auto given = parsed(part);
    if (!given || !given->is_object())
        return refuse({FailureKind::wrongUsage, {}, {}, "must be a part of a document as a JSON object", {}});
    for (const char* key : keysOfFile)
        if (given->contains(key)) return refuse({FailureKind::wrongUsage, {}, key, "is no part of a document", {}});
    ordered_json object = wholeObject(document);
    take(object, *given);
    auto read = readHolding(document, object, *given);
    if (!read) return refuse(read.error());
    return read;
}

std::string partBetween(const Document& from, const Document& to) {
    return textOfAny(partBetweenObjects(wholeObject(from), wholeObject(to)));
}

std::vector<std::string> pathsOf(const Document& document) {
    std::vector<std::string> paths;
    listPaths(wholeObject(document), {}, paths);
    return paths;
}

}  // namespace echolucent
