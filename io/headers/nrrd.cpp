#include "io/headers/nrrd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/headers/header_text.h"
#include "io/headers/nrrd_fields.h"
#include "io/study_assembly.h"

namespace echolucent {

namespace {

const std::string exportAgain = "Correct the header or export the volume again.";

/// What an axis of the file means.
enum class AxisRole { space, time, colour };

class NrrdHeader {
public:
    NrrdHeader(std::string path, bool framesAsSlices) : m_path(std::move(path)), m_framesAsSlices(framesAsSlices) {}
    Result<StoredVolume> read();

private:
    using Step = Result<void> (NrrdHeader::*)();

    Result<void> readShape();
    Result<void> readType();
    Result<void> readRoles();
    Result<void> readFourthAxis();
    Result<void> placeAxes();
    Result<void> readSpacing();
    Result<void> readDirections();
    Result<void> readOrigin();
    Result<void> readPhaseTime();
    Result<void> applySpace();
    Result<void> readWhiteLevel();
    Result<void> readEncoding();
    Result<void> readDataPlace();
    Result<void> readSkips();
    double mmOfAxis(std::size_t axis, const char* field);

    [[nodiscard]] const std::string* find(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        return found == m_fields.fields.end() ? nullptr : &found->second;
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& field, const std::string& problem,
                                                const std::string& remedy = exportAgain) const {
        return fail(FailureKind::unreadable, m_path, field, problem, remedy);
    }
    Result<std::int64_t> skipOf(const char* field, std::int64_t least) const;

    std::string m_path;
    bool m_framesAsSlices = false;
    NrrdFields m_fields;
    std::vector<std::int64_t> m_sizes;
    std::vector<std::string> m_kinds;
    std::vector<NrrdVector> m_directions;  // one for each axis of the file; empty where the header has none
    std::vector<AxisRole> m_roles;
    std::array<std::size_t, 3> m_spaceAxes{};  // the file's axes that are x, y, z
    std::optional<std::size_t> m_timeAxis;
    StoredVolume m_stored;
};

Result<StoredVolume> NrrdHeader::read() {
    auto fields = readNrrdFields(m_path);
    if (!fields) return tl::unexpected(fields.error());
    m_fields = std::move(*fields);
    for (const Step step :
         {&NrrdHeader::readShape, &NrrdHeader::readType, &NrrdHeader::readRoles, &NrrdHeader::placeAxes,
          &NrrdHeader::readSpacing, &NrrdHeader::readDirections, &NrrdHeader::readOrigin, &NrrdHeader::applySpace,
          &NrrdHeader::readPhaseTime, &NrrdHeader::readWhiteLevel, &NrrdHeader::readEncoding,
          &NrrdHeader::readDataPlace, &NrrdHeader::readSkips})
        if (const auto done = (this->*step)(); !done) return tl::unexpected(done.error());
    m_stored.path = m_path;
    m_stored.sizeKey = "sizes";
    m_stored.facts.insert(m_stored.facts.begin(), {"format", "NRRD", ""});
    return m_stored;
}

Result<void> NrrdHeader::readShape() {
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
    m_sizes = *sizes;
    return {};
}

Result<void> NrrdHeader::readType() {
    const auto* text = find("type");
    if (text == nullptr) return wrong("type", "is missing");
    const auto type = nrrdType(*text);
    if (!type)
        return wrong("type", "is " + quotedText(*text) + ", which is not a type that can be read",
                     "Use uchar, ushort, short or float.");
    m_stored.type = *type;
    return {};
}

Result<void> NrrdHeader::readRoles() {
    if (const auto* text = find("kinds")) {
        m_kinds = wordsOf(*text);
        if (m_kinds.size() != m_sizes.size())
            return wrong("kinds", fmt::format("must be {} words, not {}", m_sizes.size(), quotedText(*text)));
        for (std::string& kind : m_kinds) kind = lowerCase(kind);
    }
    if (const auto* text = find("space directions")) {
        const auto vectors = nrrdVectors(*text);
        if (!vectors || vectors->size() != m_sizes.size())
            return wrong("space directions",
                         fmt::format("must be {} vectors or \"none\", not {}", m_sizes.size(), quotedText(*text)));
        m_directions = *vectors;
    }
    m_roles.assign(m_sizes.size(), AxisRole::space);
    if (m_sizes.size() == 4) return readFourthAxis();
    // "list" is left alone: programs write it on the slice axis of true volumes.
    const auto time = std::find(m_kinds.begin(), m_kinds.end(), "time");
    if (time == m_kinds.end()) return {};
    if (!m_framesAsSlices) {
        auto refused =
            wrong("kinds", "has two space axes and a time axis: 2D pictures over time without volume geometry",
                  "Add --frames-as-slices to take the pictures as slices.");
        refused.value().framesCouldBeSlices = true;
        return refused;
    }
    m_stored.geometry.spacingKnown = false;
    m_stored.warnings.push_back("Pictures over time are taken as slices.");
    return {};
}

Result<void> NrrdHeader::readFourthAxis() {
    std::optional<std::size_t> extra;
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const std::string kind = m_kinds.empty() ? "" : m_kinds[axis];
        const bool plainSpace = kind.empty() || kind == "domain" || kind == "space" || kind == "???" || kind == "none";
        const bool noDirection = !m_directions.empty() && !m_directions[axis];
        if (plainSpace && !noDirection) continue;
        if (extra)
            return wrong("kinds", "names more than one axis that is not space", "Save one scalar volume over time.");
        extra = axis;
    }
    const std::size_t axis = extra.value_or(3);
    const std::string kind = m_kinds.empty() ? "" : m_kinds[axis];
    const bool colour = kind == "rgb-color" || kind == "3-color";
    const bool time = kind.empty() || kind == "time" || kind == "list" || kind == "domain" || kind == "space" ||
                      kind == "???" || kind == "none" || m_sizes[axis] == 1;
    if (!colour && !time)
        return wrong("kinds", "has an axis of kind " + quotedText(kind) + ", which cannot be read",
                     "Save one scalar for each voxel.");
    if (colour && (axis != 0 || m_sizes[axis] != 3 || bytesOf(m_stored.type) > 2 || m_stored.type == StoredType::int8 ||
                   m_stored.type == StoredType::int16))
        return wrong("kinds", "has a colour axis that is not the first, of size 3, with 8 or 16 unsigned bits");
    if (axis != 0 && axis != 3)
        return wrong("kinds", "has its time axis in the middle; it must be the first or the last",
                     "Export the volume with time as the last axis.");
    m_roles[axis] = colour ? AxisRole::colour : AxisRole::time;
    return {};
}

Result<void> NrrdHeader::placeAxes() {
    std::size_t next = 0;
    for (std::size_t axis = 0; axis < m_sizes.size(); ++axis) {
        if (m_roles[axis] == AxisRole::space) {
            m_stored.geometry.size[next] = m_sizes[axis];
            m_spaceAxes[next++] = axis;
        } else if (m_roles[axis] == AxisRole::colour) {
            m_stored.channels = 3;
        } else {
            m_timeAxis = axis;
            m_stored.phases = m_sizes[axis];
            m_stored.phasesFastest = axis == 0;
        }
    }
    return {};
}

double NrrdHeader::mmOfAxis(std::size_t axis, const char* field) {
    const auto units = find(field) != nullptr ? nrrdQuotedWords(*find(field)) : std::vector<std::string>{};
    if (axis >= units.size()) return 1.0;
    if (const auto mm = mmOfUnit(units[axis])) return *mm;
    m_stored.warnings.push_back(
        fmt::format("{} names {}, which is not a known length; mm is assumed.", field, quotedText(units[axis])));
    return 1.0;
}

Result<void> NrrdHeader::readSpacing() {
    const auto* text = find("spacings");
    if (text == nullptr) {
        if (m_directions.empty()) m_stored.geometry.spacingKnown = false;
        return {};
    }
    const auto spacings = realNumbers(*text);
    if (!spacings || spacings->size() != m_sizes.size())
        return wrong("spacings", fmt::format("must be {} numbers, not {}", m_sizes.size(), quotedText(*text)));
    if (!m_directions.empty()) return {};
    m_stored.spacingSource = "spacings";
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t fileAxis = m_spaceAxes[static_cast<std::size_t>(axis)];
        double spacing = (*spacings)[fileAxis] * mmOfAxis(fileAxis, "units");
        // The axis that stands for time has a spacing in seconds or none.
        if (m_framesAsSlices && !m_stored.geometry.spacingKnown && !(std::isfinite(spacing) && spacing > 0))
            spacing = 1;
        if (!std::isfinite(spacing) || spacing == 0.0)
            return wrong("spacings", "must be finite and not 0 along the space axes, not " + quotedText(*text));
        if (spacing < 0) {
            m_stored.warnings.push_back(fmt::format(
                "spacings is negative along {}: taken as positive, with that axis turned round.", "xyz"[axis]));
            m_stored.geometry.direction(axis, axis) = -1;
        }
        m_stored.geometry.spacing[axis] = std::abs(spacing);
    }
    return {};
}

Result<void> NrrdHeader::readDirections() {
    if (m_directions.empty()) return {};
    const std::string& text = *find("space directions");
    Mat3& direction = m_stored.geometry.direction;
    for (int axis = 0; axis < 3; ++axis) {
        const NrrdVector& vector = m_directions[m_spaceAxes[static_cast<std::size_t>(axis)]];
        if (!vector || vector->size() < 3)
            return wrong("space directions",
                         "must hold a vector of 3 numbers for each space axis, not " + quotedText(text));
        Vec3 step;
        for (int row = 0; row < 3; ++row)
            step[row] =
                (*vector)[static_cast<std::size_t>(row)] * mmOfAxis(static_cast<std::size_t>(row), "space units");
        const double spacing = length(step);
        if (!std::isfinite(spacing) || spacing == 0.0)
            return wrong("space directions", "must be finite vectors that are not 0, not " + quotedText(text));
        m_stored.geometry.spacing[axis] = spacing;
        for (int row = 0; row < 3; ++row) direction(row, axis) = step[row];
    }
    m_stored.spacingSource = "space directions";
    if (!normalizeDirection(direction))
        return wrong("space directions", "does not hold three independent directions: " + quotedText(text));
    if (auto warning = skewWarning(direction); !warning.empty()) m_stored.warnings.push_back(std::move(warning));
    return {};
}

Result<void> NrrdHeader::readOrigin() {
    const auto* text = find("space origin");
    if (text == nullptr) return {};
    const auto vectors = nrrdVectors(*text);
    const bool whole = vectors && vectors->size() == 1 && vectors->front() && vectors->front()->size() >= 3 &&
                       std::all_of(vectors->front()->begin(), vectors->front()->begin() + 3,
                                   [](double value) { return std::isfinite(value); });
    if (!whole) return wrong("space origin", "must be one vector of 3 finite numbers, not " + quotedText(*text));
    for (int row = 0; row < 3; ++row)
        m_stored.geometry.origin[row] =
            (*vectors->front())[static_cast<std::size_t>(row)] * mmOfAxis(static_cast<std::size_t>(row), "space units");
    if (!isPosition(m_stored.geometry.origin))
        return wrong("space origin", "lies farther than 10 km from 0: " + quotedText(*text));
    return {};
}

Result<void> NrrdHeader::applySpace() {
    const auto* text = find("space");
    if (text == nullptr) return {};
    std::string space = lowerCase(*text);
    if (space.ends_with("-time")) space.resize(space.size() - 5);
    Vec3 sign(1, 1, 1);
    if (space == "right-anterior-superior" || space == "ras")
        sign = {-1, -1, 1};
    else if (space == "left-anterior-superior" || space == "las")
        sign = {1, -1, 1};
    else if (space != "left-posterior-superior" && space != "lps" && space != "scanner-xyz" &&
             space != "3d-right-handed" && space != "3d-left-handed")
        return wrong("space", "is " + quotedText(*text) + ", which is not a known frame",
                     "Use left-posterior-superior, right-anterior-superior or left-anterior-superior.");
    for (int row = 0; row < 3; ++row) {
        m_stored.geometry.origin[row] *= sign[row];
        for (int axis = 0; axis < 3; ++axis) m_stored.geometry.direction(row, axis) *= sign[row];
    }
    const bool frameOfPatient = space != "scanner-xyz" && !space.starts_with("3d-");
    m_stored.geometry.patientFrameKnown = frameOfPatient && saysMoreThanItsAxes(m_stored.geometry.direction);
    m_stored.facts.push_back({"patient frame", space, "space"});
    return {};
}

Result<void> NrrdHeader::readPhaseTime() {
    if (!m_timeAxis) return {};
    const auto* text = find("spacings");
    const auto spacings = text != nullptr ? realNumbers(*text) : std::nullopt;
    if (!spacings || !std::isfinite((*spacings)[*m_timeAxis]) || (*spacings)[*m_timeAxis] <= 0) return {};
    const double step = (*spacings)[*m_timeAxis];
    const auto units = find("units") != nullptr ? nrrdQuotedWords(*find("units")) : std::vector<std::string>{};
    const auto seconds = *m_timeAxis < units.size() ? secondsOfUnit(units[*m_timeAxis]) : std::nullopt;
    // Where there is no unit, 1 is what programs write that know no time.
    if (!seconds && step == 1.0) return {};
    m_stored.phaseSeconds = step * seconds.value_or(1.0);
    m_stored.phaseSource = seconds ? "spacings, units" : "spacings, assumed to be seconds";
    return {};
}

Result<void> NrrdHeader::readWhiteLevel() {
    const auto found = m_fields.keys.find("WhiteLevel");
    if (found == m_fields.keys.end()) return {};
    m_stored.whiteLevel = positiveNumber(found->second);
    if (!m_stored.whiteLevel) return wrong("WhiteLevel", "must be a number above 0, not " + quotedText(found->second));
    m_stored.whiteLevelSource = "WhiteLevel";
    return {};
}

Result<void> NrrdHeader::readEncoding() {
    const auto* text = find("encoding");
    if (text == nullptr) return wrong("encoding", "is missing");
    const std::string encoding = lowerCase(*text);
    if (encoding != "raw" && encoding != "gzip" && encoding != "gz")
        return wrong("encoding", "is " + quotedText(*text) + "; only raw and gzip are read",
                     "Save the volume with encoding raw or gzip.");
    m_stored.extent.compressed = encoding != "raw";
    const auto* endian = find("endian");
    if (endian == nullptr && bytesOf(m_stored.type) > 1)
        return wrong("endian", "is missing, but " + std::string(nameOf(m_stored.type)) + " needs it");
    if (endian != nullptr) {
        const std::string order = lowerCase(*endian);
        if (order != "little" && order != "big")
            return wrong("endian", "must be little or big, not " + quotedText(*endian));
        m_stored.bigEndian = order == "big";
    }
    return {};
}

Result<void> NrrdHeader::readDataPlace() {
    const auto* name = find("data file");
    if (name == nullptr) {
        if (!m_fields.ended)
            return wrong("", "has a header without the empty line that ends it",
                         "The file is cut off or damaged: copy or export it again.");
        m_stored.dataPath = m_path;
        m_stored.extent.offset = m_fields.headerBytes;
        return {};
    }
    if (*name == "LIST" || name->starts_with("LIST ") || name->find('%') != std::string::npos)
        return wrong("data file", "is " + quotedText(*name) + ": volumes spread over several data files are not read",
                     "Save the volume as one .nrrd file.");
    const auto beside = dataFileBeside(m_path, "data file", *name);
    if (!beside) return tl::unexpected(beside.error());
    m_stored.dataPath = *beside;
    return {};
}

Result<std::int64_t> NrrdHeader::skipOf(const char* field, std::int64_t least) const {
    const auto* text = find(field);
    if (text == nullptr) return 0;
    const auto skip = wholeNumber(*text);
    if (!skip || *skip < least)
        return wrong(field, fmt::format("must be {} or above, not {}", least, quotedText(*text)));
    return *skip;
}

Result<void> NrrdHeader::readSkips() {
    const auto lines = skipOf("line skip", 0);
    if (!lines) return tl::unexpected(lines.error());
    const auto bytes = skipOf("byte skip", m_stored.extent.compressed ? 0 : -1);
    if (!bytes) return tl::unexpected(bytes.error());
    if (*lines > 0) {
        const auto file = InputFile::open(m_stored.dataPath);
        if (!file) return tl::unexpected(file.error());
        const auto beginning = file->beginning(static_cast<std::size_t>(m_stored.extent.offset) + headerLimit);
        if (!beginning) return tl::unexpected(beginning.error());
        std::string_view rest = *beginning;
        rest.remove_prefix(std::min(static_cast<std::size_t>(m_stored.extent.offset), rest.size()));
        for (std::int64_t line = 0; line < *lines; ++line) {
            const auto end = rest.find('\n');
            if (end == std::string_view::npos)
                return wrong("line skip", fmt::format("is {}, but the data begin with only {} lines", *lines, line));
            rest.remove_prefix(end + 1);
        }
        m_stored.extent.offset = beginning->size() - rest.size();
    }
    if (*bytes == -1)
        m_stored.dataAtEnd = true;
    else if (m_stored.extent.compressed)
        m_stored.extent.skipBytes = static_cast<std::uint64_t>(*bytes);
    else
        m_stored.extent.offset += static_cast<std::uint64_t>(*bytes);
    return {};
}

}  // namespace

bool looksLikeNrrd(std::string_view beginning) { return beginning.starts_with("NRRD000"); }

Result<StoredVolume> readNrrdHeader(const std::string& path, bool framesAsSlices) {
    return NrrdHeader(path, framesAsSlices).read();
}

}  // namespace echolucent
