#include "io/stored/stored_volume_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "io/stored/coarse_bytes.h"
#include "io/stored/reduced_phases.h"
#include "io/stored/right_handed.h"
#include "io/stored/stored_bytes.h"
#include "io/study/study_assembly.h"
#include "io/study/value_window.h"
#include "processing/volume/block_mean.h"

namespace echolucent {

namespace {

/// Separates phases that are interleaved voxel by voxel.
std::vector<VoxelBytes> splitPhases(const VoxelBytes& all, std::size_t phases, std::size_t voxelBytes) {
    std::vector<VoxelBytes> split(phases, VoxelBytes(all.size() / phases));
    const std::size_t voxels = all.size() / phases / voxelBytes;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
        for (std::size_t phase = 0; phase < phases; ++phase)
            std::memcpy(split[phase].data() + voxel * voxelBytes, all.data() + (voxel * phases + phase) * voxelBytes,
                        voxelBytes);
    return split;
}

/// Chooses how the voxels are reduced. Voxels along beams are not reduced: their conversion has its own limit. Fails if
/// the machine has too little memory.
Result<std::optional<ChosenReduction>> reductionOf(const StoredVolume& stored, const ByteCounts& counts,
                                                   const ReadOptions& options) {
    if (!stored.polar)
        return chooseReduction(stored.path, stored.sizeKey,
                               {stored.geometry.size, stored.phases, stored.type, stored.rescale.has_value()}, options);
    const std::int64_t kept =
        stored.rescale ? counts.all / bytesOf(stored.type) * bytesOf(StoredType::float32) : counts.all;
    const auto largest = static_cast<std::uint64_t>(std::max(kept, counts.all));
    if (auto enough = requireMemory(stored.path, stored.sizeKey, largest); !enough)
        return tl::unexpected(enough.error());
    return std::optional<ChosenReduction>();
}

Result<std::vector<VoxelBytes>> readPhases(const StoredVolume& stored, StoredBytes& source, const ByteCounts& counts,
                                           const Progress& progress) {
    if (stored.phasesFastest) {
        VoxelBytes all(static_cast<std::size_t>(counts.all));
        if (const auto read = source.read(all, progress, 0.0, 0.8); !read) return tl::unexpected(read.error());
        return splitPhases(all, static_cast<std::size_t>(stored.phases),
                           static_cast<std::size_t>(bytesOf(stored.type) * stored.channels));
    }
    std::vector<VoxelBytes> phases;
    for (std::int64_t phase = 0; phase < stored.phases; ++phase) {
        VoxelBytes bytes(static_cast<std::size_t>(counts.phase));
        const double share = 0.8 / static_cast<double>(stored.phases);
        const auto read =
            source.read(bytes, progress, share * static_cast<double>(phase), share * static_cast<double>(phase + 1));
        if (!read) return tl::unexpected(read.error());
        phases.push_back(std::move(bytes));
    }
    return phases;
}

void addStorageFacts(const StoredVolume& stored, StudyParts& parts) {
    if (bytesOf(stored.type) > 1 && stored.extent.encoding != VoxelEncoding::text)
        parts.facts.push_back({"byte order", stored.bigEndian ? "big endian" : "little endian",
                               stored.byteOrderKey.empty() ? "assumed" : stored.byteOrderKey});
    parts.facts.push_back({"compression", std::string(compressionWords(stored.extent.encoding)), stored.encodingKey});
    if (stored.data.size() > 1)
        parts.facts.push_back({"data files", std::to_string(stored.data.size()), "the header's names of data files"});
    if (stored.rescale)
        parts.facts.push_back(
            {"rescale",
             fmt::format("value = {:.9g} x stored {} {:.9g}", stored.rescale->slope,
                         stored.rescale->intercept < 0 ? "-" : "+", std::abs(stored.rescale->intercept)),
             stored.rescaleSource});
    if (stored.channels == 3) {
        parts.facts.push_back({"colour", "reduced to luma", "3 channels"});
        parts.warnings.emplace_back("The voxels are in colour; they were reduced to luma.");
    }
}

/// Turns stored voxels into one value each, in this machine's byte order.
void toValues(const StoredVolume& stored, std::vector<VoxelBytes>& phases) {
    for (auto& bytes : phases) {
        toMachineByteOrder(bytes, stored.type, stored.bigEndian);
        if (stored.channels == 3) reduceToLuma(bytes, stored.type);
    }
}

/// Makes the study of voxels that are one value each, one vector for each phase. `chosen` says how they were reduced.
Result<Study> studyOf(const StoredVolume& stored, std::vector<VoxelBytes> phases,
                      const std::optional<ChosenReduction>& chosen, const std::vector<std::string>& warnings,
                      const ReadOptions& options, const Progress& progress) {
    if (const auto problem = problemOfFloats(phases, stored.type, stored.rescale.value_or(Rescale{})))
        return fail(FailureKind::unreadable, stored.path, stored.rescale ? stored.rescaleSource : stored.typeKey,
                    *problem, "Correct the values or their scale, and save the volume as float32.");

    StudyParts parts;
    parts.path = stored.path;
    parts.facts = stored.facts;
    parts.files = {stored.path};
    for (const DataFile& file : stored.data)
        if (file.path != stored.path) parts.files.push_back(file.path);
    if (!stored.layoutPath.empty()) parts.files.push_back(stored.layoutPath);
    parts.geometry = chosen ? reducedGeometry(stored.geometry, chosen->reduction) : stored.geometry;
    parts.reduction = chosen;
    if (const auto axis = axisToTurn(stored)) {
        turnRound(phases, parts.geometry.size, static_cast<std::size_t>(bytesOf(stored.type)), *axis);
        parts.geometry = turnedRound(parts.geometry, *axis);
        if (parts.reduction) parts.reduction->reduction = turnedRound(parts.reduction->reduction, *axis);
        parts.turnedAxis = axis;
        parts.facts.push_back({"handedness", handednessInWords(*axis), "determinant of the axes' directions"});
    }
    parts.spacingSource = stored.spacingSource;
    parts.inPlaneSpacingKnown = stored.inPlaneSpacingKnown;
    parts.sliceAxis = stored.sliceAxis;
    parts.sizeSource = stored.sizeKey;
    parts.typeSource = stored.typeKey;
    parts.whiteLevel = stored.whiteLevel;
    parts.whiteLevelSource = stored.whiteLevelSource;
    parts.blackLevel = stored.blackLevel;
    parts.blackLevelSource = stored.blackLevelSource;
    parts.lowestLevel = stored.lowestLevel;
    parts.window = stored.window;
    parts.phaseTimes = stored.phaseTimes;
    parts.phaseSource = stored.phaseSource;
    parts.warnings = stored.warnings;
    parts.warnings.insert(parts.warnings.end(), warnings.begin(), warnings.end());
    addStorageFacts(stored, parts);
    keepVoxels(parts, std::move(phases), stored.type, stored.rescale, options);
    if (stored.polar)
        if (auto converted = scanConvert(parts, *stored.polar, stored.polarSources, options, progress); !converted)
            return tl::unexpected(converted.error());
    return assembleStudy(std::move(parts), options, progress);
}

/// Hands over the coarse volume, if it can be read soon. Problems of the volume are left to the full reading.
void offerCoarse(const StoredVolume& stored, StoredBytes& source, const std::optional<ChosenReduction>& chosen,
                 const ReadOptions& options, const Progress& progress) {
    if (!progress.coarse) return;
    const auto axis = axisToTurn(stored);
    StoredVolume coarse = stored;
    if (axis) coarse.geometry = turnedRound(stored.geometry, *axis);
    const auto grid = coarseGridOf(coarse);
    if (!grid) return;
    const CoarseGrid inFile = axis ? asStored(*grid, stored.geometry, *axis) : *grid;
    auto bytes = readCoarseBytes(stored, source, inFile, progress);
    if (!bytes) return;
    coarse.geometry = inFile.geometry;
    coarse.phases = 1;
    std::vector<VoxelBytes> phases;
    phases.push_back(std::move(*bytes));
    toValues(coarse, phases);
    const auto study = studyOf(coarse, std::move(phases), {}, {}, options, Progress{{}, progress.cancel});
    if (!study) return;
    CoarseVolume volume = coarseVolumeOf(*grid, *study->phases.front());
    // Opacities will be given per unit of the reduced volume.
    if (chosen)
        volume.units = std::max(
            1.0, volume.units * stored.geometry.unit() / reducedGeometry(stored.geometry, chosen->reduction).unit());
    progress.coarse(volume);
}

}  // namespace

Result<Study> readStoredVolume(const StoredVolume& stored, const ReadOptions& options, const Progress& progress) {
    const auto counts = countBytes(stored);
    if (!counts) return tl::unexpected(counts.error());
    StoredBytes source(stored, *counts);
    if (auto checked = source.check(progress); !checked) return tl::unexpected(checked.error());
    auto chosen = reductionOf(stored, *counts, options);
    if (!chosen) return tl::unexpected(chosen.error());
    // The blocks of a grid that is turned round afterwards are those of the turned grid.
    if (const auto axis = axisToTurn(stored); axis && *chosen)
        (*chosen)->reduction = turnedRound((*chosen)->reduction, *axis);
    offerCoarse(stored, source, *chosen, options, progress);
    auto phases = *chosen ? readReducedPhases(stored, source, (*chosen)->reduction, progress)
                          : readPhases(stored, source, *counts, progress);
    if (!phases) return tl::unexpected(phases.error());
    if (!*chosen) toValues(stored, *phases);
    return studyOf(stored, std::move(*phases), *chosen, source.warnings(), options, progress);
}

}  // namespace echolucent
