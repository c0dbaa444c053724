#include "io/headers/nrrd_fields.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

struct TypeAlias {
    std::string_view name;
    StoredType type;
};
constexpr std::array<TypeAlias, 38> typeAliases{{{"signed char", StoredType::int8},
                                                 {"int8", StoredType::int8},
                                                 {"int8_t", StoredType::int8},
                                                 {"uchar", StoredType::uint8},
                                                 {"unsigned char", StoredType::uint8},
                                                 {"uint8", StoredType::uint8},
                                                 {"uint8_t", StoredType::uint8},
                                                 {"short", StoredType::int16},
                                                 {"short int", StoredType::int16},
                                                 {"signed short", StoredType::int16},
                                                 {"signed short int", StoredType::int16},
                                                 {"int16", StoredType::int16},
                                                 {"int16_t", StoredType::int16},
                                                 {"ushort", StoredType::uint16},
                                                 {"unsigned short", StoredType::uint16},
                                                 {"unsigned short int", StoredType::uint16},
                                                 {"uint16", StoredType::uint16},
                                                 {"uint16_t", StoredType::uint16},
                                                 {"int", StoredType::int32},
                                                 {"signed int", StoredType::int32},
                                                 {"int32", StoredType::int32},
                                                 {"int32_t", StoredType::int32},
                                                 {"uint", StoredType::uint32},
                                                 {"unsigned int", StoredType::uint32},
                                                 {"uint32", StoredType::uint32},
                                                 {"uint32_t", StoredType::uint32},
                                                 {"longlong", StoredType::int64},
                                                 {"long long", StoredType::int64},
                                                 {"long long int", StoredType::int64},
                                                 {"int64", StoredType::int64},
                                                 {"int64_t", StoredType::int64},
                                                 {"ulonglong", StoredType::uint64},
                                                 {"unsigned long long", StoredType::uint64},
                                                 {"unsigned long long int", StoredType::uint64},
                                                 {"uint64", StoredType::uint64},
                                                 {"uint64_t", StoredType::uint64},
                                                 {"float", StoredType::float32},
                                                 {"double", StoredType::float64}}};

/// Fields that have two names.
constexpr std::array<std::array<std::string_view, 2>, 6> otherNames{{{"datafile", "data file"},
                                                                     {"lineskip", "line skip"},
                                                                     {"byteskip", "byte skip"},
                                                                     {"axismins", "axis mins"},
                                                                     {"axismaxs", "axis maxs"},
                                                                     {"centers", "centerings"}}};

Result<void> readLine(const std::string& path, std::string_view line, int number, NrrdFields& result) {
    if (line.starts_with('#')) return {};
    const auto colon = line.find(':');
    const bool isKey = colon != std::string_view::npos && line.substr(colon).starts_with(":=");
    const bool isField = colon != std::string_view::npos &&
                         (colon + 1 == line.size() || line[colon + 1] == ' ' || line[colon + 1] == '\t');
    if (isKey) {
        const std::string key = trimmed(line.substr(0, colon));
        const std::string value = trimmed(line.substr(colon + 2));
        const auto [known, isNew] = result.keys.emplace(key, value);
        // Only the values of such keys are read.
        const bool isRead = key == "WhiteLevel" || key == "BlackLevel" || key.starts_with("axis ") ||
                            key.starts_with("MultiVolume.") || key.starts_with("Seq_Frame");
        if (!isNew && isRead && known->second != value)
            return fail(FailureKind::unreadable, path, key, "appears twice in the header, with different values",
                        correctHeader);
        return {};
    }
    if (!isField)
        return fail(FailureKind::unreadable, path, "",
                    fmt::format("has no \"field: value\" in line {} of its header ({})", number, quotedText(line)),
                    "This is no NRRD file, or its header is damaged.");
    std::string field = lowerCase(trimmed(line.substr(0, colon)));
    for (const auto& [other, name] : otherNames)
        if (field == other) field = name;
    const std::string value = trimmed(line.substr(colon + 1));
    const auto [known, isNew] = result.fields.emplace(field, value);
    if (isNew) return {};
    if (known->second != value)
        return fail(FailureKind::unreadable, path, quotedText(field),
                    "appears twice in the header, with different values", correctHeader);
    result.repeated.insert(field);
    return {};
}

}  // namespace

Result<NrrdFields> readNrrdFields(const InputFile& file) {
    const std::string& path = file.path();
    const auto beginning = file.beginning(headerLimit);
    if (!beginning) return tl::unexpected(beginning.error());
    std::string_view rest = withoutByteOrderMark(*beginning);
    if (rest.starts_with("NRRD") && endsLinesWithLoneCr(rest))
        return fail(FailureKind::unreadable, path, "", loneCrProblem, loneCrRemedy);
    auto magic = nextLine(rest);
    if (magic) magic = magic->substr(0, magic->find_last_not_of(" \t") + 1);
    if (beginning->size() < 8 && std::string_view("NRRD000").starts_with(beginning->substr(0, 7)))
        return fail(FailureKind::unreadable, path, "",
                    fmt::format("ends after {} bytes, within the first line of its header", beginning->size()),
                    damagedFile);
    if (!magic || magic->size() != 8 || !magic->starts_with("NRRD000"))
        return fail(FailureKind::unreadable, path, "", "does not begin with NRRD and a version",
                    "This is no NRRD file.");
    if (magic->back() < '1' || magic->back() > '5')
        return fail(FailureKind::unreadable, path, "",
                    "is of NRRD version " + quotedText(magic->substr(4)) + ", only 0001 to 0005 are known",
                    "Export the volume again as NRRD0004 or NRRD0005.");
    NrrdFields result;
    for (int number = 2; const auto line = nextLine(rest); ++number) {
        if (line->empty()) {
            result.ended = true;
            break;
        }
        if (rest.empty() && !beginning->ends_with('\n') && line->find(':') == std::string_view::npos &&
            !line->starts_with('#'))
            return fail(FailureKind::unreadable, path, "",
                        fmt::format("ends within line {} of its header ({})", number, quotedText(*line)), damagedFile);
        if (const auto read = readLine(path, *line, number, result); !read) return tl::unexpected(read.error());
        if (const auto data = result.fields.find("data file");
            data != result.fields.end() && isNrrdList(data->second)) {
            while (const auto name = nextLine(rest))
                if (!trimmed(*name).empty()) result.dataFiles.push_back(trimmed(*name));
            if (file.size() > headerLimit)
                return fail(FailureKind::unreadable, path, "data file",
                            fmt::format("begins a list that is longer than {} bytes", headerLimit),
                            "Save the volume as one .nrrd file.");
        }
    }
    result.headerBytes = beginning->size() - rest.size();
    return result;
}

bool isNrrdList(const std::string& dataFile) {
    return dataFile == "LIST" || dataFile.starts_with("LIST ") || dataFile.starts_with("LIST\t");
}

std::optional<StoredType> nrrdType(const std::string& text) {
    const std::string name = lowerCase(text);
    const auto known = std::find_if(typeAliases.begin(), typeAliases.end(),
                                    [&](const TypeAlias& alias) { return alias.name == name; });
    return known == typeAliases.end() ? std::nullopt : std::optional(known->type);
}

std::optional<std::vector<NrrdVector>> nrrdVectors(const std::string& text) {
    std::vector<NrrdVector> vectors;
    std::string_view rest = text;
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        if (rest.empty()) return vectors;
        if (rest.starts_with("none")) {
            vectors.emplace_back(std::nullopt);
            rest.remove_prefix(4);
            continue;
        }
        const auto end = rest.find(')');
        if (rest.front() != '(' || end == std::string_view::npos) return std::nullopt;
        std::string numbers(rest.substr(1, end - 1));
        std::replace(numbers.begin(), numbers.end(), ',', ' ');
        const auto values = realNumbers(numbers);
        if (!values || values->size() < 2 || values->size() > 4) return std::nullopt;
        vectors.emplace_back(*values);
        rest.remove_prefix(end + 1);
    }
}

std::vector<std::string> nrrdWords(const std::string& text) {
    std::vector<std::string> words;
    std::string_view rest = text;
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        if (rest.empty()) return words;
        const bool quoted = rest.front() == '"';
        if (quoted) rest.remove_prefix(1);
        const auto end = std::min(quoted ? rest.find('"') : rest.find_first_of(" \t"), rest.size());
        words.push_back(trimmed(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

}  // namespace echolucent
