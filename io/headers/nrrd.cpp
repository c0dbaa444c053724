#include "io/headers/nrrd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/headers/frame_spacing.h"
#include "io/headers/frames_over_time.h"
#include "io/headers/header_units.h"
#include "io/headers/nrrd_axes.h"
#include "io/headers/nrrd_data.h"
#include "io/headers/nrrd_fields.h"
#include "io/headers/nrrd_space.h"
#include "io/headers/nrrd_spacings.h"
#include "io/headers/nrrd_times.h"
#include "io/headers/value_levels.h"
#include "io/study/study_assembly.h"
#include "processing/ascii_letters.h"

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
    void take(const LengthUnits& units);
    [[nodiscard]] LengthUnits coordinateUnits() const;
    Result<void> checkVectors(const char* field, const std::vector<NrrdVector>& vectors);
    void compareSpacings();
    void note(const std::string& sentence) { m_stored.warnings.push_back(sentence); }
    Result<void> readPhaseTime();
    Result<void> applySpace();
    Result<void> readWhiteLevel();
    Result<void> readEncoding();
    Result<void> readDataPlace();

    [[nodiscard]] const std::string* find(const std::string& field) const {
        const auto found = m_fields.fields.find(field);
        return found == m_fields.fields.end() ? nullptr : &found->second;
    }
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& field, const std::string& problem,
                                                const std::string& remedy = correctHeader) const {
        return fail(FailureKind::unreadable, m_path, field, problem, remedy);
    }

    const InputFile& m_file;
    std::string m_path;
    bool m_framesAsSlices = false;
    NrrdFields m_fields;
    NrrdAxes m_axes;
    std::array<std::size_t, 3> m_spaceAxes{};  // the file's axes that are x, y, z
    std::optional<std::size_t> m_timeAxis;
    NrrdSpacings m_spacings;
    std::size_t m_dimensions = 0;  // of space and time, in which vectors are given; 0 until known
    Vec3 m_coordinateMm{1, 1, 1};  // units of the three coordinates of space
    StoredVolume m_stored;
};

Result<StoredVolume> NrrdHeader::read() {
    auto fields = readNrrdFields(m_file);
    if (!fields) return tl::unexpected(fields.error());
    m_fields = std::move(*fields);
    if (!m_fields.repeated.empty()) note(repeatedNote(m_fields.repeated));
    if (!m_fields.ended && find("data file") == nullptr)
        return wrong("", "has a header without the empty line that ends it", damagedFile);
    for (const Step step :
         {&NrrdHeader::readType, &NrrdHeader::placeAxes, &NrrdHeader::readSpacing, &NrrdHeader::readDirections,
          &NrrdHeader::readOrigin, &NrrdHeader::applySpace, &NrrdHeader::readFrames, &NrrdHeader::readPhaseTime,
          &NrrdHeader::readWhiteLevel, &NrrdHeader::readEncoding, &NrrdHeader::readDataPlace})
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
    for (const std::string& warning : m_axes.warnings) note(warning);
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

void NrrdHeader::take(const LengthUnits& units) {
    if (!units.warning.empty()) note(units.warning);
    if (!units.known) m_stored.geometry.spacingKnown = false;
}

Result<void> NrrdHeader::readSpacing() {
    auto spacings = nrrdSpacings(m_path, m_fields, m_axes);
    if (!spacings) return tl::unexpected(spacings.error());
    m_spacings = std::move(*spacings);
    for (const std::string& warning : m_spacings.warnings) note(warning);
    if (!m_axes.directions.empty()) return {};
    if (m_spacings.values.empty()) {
        m_stored.geometry.spacingKnown = false;
        return {};
    }
    const LengthUnits units = unitsOfSpaceAxes(m_fields, m_axes);
    take(units);
    m_stored.spacingSource = m_spacings.source + (units.stated ? ", units" : "");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double spacing = m_spacings.values[m_spaceAxes[axis]] * units.mm[axis];
        // A time axis has a spacing in seconds or none.
        if (m_axes.mayBeNoSpace(m_spaceAxes[axis]) && !(std::isfinite(spacing) && spacing > 0)) spacing = 1;
        if (!std::isfinite(spacing) || spacing == 0.0)
            return wrong(m_spacings.source,
                         "must be finite and not 0 along the space axes, not " +
                             quotedText(*find(m_spacings.source == "spacings" ? "spacings" : "axis maxs")));
        if (spacing < 0) {
            note(fmt::format("{} is negative along {}: taken as positive, with that axis turned round.",
                             m_spacings.source, "xyz"[axis]));
            m_stored.geometry.direction(static_cast<int>(axis), static_cast<int>(axis)) = -1;
        }
        m_stored.geometry.spacing[static_cast<int>(axis)] = std::abs(spacing);
    }
    return {};
}

/// The unit of the coordinates of space: that of "space units", else that of units, unless the spacings beside it show
/// that the directions are in mm.
LengthUnits NrrdHeader::coordinateUnits() const {
    if (const LengthUnits stated = unitsOfCoordinates(m_fields); stated.stated) return stated;
    LengthUnits units = unitsOfSpaceAxes(m_fields, m_axes);
    if (!units.known || (units.areOne() && units.mm.front() == 1.0)) return units;
    bool inMm = !m_spacings.values.empty();
    for (std::size_t axis = 0; axis < 3 && inMm; ++axis) {
        const NrrdVector& step = m_axes.directions[m_spaceAxes[axis]];
        const double stated = std::abs(m_spacings.values[m_spaceAxes[axis]]) * units.mm[axis];
        inMm = step && step->size() >= 3 &&
               std::abs(stated - length(Vec3((*step)[0], (*step)[1], (*step)[2]))) <= 1e-4 * stated;
    }
    if (inMm) return unitsOfCoordinates(m_fields);
    units.known = units.areOne();
    units.warning = units.known ? "units counts for the coordinates of space too: there are no space units."
                                : "units names several lengths, which cannot be those of the coordinates of space.";
    if (!units.known) units.mm.assign(3, 1.0);
    return units;
}

/// Refuses vectors of another length than the space has dimensions. Decimal commas make such vectors.
Result<void> NrrdHeader::checkVectors(const char* field, const std::vector<NrrdVector>& vectors) {
    for (const NrrdVector& vector : vectors) {
        if (!vector) continue;
        if (m_dimensions == 0) m_dimensions = vector->size();
        // Programs that know no time write three numbers in a space with time.
        if (m_dimensions == 4 && vector->size() == 3) continue;
        if (vector->size() != m_dimensions)
            return wrong(field,
                         fmt::format("must hold vectors of {} numbers in this space, not {}", m_dimensions,
                                     quotedText(*find(field))),
                         "Correct the header. Numbers have points, never commas, before their fractions.");
    }
    return {};
}

Result<void> NrrdHeader::readDirections() {
    m_dimensions = nrrdSpaceDimensions(m_fields);
    if (m_axes.directions.empty()) return {};
    if (auto alike = checkVectors("space directions", m_axes.directions); !alike) return alike;
    const std::string& text = *find("space directions");
    const LengthUnits units = coordinateUnits();
    take(units);
    m_coordinateMm = {units.mm[0], units.mm[1], units.mm[2]};
    Mat3& direction = m_stored.geometry.direction;
    std::optional<int> withoutDirection;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t fileAxis = m_spaceAxes[static_cast<std::size_t>(axis)];
        const NrrdVector& vector = m_axes.directions[fileAxis];
        if ((!vector || isTimeDirection(vector)) && m_axes.mayBeNoSpace(fileAxis)) {
            withoutDirection = axis;
            continue;
        }
        if (!vector || vector->size() < 3)
            return wrong("space directions",
                         "must hold a vector of 3 numbers for each space axis, not " + quotedText(text));
        Vec3 step;
        for (int row = 0; row < 3; ++row) step[row] = (*vector)[static_cast<std::size_t>(row)] * m_coordinateMm[row];
        const double spacing = length(step);
        if (!std::isfinite(spacing) || spacing == 0.0)
            return wrong("space directions", "must be finite vectors that are not 0, not " + quotedText(text));
        m_stored.geometry.spacing[axis] = spacing;
        for (int row = 0; row < 3; ++row) direction(row, axis) = step[row];
        if (vector->size() > 3 && (*vector)[3] != 0)
            note(fmt::format("space directions moves through time along {}, which is left out.", "xyz"[axis]));
    }
    m_stored.spacingSource = "space directions";
    compareSpacings();
    if (withoutDirection) {
        const auto column = [&](int axis) { return Vec3(direction(0, axis), direction(1, axis), direction(2, axis)); };
        const Vec3 normal = column((*withoutDirection + 1) % 3).cross(column((*withoutDirection + 2) % 3));
        // Frames over time have no hands: a left-handed frame must not give them any.
        const auto space = find("space") != nullptr ? nrrdSpace(*find("space")) : std::nullopt;
        const double way = space && space->isLeftHanded() ? -1.0 : 1.0;
        for (int row = 0; row < 3; ++row) direction(row, *withoutDirection) = way * normal[row];
    }
    if (!normalizeDirection(direction))
        return wrong("space directions", "does not hold three independent directions: " + quotedText(text));
    if (auto warning = skewWarning(direction); !warning.empty()) note(warning);
    return {};
}

/// Notes where spacings beside space directions, which do not count, say something else.
void NrrdHeader::compareSpacings() {
    const LengthUnits units = unitsOfSpaceAxes(m_fields, m_axes);
    if (m_spacings.source != "spacings" || !units.known) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        // Without units of their own, spacings are in those of space.
        const double mm = units.stated ? units.mm[axis] : m_coordinateMm[static_cast<int>(axis)];
        const double stated = std::abs(m_spacings.values[m_spaceAxes[axis]]) * mm;
        const double spacing = m_stored.geometry.spacing[static_cast<int>(axis)];
        if (!std::isfinite(stated) || std::abs(stated - spacing) <= 1e-4 * spacing) continue;
        note(
            fmt::format("spacings gives {:.6g} mm along {} where space directions gives {:.6g} mm; space directions "
                        "counts.",
                        stated, "xyz"[axis], spacing));
    }
}

Result<void> NrrdHeader::readOrigin() {
    const auto* text = find("space origin");
    if (text == nullptr) return {};
    const auto vectors = nrrdVectors(*text);
    const bool whole = vectors && vectors->size() == 1 && vectors->front() && vectors->front()->size() >= 3 &&
                       std::all_of(vectors->front()->begin(), vectors->front()->begin() + 3,
                                   [](double value) { return std::isfinite(value); });
    if (!whole) return wrong("space origin", "must be one vector of 3 finite numbers, not " + quotedText(*text));
    if (auto alike = checkVectors("space origin", *vectors); !alike) return alike;
    // Without directions, the unit of the coordinates was not read yet.
    if (m_axes.directions.empty()) {
        const LengthUnits units = unitsOfCoordinates(m_fields);
        for (int row = 0; row < 3; ++row) m_coordinateMm[row] = units.mm[static_cast<std::size_t>(row)];
    }
    for (int row = 0; row < 3; ++row)
        m_stored.geometry.origin[row] = (*vectors->front())[static_cast<std::size_t>(row)] * m_coordinateMm[row];
    if (!isPosition(m_stored.geometry.origin))
        return wrong("space origin", "lies farther than 10 km from 0: " + quotedText(*text));
    return {};
}

Result<void> NrrdHeader::applySpace() {
    const auto* text = find("space");
    if (text == nullptr) return {};
    const auto space = nrrdSpace(*text);
    if (!space)
        return wrong("space", "is " + quotedText(*text) + ", which is not a known frame",
                     "Use left-posterior-superior, right-anterior-superior or left-anterior-superior.");
    VolumeGeometry& geometry = m_stored.geometry;
    geometry.origin = geometry.origin.mul(space->inLps);
    geometry.direction = Mat3::diag(space->inLps) * geometry.direction;
    geometry.patientFrameKnown = space->ofPatient && saysMoreThanItsAxes(geometry.direction);
    m_stored.ownAxes = space->ownAxes;
    m_stored.facts.push_back({"patient frame", space->name, "space"});
    return {};
}

Result<void> NrrdHeader::readPhaseTime() {
    if (!m_timeAxis || m_stored.phases < 2) return {};
    if (auto stated = nrrdTimes(m_fields, m_axes, m_spacings, *m_timeAxis)) takeTimes(std::move(*stated), m_stored);
    return {};
}

Result<void> NrrdHeader::readFrames() {
    FrameWords words;
    words.kindsKey = "kinds";
    for (std::size_t axis = 0; axis < 3; ++axis) words.kinds[axis] = m_axes.kindOf(m_spaceAxes[axis]);
    for (const auto& [key, value] : m_fields.keys) words.keys.push_back(key);
    takeFrameSpacing(m_fields.keys, m_stored);
    return settleFrames(m_stored, words, m_framesAsSlices);
}

Result<void> NrrdHeader::readWhiteLevel() {
    const auto find = [&](const char* key) {
        const auto found = m_fields.keys.find(key);
        return found != m_fields.keys.end() ? &found->second : nullptr;
    };
    const auto read = readLevels(find("BlackLevel"), find("WhiteLevel"), m_stored);
    return read ? Result<void>() : wrong(read.error().key, read.error().problem);
}

Result<void> NrrdHeader::readEncoding() {
    const auto* text = find("encoding");
    if (text == nullptr) return wrong("encoding", "is missing");
    const std::map<std::string, VoxelEncoding> encodings{{"raw", VoxelEncoding::raw},     {"gzip", VoxelEncoding::zlib},
                                                         {"gz", VoxelEncoding::zlib},     {"gzi", VoxelEncoding::zlib},
                                                         {"bzip2", VoxelEncoding::bzip2}, {"bz2", VoxelEncoding::bzip2},
                                                         {"ascii", VoxelEncoding::text},  {"text", VoxelEncoding::text},
                                                         {"txt", VoxelEncoding::text},    {"hex", VoxelEncoding::hex}};
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

Result<void> NrrdHeader::readDataPlace() { return placeNrrdData(m_file, m_fields, m_axes.sizes, m_stored); }

}  // namespace

bool looksLikeNrrd(std::string_view beginning) { return withoutByteOrderMark(beginning).starts_with(nrrdSignature); }

Result<StoredVolume> readNrrdHeader(const InputFile& file, bool framesAsSlices) {
    return NrrdHeader(file, framesAsSlices).read();
}

}  // namespace echolucent
