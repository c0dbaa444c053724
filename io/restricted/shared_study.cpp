#include "io/restricted/shared_study.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "io/files/input_file.h"
#include "io/restricted/descriptions.h"
#include "io/study/study_assembly.h"

namespace echolucent::restricted {

namespace {

/// The place of voxels or a mask in shared memory.
struct Extent {
    std::int32_t type = 0;     // index of the alternative of Voxels
    std::uint64_t offset = 0;  // bytes from the beginning, a multiple of a page
    std::uint64_t count = 0;   // values
};

template <typename Archive, Described<Extent> Value>
void describe(Archive& archive, Value& extent) {
    archive(extent.type, extent.offset, extent.count);
}

struct SharedVolume {
    VolumeGeometry geometry;
    Extent voxels;
    double whiteLevel = 1.0;
    ValueScale valueScale;
    std::int32_t mask = -1;  // index in the list of masks; -1 if all voxels are data
    DataBox box;
};

template <typename Archive, Described<SharedVolume> Value>
void describe(Archive& archive, Value& volume) {
    archive(volume.geometry, volume.voxels, volume.whiteLevel, volume.valueScale, volume.mask, volume.box);
}

/// The volumes of a study, and their shared masks.
struct SharedVolumes {
    std::vector<SharedVolume> phases;
    std::vector<Extent> masks;
};

template <typename Archive, Described<SharedVolumes> Value>
void describe(Archive& archive, Value& volumes) {
    archive(volumes.phases, volumes.masks);
}

// No volume is longer, in units. A coarse grid has at least one voxel.
constexpr double mostUnitsOfCoarse = 100'000;

/// Memory that both processes see. Voxels in it keep it alive.
class Mapping {
public:
    Mapping(int file, std::uint64_t bytes, int protection)
        : m_bytes(static_cast<std::size_t>(bytes)),
          m_start(bytes > 0 ? mmap(nullptr, m_bytes, protection, MAP_SHARED, file, 0) : MAP_FAILED) {}
    ~Mapping() {
        if (isOpen()) munmap(m_start, m_bytes);
    }
    Mapping(const Mapping&) = delete;
    Mapping& operator=(const Mapping&) = delete;
    [[nodiscard]] bool isOpen() const { return m_start != MAP_FAILED; }
    [[nodiscard]] std::uint8_t* start() const { return static_cast<std::uint8_t*>(m_start); }
    [[nodiscard]] std::uint64_t size() const { return m_bytes; }
    /// Lets the kernel map all pages of a part at once, which is faster than mapping each at its first touch. The part
    /// begins at a page. All its pages must be there already, because mapping a missing page would take memory.
    void mapPart(std::uint64_t offset, std::uint64_t bytes) const {
        madvise(start() + offset, static_cast<std::size_t>(bytes), MADV_POPULATE_READ);
    }

private:
    std::size_t m_bytes;
    void* m_start;
};

/// Lays values out in shared memory. Values that lie there already stay in place.
class Placing {
public:
    explicit Placing(SharedVoxelMemory& memory) : m_memory(memory) {}
    /// Throws std::bad_alloc if memory runs out.
    template <typename Value>
    Extent place(std::int32_t type, const VoxelArray<Value>& values) {
        const std::size_t bytes = values.size() * sizeof(Value);
        if (const auto offset = m_memory.offsetOf(values.data()); offset && *offset % sharedPageBytes == 0)
            return {type, *offset, values.size()};
        void* const copy = m_memory.allocate(bytes);
        std::memcpy(copy, values.data(), bytes);
        m_copies.emplace_back(copy, bytes);
        return {type, *m_memory.offsetOf(copy), values.size()};
    }

    /// Gives the copies back after the memory was handed over.
    void end() {
        for (const auto& [copy, bytes] : std::exchange(m_copies, {})) m_memory.deallocate(copy, bytes);
    }

private:
    SharedVoxelMemory& m_memory;
    std::vector<std::pair<void*, std::size_t>> m_copies;
};

/// The values at an extent; no value if they do not lie in the memory.
template <typename Value>
std::optional<VoxelArray<Value>> valuesAt(const std::shared_ptr<const Mapping>& memory, const Extent& extent) {
    if (extent.offset % sharedPageBytes != 0 || extent.offset > memory->size() ||
        extent.count > (memory->size() - extent.offset) / sizeof(Value))
        return std::nullopt;
    const auto* first = reinterpret_cast<const Value*>(memory->start() + extent.offset);
    return VoxelArray<Value>(memory, std::span(first, static_cast<std::size_t>(extent.count)));
}

/// A part of shared memory, in bytes.
struct Part {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
};

/// Maps those parts whose pages are all there, whatever the message says. The system looks for holes page by page, so
/// each page is looked at once, however many parts there are.
void mapAhead(const Mapping& memory, const Descriptor& file, std::vector<Part> parts) {
    std::ranges::sort(parts, {}, &Part::offset);
    std::uint64_t mapped = 0, hole = 0;
    for (const Part& part : parts) {
        mapped += part.bytes;
        if (mapped > memory.size()) return;
        if (part.offset >= hole) {
            const off_t found = lseek(file.number(), static_cast<off_t>(part.offset), SEEK_HOLE);
            if (found < 0) return;
            hole = static_cast<std::uint64_t>(found);
        }
        if (part.offset < hole && part.bytes <= hole - part.offset) memory.mapPart(part.offset, part.bytes);
    }
}

std::optional<Voxels> voxelsAt(const std::shared_ptr<const Mapping>& memory, const Extent& extent) {
    const auto as = [&]<typename Value>(Value) -> std::optional<Voxels> {
        auto values = valuesAt<Value>(memory, extent);
        return values ? std::optional<Voxels>(std::move(*values)) : std::nullopt;
    };
    switch (extent.type) {
        case 0: return as(std::uint8_t{});
        case 1: return as(std::uint16_t{});
        case 2: return as(float{});
        default: return std::nullopt;
    }
}

bool isFinite(const Vec3& vector) {
    return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

/// Whether the numbers of a volume are ones that a reader gives: size, spacing, origin, directions (right-handed),
/// reduction, probe, white level, scale and box.
bool isSensible(const SharedVolume& volume) {
    const VolumeGeometry& geometry = volume.geometry;
    std::optional<std::int64_t> voxels = 1;
    for (const std::int64_t size : geometry.size)
        voxels = voxels && size >= 1 ? checkedProduct(*voxels, size) : std::nullopt;
    if (!voxels || static_cast<std::uint64_t>(*voxels) != volume.voxels.count) return false;
    if (!std::all_of(std::begin(geometry.direction.val), std::end(geometry.direction.val),
                     [](double value) { return std::abs(value) <= 1.0 + 1e-6; }))
        return false;
    if (!(cv::determinant(geometry.direction) > 0.0)) return false;
    if (geometry.reduction && !canHaveMade(*geometry.reduction, geometry.size)) return false;
    if (const auto& probe = geometry.probe) {
        const auto isUnit = [](const Vec3& vector) { return std::abs(length(vector) - 1.0) < 1e-3; };
        if (!isUnit(probe->forward) || !isUnit(probe->down) || (probe->apexMm && !isFinite(*probe->apexMm)))
            return false;
    }
    const bool sensibleLevels = isSensibleWhite(volume.whiteLevel) && isSensible(volume.valueScale) &&
                                std::isfinite(volume.valueScale.fileValue(volume.whiteLevel));
    return sensibleLevels && isFinite(volume.box.lowMm) && isFinite(volume.box.highMm) &&
           isSensibleSpacing(geometry.spacing) && isPosition(geometry.origin);
}

bool isSensible(const Study& study) { return !study.name.empty(); }

/// Whether phases can be of one study: one size, type and scale, and at most mostPhases.
bool belongTogether(const std::vector<SharedVolume>& phases) {
    return !phases.empty() && phases.size() <= static_cast<std::size_t>(mostPhases) &&
           std::all_of(phases.begin(), phases.end(), [&](const SharedVolume& phase) {
               return phase.geometry.size == phases.front().geometry.size &&
                      phase.voxels.type == phases.front().voxels.type && phase.valueScale == phases.front().valueScale;
           });
}

/// Whether a mask marks only finite voxels as data.
bool marksFiniteOnly(const DataMask& mask, const DataMask& finite) {
    return finite.empty() ||
           std::equal(mask.begin(), mask.end(), finite.begin(), finite.end(),
                      [](std::uint8_t marked, std::uint8_t isFinite) { return marked == 0 || isFinite != 0; });
}

}  // namespace

Result<SharedStudy> shareStudy(Study study, SharedVoxelMemory& memory) {
    Placing placing(memory);
    SharedVolumes shared;
    std::map<const std::uint8_t*, std::int32_t> masks;
    try {
        for (const auto& phase : study.phases) {
            SharedVolume volume{phase->geometry(), {}, phase->whiteLevel(), phase->valueScale(), -1, phase->dataBox()};
            const auto type = static_cast<std::int32_t>(phase->voxels().index());
            volume.voxels =
                std::visit([&](const auto& values) { return placing.place(type, values); }, phase->voxels());
            if (const DataMask& mask = phase->dataMask(); !mask.empty()) {
                const auto [place, isNew] =
                    masks.try_emplace(mask.data(), static_cast<std::int32_t>(shared.masks.size()));
                if (isNew) shared.masks.push_back(placing.place(0, mask));
                volume.mask = place->second;
            }
            shared.phases.push_back(volume);
        }
    } catch (const std::bad_alloc&) {
        return fail(FailureKind::unreadable, study.files.empty() ? study.name : study.files.front(), "",
                    "needs more memory than there is", "Close other programs, or open it on a larger machine.");
    }
    MessageWriter writer;
    writer(study, shared);
    SharedStudy ready{writer.bytes(), memory.handOver()};
    study.phases.clear();
    placing.end();
    return ready;
}

namespace {

/// As takeStudy(); also no value if the memory is larger than `mostBytes`, or a size than `longest` voxels.
std::optional<Study> takeStudyWithin(std::span<const std::uint8_t> bytes, const Descriptor& voxels,
                                     std::int64_t mostBytes, std::int64_t longest) {
    Study study;
    SharedVolumes shared;
    MessageReader reader(bytes);
    reader(study, shared);
    if (!reader.complete() || !isSensible(study) || !belongTogether(shared.phases) ||
        !areTimesOf(study.phaseTimes, shared.phases.size()) ||
        std::ranges::max(shared.phases.front().geometry.size) > longest)
        return std::nullopt;
    // Only memory without a name can be sealed. Sealed memory is no file, and neither shrinks nor changes.
    struct stat status {};
    if (fcntl(voxels.number(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0 ||
        fstat(voxels.number(), &status) != 0 || status.st_size <= 0 || status.st_size > mostBytes)
        return std::nullopt;
    const auto memory =
        std::make_shared<const Mapping>(voxels.number(), static_cast<std::uint64_t>(status.st_size), PROT_READ);
    if (!memory->isOpen()) return std::nullopt;
    std::vector<Part> parts;
    std::vector<Volume::SharedMask> masks;
    for (const Extent& extent : shared.masks) {
        auto mask = valuesAt<std::uint8_t>(memory, extent);
        if (!mask) return std::nullopt;
        parts.push_back({extent.offset, extent.count});
        masks.push_back(std::make_shared<const DataMask>(std::move(*mask)));
    }
    std::vector<Voxels> voxelsOfPhases;
    for (const SharedVolume& phase : shared.phases) {
        auto values = isSensible(phase) ? voxelsAt(memory, phase.voxels) : std::nullopt;
        const auto mask = static_cast<std::size_t>(phase.mask);
        if (!values || (phase.mask >= 0 && (mask >= masks.size() || masks[mask]->size() != phase.voxels.count)))
            return std::nullopt;
        const std::size_t bytesOfOne = std::visit([](const auto& all) { return sizeof(all.front()); }, *values);
        parts.push_back({phase.voxels.offset, phase.voxels.count * bytesOfOne});
        voxelsOfPhases.push_back(std::move(*values));
    }
    mapAhead(*memory, voxels, std::move(parts));
    for (std::size_t i = 0; i < shared.phases.size(); ++i) {
        const SharedVolume& phase = shared.phases[i];
        const auto mask = static_cast<std::size_t>(phase.mask);
        const Volume volume =
            Volume(phase.geometry, std::move(voxelsOfPhases[i]), phase.whiteLevel).withValueScale(phase.valueScale);
        if (phase.mask >= 0 && !marksFiniteOnly(*masks[mask], volume.dataMask())) return std::nullopt;
        study.phases.push_back(std::make_shared<const Volume>(
            phase.mask >= 0 ? volume.withDataMask(masks[mask], phase.box) : volume.withDataBox(phase.box)));
    }
    return study;
}

}  // namespace

std::optional<Study> takeStudy(std::span<const std::uint8_t> bytes, const Descriptor& voxels) {
    constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
    return takeStudyWithin(bytes, voxels, any, any);
}

Result<SharedStudy> shareCoarse(const CoarseVolume& coarse) {
    Study study;
    study.name = "coarse";
    study.phases = {coarse.voxels};
    SharedVoxelMemory memory;
    auto shared = shareStudy(std::move(study), memory);
    if (!shared) return shared;
    MessageWriter writer;
    writer(coarse.units);
    shared->bytes = writer.bytes() + shared->bytes;
    return shared;
}

std::optional<CoarseVolume> takeCoarse(std::span<const std::uint8_t> bytes, const Descriptor& voxels) {
    CoarseVolume coarse;
    MessageReader reader(bytes);
    reader(coarse.units);
    // Voxels of any type and their mask, each at the beginning of a page.
    constexpr std::int64_t mostBytes =
        mostCoarseVoxels * mostCoarseVoxels * mostCoarseVoxels * 5 + 2 * static_cast<std::int64_t>(sharedPageBytes);
    if (!reader.good() || !(coarse.units >= 1.0 && coarse.units <= mostUnitsOfCoarse)) return std::nullopt;
    const auto study = takeStudyWithin(reader.rest(), voxels, mostBytes, mostCoarseVoxels);
    if (!study || study->phases.size() != 1) return std::nullopt;
    coarse.voxels = study->phases.front();
    return coarse;
}

}  // namespace echolucent::restricted
