#include <new>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "io/dicom/dicom_reader.h"
#include "io/document/curve_file.h"
#include "io/document/preset_file.h"
#include "io/file_formats.h"
#include "io/files/archives.h"
#include "io/files/data_files.h"
#include "io/files/file_access.h"
#include "io/files/input_problems.h"
#include "io/headers/raw_volume.h"
#include "io/nifti/nifti_header.h"
#include "io/nifti/nifti_reader.h"
#include "io/stored/stored_volume_reader.h"
#include "io/study/study.h"
#include "io/study/study_assembly.h"
#include "io/voxels/gzip_file.h"
#include "io/wrapped_voxels.h"

namespace echolucent {

namespace {

/// Whether a file ends within the first bytes of a gzip file.
bool isCutGzip(std::string_view beginning) {
    return !beginning.empty() && beginning.size() < gzipSignature.size() && gzipSignature.starts_with(beginning);
}

/// A sentence for files that end within the first bytes of a known format; no value for all others.
std::optional<Failure> cutWithinItsBeginning(const std::string& path, std::string_view beginning) {
    std::string_view cut = isCutGzip(beginning) ? "a gzip file" : "";
    for (const FileFormat& format : fileFormats())
        if (cut.empty() && format.mayBeCutAt(beginning)) cut = format.oneOfThem;
    if (cut.empty()) return std::nullopt;
    return fail(FailureKind::unreadable, path, "",
                fmt::format("ends after {} bytes, within the beginning of {}", beginning.size(), cut), incompleteFile)
        .value();
}

/// A sentence for files of formats that are known but not read; no value for all others.
std::optional<Failure> knownButNotRead(const std::string& path, std::string_view beginning) {
    const auto refuse = [&](std::string_view problem, const char* remedy) {
        return fail(FailureKind::unreadable, path, "", std::string(problem), remedy).value();
    };
    if (const std::string_view archive = archiveInWords(beginning); !archive.empty())
        return refuse(archive, "Unpack it and open what comes out.");
    if (looksLikeAnalyze(beginning))
        return refuse("is an Analyze 7.5 header, which does not say where left and right are", "Convert it to NIfTI.");
    const auto text = beginning.find_first_not_of(" \t\r\n");
    if (text == std::string_view::npos || beginning[text] != '{') return std::nullopt;
    if (beginning.find(curveFormatName) != std::string_view::npos) {
        Failure curve = refuse("is an opacity curve, not a volume", "Open a volume, and then this file as its curve.");
        curve.opacityCurve = true;
        return curve;
    }
    if (beginning.find(presetsFormatName) != std::string_view::npos) {
        Failure presets = refuse("holds presets, not a volume", "Open a volume, and import this file as presets.");
        presets.presets = true;
        return presets;
    }
    return std::nullopt;
}

struct KnownLayout {
    RawLayout layout;
    std::string source;  ///< "--raw-size", or the name of the layout's file
    std::string path;    ///< the layout's file; empty if a person gave the layout
};

/// The layout that a person gave, or the one beside the file. If the file is packed, the layout beside its unpacked
/// name counts too. No value if there is none.
Result<std::optional<KnownLayout>> knownLayout(const std::string& path, const ReadOptions& options) {
    if (options.raw) return std::optional(KnownLayout{*options.raw, "--raw-size", ""});
    for (const std::string& described : {path, withoutGzipEnding(path)}) {
        const auto recalled = recalledRawLayout(described);
        if (!recalled) return tl::unexpected(recalled.error());
        const std::string kept = rawLayoutPath(described);
        if (*recalled) return std::optional(KnownLayout{**recalled, nameFromPath(kept), kept});
    }
    return std::optional<KnownLayout>();
}

/// The bytes of a file that was packed as a whole; 0 if it was not.
struct Packing {
    std::uint64_t packedBytes = 0, unpackedBytes = 0;
};

Result<Study> readStored(Result<StoredVolume> stored, const Packing& packing, const ReadOptions& options,
                         const Progress& progress) {
    if (!stored) return tl::unexpected(stored.error());
    stored->packedBytes += packing.packedBytes;
    stored->unpackedBytes += packing.unpackedBytes;
    if (auto settled = settleBeginnings(*stored, progress); !settled) return tl::unexpected(settled.error());
    return readStoredVolume(*stored, options, progress);
}

Result<Study> readUnknown(const InputFile& file, std::string_view beginning, const Packing& packing,
                          const ReadOptions& options, const Progress& progress) {
    const std::string& path = file.path();
    const auto known = knownLayout(path, options);
    if (!known) return tl::unexpected(known.error());
    if (!*known) {
        if (auto refused = cutWithinItsBeginning(path, beginning)) return tl::unexpected(*refused);
        if (auto refused = knownButNotRead(path, beginning)) return tl::unexpected(*refused);
        auto unknown = fail(FailureKind::unreadable, path, "",
                            beginning.empty() ? "is empty" : "is no " + namesOfFormats() + " file",
                            "If it is a raw volume without a header, describe it with --raw-size XxYxZ, --raw-type, "
                            "--raw-byte-order, --raw-header-bytes and --raw-spacing, or, where it holds beams, with "
                            "--raw-polar, --raw-range, --raw-lines and --raw-planes instead of the spacing.");
        unknown.value().layoutUnknown = !beginning.empty();
        return unknown;
    }
    auto stored = storedVolumeFromLayout(file, (*known)->layout, (*known)->source);
    if (!stored) return tl::unexpected(stored.error());
    stored->layoutPath = (*known)->path;
    return readStored(std::move(stored), packing, options, progress);
}

/// Reads a file. If its voxels are packed in a separate file, unpacking them is half of the progress.
Result<Study> readAs(const FileFormat& format, const InputFile& file, const Packing& packing,
                     const ReadOptions& options, const Progress& progress) {
    if (const auto* readStudy = std::get_if<FileFormat::StudyReader>(&format.reader))
        return (*readStudy)(file, options, progress);
    double reached = 0;
    auto stored = std::get<FileFormat::HeaderReader>(format.reader)(
        file, options.framesAsSlices, {[&](double share) { progress.at(reached = 0.5 * share); }, progress.cancel});
    return readStored(
        std::move(stored), packing, options,
        {[&](double share) { progress.at(reached + (1 - reached) * share); }, progress.cancel, progress.coarse});
}

/// Reads an opened file. A file that was packed as a whole is unpacked already.
Result<Study> readOpened(const InputFile& file, const Packing& packing, const ReadOptions& options,
                         const Progress& progress) {
    const auto beginning = file.beginning(4096);
    if (!beginning) return tl::unexpected(beginning.error());
    const FileFormat* format = formatFromContent(*beginning);
    if (format == nullptr && !isCutGzip(*beginning) && !knownButNotRead(file.path(), *beginning))
        format = formatFromName(withoutGzipEnding(file.path()));
    if (format != nullptr) return readAs(*format, file, packing, options, progress);
    return readUnknown(file, *beginning, packing, options, progress);
}

/// Whether to unpack a file. One that begins like gzip is unpacked if its name says so, or if no layout describes it:
/// raw voxels may begin like gzip by chance.
Result<bool> isPacked(const InputFile& file, const ReadOptions& options) {
    const auto beginning = file.beginning(3);
    if (!beginning) return tl::unexpected(beginning.error());
    if (!looksLikeGzip(*beginning)) return false;
    if (withoutGzipEnding(file.path()) != file.path()) return true;
    const auto layout = knownLayout(file.path(), options);
    if (!layout) return tl::unexpected(layout.error());
    return !layout->has_value();
}

/// Reads a packed file. Unpacking is half of the progress.
Result<Study> readPacked(const InputFile& packed, const ReadOptions& options, const Progress& progress) {
    const auto unpacked = unpackGzip(packed, {[&](double share) { progress.at(0.5 * share); }, progress.cancel});
    if (!unpacked) return tl::unexpected(unpacked.error());
    const auto beginning = unpacked->beginning(3);
    if (beginning && looksLikeGzip(*beginning))
        return fail(FailureKind::unreadable, packed.path(), "", "is compressed with gzip twice",
                    "Unpack it with gunzip and open what comes out.");
    auto study = readOpened(*unpacked, {packed.size(), unpacked->size()}, options,
                            {[&](double share) { progress.at(0.5 + 0.5 * share); }, progress.cancel, progress.coarse});
    if (study)
        study->facts.push_back(
            {"file", fmt::format("gzip, {} bytes unpacked to {}", packed.size(), unpacked->size()), "its beginning"});
    return study;
}

/// The header of a NIfTI or Analyze pair whose voxels were named. No value if a layout describes the file, if its
/// content is known, or if no such header lies beside it.
Result<std::optional<InputFile>> headerOfPair(const InputFile& voxels, const ReadOptions& options,
                                              const Progress& progress) {
    const auto beside = niftiHeaderBeside(voxels.path());
    if (!beside) return std::optional<InputFile>();
    const auto layout = knownLayout(voxels.path(), options);
    if (!layout) return tl::unexpected(layout.error());
    const auto own = voxels.beginning(4096);
    if (!own) return tl::unexpected(own.error());
    if (layout->has_value() || formatFromContent(*own) != nullptr) return std::optional<InputFile>();
    // A link may lead anywhere, so read only in the folder that was named.
    if (auto inside = requireInItsFolder(*beside); !inside) return tl::unexpected(inside.error());
    auto header = InputFile::open(*beside);
    if (!header) return tl::unexpected(header.error());
    auto beginning = header->beginning(niftiHeaderBytes);
    if (beginning && looksLikeGzip(*beginning)) {
        const auto unpacked = unpackGzip(*header, {nullptr, progress.cancel});
        if (!unpacked) return tl::unexpected(unpacked.error());
        beginning = unpacked->beginning(niftiHeaderBytes);
    }
    if (!beginning) return tl::unexpected(beginning.error());
    if (!looksLikeNifti(*beginning) && !looksLikeAnalyze(*beginning) && !beginsLikeNifti(*beginning))
        return std::optional<InputFile>();
    return std::optional(std::move(*header));
}

Result<Study> readFile(const std::string& path, const ReadOptions& options, const Progress& progress) {
    auto file = InputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    // A person may name the voxels of a pair instead of its header.
    auto header = headerOfPair(*file, options, progress);
    if (!header) return tl::unexpected(header.error());
    if (*header) file = std::move(**header);
    const auto packed = isPacked(*file, options);
    if (!packed) return tl::unexpected(packed.error());
    return *packed ? readPacked(*file, options, progress) : readOpened(*file, {}, options, progress);
}

}  // namespace

Result<Study> readStudy(const std::string& path, const ReadOptions& options, const Progress& progress) {
    try {
        if (path.empty()) return fail(FailureKind::wrongUsage, "", "", "no file was named", "Name a volume.");
        const FileKind kind = fileAccess().kindOf(path);
        if (kind == FileKind::missing)
            return fail(FailureKind::unreadable, path, "", "does not exist", "Check the name.");
        if (kind == FileKind::forbidden)
            return fail(FailureKind::unreadable, path, "", "lies in a folder that you may not look into",
                        "Ask for permission to read it, or copy it to a folder of your own.");
        if (kind == FileKind::unreachable)
            return fail(FailureKind::unreadable, path, "", "could not be read: its disc or the connection to it failed",
                        "Connect it again, and then open it.");
        if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
        return kind == FileKind::folder ? readDicomFolder(path, options, progress) : readFile(path, options, progress);
    } catch (const std::bad_alloc&) {
        return fail(FailureKind::unreadable, path, "", "needs more memory than there is",
                    "Close other programs, or open it on a larger machine.");
    } catch (const std::length_error&) {
        return fail(FailureKind::unreadable, path, "", "needs more memory than there is",
                    "Close other programs, or open it on a larger machine.");
    }
}

}  // namespace echolucent
