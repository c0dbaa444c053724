#include "io/headers/nrrd_data.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

class NrrdData {
public:
    NrrdData(const InputFile& file, const NrrdFields& fields, const std::vector<std::int64_t>& sizes,
             StoredVolume& stored)
        : m_file(file), m_fields(fields), m_sizes(sizes), m_stored(stored) {}
    Result<void> readPlace();
    Result<void> readSkips();

private:
    Result<void> readFileList(const std::string& text);
    Result<void> readPatternOrName(const std::string& text);
    Result<void> setDataFiles(const std::vector<std::string>& names, std::optional<std::int64_t> held);
    Result<std::int64_t> skipOf(const char* field, std::int64_t least) const;
    [[nodiscard]] const std::string* find(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        return found == m_fields.fields.end() ? nullptr : &found->second;
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& field, const std::string& problem) const {
        return fail(FailureKind::unreadable, m_stored.path, field, problem, correctHeader);
    }
    [[nodiscard]] DataFileKey key() const { return {m_stored.path, "data file"}; }

    const InputFile& m_file;
    const NrrdFields& m_fields;
    const std::vector<std::int64_t>& m_sizes;
    StoredVolume& m_stored;
};

Result<void> NrrdData::readPlace() {
    const auto* name = find("data file");
    if (name == nullptr) {
        m_stored.data = {{m_stored.path, m_file}};
        m_stored.extent.offset = m_fields.headerBytes;
        return {};
    }
    if (isNrrdList(*name)) return readFileList(*name);
    if (name->find('%') != std::string::npos) return readPatternOrName(*name);
    const auto beside = dataFileBeside(key(), *name);
    if (!beside) return tl::unexpected(beside.error());
    m_stored.data = {*beside};
    return {};
}

Result<void> NrrdData::setDataFiles(const std::vector<std::string>& names, std::optional<std::int64_t> held) {
    // Each file holds the first `held` axes whole; without `held`, all axes but the last. If `held` names all axes,
    // each file holds a slab along the last one.
    const auto count = static_cast<std::int64_t>(names.size());
    const auto axes = static_cast<std::int64_t>(m_sizes.size());
    const std::int64_t whole = held.value_or(axes - 1);
    if (whole < 2 || whole > axes)
        return wrong("data file", fmt::format("gives each file {} dimensions; it must be 2 to {}", whole, axes));
    std::optional<std::int64_t> expected = 1;
    for (std::int64_t axis = whole; axis < axes && expected; ++axis)
        expected = checkedProduct(*expected, m_sizes[static_cast<std::size_t>(axis)]);
    const bool fits = whole == axes ? count > 0 && m_sizes.back() % count == 0 : count == expected.value_or(0);
    if (!fits && whole == axes)
        return wrong("data file",
                     fmt::format("names {} data files, which cannot share {} slices", count, m_sizes.back()));
    if (!fits)
        return wrong("data file",
                     fmt::format("names {} data files where the volume has {} parts", count, expected.value_or(0)));
    auto files = dataFilesBeside(key(), names);
    if (!files) return tl::unexpected(files.error());
    m_stored.data = std::move(*files);
    return {};
}

Result<void> NrrdData::readFileList(const std::string& text) {
    const std::vector<std::string> words = wordsOf(text);
    const auto held = words.size() == 2 ? wholeNumber(words[1]) : std::nullopt;
    if (words.size() > 2 || (words.size() == 2 && !held))
        return wrong("data file", "must be LIST and the dimensions of each file, not " + quotedText(text));
    return setDataFiles(m_fields.dataFiles, held);
}

Result<void> NrrdData::readPatternOrName(const std::string& text) {
    constexpr std::size_t mostNumbers = 4;
    const NamePattern pattern = namePatternIn(text, mostNumbers);
    const auto literal = dataFileOfThatName(key(), text);
    if (!literal) return tl::unexpected(literal.error());
    if (*literal) {
        if (pattern.isPattern) m_stored.warnings.push_back(literalNameNote(text));
        m_stored.data = {**literal};
        return {};
    }
    if (!pattern.isPattern) return neitherNameNorPattern(key(), text);
    const std::vector<std::int64_t>& numbers = pattern.numbers;
    if (numbers.size() < 3)
        return wrong("data file",
                     "must be a pattern with the first number, the last and the step, not " + quotedText(text));
    const auto names = namesOfPattern(key(), pattern.name, {numbers[0], numbers[1], numbers[2]});
    if (!names) return tl::unexpected(names.error());
    return setDataFiles(*names, numbers.size() == mostNumbers ? std::optional(numbers[3]) : std::nullopt);
}

Result<std::int64_t> NrrdData::skipOf(const char* field, std::int64_t least) const {
    const auto* text = find(field);
    if (text == nullptr) return 0;
    const auto skip = wholeNumber(*text);
    if (!skip || *skip < least)
        return wrong(field, fmt::format("must be {} or above, not {}", least, quotedText(*text)));
    return *skip;
}

Result<void> NrrdData::readSkips() {
    const auto lines = skipOf("line skip", 0);
    if (!lines) return tl::unexpected(lines.error());
    const VoxelEncoding encoding = m_stored.extent.encoding;
    const auto bytes = skipOf("byte skip", encoding == VoxelEncoding::raw || isCompressed(encoding) ? -1 : 0);
    if (!bytes) return tl::unexpected(bytes.error());
    m_stored.skipLines = *lines;
    m_stored.dataAtEnd = *bytes == -1;
    m_stored.extent.skipBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(*bytes, 0));
    return {};
}

}  // namespace

Result<void> placeNrrdData(const InputFile& file, const NrrdFields& fields, const std::vector<std::int64_t>& sizes,
                           StoredVolume& stored) {
    NrrdData place(file, fields, sizes, stored);
    if (auto placed = place.readPlace(); !placed) return placed;
    return place.readSkips();
}

}  // namespace echolucent
