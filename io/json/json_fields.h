// Checked access to the values of a JSON object; the first that is wrong is kept as a failure that names its key.
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

/// The JSON object that a text holds. A text that is no JSON object (the sentence names the line where it breaks), that
/// holds a number too large for a double, that nests deeper than any of this program's files, or whose "format" and
/// "version" are not the given format and from 1 to `newest`, is refused. The file is named in that sentence, which
/// ends with the remedy.
[[nodiscard]] Result<nlohmann::json> jsonObject(std::string_view text, const std::string& file,
                                                const std::string& format, const std::string& remedy, int newest = 1);

/// What went wrong while a file was read.
struct JsonProblems {
    std::string file;
    std::optional<Failure> first;
    /// The first problem with what to do about it; there must be one.
    [[nodiscard]] tl::unexpected<Failure> refused(const std::string& remedy) const;
};

/// The values of one object. A value that is missing or wrong is told to the problems, which outlive this, and read as
/// the least that is allowed (0 where nothing is), false, an empty text, (0, 0, 0), an object or a list without
/// entries.
class JsonFields {
public:
    static constexpr std::size_t anyNumber = std::numeric_limits<std::size_t>::max();

    /// `place` holds the keys from the file's root to this object ("poses[0]"), and is empty for the root itself.
    JsonFields(const nlohmann::json& object, std::string place, JsonProblems& problems);

    [[nodiscard]] bool has(const char* key) const;
    /// Whether the value is null, or missing.
    bool isNull(const char* key);
    /// A finite number in [least, largest].
    double number(const char* key, double least = -std::numeric_limits<double>::infinity(),
                  double largest = std::numeric_limits<double>::infinity());
    /// A whole number in [least, largest].
    std::int64_t whole(const char* key, std::int64_t least, std::int64_t largest);
    /// A whole number from 0 to 2^64 - 1.
    std::uint64_t seed(const char* key);
    /// True or false.
    bool flag(const char* key);
    std::string text(const char* key);
    /// Three finite numbers.
    Vec3 vector(const char* key);
    /// A list of triples of finite numbers.
    std::vector<Vec3> vectors(const char* key);
    /// A list of whole numbers in [least, largest].
    std::vector<std::int64_t> wholes(const char* key, std::int64_t least, std::int64_t largest);
    /// Finite numbers, as many as there are.
    std::vector<double> numbers(const char* key);
    /// A list of at most so many pairs of finite numbers.
    std::vector<std::array<double, 2>> pairs(const char* key, std::size_t most = anyNumber);
    /// The object under a key.
    JsonFields object(const char* key);
    /// The objects of a list of at most so many entries.
    std::vector<JsonFields> list(const char* key, std::size_t most = anyNumber);
    /// Three whole numbers from 1 to `largest`: the size of a volume, voxels. Whoever makes the volume checks the
    /// product.
    std::array<std::int64_t, 3> size(const char* key, double largest = 1e6);
    /// A choice by name; `named` gives none for an unknown name.
    template <typename Choice>
    Choice choice(const char* key, std::optional<Choice> (*named)(std::string_view)) {
        const std::string name = text(key);
        const std::optional<Choice> found = named(name);
        if (!found) wrong(key, "must not be " + shortened("\"" + name + "\""));
        return found.value_or(Choice{});
    }
    /// The parameters of a table that stand here; what is not here stays. A table holds each choice before the
    /// parameters that have a meaning by it.
    template <typename Values>
    void parameters(const ParameterTable<Values>& table, Values& values) {
        for (const Parameter<Values>& row : table) take(row, values);
    }
    /// Whether anything was wrong so far, in this object or in others of the same problems.
    [[nodiscard]] bool failed() const { return m_problems->first.has_value(); }
    /// Notes that a key holds something wrong; `problem` is lower case and has no full stop.
    void wrong(const char* key, const std::string& problem);

    /// What a file says, as long as a sentence can bear.
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
    /// The value of a key that is there as a parameter's value of the kind that `like` has, or nothing where it is no
    /// such value.
    [[nodiscard]] std::optional<ParameterValue> parameterValue(const char* key,
                                                               const std::optional<ParameterValue>& like) const;
    /// The value of a key that is there as JSON.
    [[nodiscard]] std::string written(const char* key) const;

    const nlohmann::json* m_object;
    std::string m_place;
    JsonProblems* m_problems;
};

}  // namespace echolucent
