#include "io/document/json_fields.h"

#include <cmath>

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

}  // namespace

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
    Vec3 vector{0, 0, 0};
    if (!value) return vector;
    bool good = value->is_array() && value->size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
        good = (*value)[i].is_number() && std::isfinite((*value)[i].get<double>());
        if (good) vector[static_cast<int>(i)] = (*value)[i].get<double>();
    }
    if (!good) wrong(key, "must be a list of three numbers");
    return vector;
}

JsonFields JsonFields::object(const char* key) {
    const json* value = find(key);
    return {value ? *value : emptyObject(), m_place.empty() ? std::string(key) : m_place + "." + key, *m_problems};
}

std::vector<JsonFields> JsonFields::list(const char* key) {
    std::vector<JsonFields> entries;
    const json* value = find(key);
    if (value && !value->is_array()) {
        wrong(key, "must be a list");
    } else if (value) {
        const std::string place = m_place.empty() ? std::string(key) : m_place + "." + key;
        for (std::size_t i = 0; i < value->size(); ++i)
            entries.emplace_back((*value)[i], fmt::format("{}[{}]", place, i), *m_problems);
    }
    return entries;
}

std::optional<ParameterValue> JsonFields::parameterValue(const json& value, const std::optional<ParameterValue>& like) {
    if (!like) return std::nullopt;
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

}  // namespace echolucent
