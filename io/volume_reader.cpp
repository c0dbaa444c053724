#include <filesystem>
#include <new>
#include <stdexcept>

#include "io/curve_file.h"
#include "io/dicom/dicom_reader.h"
#include "io/document/preset_file.h"
#include "io/headers/header_text.h"
#include "io/headers/meta_image.h"
#include "io/headers/nrrd.h"
#include "io/headers/raw_volume.h"
#include "io/study.h"
#include "io/study_assembly.h"

namespace echolucent {

namespace {

enum class Format { metaImage, nrrd, dicom, unknown };

Format formatFromContent(std::string_view beginning) {
    if (looksLikeNrrd(beginning)) return Format::nrrd;
    if (looksLikeDicom(beginning)) return Format::dicom;
    if (looksLikeMetaImage(beginning)) return Format::metaImage;
    return Format::unknown;
}

Format formatFromName(const std::string& path) {
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    if (extension == ".mha" || extension == ".mhd") return Format::metaImage;
    if (extension == ".nrrd" || extension == ".nhdr") return Format::nrrd;
    if (extension == ".dcm" || extension == ".dicom" || extension == ".ima") return Format::dicom;
    return Format::unknown;
}

/// A sentence for files of formats that are known but not read; no value for all others.
std::optional<Failure> knownButNotRead(const std::string& path, std::string_view beginning) {
    const auto refuse = [&](const char* problem, const char* remedy) {
        return fail(FailureKind::unreadable, path, "", problem, remedy).value();
    };
    if (beginning.starts_with("\x1f\x8b"))
        return refuse("is compressed with gzip as a whole", "Unpack it with gunzip and open what comes out.");
    if (beginning.starts_with("PK\x03\x04")) return refuse("is a ZIP archive", "Unpack it and open what comes out.");
    if (beginning.starts_with("KRETZFILE"))
        return refuse("is a GE Voluson volume (Kretz), which cannot be read yet",
                      "Export it as a Cartesian volume: MetaImage, NRRD or DICOM slices.");
    if (beginning.size() >= 348 && (beginning.substr(344, 3) == "n+1" || beginning.substr(344, 3) == "ni1"))
        return refuse("is a NIfTI volume, which cannot be read yet", "Convert it to MetaImage or NRRD.");
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

Result<Study> readUnknown(const InputFile& file, std::string_view beginning, const ReadOptions& options,
                          const Progress& progress) {
    const std::string& path = file.path();
    auto layout = options.raw;
    std::string source = "--raw-size";
    if (!layout) {
        const auto recalled = recalledRawLayout(path);
        if (!recalled) return tl::unexpected(recalled.error());
        layout = *recalled;
        source = nameFromPath(rawLayoutPath(path));
    }
    if (!layout) {
        if (auto refused = knownButNotRead(path, beginning)) return tl::unexpected(*refused);
        auto unknown = fail(FailureKind::unreadable, path, "",
                            beginning.empty() ? "is empty" : "is not a MetaImage, NRRD or DICOM file",
                            "If it is a raw volume without a header, describe it with --raw-size XxYxZ, --raw-type, "
                            "--raw-byte-order, --raw-header-bytes and --raw-spacing.");
        unknown.value().layoutUnknown = !beginning.empty();
        return unknown;
    }
    auto stored = storedVolumeFromLayout(file, *layout, source);
    if (!stored) return tl::unexpected(stored.error());
    if (!options.raw) stored->layoutPath = rawLayoutPath(path);
    return readStoredVolume(std::move(*stored), options, progress);
}

Result<Study> readFile(const std::string& path, const ReadOptions& options, const Progress& progress) {
    const auto file = InputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    const auto beginning = file->beginning(4096);
    if (!beginning) return tl::unexpected(beginning.error());
    Format format = formatFromContent(*beginning);
    if (format == Format::unknown && !knownButNotRead(path, *beginning)) format = formatFromName(path);
    switch (format) {
        case Format::metaImage: {
            auto stored = readMetaImageHeader(*file, options.framesAsSlices);
            if (!stored) return tl::unexpected(stored.error());
            return readStoredVolume(std::move(*stored), options, progress);
        }
        case Format::nrrd: {
            auto stored = readNrrdHeader(*file, options.framesAsSlices);
            if (!stored) return tl::unexpected(stored.error());
            return readStoredVolume(std::move(*stored), options, progress);
        }
        case Format::dicom: return readDicom(*file, options, progress);
        case Format::unknown: break;
    }
    return readUnknown(*file, *beginning, options, progress);
}

}  // namespace

Result<Study> readStudy(const std::string& path, const ReadOptions& options, const Progress& progress) {
    try {
        std::error_code error;
        if (path.empty()) return fail(FailureKind::wrongUsage, "", "", "no file was named", "Name a volume.");
        if (!std::filesystem::exists(path, error))
            return fail(FailureKind::unreadable, path, "", "does not exist", "Check the name.");
        if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
        return std::filesystem::is_directory(path, error) ? readDicomFolder(path, options, progress)
                                                          : readFile(path, options, progress);
    } catch (const std::bad_alloc&) {
        return fail(FailureKind::unreadable, path, "", "needs more memory than there is",
                    "Close other programs, or open it on a larger machine.");
    } catch (const std::length_error&) {
        return fail(FailureKind::unreadable, path, "", "needs more memory than there is",
                    "Close other programs, or open it on a larger machine.");
    }
}

}  // namespace echolucent
