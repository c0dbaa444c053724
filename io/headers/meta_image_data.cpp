#include "io/headers/meta_image_data.h"

#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

// Of a pattern: the first, the last, the step.
constexpr std::size_t mostPatternNumbers = 3;

class MetaImageData {
public:
    MetaImageData(const InputFile& file, const MetaImageKeys& keys, std::int64_t dimensions, StoredVolume& stored)
        : m_file(file), m_keys(keys), m_dimensions(dimensions), m_stored(stored) {}
    Result<void> read();

private:
    Result<void> readFileList(const std::vector<std::string>& words);
    Result<void> readFilePattern(const std::string& text);
    Result<void> setDataFiles(const std::vector<std::string>& names, std::int64_t expected);
    Result<void> readCompressedSize();
    Result<void> readHeaderSize(bool local);
    [[nodiscard]] std::int64_t slowestSize() const {
        return m_dimensions == 4 ? m_stored.phases : m_stored.geometry.size[2];
    }
    [[nodiscard]] const std::string* find(const std::string& key) const { return m_keys.find(key); }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem,
                                                const std::string& remedy = correctHeader) const {
        return m_keys.wrong(key, problem, remedy);
    }
    [[nodiscard]] DataFileKey key() const { return {m_stored.path, "ElementDataFile"}; }

    const InputFile& m_file;
    const MetaImageKeys& m_keys;
    std::int64_t m_dimensions;
    StoredVolume& m_stored;
};

Result<void> MetaImageData::read() {
    const std::string name = *find("ElementDataFile");
    const std::vector<std::string> words = wordsOf(name);
    const bool pattern = name.find('%') != std::string::npos;
    const bool local = lowerCase(name) == "local";
    Result<std::optional<DataFile>> literal;
    if (pattern) literal = dataFileOfThatName(key(), name);
    if (!literal) return tl::unexpected(literal.error());
    if (isMetaImageList(name) || (pattern && !*literal)) {
        if (find("CompressedDataSize") != nullptr && m_stored.extent.encoding == VoxelEncoding::zlib)
            return wrong("CompressedDataSize", "is one number beside several data files", "Leave it out.");
        if (auto named = pattern ? readFilePattern(name) : readFileList(words); !named) return named;
        return readHeaderSize(false);
    }
    if (*literal && namePatternIn(name, mostPatternNumbers).isPattern)
        m_stored.warnings.push_back(literalNameNote(name));
    if (local) {
        m_stored.data = {{m_stored.path, m_file}};
        m_stored.extent.offset = m_keys.headerBytes;
    } else {
        const auto beside = dataFileBeside(key(), name);
        if (!beside) return tl::unexpected(beside.error());
        m_stored.data = {*beside};
    }
    if (auto size = readCompressedSize(); !size) return size;
    return readHeaderSize(local);
}

Result<void> MetaImageData::setDataFiles(const std::vector<std::string>& names, std::int64_t expected) {
    if (static_cast<std::int64_t>(names.size()) != expected)
        return wrong("ElementDataFile",
                     fmt::format("names {} data files where the volume has {} parts", names.size(), expected));
    auto files = dataFilesBeside(key(), names);
    if (!files) return tl::unexpected(files.error());
    m_stored.data = std::move(*files);
    return {};
}

Result<void> MetaImageData::readFileList(const std::vector<std::string>& words) {
    // "LIST 2" means that each file holds two dimensions. Without a number, it holds all but the last.
    const auto held = words.size() < 2 ? std::optional(m_dimensions - 1) : wholeNumber(words[1]);
    if (words.size() > 2 || !held || *held < 2 || *held > m_dimensions)
        return wrong("ElementDataFile", fmt::format("must be LIST and the dimensions of each file, 2 to {}, not {}",
                                                    m_dimensions, quotedText(*find("ElementDataFile"))));
    std::optional<std::int64_t> files = 1;
    if (*held < m_dimensions) files = slowestSize();
    if (*held < m_dimensions - 1) files = checkedProduct(*files, m_stored.geometry.size[2]);
    return setDataFiles(m_keys.listed, files.value_or(0));
}

Result<void> MetaImageData::readFilePattern(const std::string& text) {
    // "name%03d.raw first last step". Without numbers, the files count from 1, one for each index of the last axis.
    const NamePattern pattern = namePatternIn(text, mostPatternNumbers);
    if (!pattern.isPattern) return neitherNameNorPattern(key(), text);
    FileNumbers numbers{1, slowestSize(), 1};
    const std::array<std::int64_t*, mostPatternNumbers> places{&numbers.first, &numbers.last, &numbers.step};
    for (std::size_t i = 0; i < pattern.numbers.size(); ++i) *places[i] = pattern.numbers[i];
    // If the sum would overflow, namesOfPattern() refuses the first number.
    if (pattern.numbers.size() == 1 && numbers.first <= std::numeric_limits<std::int64_t>::max() - slowestSize())
        numbers.last = numbers.first + slowestSize() - 1;
    const auto names = namesOfPattern(key(), pattern.name, numbers);
    if (!names) return tl::unexpected(names.error());
    if (pattern.numbers.empty()) {
        // Without numbers, the per cent sign may as well belong to the name of one file.
        const auto first = dataFileOfThatName(key(), names->front());
        if (!first) return tl::unexpected(first.error());
        if (!*first)
            return wrong("ElementDataFile",
                         fmt::format("is {}: neither that file nor the first of that pattern, {}, lies beside the "
                                     "header",
                                     quotedText(text), quotedText(names->front())),
                         "Put the file of that name beside the header, or correct the name.");
    }
    return setDataFiles(*names, slowestSize());
}

Result<void> MetaImageData::readCompressedSize() {
    const auto* text = find("CompressedDataSize");
    if (text == nullptr || m_stored.extent.encoding != VoxelEncoding::zlib) return {};
    const auto size = wholeNumber(*text);
    if (!size || *size < 0) return wrong("CompressedDataSize", "must be a whole number, not " + quotedText(*text));
    m_stored.extent.length = static_cast<std::uint64_t>(*size);
    return {};
}

Result<void> MetaImageData::readHeaderSize(bool local) {
    const auto* text = find("HeaderSize");
    if (text == nullptr) return {};
    const auto bytes = wholeNumber(*text);
    if (!bytes || *bytes < -1) return wrong("HeaderSize", "must be -1, 0 or above, not " + quotedText(*text));
    if (*bytes == -1) {
        if (m_stored.extent.encoding != VoxelEncoding::raw)
            return wrong("HeaderSize", "is -1, which has no meaning for compressed data or text");
        m_stored.dataAtEnd = true;
    } else if (*bytes > 0) {
        if (local && static_cast<std::uint64_t>(*bytes) < m_keys.headerBytes)
            return wrong("HeaderSize",
                         fmt::format("is {}, but the header is {} bytes long", *bytes, m_keys.headerBytes));
        m_stored.extent.offset = static_cast<std::uint64_t>(*bytes);
    }
    return {};
}

}  // namespace

Result<void> placeMetaImageData(const InputFile& file, const MetaImageKeys& keys, std::int64_t dimensions,
                                StoredVolume& stored) {
    return MetaImageData(file, keys, dimensions, stored).read();
}

}  // namespace echolucent
