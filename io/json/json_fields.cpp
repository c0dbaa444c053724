#include "io/json/json_fields.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace echolucent {

namespace {

using nlohmann::json;

const json& emptyObject() {
    static const json object = json::object();
    return object;
}

std::string rangeText(double least, double largest) {
    if (std::isfinite(largest)) return fmt::format("must be {} to {}", textOf(least), textOf(largest));
    if (!std::isfinite(least)) return "must be a finite number";
    return least > 0 && least < 1e-300 ? "must be above 0" : fmt::format("must be {} or more", textOf(least));
}

/// Three finite numbers; no value if `value` is no list of them.
std::optional<Vec3> vectorOf(const json& value) {
    if (!value.is_array() || value.size() != 3) return std::nullopt;
    Vec3 vector;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!value[i].is_number() || !std::isfinite(value[i].get<double>())) return std::nullopt;
        vector[static_cast<int>(i)] = value[i].get<double>();
    }
    return vector;
}

}  // namespace

bool nestsTooDeep(std::string_view text) {
    constexpr int deepest = 64;
    int depth = 0;
    bool inText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (inText && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            inText = !inText;
        else if (!inText && (text[i] == '[' || text[i] == '{') && ++depth > deepest)
            return true;
        else if (!inText && (text[i] == ']' || text[i] == '}'))
            --depth;
    }
    return false;
}

Result<json> jsonObject(std::string_view text, const std::string& file, const std::string& format,
                        const std::string& remedy, int newest) {
    const auto refuse = [&](const std::string& key, const std::string& problem) {
        return fail(FailureKind::unreadable, file, key, problem, remedy);
    };
    if (nestsTooDeep(text)) return refuse("", "nests lists or objects too deep");
    json object;
    try {
        object = json::parse(text);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        return refuse("", fmt::format("is not JSON: it breaks in line {}", 1 + std::count(text.begin(), end, '\n')));
    } catch (const json::exception&) {
        return refuse("", "holds a number too large for JSON readers");
    }
    if (!object.is_object()) return refuse("", "must be a JSON object");
    if (object.value("format", json()) != format) return refuse("format", "must be \"" + format + "\"");
    const json version = object.value("version", json());
    for (int known = 1; known <= newest; ++known)
        if (version == known) return object;
    return refuse("version", (newest == 1 ? "must be 1, not " : fmt::format("must be from 1 to {}, not ", newest)) +
                                 JsonFields::shortened(version.dump()));
}

tl::unexpected<Failure> JsonProblems::refused(const std::string& remedy) const {
    Failure failure = *first;
    failure.remedy = remedy;
    return tl::unexpected(std::move(failure));
}

JsonFields::JsonFields(const json& object, std::string place, JsonProblems& problems)
    : m_object(object.is_object() ? &object : &emptyObject()), m_place(std::move(place)), m_problems(&problems) {
    if (!object.is_object() && !m_problems->first)
        m_problems->first = Failure{FailureKind::unreadable, problems.file, m_place, "must be a JSON object", {}};
}

void JsonFields::wrong(const char* key, const std::string& problem) {
    if (m_problems->first) return;
    m_problems->first = Failure{FailureKind::unreadable,
                                m_problems->file,
                                m_place.empty() ? std::string(key) : m_place + "." + key,
                                problem,
                                {}};
}

std::string JsonFields::shortened(const std::string& text) {
    constexpr std::size_t longest = 60;
    if (text.size() <= longest) return text;
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // cut before a letter, not within
    return text.substr(0, end) + "...";
}

bool JsonFields::has(const char* key) const { return m_object->contains(key); }

const json* JsonFields::find(const char* key) {
    const auto found = m_object->find(key);
    if (found != m_object->end()) return &*found;
    wrong(key, "is missing");
    return nullptr;
}

bool JsonFields::isNull(const char* key) {
    const json* value = find(key);
    return !value || value->is_null();
}

double JsonFields::number(const char* key, double least, double largest) {
    const json* value = find(key);
    if (value && !value->is_number()) {
        wrong(key, "must be a number");
    } else if (value) {
        const double number = value->get<double>();
        if (std::isfinite(number) && number >= least && number <= largest) return number;
        wrong(key, fmt::format("{}, not {}", rangeText(least, largest), number));
    }
    return std::isfinite(least) ? least : 0.0;
}

std::int64_t JsonFields::whole(const char* key, std::int64_t least, std::int64_t largest) {
    const json* value = find(key);
    if (value && !value->is_number_integer()) {
        wrong(key, "must be a whole number");
    } else if (value) {
        const bool fits = !value->is_number_unsigned() ||
                          value->get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<std::int64_t>::max());
        if (fits && value->get<std::int64_t>() >= least && value->get<std::int64_t>() <= largest)
            return value->get<std::int64_t>();
        wrong(key, fmt::format("must be {} to {}, not {}", least, largest, value->dump()));
    }
    return least;
}

std::uint64_t JsonFields::seed(const char* key) {
    const json* value = find(key);
    if (value && value->is_number_unsigned()) return value->get<std::uint64_t>();
    if (value) wrong(key, "must be a whole number from 0 on");
    return 0;
}

bool JsonFields::flag(const char* key) {
    const json* value = find(key);
    if (value && value->is_boolean()) return value->get<bool>();
    if (value) wrong(key, "must be true or false");
    return false;
}

std::string JsonFields::text(const char* key) {
    const json* value = find(key);
    if (value && value->is_string()) return value->get<std::string>();
    if (value) wrong(key, "must be a text");
    return {};
}

Vec3 JsonFields::vector(const char* key) {
    const json* value = find(key);
    if (!value) return {0, 0, 0};
    const std::optional<Vec3> vector = vectorOf(*value);
    if (!vector) wrong(key, "must be a list of three numbers");
    return vector.value_or(Vec3{0, 0, 0});
}

std::vector<Vec3> JsonFields::vectors(const char* key) {
    const json* value = find(key);
    std::vector<Vec3> vectors;
    if (!value) return vectors;
    bool good = value->is_array();
    for (std::size_t i = 0; good && i < value->size(); ++i) {
        const std::optional<Vec3> vector = vectorOf((*value)[i]);
        good = vector.has_value();
        if (good) vectors.push_back(*vector);
    }
    if (!good) wrong(key, "must be a list of lists of three numbers");
    return vectors;
}

std::vector<std::int64_t> JsonFields::wholes(const char* key, std::int64_t least, std::int64_t largest) {
    const json* value = find(key);
    std::vector<std::int64_t> wholes;
    if (!value) return wholes;
    bool good = value->is_array();
    for (std::size_t i = 0; good && i < value->size(); ++i) {
        const json& entry = (*value)[i];
        good = entry.is_number_integer() && entry >= json(least) && entry <= json(largest);
        if (good) wholes.push_back(entry.get<std::int64_t>());
    }
    if (!good) wrong(key, fmt::format("must be a list of whole numbers from {} to {}", least, largest));
    return wholes;
}

std::vector<double> JsonFields::numbers(const char* key) {
    const json* value = find(key);
    std::vector<double> numbers;
    if (!value) return numbers;
    bool good = value->is_array();
    for (std::size_t i = 0; good && i < value->size(); ++i) {
        good = (*value)[i].is_number() && std::isfinite((*value)[i].get<double>());
        if (good) numbers.push_back((*value)[i].get<double>());
    }
    if (!good) wrong(key, "must be a list of numbers");
    return numbers;
}

std::vector<std::array<double, 2>> JsonFields::pairs(const char* key, std::size_t most) {
    const json* value = find(key);
    std::vector<std::array<double, 2>> pairs;
    if (!value) return pairs;
    const auto isNumber = [](const json& part) { return part.is_number() && std::isfinite(part.get<double>()); };
    bool good = value->is_array();
    for (std::size_t i = 0; good && i < value->size(); ++i) {
        const json& pair = (*value)[i];
        good = pair.is_array() && pair.size() == 2 && isNumber(pair[0]) && isNumber(pair[1]);
        if (good) pairs.push_back({pair[0].get<double>(), pair[1].get<double>()});
    }
    if (!good) wrong(key, "must be a list of pairs of numbers");
    if (pairs.size() > most) wrong(key, fmt::format("must hold at most {} pairs", most));
    return pairs;
}

JsonFields JsonFields::object(const char* key) {
    const json* value = find(key);
    return {value ? *value : emptyObject(), m_place.empty() ? std::string(key) : m_place + "." + key, *m_problems};
}

std::vector<JsonFields> JsonFields::list(const char* key, std::size_t most) {
    std::vector<JsonFields> entries;
    const json* value = find(key);
    if (value && !value->is_array()) {
        wrong(key, "must be a list");
    } else if (value && value->size() > most) {
        wrong(key, fmt::format("must hold at most {} entries, not {}", most, value->size()));
    } else if (value) {
        const std::string place = m_place.empty() ? std::string(key) : m_place + "." + key;
        for (std::size_t i = 0; i < value->size(); ++i)
            entries.emplace_back((*value)[i], fmt::format("{}[{}]", place, i), *m_problems);
    }
    return entries;
}

std::array<std::int64_t, 3> JsonFields::size(const char* key, double largest) {
    const Vec3 edges = vector(key);
    std::array<std::int64_t, 3> size{1, 1, 1};
    for (int axis = 0; axis < 3; ++axis) {
        if (edges[axis] >= 1 && edges[axis] <= largest && edges[axis] == std::floor(edges[axis]))
            size[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(edges[axis]);
        else
            wrong(key, "must be three whole numbers from 1 to " + textOf(largest));
    }
    return size;
}

std::optional<ParameterValue> JsonFields::parameterValue(const char* key,
                                                         const std::optional<ParameterValue>& like) const {
    if (!like) return std::nullopt;
    const json& value = *m_object->find(key);
    if (std::holds_alternative<bool>(*like) && value.is_boolean()) return ParameterValue(value.get<bool>());
    if (std::holds_alternative<std::int64_t>(*like) && value.is_number_integer() &&
        value <= json(std::numeric_limits<std::int64_t>::max()))
        return ParameterValue(value.get<std::int64_t>());
    if (std::holds_alternative<double>(*like) && value.is_number() && std::isfinite(value.get<double>()))
        return ParameterValue(value.get<double>());
    if (std::holds_alternative<std::string>(*like) && value.is_string())
        return ParameterValue(value.get<std::string>());
    return std::nullopt;
}

std::string JsonFields::written(const char* key) const { return m_object->find(key)->dump(); }

}  // namespace echolucent
