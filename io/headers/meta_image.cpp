#include "io/headers/meta_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/headers/frame_spacing.h"
#include "io/headers/frames_over_time.h"
#include "io/headers/header_units.h"
#include "io/headers/meta_image_data.h"
#include "io/headers/meta_image_keys.h"
#include "io/headers/stated_times.h"
#include "io/headers/value_levels.h"
#include "io/study/study_assembly.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

struct TypeName {
    std::string_view name;
    StoredType type;
};
// MET_LONG is 4 bytes in files, on every machine.
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

class MetaImageHeader {
public:
    MetaImageHeader(const InputFile& file, MetaImageKeys keys, bool framesAsSlices)
        : m_file(file), m_path(file.path()), m_framesAsSlices(framesAsSlices), m_keys(std::move(keys)) {
        m_stored.path = m_path;
        m_stored.sizeKey = "DimSize";
        m_stored.typeKey = "ElementType";
        m_stored.encodingKey = "CompressedData, BinaryData";
        if (!m_keys.repeated.empty()) m_stored.warnings.push_back(repeatedNote(m_keys.repeated));
    }

    Result<StoredVolume> read();

private:
    using Step = Result<void> (MetaImageHeader::*)();

    Result<void> readKind();
    Result<void> readSize();
    Result<void> readType();
    Result<void> readSpacing();
    Result<void> readPosition();
    Result<void> readByteOrder();
    Result<void> readWhiteLevel();
    Result<void> readFrames();
    Result<void> readDataPlace();
    void readUnit();
    Result<void> readPhaseTimes();

    [[nodiscard]] const std::string* find(const std::string& key) const { return m_keys.find(key); }
    [[nodiscard]] std::string firstOf(std::initializer_list<const char*> keys) const { return m_keys.firstOf(keys); }
    [[nodiscard]] Result<bool> flag(const std::string& key) const { return m_keys.flag(key); }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem) const {
        return m_keys.wrong(key, problem);
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem,
                                                const std::string& remedy) const {
        return m_keys.wrong(key, problem, remedy);
    }

    const InputFile& m_file;
    std::string m_path;
    bool m_framesAsSlices = false;
    MetaImageKeys m_keys;
    std::int64_t m_dimensions = 0;
    double m_fourthSpacing = 0;  // between phases; 0 if the header has none
    double m_mm = 1.0;           // length of the header's unit
    StoredVolume m_stored;
};

Result<StoredVolume> MetaImageHeader::read() {
    for (const Step step : {&MetaImageHeader::readKind, &MetaImageHeader::readSize, &MetaImageHeader::readType,
                            &MetaImageHeader::readSpacing, &MetaImageHeader::readPosition, &MetaImageHeader::readFrames,
                            &MetaImageHeader::readPhaseTimes, &MetaImageHeader::readByteOrder,
                            &MetaImageHeader::readWhiteLevel, &MetaImageHeader::readDataPlace})
        if (const auto done = (this->*step)(); !done) return tl::unexpected(done.error());
    m_stored.facts.insert(m_stored.facts.begin(), {"format", "MetaImage", "keys of the header"});
    return m_stored;
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
        if (!*binary) m_stored.extent.encoding = VoxelEncoding::text;
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
    const auto known = std::find_if(typeNames.begin(), typeNames.end(), [&](const TypeName& candidate) {
        return lowerCase(candidate.name) == lowerCase(*text);
    });
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

void MetaImageHeader::readUnit() {
    const auto* unit = find("DistanceUnits");
    if (unit == nullptr) return;
    const LengthUnits units = lengthUnits("DistanceUnits", {*unit});
    m_mm = units.mm.front();
    if (units.known) return;
    m_stored.geometry.spacingKnown = false;
    m_stored.warnings.push_back(units.warning);
}

Result<void> MetaImageHeader::readSpacing() {
    readUnit();
    const std::string key = firstOf({"ElementSpacing", "ElementSize"});
    if (key.empty()) {
        m_stored.geometry.spacingKnown = false;
        return {};
    }
    // Some programs leave out the spacing of the time axis.
    const auto spacing = m_keys.numbers(key, 3, static_cast<std::size_t>(m_dimensions), m_stored.warnings);
    if (!spacing) return tl::unexpected(spacing.error());
    for (int axis = 0; axis < 3; ++axis) {
        const double value = (*spacing)[static_cast<std::size_t>(axis)];
        if (!std::isfinite(value) || value == 0.0)
            return wrong(key, "must be finite and not 0 along x, y and z, not " + quotedText(*find(key)));
        m_stored.geometry.spacing[axis] = value * m_mm;
    }
    m_stored.spacingSource = key + (m_mm != 1.0 ? ", DistanceUnits" : "");
    if (spacing->size() > 3) m_fourthSpacing = (*spacing)[3];
    const auto known = flag("SpacingKnown");
    if (!known) return tl::unexpected(known.error());
    if (find("SpacingKnown") != nullptr) m_stored.geometry.spacingKnown = m_stored.geometry.spacingKnown && *known;
    return {};
}

Result<void> MetaImageHeader::readPhaseTimes() {
    if (m_stored.phases < 2) return {};
    std::optional<StatedTimes> times = timesOfSequence(m_keys.values, m_stored.phases);
    // MetaImage has no unit for the fourth axis.
    if (!times) times = timesEvery(m_fourthSpacing, "", firstOf({"ElementSpacing", "ElementSize"}));
    if (times) takeTimes(std::move(*times), m_stored);
    return {};
}

Result<void> MetaImageHeader::readPosition() {
    const auto dimensions = static_cast<std::size_t>(m_dimensions);
    const auto turned = m_keys.onlyOf({"TransformMatrix", "Rotation", "Orientation"});
    if (!turned) return tl::unexpected(turned.error());
    if (const std::string& key = *turned; !key.empty()) {
        const std::string& text = *find(key);
        const auto values = m_keys.numbers(key, dimensions * dimensions, dimensions * dimensions, m_stored.warnings);
        if (!values) return tl::unexpected(values.error());
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
    const auto placed = m_keys.onlyOf({"Offset", "Position", "Origin"});
    if (!placed) return tl::unexpected(placed.error());
    if (const std::string& key = *placed; !key.empty()) {
        const std::string& text = *find(key);
        const auto values = m_keys.numbers(key, dimensions, dimensions, m_stored.warnings);
        if (!values) return tl::unexpected(values.error());
        if (!std::all_of(values->begin(), values->begin() + 3, [](double v) { return std::isfinite(v); }))
            return wrong(key, fmt::format("must be {} finite numbers, not {}", dimensions, quotedText(text)));
        for (int axis = 0; axis < 3; ++axis)
            m_stored.geometry.origin[axis] = (*values)[static_cast<std::size_t>(axis)] * m_mm;
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
    const auto only = m_keys.onlyOf({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
    if (!only) return tl::unexpected(only.error());
    const std::string& key = *only;
    const auto big = flag(key);
    if (!big) return tl::unexpected(big.error());
    m_stored.bigEndian = *big;
    m_stored.byteOrderKey = key;
    const auto compressed = flag("CompressedData");
    if (!compressed) return tl::unexpected(compressed.error());
    const bool isText = m_stored.extent.encoding == VoxelEncoding::text;
    if (*compressed && isText) return wrong("CompressedData", "is True beside BinaryData = False");
    if (*compressed) m_stored.extent.encoding = VoxelEncoding::zlib;
    if (isText) m_stored.bigEndian = false;
    return {};
}

Result<void> MetaImageHeader::readWhiteLevel() {
    const auto read = readLevels(find("BlackLevel"), find("WhiteLevel"), m_stored);
    return read ? Result<void>() : wrong(read.error().key, read.error().problem);
}

Result<void> MetaImageHeader::readFrames() {
    FrameWords words;
    words.kindsKey = "Kinds";
    if (const auto* text = find("Kinds")) {
        const auto kinds = wordsOf(*text);
        if (static_cast<std::int64_t>(kinds.size()) == m_dimensions) {
            for (std::size_t axis = 0; axis < 3; ++axis) words.kinds[axis] = lowerCase(kinds[axis]);
            for (const std::string& kind : kinds)
                if (!mayBeAxisOfVolume(lowerCase(kind)))
                    return wrong("Kinds",
                                 "has an axis of kind " + quotedText(kind) + ", which is neither space nor time",
                                 "Save one scalar for each voxel.");
        } else {
            m_stored.warnings.push_back(
                fmt::format("Kinds is ignored: it must be {} words, not {}.", m_dimensions, quotedText(*text)));
        }
    }
    for (const auto& [key, value] : m_keys.values) words.keys.push_back(key);
    takeFrameSpacing(m_keys.values, m_stored);
    return settleFrames(m_stored, words, m_framesAsSlices);
}

Result<void> MetaImageHeader::readDataPlace() { return placeMetaImageData(m_file, m_keys, m_dimensions, m_stored); }

}  // namespace

bool looksLikeMetaImage(std::string_view beginning) {
    beginning = withoutByteOrderMark(beginning);
    const auto line = nextLine(beginning);
    if (!line || line->find('=') == std::string_view::npos) return false;
    const std::string key = lowerCase(trimmed(line->substr(0, line->find('='))));
    constexpr std::array<std::string_view, 5> firstKeys{"objecttype", "ndims", "comment", "objectsubtype", "dimsize"};
    return std::find(firstKeys.begin(), firstKeys.end(), key) != firstKeys.end();
}

Result<StoredVolume> readMetaImageHeader(const InputFile& file, bool framesAsSlices) {
    auto keys = readMetaImageKeys(file);
    if (!keys) return tl::unexpected(keys.error());
    return MetaImageHeader(file, std::move(*keys), framesAsSlices).read();
}

}  // namespace echolucent
