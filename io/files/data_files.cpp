#include "io/files/data_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "io/files/file_access.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

// A longer name would not fit into a message.
constexpr std::size_t longestName = 1000;

tl::unexpected<Failure> wrong(const DataFileKey& key, const std::string& problem,
                              const std::string& remedy = correctHeader) {
    return fail(FailureKind::unreadable, key.headerPath, key.key, problem, remedy);
}

/// Whether a name stays in or below its folder. Links are not looked at. False for names with a drive or with zero
/// bytes.
bool staysBelow(const std::string& name) {
    const std::filesystem::path path(name);
    const bool hasDrive = name.find(":\\") == 1;
    if (name.empty() || path.is_absolute() || hasDrive || name.find('\0') != std::string::npos || !path.has_filename())
        return false;
    return std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; }) &&
           path.filename() != ".";
}

/// The name with slashes for the backslashes that programs write on Windows, unless a file has that very name.
std::string nameIn(const std::filesystem::path& folder, std::string name) {
    const bool hasBackslash = name.find('\\') != std::string::npos;
    if (!hasBackslash || !staysBelow(name) || fileAccess().kindOf((folder / name).string()) == FileKind::file)
        return name;
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

/// The path without links. Parts that do not exist stay as they are.
std::filesystem::path endOf(const std::filesystem::path& path) { return fileAccess().resolved(path.string()); }

/// Whether a path leads into a folder or below it, links followed.
bool endsBelow(const std::filesystem::path& path, const std::filesystem::path& folder) {
    const auto root = endOf(folder), end = endOf(path);
    return std::mismatch(root.begin(), root.end(), end.begin(), end.end()).first == root.end();
}

/// The number of a pattern, and the text before and after it.
struct Pattern {
    std::string before, after;
    std::size_t width = 0;
    bool zeros = false;
};

std::optional<Pattern> patternFrom(const std::string& text) {
    constexpr std::size_t widest = 20;
    Pattern pattern;
    bool hasNumber = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string& part = hasNumber ? pattern.after : pattern.before;
        if (text[at] != '%') {
            part += text[at];
            continue;
        }
        if (text.compare(at, 2, "%%") == 0) {
            part += text[at++];
            continue;
        }
        const std::size_t end = text.find_first_not_of("0123456789", at + 1);
        if (hasNumber || end == std::string::npos || (text[end] != 'd' && text[end] != 'i' && text[end] != 'u'))
            return std::nullopt;
        const std::string width = text.substr(at + 1, end - at - 1);
        pattern.zeros = width.starts_with('0');
        const auto columns = width.empty() ? std::optional<std::int64_t>(0) : wholeNumber(width);
        if (!columns || static_cast<std::size_t>(*columns) > widest) return std::nullopt;
        pattern.width = static_cast<std::size_t>(*columns);
        hasNumber = true;
        at = end;
    }
    return hasNumber ? std::optional(pattern) : std::nullopt;
}

std::string nameWith(const Pattern& pattern, std::int64_t number) {
    const std::string digits =
        pattern.zeros ? fmt::format("{:0{}}", number, pattern.width) : fmt::format("{:{}}", number, pattern.width);
    return pattern.before + digits + pattern.after;
}

}  // namespace

Result<InputFile> DataFile::open() const {
    if (opened) return *opened;
    auto file = InputFile::open(path);
    // The name stands in the header, which may be cut off within this name.
    if (!file)
        file.error().remedy =
            "Put it beside the header with the permission to read it; where the header is cut off, copy both again.";
    return file;
}

Result<void> requireInItsFolder(const std::string& path) {
    if (endsBelow(path, std::filesystem::path(path).parent_path())) return {};
    return fail(FailureKind::unreadable, path, "", "is a link out of its folder, which is not followed",
                "Put the file itself into the folder, or remove the link.");
}

Result<DataFile> dataFileBeside(const DataFileKey& key, const std::string& name) {
    if (name.size() > longestName)
        return wrong(key,
                     fmt::format("names {}, which is {} letters long; no more than {} are read", quotedText(name),
                                 name.size(), longestName),
                     "Give the file a shorter name, and correct it in the header.");
    const auto folder = std::filesystem::path(key.headerPath).parent_path();
    if (name.empty())
        return wrong(key, "names no file", "The header is incomplete or damaged: copy or export it again.");
    const std::string found = nameIn(folder, name);
    if (!staysBelow(found) || !endsBelow(folder / found, folder))
        return wrong(key, "names " + quotedText(name) + ", which does not lie in or below the header's own folder",
                     "Put all files into one folder and correct the name in the header.");
    if (endOf(folder / found) == endOf(key.headerPath))
        return wrong(key, "names " + quotedText(name) + ", which is the header itself and holds no voxels",
                     "Put the file of voxels beside the header and correct the name in it.");
    std::string plain = found;
    while (plain.starts_with("./")) plain.erase(0, 2);
    return DataFile{(folder / plain).string()};
}

Result<std::vector<DataFile>> dataFilesBeside(const DataFileKey& key, const std::vector<std::string>& names) {
    if (names.empty()) return wrong(key, "is a list of data files, but names none");
    if (names.size() > mostDataFiles)
        return wrong(key,
                     fmt::format("names {} data files, more than the {} that are read", names.size(), mostDataFiles),
                     "Save the volume as one file.");
    std::vector<DataFile> files;
    for (const std::string& name : names) {
        auto file = dataFileBeside(key, name);
        if (!file) return tl::unexpected(file.error());
        files.push_back(std::move(*file));
    }
    return files;
}

Result<std::optional<DataFile>> dataFileOfThatName(const DataFileKey& key, const std::string& name) {
    if (name.empty() || name.size() > longestName) return std::optional<DataFile>();
    const auto folder = std::filesystem::path(key.headerPath).parent_path();
    const std::string found = nameIn(folder, name);
    const auto path = folder / found;
    if (!staysBelow(found) || fileAccess().kindOf(path.string()) == FileKind::missing) return std::optional<DataFile>();
    auto file = dataFileBeside(key, name);
    if (!file) return tl::unexpected(file.error());
    return std::optional(std::move(*file));
}

NamePattern namePatternIn(const std::string& text, std::size_t mostNumbers) {
    NamePattern pattern{.name = trimmed(text), .numbers = {}};
    while (pattern.numbers.size() < mostNumbers) {
        const auto blank = pattern.name.find_last_of(" \t");
        const auto sign = pattern.name.find_last_of('%');
        if (blank == std::string::npos || sign == std::string::npos || blank < sign) break;
        const auto number = wholeNumber(pattern.name.substr(blank + 1));
        if (!number) break;
        pattern.numbers.insert(pattern.numbers.begin(), *number);
        pattern.name = trimmed(pattern.name.substr(0, blank));
    }
    pattern.isPattern = patternFrom(pattern.name).has_value();
    return pattern;
}

std::string literalNameNote(const std::string& name) {
    return "A file is called " + quotedText(name) +
           ", word for word: it is read, and the name is taken for no pattern.";
}

tl::unexpected<Failure> neitherNameNorPattern(const DataFileKey& key, const std::string& text) {
    return wrong(key,
                 "is " + quotedText(text) +
                     ", which is no pattern with one number such as slice%03d.raw, and no file of that name lies "
                     "beside the header",
                 "Put the file of that name beside the header, or correct the name.");
}

Result<std::vector<std::string>> namesOfPattern(const DataFileKey& key, const std::string& text,
                                                const FileNumbers& numbers) {
    const auto pattern = patternFrom(text);
    if (!pattern)
        return wrong(key, "is " + quotedText(text) + ", which is no pattern with one number such as slice%03d.raw",
                     "Correct the pattern.");
    constexpr std::int64_t largest = 1'000'000'000;
    for (const std::int64_t number : {numbers.first, numbers.last, numbers.step})
        if (number < -largest || number > largest)
            return wrong(key, fmt::format("counts with {}, which no file has", number));
    const std::int64_t span = numbers.last - numbers.first;
    if (numbers.step == 0 || span / numbers.step < 0 || (span != 0 && (span < 0) != (numbers.step < 0)))
        return wrong(key, fmt::format("counts from {} to {} in steps of {}, which never ends", numbers.first,
                                      numbers.last, numbers.step));
    const std::int64_t count = span / numbers.step + 1;
    if (count > static_cast<std::int64_t>(mostDataFiles))
        return wrong(key, fmt::format("names {} data files, more than the {} that are read", count, mostDataFiles),
                     "Save the volume as one file.");
    std::vector<std::string> names;
    for (std::int64_t index = 0; index < count; ++index)
        names.push_back(nameWith(*pattern, numbers.first + index * numbers.step));
    return names;
}

}  // namespace echolucent
