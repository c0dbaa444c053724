#include "io/headers/nrrd_axes.h"

#include <algorithm>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/headers/frames_over_time.h"
#include "io/headers/header_units.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

/// Whether a kind means space, or says nothing.
bool saysSpace(const std::string& kind) {
    return kind.empty() || kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

class AxesReader {
public:
    AxesReader(const std::string& path, const NrrdFields& fields, StoredType type)
        : m_path(path), m_fields(fields), m_type(type) {}
    Result<NrrdAxes> read();

private:
    Result<void> readShape();
    Result<void> readRoles();
    Result<void> readThreeAxes();
    Result<void> readFourAxes();
    Result<void> checkKind(std::size_t axis, const std::string& problem);
    Result<void> checkColourAxis(std::size_t axis) const;
    [[nodiscard]] bool isPlainSpace(std::size_t axis) const;
    [[nodiscard]] bool isScalarFirst() const;
    [[nodiscard]] bool mayBeComponentsFirst() const;
    [[nodiscard]] bool hasNoSpacing(std::size_t axis) const;
    [[nodiscard]] bool isColour(std::size_t axis) const {
        return m_axes.kindOf(axis) == "rgb-color" || m_axes.kindOf(axis) == "3-color";
    }
    [[nodiscard]] const std::string* find(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        return found == m_fields.fields.end() ? nullptr : &found->second;
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& field, const std::string& problem,
                                                const std::string& remedy = correctHeader) const {
        return fail(FailureKind::unreadable, m_path, field, problem, remedy);
    }

    const std::string& m_path;
    const NrrdFields& m_fields;
    StoredType m_type;
    NrrdAxes m_axes;
};

Result<NrrdAxes> AxesReader::read() {
    if (auto shape = readShape(); !shape) return tl::unexpected(shape.error());
    if (auto roles = readRoles(); !roles) return tl::unexpected(roles.error());
    return std::move(m_axes);
}

Result<void> AxesReader::readShape() {
    const auto* dimensionText = find("dimension");
    if (dimensionText == nullptr) return wrong("dimension", "is missing");
    const auto dimension = wholeNumber(*dimensionText);
    if (dimension == 2)
        return wrong("dimension", "is 2: this is a 2D picture, not a volume", "Open a 3D or 4D volume.");
    if (dimension != 3 && dimension != 4)
        return wrong("dimension", "must be 3 or 4, not " + quotedText(*dimensionText), "Open a 3D or 4D volume.");
    const auto* text = find("sizes");
    if (text == nullptr) return wrong("sizes", "is missing");
    const auto sizes = wholeNumbers(*text);
    if (!sizes || static_cast<std::int64_t>(sizes->size()) != *dimension ||
        std::any_of(sizes->begin(), sizes->end(), [](std::int64_t size) { return size < 1; }))
        return wrong("sizes", fmt::format("must be {} whole numbers above 0, not {}", *dimension, quotedText(*text)));
    m_axes.sizes = *sizes;
    return {};
}

Result<void> AxesReader::readRoles() {
    if (const auto* text = find("kinds")) {
        m_axes.kinds = wordsOf(*text);
        if (m_axes.kinds.size() != m_axes.sizes.size())
            return wrong("kinds", fmt::format("must be {} words, not {}", m_axes.sizes.size(), quotedText(*text)));
        for (std::string& kind : m_axes.kinds) kind = lowerCase(kind);
    }
    if (const auto* text = find("space directions")) {
        const auto vectors = nrrdVectors(*text);
        if (!vectors || vectors->size() != m_axes.sizes.size())
            return wrong("space directions",
                         fmt::format("must be {} vectors or \"none\", not {}", m_axes.sizes.size(), quotedText(*text)));
        m_axes.directions = *vectors;
    }
    m_axes.roles.assign(m_axes.sizes.size(), NrrdAxisRole::space);
    for (std::size_t axis = 0; axis < m_axes.directions.size(); ++axis) {
        if (!isTimeDirection(m_axes.directions[axis]) || !saysSpace(m_axes.kindOf(axis))) continue;
        m_axes.kinds.resize(m_axes.sizes.size());
        m_axes.kinds[axis] = "time";
    }
    return m_axes.sizes.size() == 4 ? readFourAxes() : readThreeAxes();
}

bool AxesReader::isPlainSpace(std::size_t axis) const {
    if (!saysSpace(m_axes.kindOf(axis))) return false;
    if (m_axes.directions.empty()) return !hasNoSpacing(axis);
    return (m_axes.directions[axis] && !isTimeDirection(m_axes.directions[axis]));
}

/// Refuses an axis that is neither space nor time nor a list. An axis of one value counts as a scalar, whatever its
/// kind.
Result<void> AxesReader::checkKind(std::size_t axis, const std::string& problem) {
    const std::string kind = m_axes.kindOf(axis);
    if (mayBeAxisOfVolume(kind)) return {};
    if (m_axes.sizes[axis] != 1)
        return wrong("kinds", "has an axis of kind " + quotedText(kind) + problem, "Save one scalar for each voxel.");
    if (kind != "scalar" && kind != "stub")
        m_axes.warnings.push_back(fmt::format(
            "kinds calls the axis {} {}; it has one value, which is taken as a scalar.", axis + 1, quotedText(kind)));
    return {};
}

Result<void> AxesReader::readThreeAxes() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (isColour(axis))
            return wrong("kinds", "says that one of three axes is colour: this is a 2D colour picture, not a volume",
                         "Open a 3D or 4D volume.");
        if (auto known = checkKind(axis, ": this is a 2D picture of several values a pixel, not a volume"); !known)
            return known;
    }
    return {};
}

Result<void> AxesReader::checkColourAxis(std::size_t axis) const {
    const bool unsignedBytes = m_type == StoredType::uint8 || m_type == StoredType::uint16;
    if (axis == 0 && m_axes.sizes[axis] == 3 && unsignedBytes) return {};
    return wrong("kinds", "has a colour axis that is not the first, of size 3, with 8 or 16 unsigned bits");
}

/// Whether the first of four axes that have no kinds holds one value, as programs write it that store vectors.
bool AxesReader::isScalarFirst() const {
    return m_axes.kinds.empty() && m_axes.directions.empty() && m_axes.sizes[0] == 1 &&
           std::all_of(m_axes.sizes.begin() + 1, m_axes.sizes.end(), [](std::int64_t size) { return size > 1; });
}

/// Whether an axis without a kind has the spacing NaN, which is that of axes without space.
bool AxesReader::hasNoSpacing(std::size_t axis) const {
    const auto* text = find("spacings");
    const auto spacings = text != nullptr ? wordsOf(lowerCase(*text)) : std::vector<std::string>{};
    return m_axes.kindOf(axis).empty() && spacings.size() == m_axes.sizes.size() && spacings[axis] == "nan";
}

/// Whether the first of four axes may be colour or the components of vectors: it has no kind, no place in space, and
/// few values where the others have more.
bool AxesReader::mayBeComponentsFirst() const {
    constexpr std::int64_t mostComponents = 4;
    if (!m_axes.kinds.empty() || m_axes.sizes[0] == 1 || m_axes.sizes[0] > mostComponents) return false;
    if (!m_axes.directions.empty() && m_axes.directions[0]) return false;
    const auto* units = find("units");
    const auto words = units != nullptr ? nrrdWords(*units) : std::vector<std::string>{};
    if (words.size() == m_axes.sizes.size() && secondsOfUnit(words[0])) return false;
    return std::all_of(m_axes.sizes.begin() + 1, m_axes.sizes.end(),
                       [](std::int64_t size) { return size > mostComponents; });
}

Result<void> AxesReader::readFourAxes() {
    if (mayBeComponentsFirst())
        return wrong("kinds",
                     fmt::format("is missing, and the first axis of {} may be colour or components", m_axes.sizes[0]),
                     "Write the kinds of all axes, such as RGB-color domain domain domain.");
    std::vector<std::size_t> others;
    for (std::size_t axis = 0; axis < 4; ++axis)
        if (!isPlainSpace(axis)) others.push_back(axis);
    // Two space axes, a colour axis and a time-like axis are 2D frames in colour.
    const bool colourFrames = others.size() == 2 && isColour(others[0]) && m_axes.mayBeNoSpace(others[1]);
    if (others.size() > 1 && !colourFrames)
        return wrong("kinds", "names more than one axis that is not space", "Save one scalar volume over time.");
    const std::size_t axis = others.empty() ? (isScalarFirst() ? 0 : 3) : others[0];
    if (isColour(axis)) {
        if (auto colour = checkColourAxis(axis); !colour) return colour;
        m_axes.roles[axis] = NrrdAxisRole::colour;
        return {};
    }
    if (auto known = checkKind(axis, ", which cannot be read"); !known) return known;
    if (axis != 0 && axis != 3)
        return wrong("kinds", "has its time axis in the middle; it must be the first or the last",
                     "Export the volume with time as the last axis.");
    m_axes.roles[axis] = NrrdAxisRole::time;
    if (m_axes.kinds.empty() && m_axes.sizes[axis] > 1)
        m_axes.warnings.push_back(
            fmt::format("kinds is missing: the {} axis is taken as time.", axis == 0 ? "first" : "last"));
    return {};
}

}  // namespace

std::size_t nrrdSpaceDimensions(const NrrdFields& fields) {
    const auto space = fields.fields.find("space");
    if (space != fields.fields.end()) {
        const std::string name = lowerCase(space->second);
        return name.ends_with("-time") || name == "rast" || name == "last" || name == "lpst" ? 4 : 3;
    }
    const auto dimension = fields.fields.find("space dimension");
    const auto number = dimension == fields.fields.end() ? std::nullopt : wholeNumber(dimension->second);
    return number == 3 || number == 4 ? static_cast<std::size_t>(*number) : 0;
}

bool isTimeDirection(const NrrdVector& direction) {
    return direction && direction->size() == 4 && (*direction)[0] == 0 && (*direction)[1] == 0 &&
           (*direction)[2] == 0 && (*direction)[3] != 0;
}

Result<NrrdAxes> readNrrdAxes(const std::string& path, const NrrdFields& fields, StoredType type) {
    return AxesReader(path, fields, type).read();
}

}  // namespace echolucent
