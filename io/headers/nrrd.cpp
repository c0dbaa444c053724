#include "io/headers/nrrd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/headers/frames_over_time.h"
#include "io/headers/nrrd_axes.h"
#include "io/headers/nrrd_fields.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

class NrrdHeader {
public:
    NrrdHeader(const InputFile& file, bool framesAsSlices)
        : m_file(file), m_path(file.path()), m_framesAsSlices(framesAsSlices) {
        m_stored.path = m_path;
        m_stored.sizeKey = "sizes";
        m_stored.typeKey = "type";
        m_stored.byteOrderKey = "endian";
        m_stored.encodingKey = "encoding";
    }
    Result<StoredVolume> read();

private:
    using Step = Result<void> (NrrdHeader::*)();

    Result<void> readType();
    Result<void> readFrames();
    Result<void> placeAxes();
    Result<void> readSpacing();
    Result<void> readDirections();
    Result<void> readOrigin();
    Result<void> readPhaseTime();
    Result<void> applySpace();
    Result<void> readWhiteLevel();
    Result<void> readEncoding();
    Result<void> readDataPlace();
    Result<void> readFileList(const std::vector<std::string>& words);
    Result<void> readFilePattern(const std::vector<std::string>& words);
    Result<void> setDataFiles(const std::vector<std::string>& names, std::optional<std::int64_t> held);
    Result<void> readSkips();
    double mmOfAxis(std::size_t axis, const char* field);

    [[nodiscard]] const std::string* find(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        return found == m_fields.fields.end() ? nullptr : &found->second;
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& field, const std::string& problem,
                                                const std::string& remedy = correctHeader) const {
        return fail(FailureKind::unreadable, m_path, field, problem, remedy);
    }
    Result<std::int64_t> skipOf(const char* field, std::int64_t least) const;

    const InputFile& m_file;
    std::string m_path;
    bool m_framesAsSlices = false;
    NrrdFields m_fields;
    NrrdAxes m_axes;
    std::array<std::size_t, 3> m_spaceAxes{};  // the file's axes that are x, y, z
    std::optional<std::size_t> m_timeAxis;
    std::vector<double> m_spacings;  // the header's spacings beside space directions, which count instead; else empty
    StoredVolume m_stored;
};

Result<StoredVolume> NrrdHeader::read() {
    auto fields = readNrrdFields(m_file);
    if (!fields) return tl::unexpected(fields.error());
    m_fields = std::move(*fields);
    if (!m_fields.ended && find("data file") == nullptr)
        return wrong("", "has a header without the empty line that ends it", damagedFile);
    for (const Step step :
         {&NrrdHeader::readType, &NrrdHeader::placeAxes, &NrrdHeader::readSpacing, &NrrdHeader::readDirections,
          &NrrdHeader::readOrigin, &NrrdHeader::applySpace, &NrrdHeader::readPhaseTime, &NrrdHeader::readFrames,
          &NrrdHeader::readWhiteLevel, &NrrdHeader::readEncoding, &NrrdHeader::readDataPlace, &NrrdHeader::readSkips})
        if (const auto done = (this->*step)(); !done) return tl::unexpected(done.error());
    m_stored.facts.insert(m_stored.facts.begin(), {"format", "NRRD", "its first line"});
    return m_stored;
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

Result<void> NrrdHeader::placeAxes() {
    auto axes = readNrrdAxes(m_path, m_fields, m_stored.type);
    if (!axes) return tl::unexpected(axes.error());
    m_axes = std::move(*axes);
    m_stored.warnings = m_axes.warnings;
    std::size_t next = 0;
    for (std::size_t axis = 0; axis < m_axes.sizes.size(); ++axis) {
        if (m_axes.roles[axis] == NrrdAxisRole::space) {
            m_stored.geometry.size[next] = m_axes.sizes[axis];
            m_spaceAxes[next++] = axis;
        } else if (m_axes.roles[axis] == NrrdAxisRole::colour) {
            m_stored.channels = 3;
        } else {
            m_timeAxis = axis;
            m_stored.phases = m_axes.sizes[axis];
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
        if (m_axes.directions.empty()) m_stored.geometry.spacingKnown = false;
        return {};
    }
    const auto spacings = realNumbers(*text);
    if (!spacings || spacings->size() != m_axes.sizes.size())
        return wrong("spacings", fmt::format("must be {} numbers, not {}", m_axes.sizes.size(), quotedText(*text)));
    if (!m_axes.directions.empty()) {
        m_spacings = *spacings;
        return {};
    }
    m_stored.spacingSource = "spacings";
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t fileAxis = m_spaceAxes[static_cast<std::size_t>(axis)];
        double spacing = (*spacings)[fileAxis] * mmOfAxis(fileAxis, "units");
        // A time axis has a spacing in seconds or none.
        if (m_axes.mayBeNoSpace(fileAxis) && !(std::isfinite(spacing) && spacing > 0)) spacing = 1;
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
    if (m_axes.directions.empty()) return {};
    const std::string& text = *find("space directions");
    Mat3& direction = m_stored.geometry.direction;
    std::optional<int> withoutDirection;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t fileAxis = m_spaceAxes[static_cast<std::size_t>(axis)];
        const NrrdVector& vector = m_axes.directions[fileAxis];
        if (!vector && m_axes.mayBeNoSpace(fileAxis)) {
            withoutDirection = axis;
            continue;
        }
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
    for (std::size_t axis = 0; axis < 3 && !m_spacings.empty(); ++axis) {
        const double stated = std::abs(m_spacings[m_spaceAxes[axis]]) * mmOfAxis(m_spaceAxes[axis], "units");
        const double spacing = m_stored.geometry.spacing[static_cast<int>(axis)];
        if (!std::isfinite(stated) || std::abs(stated - spacing) <= 1e-4 * spacing) continue;
        m_stored.warnings.push_back(
            fmt::format("spacings gives {:.6g} mm along {} where space directions gives {:.6g} mm; space directions "
                        "counts.",
                        stated, "xyz"[axis], spacing));
    }
    if (withoutDirection) {
        const auto column = [&](int axis) { return Vec3(direction(0, axis), direction(1, axis), direction(2, axis)); };
        const Vec3 normal = column((*withoutDirection + 1) % 3).cross(column((*withoutDirection + 2) % 3));
        for (int row = 0; row < 3; ++row) direction(row, *withoutDirection) = normal[row];
    }
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
    // Without a unit, programs that know no time write 1.
    if (!seconds && step == 1.0) return {};
    m_stored.phaseTimes = PhaseTimes::every(step * seconds.value_or(1.0));
    m_stored.phaseSource = seconds ? "spacings, units" : "spacings, assumed to be seconds";
    return {};
}

Result<void> NrrdHeader::readFrames() {
    FrameWords words;
    words.kindsKey = "kinds";
    for (std::size_t axis = 0; axis < 3; ++axis) words.kinds[axis] = m_axes.kindOf(m_spaceAxes[axis]);
    for (const auto& [key, value] : m_fields.keys) words.keys.push_back(key);
    return settleFrames(m_stored, words, m_framesAsSlices);
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
    const std::map<std::string, VoxelEncoding> encodings{
        {"raw", VoxelEncoding::raw},     {"gzip", VoxelEncoding::zlib}, {"gz", VoxelEncoding::zlib},
        {"bzip2", VoxelEncoding::bzip2}, {"bz2", VoxelEncoding::bzip2}, {"ascii", VoxelEncoding::text},
        {"text", VoxelEncoding::text},   {"txt", VoxelEncoding::text},  {"hex", VoxelEncoding::hex}};
    const auto encoding = encodings.find(lowerCase(*text));
    if (encoding == encodings.end())
        return wrong("encoding", "is " + quotedText(*text) + ", which is not known",
                     "Save the volume with encoding raw or gzip.");
    m_stored.extent.encoding = encoding->second;
    if (encoding->second == VoxelEncoding::text) return {};  // numbers have no byte order
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
        m_stored.data = {{m_path, m_file}};
        m_stored.extent.offset = m_fields.headerBytes;
        return {};
    }
    if (isNrrdList(*name)) return readFileList(wordsOf(*name));
    if (name->find('%') != std::string::npos) return readFilePattern(wordsOf(*name));
    const auto beside = dataFileBeside({m_path, "data file"}, *name);
    if (!beside) return tl::unexpected(beside.error());
    m_stored.data = {*beside};
    return {};
}

Result<void> NrrdHeader::setDataFiles(const std::vector<std::string>& names, std::optional<std::int64_t> held) {
    // Each file holds the first `held` axes whole; without `held`, all axes but the last. If `held` names all axes,
    // each file holds a slab along the last one.
    const auto count = static_cast<std::int64_t>(names.size());
    const auto axes = static_cast<std::int64_t>(m_axes.sizes.size());
    const std::int64_t whole = held.value_or(axes - 1);
    if (whole < 2 || whole > axes)
        return wrong("data file", fmt::format("gives each file {} dimensions; it must be 2 to {}", whole, axes));
    std::optional<std::int64_t> expected = 1;
    for (std::int64_t axis = whole; axis < axes && expected; ++axis)
        expected = checkedProduct(*expected, m_axes.sizes[static_cast<std::size_t>(axis)]);
    const bool fits = whole == axes ? count > 0 && m_axes.sizes.back() % count == 0 : count == expected.value_or(0);
    if (!fits && whole == axes)
        return wrong("data file",
                     fmt::format("names {} data files, which cannot share {} slices", count, m_axes.sizes.back()));
    if (!fits)
        return wrong("data file",
                     fmt::format("names {} data files where the volume has {} parts", count, expected.value_or(0)));
    auto files = dataFilesBeside({m_path, "data file"}, names);
    if (!files) return tl::unexpected(files.error());
    m_stored.data = std::move(*files);
    return {};
}

Result<void> NrrdHeader::readFileList(const std::vector<std::string>& words) {
    const auto held = words.size() == 2 ? wholeNumber(words[1]) : std::nullopt;
    if (words.size() > 2 || (words.size() == 2 && !held))
        return wrong("data file",
                     "must be LIST and the dimensions of each file, not " + quotedText(*find("data file")));
    return setDataFiles(m_fields.dataFiles, held);
}

Result<void> NrrdHeader::readFilePattern(const std::vector<std::string>& words) {
    // A stray % in a name is refused here, whatever follows the name.
    if (const auto pattern = namesOfPattern({m_path, "data file"}, words.front(), {1, 1, 1}); !pattern)
        return tl::unexpected(pattern.error());
    std::vector<std::int64_t> numbers;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (const auto number = wholeNumber(words[i])) numbers.push_back(*number);
    if (numbers.size() + 1 != words.size() || numbers.size() < 3 || numbers.size() > 4)
        return wrong("data file", "must be a pattern with the first number, the last and the step, not " +
                                      quotedText(*find("data file")));
    const auto names = namesOfPattern({m_path, "data file"}, words.front(), {numbers[0], numbers[1], numbers[2]});
    if (!names) return tl::unexpected(names.error());
    return setDataFiles(*names, numbers.size() == 4 ? std::optional(numbers[3]) : std::nullopt);
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
    const auto bytes = skipOf("byte skip", m_stored.extent.encoding == VoxelEncoding::raw ? -1 : 0);
    if (!bytes) return tl::unexpected(bytes.error());
    m_stored.skipLines = *lines;
    m_stored.dataAtEnd = *bytes == -1;
    m_stored.extent.skipBytes = static_cast<std::uint64_t>(std::max<std::int64_t>(*bytes, 0));
    return {};
}

}  // namespace

bool looksLikeNrrd(std::string_view beginning) { return beginning.starts_with(nrrdSignature); }

Result<StoredVolume> readNrrdHeader(const InputFile& file, bool framesAsSlices) {
    return NrrdHeader(file, framesAsSlices).read();
}

}  // namespace echolucent
