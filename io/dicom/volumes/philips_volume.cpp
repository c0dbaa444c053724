#include "io/dicom/volumes/philips_volume.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/pixels/dicom_pixels.h"
#include "io/dicom/pixels/pixel_statements.h"
#include "io/files/input_problems.h"
#include "io/study/study_assembly.h"
#include "io/study/value_window.h"

namespace echolucent {

namespace {

struct PhilipsVoxels {
    std::vector<VoxelBytes> phases;
    StoredType type = StoredType::uint8;
    std::int64_t missing = 0;  ///< voxels that the file lacks at the end of the last phase
};

Result<void> readBytes(const InputFile& input, std::uint64_t offset, std::span<std::uint8_t> bytes,
                       const Progress& progress) {
    constexpr std::size_t pieceBytes = std::size_t{4} << 20;
    for (std::size_t done = 0; done < bytes.size(); done += pieceBytes) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, input.path(), "", "was not read: cancelled");
        const auto piece = bytes.subspan(done, std::min(pieceBytes, bytes.size() - done));
        if (auto read = input.readAt(offset + done, piece); !read) return read;
    }
    return {};
}

Result<PhilipsVoxels> qlabVoxels(const InputFile& input, const DicomFile& file, const PhilipsVolume& volume,
                                 std::vector<std::string>& warnings, const Progress& progress) {
    const DicomScan& scan = file.scan();
    const std::int64_t declared = volume.phases;
    // philipsVolumeOf() checked that the file holds one volume, except perhaps the end of its last row.
    const std::int64_t one = volume.voxelCount();
    // The declared length is often false, so measure what the file holds.
    const auto held = static_cast<std::int64_t>(input.size() - std::min(scan.pixelStart, input.size()));
    const std::int64_t whole = held / one;
    const std::int64_t rest = held % one;
    // If only the end of the last row is cut off, the phase still counts.
    const bool almost = whole < declared && one - rest < volume.size[0];
    PhilipsVoxels voxels;
    const std::int64_t phases = std::min(declared, whole + (almost ? 1 : 0));
    voxels.missing = std::max<std::int64_t>(0, phases * one - held);
    if (auto memory = requireMemory(input.path(), volume.sizeSource, static_cast<std::uint64_t>(phases * one)); !memory)
        return tl::unexpected(memory.error());
    for (std::int64_t phase = 0; phase < phases; ++phase) {
        VoxelBytes bytes(static_cast<std::size_t>(one));
        const auto there = static_cast<std::size_t>(std::min(one, held - phase * one));
        const auto read = readBytes(input, scan.pixelStart + static_cast<std::uint64_t>(phase * one),
                                    std::span(bytes).first(there), progress);
        if (!read) return tl::unexpected(read.error());
        progress.at(0.9 * static_cast<double>(phase + 1) / static_cast<double>(phases));
        voxels.phases.push_back(std::move(bytes));
    }
    if (phases < declared)
        warnings.push_back(
            fmt::format("The file declares {} volumes and holds {}, which were read.", declared, phases));
    if (voxels.missing > 0)
        warnings.push_back(
            fmt::format("The last volume ends {} bytes early; the voxels there are no data.", voxels.missing));
    if (static_cast<std::int64_t>(scan.pixelBytesDeclared) != held)
        warnings.push_back(
            fmt::format("(7fe0,0010) Pixel Data declares {} bytes, the file holds {}.", scan.pixelBytesDeclared, held));
    return voxels;
}

Result<PhilipsVoxels> framesVoxels(const DicomFile& file, const PhilipsVolume& volume, StudyParts& parts,
                                   const Progress& progress) {
    auto frames = DicomFrames::open(file.dataset(), file.path(), file.scan());
    if (!frames) return tl::unexpected(frames.error());
    const auto bytes = checkedProduct(frames->frameBytes(), frames->frames());
    const auto memory =
        requireMemory(file.path(), volume.sizeSource, bytes ? static_cast<std::uint64_t>(*bytes) : ~std::uint64_t{0});
    if (!memory) return tl::unexpected(memory.error());
    if (const auto checked = frames->check(progress); !checked) return tl::unexpected(checked.error());
    PhilipsVoxels voxels;
    voxels.type = frames->type();
    const auto frameBytes = static_cast<std::size_t>(frames->frameBytes());
    const auto phaseBytes = frameBytes * static_cast<std::size_t>(volume.size[2]);
    for (std::int64_t index = 0; index < frames->frames(); ++index) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, file.path(), "", "was not read: cancelled");
        progress.at(0.9 * static_cast<double>(index) / static_cast<double>(frames->frames()));
        const auto slice = static_cast<std::size_t>(index % volume.size[2]);
        if (slice == 0) voxels.phases.emplace_back(phaseBytes);
        const auto out = std::span(voxels.phases.back()).subspan(slice * frameBytes, frameBytes);
        if (const auto read = frames->readGrey(index, out); !read) return tl::unexpected(read.error());
    }
    frames->sayWhite(parts);
    for (auto&& fact : frames->facts()) parts.facts.push_back(std::move(fact));
    for (auto&& warning : frames->warnings()) parts.warnings.push_back(std::move(warning));
    return voxels;
}

Result<PhilipsVoxels> privateVoxels(const DicomFile& file, const PhilipsVolume& volume) {
    DcmElement* element = nullptr;
    Uint8* bytes = nullptr;
    const DcmTagKey key(volume.voxels.group, volume.voxels.element);
    const auto count = static_cast<std::size_t>(volume.voxelCount());
    if (file.dataset().findAndGetElement(key, element).bad() || element->getUint8Array(bytes).bad() ||
        bytes == nullptr || element->getLength() < count)
        return fail(FailureKind::unreadable, file.path(), tagText(volume.voxels), "could not be read", copyAgain);
    PhilipsVoxels voxels;
    voxels.phases.emplace_back(bytes, bytes + count);
    return voxels;
}

/// Marks missing voxels as no data, unless a guess is wanted. Missing voxels hold 0, which the guess takes for outside
/// the scan. A mask would stop the guess.
void markMissing(const PhilipsVoxels& voxels, const ReadOptions& options, StudyParts& parts) {
    if (voxels.missing == 0 || options.guessNoData) return;
    std::vector<std::uint8_t> mask(voxels.phases.front().size(), std::uint8_t{1});
    std::fill(mask.end() - static_cast<std::ptrdiff_t>(voxels.missing), mask.end(), std::uint8_t{0});
    parts.dataMask = std::make_shared<const DataMask>(std::move(mask));
    parts.dataMaskSource = "the end of the file";
}

}  // namespace

Result<GreySlice> readPhilipsSlice(const InputFile& input, const DicomFile& file, const PhilipsVolume& volume,
                                   std::int64_t index, const Progress& progress) {
    GreySlice slice{volume.size[0], volume.size[1], StoredType::uint8, {}};
    if (volume.kind == PhilipsVolume::Kind::frames) {
        auto frames = DicomFrames::open(file.dataset(), file.path(), file.scan());
        if (!frames) return tl::unexpected(frames.error());
        slice.type = frames->type();
        slice.bytes.resize(static_cast<std::size_t>(frames->frameBytes()));
        if (const auto read = frames->readGrey(index, slice.bytes); !read) return tl::unexpected(read.error());
        return slice;
    }
    const auto pixels = static_cast<std::uint64_t>(volume.size[0] * volume.size[1]);
    const std::uint64_t start = static_cast<std::uint64_t>(index) * pixels;
    slice.bytes.resize(static_cast<std::size_t>(pixels));
    if (volume.kind == PhilipsVolume::Kind::qlab) {
        // The end of the last row may be missing; it stays 0.
        const std::uint64_t offset = file.scan().pixelStart + start;
        const std::uint64_t held = input.size() - std::min(input.size(), offset);
        const auto there = std::span(slice.bytes).first(static_cast<std::size_t>(std::min(held, pixels)));
        const auto read = readBytes(input, offset, there, progress);
        return read ? Result<GreySlice>(std::move(slice)) : tl::unexpected(read.error());
    }
    DcmElement* element = nullptr;
    const DcmTagKey key(volume.voxels.group, volume.voxels.element);
    if (file.dataset().findAndGetElement(key, element).bad() ||
        element
            ->getPartialValue(slice.bytes.data(), static_cast<Uint32>(start), static_cast<Uint32>(pixels), nullptr,
                              EBO_LittleEndian)
            .bad())
        return fail(FailureKind::unreadable, file.path(), tagText(volume.voxels), "could not be read", copyAgain);
    return slice;
}

Result<Study> readPhilipsVolume(const InputFile& input, const DicomFile& file, const PhilipsVolume& volume,
                                const ReadOptions& options, const Progress& progress) {
    StudyParts parts;
    parts.path = file.path();
    parts.files = {file.path()};
    const bool qlab = volume.kind == PhilipsVolume::Kind::qlab;
    parts.facts = {{"format",
                    qlab ? "DICOM, Philips QLAB Cartesian volume" : "DICOM, private volume of a Philips scanner",
                    volume.sizeSource}};
    auto voxels = qlab ? qlabVoxels(input, file, volume, parts.warnings, progress)
                  : volume.kind == PhilipsVolume::Kind::frames ? framesVoxels(file, volume, parts, progress)
                                                               : privateVoxels(file, volume);
    if (!voxels) return tl::unexpected(voxels.error());
    parts.geometry.size = volume.size;
    parts.geometry.spacingKnown = volume.spacing && !volume.spacingSource.empty();
    parts.geometry.spacing = volume.spacing.value_or(Vec3(1, 1, 1));
    parts.spacingSource = volume.spacingSource;
    parts.sizeSource = volume.sizeSource;
    parts.typeSource = volume.kind == PhilipsVolume::Kind::privateElement
                           ? "the length of " + tagText(volume.voxels) + " Philips private: one byte a voxel"
                           : "(0028,0100) Bits Allocated, (0028,0103) Pixel Representation";
    if (volume.times) {
        std::vector<double> seconds = volume.times->seconds;
        seconds.resize(std::min(seconds.size(), voxels->phases.size()));  // the file may hold fewer than it declares
        parts.phaseTimes = phaseTimesAt(seconds);
        parts.phaseSource = volume.times->source;
    }
    sayLoss(file.dataset(), parts);
    sayBurnedInText(file.dataset(), true, parts);
    markMissing(*voxels, options, parts);
    keepVoxels(parts, std::move(voxels->phases), voxels->type, std::nullopt, options);
    for (auto&& fact : equipmentFacts(file.dataset())) parts.facts.push_back(std::move(fact));
    if (!volume.warning.empty()) parts.warnings.push_back(volume.warning);
    return assembleStudy(std::move(parts), options, progress);
}

}  // namespace echolucent
