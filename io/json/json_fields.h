// Checked access to the values of a JSON object. The first wrong value is kept as a failure that names its key.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/parameters/parameter.h"
#include "processing/result.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// The JSON object in a text. Fails if the text is no JSON object; the message names the line where JSON breaks. It
/// also fails if a number is too large for a double, or if the object nests deeper than any of this program's files.
/// "format" must be `format`, and "version" 1 to `newest`. The message names the file and ends with the remedy.
[[nodiscard]] Result<nlohmann::json> jsonObject(std::string_view text, const std::string& file,
                                                const std::string& format, const std::string& remedy, int newest = 1);

/// Whether lists and objects of a JSON text nest deeper than in any file of this program. Values are read recursively,
/// so deeper ones would exhaust the stack.
[[nodiscard]] bool nestsTooDeep(std::string_view text);

/// The first problem of reading a file.
struct JsonProblems {
    std::string file;
    std::optional<Failure> first;
    /// The first problem with its remedy. There must be one.
    [[nodiscard]] tl::unexpected<Failure> refused(const std::string& remedy) const;
};

/// The values of one object. A missing or wrong value is told to `problems`, which must outlive the object. In its
/// place one reads the least allowed value (0 if there is no least), false, (0, 0, 0), or an empty text or object. A
/// list of numbers then ends before its first wrong entry.
class JsonFields {
public:
    static constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

    /// `place` holds the keys from the file's root to this object ("poses[0]"); it is empty for the root.
    JsonFields(const nlohmann::json& object, std::string place, JsonProblems& problems);

    [[nodiscard]] bool has(const char* key) const;
    /// Whether the value is null or missing. A missing key is told to the problems.
    bool isNull(const char* key);
    /// A finite number in [least, largest].
    double number(const char* key, double least = -std::numeric_limits<double>::infinity(),
                  double largest = std::numeric_limits<double>::infinity());
    /// A whole number in [least, largest].
    std::int64_t whole(const char* key, std::int64_t least, std::int64_t largest);
    /// A whole number from 0 to 2^64 - 1.
    std::uint64_t seed(const char* key);
    bool flag(const char* key);
    std::string text(const char* key);
    /// Three finite numbers.
    Vec3 vector(const char* key);
    /// A list of triples of finite numbers.
    std::vector<Vec3> vectors(const char* key);
    /// A list of whole numbers in [least, largest].
    std::vector<std::int64_t> wholes(const char* key, std::int64_t least, std::int64_t largest);
    /// A list of finite numbers.
    std::vector<double> numbers(const char* key);
    /// A list of at most `most` pairs of finite numbers.
    std::vector<std::array<double, 2>> pairs(const char* key, std::size_t most = anyNumber);
    /// The object under a key.
    JsonFields object(const char* key);
    /// The objects of a list of at most `most` entries.
    std::vector<JsonFields> list(const char* key, std::size_t most = anyNumber);
    /// The size of a volume, voxels: three whole numbers from 1 to `largest`; 1 in place of a wrong one. The product is
    /// not checked here.
    std::array<std::int64_t, 3> size(const char* key, double largest = 1e6);
    /// A choice by name; Choice{} in place of a wrong one. `named` gives no value for an unknown name.
    template <typename Choice>
    Choice choice(const char* key, std::optional<Choice> (*named)(std::string_view)) {
        const std::string name = text(key);
        const std::optional<Choice> found = named(name);
        if (!found) wrong(key, "must not be " + shortened("\"" + name + "\""));
        return found.value_or(Choice{});
    }
    /// Reads the parameters of a table; those missing here stay as they are. In the table, a choice stands before the
    /// parameters that depend on it.
    template <typename Values>
    void parameters(const ParameterTable<Values>& table, Values& values) {
        for (const Parameter<Values>& row : table) take(row, values);
    }
    /// Whether anything was wrong so far, here or in other objects with the same problems.
    [[nodiscard]] bool failed() const { return m_problems->first.has_value(); }
    /// Notes a problem with a key, in lower case without full stop.
    void wrong(const char* key, const std::string& problem);

    /// A text from a file, cut to the length that a message can bear.
    [[nodiscard]] static std::string shortened(const std::string& text);

private:
    template <typename Values>
    void take(const Parameter<Values>& row, Values& values) {
        const std::string key(row.name);
        if (!has(key.c_str())) return;
        const std::optional<ParameterValue> value = parameterValue(key.c_str(), row.get(values));
        if (!value || !row.set(values, *value))
            wrong(key.c_str(), "must not be " + shortened(written(key.c_str())));
        else if (const auto number = numberOf(*value); number && !inRange(*number, row.range))
            wrong(key.c_str(), "must be " + textOf(row.range.least) + " to " + textOf(row.range.largest));
    }
    const nlohmann::json* find(const char* key);
    /// The value of an existing key as a parameter's value of the same type as `like`; no value if it has another type.
    [[nodiscard]] std::optional<ParameterValue> parameterValue(const char* key,
                                                               const std::optional<ParameterValue>& like) const;
    /// The value of an existing key as JSON text.
    [[nodiscard]] std::string written(const char* key) const;

    const nlohmann::json* m_object;
    std::string m_place;
    JsonProblems* m_problems;
};

}  // namespace echolucent
