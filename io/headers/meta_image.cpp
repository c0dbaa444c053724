#include "io/headers/meta_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "io/headers/header_text.h"
#include "io/study_assembly.h"

namespace echolucent {

namespace {

const std::string exportAgain = "Correct the header or export the volume again.";

struct TypeName {
    std::string_view name;
    StoredType type;
};
// MET_LONG is 4 bytes in files, whatever the machine's long is.
constexpr std::array<TypeName, 12> typeNames{{{"MET_UCHAR", StoredType::uint8},
                                              {"MET_CHAR", StoredType::int8},
                                              {"MET_USHORT", StoredType::uint16},
                                              {"MET_SHORT", StoredType::int16},
                                              {"MET_UINT", StoredType::uint32},
                                              {"MET_INT", StoredType::int32},
                                              {"MET_ULONG", StoredType::uint32},
                                              {"MET_LONG", StoredType::int32},
                                              {"MET_ULONG_LONG", StoredType::uint64},
                                              {"MET_LONG_LONG", StoredType::int64},
                                              {"MET_FLOAT", StoredType::float32},
                                              {"MET_DOUBLE", StoredType::float64}}};

// Keys that decide how voxels are read; all others are allowed and ignored.
constexpr std::array<std::string_view, 22> ourKeys{"ObjectType",
                                                   "NDims",
                                                   "BinaryData",
                                                   "DimSize",
                                                   "ElementType",
                                                   "ElementNumberOfChannels",
                                                   "ElementSpacing",
                                                   "ElementSize",
                                                   "SpacingKnown",
                                                   "TransformMatrix",
                                                   "Rotation",
                                                   "Orientation",
                                                   "Offset",
                                                   "Position",
                                                   "Origin",
                                                   "BinaryDataByteOrderMSB",
                                                   "ElementByteOrderMSB",
                                                   "CompressedData",
                                                   "CompressedDataSize",
                                                   "HeaderSize",
                                                   "WhiteLevel",
                                                   "ElementDataFile"};

class MetaImageHeader {
public:
    explicit MetaImageHeader(std::string path) : m_path(std::move(path)) {}

    Result<StoredVolume> read();

private:
    using Step = Result<void> (MetaImageHeader::*)();

    Result<void> readKeys();
    Result<void> readKind();
    Result<void> readSize();
    Result<void> readType();
    Result<void> readSpacing();
    Result<void> readPosition();
    Result<void> readByteOrder();
    Result<void> readWhiteLevel();
    Result<void> readDataPlace();
    Result<void> readHeaderSize(bool local);
    void readPhaseTime(const std::vector<double>& spacing);

    [[nodiscard]] const std::string* find(const std::string& key) const {
        const auto found = m_values.find(key);
        return found == m_values.end() ? nullptr : &found->second;
    }
    /// The first of several keys for the same thing that the header holds; empty where it holds none of them.
    [[nodiscard]] std::string firstOf(std::initializer_list<const char*> keys) const {
        for (const char* key : keys)
            if (find(key) != nullptr) return key;
        return {};
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem,
                                                const std::string& remedy = exportAgain) const {
        return fail(FailureKind::unreadable, m_path, key, problem, remedy);
    }
    Result<bool> flag(const std::string& key) const;

    std::string m_path;
    std::map<std::string, std::string> m_values;
    std::size_t m_headerBytes = 0;
    std::int64_t m_dimensions = 0;
    StoredVolume m_stored;
};

Result<StoredVolume> MetaImageHeader::read() {
    for (const Step step :
         {&MetaImageHeader::readKeys, &MetaImageHeader::readKind, &MetaImageHeader::readSize,
          &MetaImageHeader::readType, &MetaImageHeader::readSpacing, &MetaImageHeader::readPosition,
          &MetaImageHeader::readByteOrder, &MetaImageHeader::readWhiteLevel, &MetaImageHeader::readDataPlace})
        if (const auto done = (this->*step)(); !done) return tl::unexpected(done.error());
    m_stored.path = m_path;
    m_stored.sizeKey = "DimSize";
    m_stored.facts.insert(m_stored.facts.begin(), {"format", "MetaImage", ""});
    return m_stored;
}

Result<void> MetaImageHeader::readKeys() {
    const auto file = InputFile::open(m_path);
    if (!file) return tl::unexpected(file.error());
    const auto beginning = file->beginning(headerLimit);
    if (!beginning) return tl::unexpected(beginning.error());
    std::string_view rest = *beginning;
    for (int number = 1; const auto line = nextLine(rest); ++number) {
        if (trimmed(*line).empty()) continue;
        const auto equals = line->find('=');
        if (equals == std::string_view::npos || trimmed(line->substr(0, equals)).empty())
            return wrong("",
                         fmt::format("has no \"Key = Value\" in line {} of its header ({})", number, quotedText(*line)),
                         "This is no MetaImage file, or its header is damaged.");
        const std::string key = trimmed(line->substr(0, equals));
        const bool isNew = m_values.emplace(key, trimmed(line->substr(equals + 1))).second;
        const bool ours = std::find(ourKeys.begin(), ourKeys.end(), key) != ourKeys.end();
        if (!isNew && ours) return wrong(key, "appears twice in the header");
        if (key == "ElementDataFile") {
            m_headerBytes = beginning->size() - rest.size();
            return {};
        }
    }
    return wrong("ElementDataFile",
                 fmt::format("is missing from the header (looked through {} bytes)", beginning->size()),
                 "The file is cut off or damaged: copy or export it again.");
}

Result<bool> MetaImageHeader::flag(const std::string& key) const {
    const std::string* value = find(key);
    if (value == nullptr) return false;
    const std::string lower = lowerCase(*value);
    if (lower == "true" || lower == "t" || lower == "1" || lower == "yes") return true;
    if (lower == "false" || lower == "f" || lower == "0" || lower == "no") return false;
    return wrong(key, "must be True or False, not " + quotedText(*value));
}

Result<void> MetaImageHeader::readKind() {
    if (const auto* kind = find("ObjectType"); kind != nullptr && *kind != "Image")
        return wrong("ObjectType", "is " + quotedText(*kind) + ", not Image", "Only MetaImage volumes can be opened.");
    const auto* text = find("NDims");
    if (text == nullptr) return wrong("NDims", "is missing");
    const auto dimensions = wholeNumber(*text);
    if (!dimensions || *dimensions < 1) return wrong("NDims", "must be 3 or 4, not " + quotedText(*text));
    if (*dimensions == 2) return wrong("NDims", "is 2: this is a 2D picture, not a volume", "Open a 3D or 4D volume.");
    if (*dimensions != 3 && *dimensions != 4)
        return wrong("NDims", "must be 3 or 4, not " + quotedText(*text), "Open a 3D or 4D volume.");
    m_dimensions = *dimensions;
    if (find("BinaryData") != nullptr) {
        const auto binary = flag("BinaryData");
        if (!binary) return tl::unexpected(binary.error());
        if (!*binary)
            return wrong("BinaryData", "is False: voxels written as text are not read", "Export the volume as binary.");
    }
    return {};
}

Result<void> MetaImageHeader::readSize() {
    const auto* text = find("DimSize");
    if (text == nullptr) return wrong("DimSize", "is missing");
    const auto sizes = wholeNumbers(*text);
    if (!sizes || static_cast<std::int64_t>(sizes->size()) != m_dimensions ||
        std::any_of(sizes->begin(), sizes->end(), [](std::int64_t size) { return size < 1; }))
        return wrong("DimSize",
                     fmt::format("must be {} whole numbers above 0, not {}", m_dimensions, quotedText(*text)));
    std::copy_n(sizes->begin(), 3, m_stored.geometry.size.begin());
    if (m_dimensions == 4) m_stored.phases = sizes->back();
    return {};
}

Result<void> MetaImageHeader::readType() {
    const auto* text = find("ElementType");
    if (text == nullptr) return wrong("ElementType", "is missing");
    const auto known = std::find_if(typeNames.begin(), typeNames.end(),
                                    [&](const TypeName& candidate) { return candidate.name == *text; });
    if (known == typeNames.end())
        return wrong("ElementType", "is " + quotedText(*text) + ", which is not a scalar type that can be read",
                     "Use MET_UCHAR, MET_USHORT, MET_SHORT or MET_FLOAT.");
    m_stored.type = known->type;
    if (const auto* channels = find("ElementNumberOfChannels")) {
        const auto count = wholeNumber(*channels);
        const bool colour = count == 3 && (m_stored.type == StoredType::uint8 || m_stored.type == StoredType::uint16);
        if (count != 1 && !colour)
            return wrong("ElementNumberOfChannels",
                         "must be 1 (or 3 for 8- or 16-bit colour), not " + quotedText(*channels),
                         "Export one channel only.");
        m_stored.channels = *count;
    }
    return {};
}

Result<void> MetaImageHeader::readSpacing() {
    const std::string key = firstOf({"ElementSpacing", "ElementSize"});
    if (key.empty()) {
        m_stored.geometry.spacingKnown = false;
        return {};
    }
    const std::string& text = *find(key);
    const auto spacing = realNumbers(text);
    // Some programs leave out the spacing of the time axis.
    if (!spacing || spacing->size() < 3 || static_cast<std::int64_t>(spacing->size()) > m_dimensions)
        return wrong(key, fmt::format("must be {} numbers, not {}", m_dimensions, quotedText(text)));
    for (int axis = 0; axis < 3; ++axis) {
        double value = (*spacing)[static_cast<std::size_t>(axis)];
        if (!std::isfinite(value) || value == 0.0)
            return wrong(key, "must be finite and not 0 along x, y and z, not " + quotedText(text));
        m_stored.geometry.spacing[axis] = value;
    }
    m_stored.spacingSource = key;
    readPhaseTime(*spacing);
    const auto known = flag("SpacingKnown");
    if (!known) return tl::unexpected(known.error());
    if (find("SpacingKnown") != nullptr) m_stored.geometry.spacingKnown = *known;
    return {};
}

void MetaImageHeader::readPhaseTime(const std::vector<double>& spacing) {
    // MetaImage has no unit for the fourth axis, and 1 is what programs write that know none.
    if (spacing.size() < 4 || !std::isfinite(spacing[3]) || spacing[3] <= 0.0 || spacing[3] == 1.0) return;
    m_stored.phaseSeconds = spacing[3];
    m_stored.phaseSource = m_stored.spacingSource + ", assumed to be seconds";
}

Result<void> MetaImageHeader::readPosition() {
    const auto dimensions = static_cast<std::size_t>(m_dimensions);
    if (const auto key = firstOf({"TransformMatrix", "Rotation", "Orientation"}); !key.empty()) {
        const std::string& text = *find(key);
        const auto values = realNumbers(text);
        if (!values || values->size() != dimensions * dimensions)
            return wrong(key, fmt::format("must be {} numbers, not {}", dimensions * dimensions, quotedText(text)));
        // The file's rows are the directions of the grid axes; ours are columns.
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t row = 0; row < 3; ++row)
                m_stored.geometry.direction(static_cast<int>(row), static_cast<int>(axis)) =
                    (*values)[axis * dimensions + row];
        if (!normalizeDirection(m_stored.geometry.direction))
            return wrong(key, "does not hold three independent directions: " + quotedText(text));
        if (auto warning = skewWarning(m_stored.geometry.direction); !warning.empty())
            m_stored.warnings.push_back(std::move(warning));
        m_stored.geometry.patientFrameKnown = saysMoreThanItsAxes(m_stored.geometry.direction);
    }
    if (const auto key = firstOf({"Offset", "Position", "Origin"}); !key.empty()) {
        const std::string& text = *find(key);
        const auto values = realNumbers(text);
        const bool finite =
            values && values->size() == dimensions &&
            std::all_of(values->begin(), values->begin() + 3, [](double v) { return std::isfinite(v); });
        if (!finite) return wrong(key, fmt::format("must be {} finite numbers, not {}", dimensions, quotedText(text)));
        for (int axis = 0; axis < 3; ++axis) m_stored.geometry.origin[axis] = (*values)[static_cast<std::size_t>(axis)];
        if (!isPosition(m_stored.geometry.origin))
            return wrong(key, "lies farther than 10 km from 0: " + quotedText(text));
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (m_stored.geometry.spacing[axis] > 0) continue;
        m_stored.geometry.spacing[axis] = -m_stored.geometry.spacing[axis];
        for (int row = 0; row < 3; ++row) m_stored.geometry.direction(row, axis) *= -1;
        m_stored.warnings.push_back(
            fmt::format("{} is negative along {}: taken as positive, with that axis turned round.",
                        m_stored.spacingSource, "xyz"[axis]));
    }
    return {};
}

Result<void> MetaImageHeader::readByteOrder() {
    const auto key = firstOf({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
    const auto big = flag(key);
    if (!big) return tl::unexpected(big.error());
    m_stored.bigEndian = *big;
    const auto compressed = flag("CompressedData");
    if (!compressed) return tl::unexpected(compressed.error());
    m_stored.extent.compressed = *compressed;
    return {};
}

Result<void> MetaImageHeader::readWhiteLevel() {
    const auto* text = find("WhiteLevel");
    if (text == nullptr) return {};
    m_stored.whiteLevel = positiveNumber(*text);
    if (!m_stored.whiteLevel) return wrong("WhiteLevel", "must be a number above 0, not " + quotedText(*text));
    m_stored.whiteLevelSource = "WhiteLevel";
    return {};
}

Result<void> MetaImageHeader::readDataPlace() {
    const std::string name = *find("ElementDataFile");
    if (name == "LIST" || name.starts_with("LIST ") || name.find('%') != std::string::npos)
        return wrong("ElementDataFile",
                     "is " + quotedText(name) + ": volumes spread over several data files are not read",
                     "Save the volume as one .mha file.");
    const bool local = name == "LOCAL" || name == "Local" || name == "local";
    if (local) {
        m_stored.dataPath = m_path;
        m_stored.extent.offset = m_headerBytes;
    } else {
        const auto beside = dataFileBeside(m_path, "ElementDataFile", name);
        if (!beside) return tl::unexpected(beside.error());
        m_stored.dataPath = *beside;
    }
    if (const auto* text = find("CompressedDataSize"); text != nullptr && m_stored.extent.compressed) {
        const auto size = wholeNumber(*text);
        if (!size || *size < 0) return wrong("CompressedDataSize", "must be a whole number, not " + quotedText(*text));
        m_stored.extent.length = static_cast<std::uint64_t>(*size);
    }
    return readHeaderSize(local);
}

Result<void> MetaImageHeader::readHeaderSize(bool local) {
    const auto* text = find("HeaderSize");
    if (text == nullptr) return {};
    const auto bytes = wholeNumber(*text);
    if (!bytes || *bytes < -1) return wrong("HeaderSize", "must be -1, 0 or above, not " + quotedText(*text));
    if (*bytes == -1) {
        if (m_stored.extent.compressed) return wrong("HeaderSize", "is -1, which has no meaning for compressed data");
        m_stored.dataAtEnd = true;
    } else if (*bytes > 0) {
        if (local && static_cast<std::uint64_t>(*bytes) < m_headerBytes)
            return wrong("HeaderSize", fmt::format("is {}, but the header is {} bytes long", *bytes, m_headerBytes));
        m_stored.extent.offset = static_cast<std::uint64_t>(*bytes);
    }
    return {};
}

}  // namespace

bool looksLikeMetaImage(std::string_view beginning) {
    const auto line = nextLine(beginning);
    if (!line || line->find('=') == std::string_view::npos) return false;
    const std::string key = trimmed(line->substr(0, line->find('=')));
    constexpr std::array<std::string_view, 5> firstKeys{"ObjectType", "NDims", "Comment", "ObjectSubType", "DimSize"};
    return std::find(firstKeys.begin(), firstKeys.end(), key) != firstKeys.end();
}

Result<StoredVolume> readMetaImageHeader(const std::string& path) { return MetaImageHeader(path).read(); }

}  // namespace echolucent
