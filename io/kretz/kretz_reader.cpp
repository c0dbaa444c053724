#include "io/kretz/kretz_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "io/files/input_problems.h"
#include "io/kretz/kretz_tags.h"
#include "io/study/polar_study.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

constexpr std::size_t pieceBytes = std::size_t{4} << 20;

/// Where the voxels of each phase begin.
struct StoredPhases {
    std::vector<std::uint64_t> offsets;
    std::uint64_t bytes = 0;  ///< of one phase
    std::string source;
    /// Whether each phase is an item of its own; the format does not say that such items are phases.
    bool onePerItem = false;
};

class KretzReader {
public:
    KretzReader(const KretzItems& items, const ReadOptions& options, const Progress& progress)
        : m_items(items), m_options(options), m_progress(progress) {}
    Result<Study> read();

private:
    using Size = std::array<std::int64_t, 3>;
    Result<Size> readSize() const;
    Result<StoredPhases> findPhases(const Size& size) const;
    Result<void> checkLength(const KretzItem& item, std::uint64_t bytes, const Size& size) const;
    [[nodiscard]] tl::unexpected<Failure> compressed() const;
    [[nodiscard]] bool saysCompressed() const;
    /// The remedy if an item is missing.
    [[nodiscard]] std::string missingRemedy() const {
        return m_items.ended() ? copyAgain
                               : "The file is incomplete, since its items have no end: copy or export it again.";
    }
    Result<std::vector<VoxelBytes>> readPhases(const StoredPhases& phases) const;
    Result<std::optional<PolarGeometry>> readGeometry(const Size& size) const;
    Result<double> needed(KretzTag tag) const;
    Result<void> setCartesian(const Size& size, StudyParts& parts) const;
    void noteWhatIsLeftOut(StudyParts& parts) const;

    const KretzItems& m_items;
    const ReadOptions& m_options;
    const Progress& m_progress;
};

Result<std::array<std::int64_t, 3>> KretzReader::readSize() const {
    Size size{};
    constexpr std::array<KretzTag, 3> tags{kretz::samples, kretz::lines, kretz::planes};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto count = m_items.wholeNumber(tags[axis]);
        if (!count) return tl::unexpected(count.error());
        if (!*count) {
            if (saysCompressed()) return compressed();
            return m_items.refused(tags[axis], "is missing: the size of the volume is not known", missingRemedy());
        }
        if (**count < 1) return m_items.refused(tags[axis], "is 0: there is no volume");
        size[axis] = **count;
    }
    return size;
}

bool KretzReader::saysCompressed() const {
    return std::any_of(std::begin(kretz::compressedVoxels), std::end(kretz::compressedVoxels),
                       [&](KretzTag tag) { return m_items.has(tag); });
}

tl::unexpected<Failure> KretzReader::compressed() const {
    return fail(FailureKind::unreadable, m_items.source().path, "",
                "is a compressed GE Voluson volume (Kretz, wavelet), which cannot be read",
                "Save it without compression on the scanner or in its software, or as a Cartesian volume.");
}

Result<void> KretzReader::checkLength(const KretzItem& item, std::uint64_t bytes, const Size& size) const {
    if (item.length == bytes) return {};
    if (item.length < bytes && saysCompressed()) return compressed();
    return m_items.refused(item.tag, fmt::format("holds {} bytes of voxels where the size {} needs {}", item.length,
                                                 sizeText(size), bytes));
}

Result<StoredPhases> KretzReader::findPhases(const Size& size) const {
    // The product of three numbers of 16 bits cannot overflow here.
    StoredPhases phases;
    phases.bytes = static_cast<std::uint64_t>(size[0] * size[1] * size[2]);
    const auto sequences = m_items.allOf(kretz::sequenceVoxels), volumes = m_items.allOf(kretz::voxels);
    if (sequences.size() > 1)
        return m_items.refused(kretz::sequenceVoxels,
                               fmt::format("stands {} times, and must stand once", sequences.size()));
    if (!sequences.empty()) {
        const KretzItem& sequence = sequences.front();
        if (sequence.length == 0 || sequence.length % phases.bytes != 0)
            return m_items.refused(
                sequence.tag, fmt::format("holds {} bytes, which is no whole number of volumes of {}", sequence.length,
                                          phases.bytes));
        phases.source = tagText(sequence.tag);
        const auto count = static_cast<std::int64_t>(sequence.length / phases.bytes);
        if (auto few = requirePhases(m_items.source().path, phases.source, count); !few)
            return tl::unexpected(few.error());
        for (std::uint64_t offset = 0; offset < sequence.length; offset += phases.bytes)
            phases.offsets.push_back(sequence.offset + offset);
    } else {
        for (const KretzItem& volume : volumes) {
            if (auto whole = checkLength(volume, phases.bytes, size); !whole) return tl::unexpected(whole.error());
            phases.offsets.push_back(volume.offset);
        }
        phases.onePerItem = true;
        phases.source = tagText(kretz::voxels);
        if (volumes.empty()) {
            if (saysCompressed()) return compressed();
            return m_items.refused(
                kretz::voxels, "is missing: the file holds no voxels, or compressed ones",
                m_items.ended() ? "Save it without compression on the scanner or in its software." : missingRemedy());
        }
    }
    if (auto few =
            requirePhases(m_items.source().path, phases.source, static_cast<std::int64_t>(phases.offsets.size()));
        !few)
        return tl::unexpected(few.error());
    return phases;
}

Result<std::vector<VoxelBytes>> KretzReader::readPhases(const StoredPhases& phases) const {
    const KretzSource& source = m_items.source();
    if (auto memory = requireMemory(source.path, phases.source, phases.bytes * phases.offsets.size()); !memory)
        return tl::unexpected(memory.error());
    std::vector<VoxelBytes> all;
    for (const std::uint64_t offset : phases.offsets) {
        VoxelBytes voxels(static_cast<std::size_t>(phases.bytes));
        for (std::size_t done = 0; done < voxels.size(); done += pieceBytes) {
            if (m_progress.cancelled()) return fail(FailureKind::cancelled, source.path, "", "was not read: cancelled");
            const auto piece = std::span(voxels).subspan(done, std::min(pieceBytes, voxels.size() - done));
            if (auto read = source.read(offset + done, piece); !read) return tl::unexpected(read.error());
            m_progress.at(
                0.8 *
                (static_cast<double>(all.size()) + static_cast<double>(done) / static_cast<double>(voxels.size())) /
                static_cast<double>(phases.offsets.size()));
        }
        all.push_back(std::move(voxels));
    }
    return all;
}

Result<double> KretzReader::needed(KretzTag tag) const {
    const auto number = m_items.number(tag);
    if (!number) return tl::unexpected(number.error());
    if (!*number)
        return m_items.refused(tag, "is missing although there are angles: the geometry is not known", missingRemedy());
    return **number;
}

Result<std::optional<PolarGeometry>> KretzReader::readGeometry(const Size& size) const {
    const auto lines = m_items.numbers(kretz::lineAngles, size[1], fmt::format("the angles of {} lines", size[1]));
    if (!lines) return tl::unexpected(lines.error());
    const auto planes = m_items.numbers(kretz::planeAngles, size[2], fmt::format("the angles of {} planes", size[2]));
    if (!planes) return tl::unexpected(planes.error());
    if (!*lines && !*planes) return std::optional<PolarGeometry>();
    if (!*lines)
        return m_items.refused(kretz::lineAngles, "is missing: there are angles of planes, but none of lines",
                               missingRemedy());
    if (!*planes)
        return m_items.refused(kretz::planeAngles, "is missing: there are angles of lines, but none of planes",
                               missingRemedy());
    const auto resolution = needed(kretz::resolution), firstSample = needed(kretz::firstSample),
               planesAxis = needed(kretz::planesAxis);
    for (const auto* number : {&resolution, &firstSample, &planesAxis})
        if (!*number) return tl::unexpected(number->error());

    PolarGeometry polar;
    polar.samples = size[0];
    polar.rangeStepMm = 1000 * *resolution;
    polar.lines.spread = polar.planes.spread = PolarSpread::angles;
    polar.lines.radiusMm = *firstSample * polar.rangeStepMm;
    polar.planes.radiusMm = (*firstSample + *planesAxis) * polar.rangeStepMm;
    polar.lines.values = **lines;
    for (double& angle : polar.lines.values) angle -= kretz::straightOn;
    // The file counts the angles of planes in the opposite direction.
    polar.planes.values = **planes;
    for (double& angle : polar.planes.values) angle = kretz::straightOn - angle;
    return std::optional(polar);
}

Result<void> KretzReader::setCartesian(const Size& size, StudyParts& parts) const {
    const auto spacing = m_items.number(kretz::cartesianSpacing), resolution = m_items.number(kretz::resolution);
    for (const auto* number : {&spacing, &resolution})
        if (!*number) return tl::unexpected(number->error());
    parts.geometry.size = size;
    parts.facts.push_back({"voxel grid", "Cartesian", "no angles of lines and planes"});
    if (!*spacing && !*resolution) {
        parts.geometry.spacingKnown = false;
        return {};
    }
    const double mm = *spacing ? **spacing : 1000 * **resolution;
    parts.geometry.spacing = {mm, mm, mm};
    parts.spacingSource =
        *spacing ? tagText(kretz::cartesianSpacing) + ", assumed to be mm" : tagText(kretz::resolution);
    if (*spacing && *resolution && !(std::abs(1000 * **resolution - mm) <= 0.01 * std::abs(mm)))
        parts.warnings.push_back(
            fmt::format("The file says two spacings, {:.6g} mm ({}) and {:.6g} mm ({}); the first "
                        "is taken.",
                        mm, tagText(kretz::cartesianSpacing), 1000 * **resolution, tagText(kretz::resolution)));
    return {};
}

void KretzReader::noteWhatIsLeftOut(StudyParts& parts) const {
    if (!m_items.ended() && m_items.source().element.empty())
        parts.warnings.emplace_back(
            "The items of the file have no end: it may have been cut off, and what followed is missing.");
    if (m_items.has(kretz::filteredVoxels))
        parts.warnings.push_back(
            fmt::format("The file also holds a filtered copy of the volume ({}), which is left out.",
                        tagText(kretz::filteredVoxels)));
    for (const auto& [tag, words] :
         {std::pair{kretz::colourVoxels, "colour flow"}, std::pair{kretz::powerVoxels, "power Doppler"}})
        if (m_items.has(tag))
            parts.warnings.push_back(
                fmt::format("The file also holds a volume of {} ({}), which is left out.", words, tagText(tag)));
}

Result<Study> KretzReader::read() {
    const auto size = readSize();
    if (!size) return tl::unexpected(size.error());
    const auto stored = findPhases(*size);
    if (!stored) return tl::unexpected(stored.error());
    const auto polar = readGeometry(*size);
    if (!polar) return tl::unexpected(polar.error());
    const auto tags = [](KretzTag first, KretzTag second) { return tagText(first) + ", " + tagText(second); };
    const PolarSources sources{tagText(kretz::samples) + " to " + tagText(kretz::planes),
                               tags(kretz::resolution, kretz::firstSample), tags(kretz::lineAngles, kretz::firstSample),
                               tags(kretz::planeAngles, kretz::planesAxis),
                               "the first sample lies on the probe's face"};
    const KretzSource& source = m_items.source();
    if (*polar)
        if (auto sensible = checkPolar(source.path, **polar, *size, sources); !sensible)
            return tl::unexpected(sensible.error());

    auto phases = readPhases(*stored);
    if (!phases) return tl::unexpected(phases.error());
    StudyParts parts;
    parts.path = source.path;
    parts.files = {source.path};
    parts.facts.push_back({"format", "GE Voluson volume (Kretz)",
                           source.element.empty() ? "KRETZFILE 1.0" : "KRETZFILE 1.0 in " + source.element});
    parts.phaseSource = stored->offsets.size() > 1 ? stored->source + " holds the phases, but no time" : "";
    parts.voxels = convertVoxels(std::move(*phases), StoredType::uint8);
    parts.typeSource = stored->source;
    parts.phasesSource =
        stored->source + (stored->onePerItem ? ", which stands several times: assumed to be phases" : "");
    parts.sizeSource = sources.size;
    noteWhatIsLeftOut(parts);
    auto placed = *polar ? scanConvert(parts, **polar, sources, m_options, m_progress) : setCartesian(*size, parts);
    if (!placed) return tl::unexpected(placed.error());
    return assembleStudy(std::move(parts), m_options, m_progress);
}

}  // namespace

bool looksLikeKretz(std::string_view beginning) { return beginning.starts_with(kretzSignature); }

Result<Study> readKretz(KretzSource source, const ReadOptions& options, const Progress& progress) {
    const auto items = KretzItems::walk(std::move(source), progress);
    if (!items) return tl::unexpected(items.error());
    return KretzReader(*items, options, progress).read();
}

}  // namespace echolucent
