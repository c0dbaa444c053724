#include "io/file_formats.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "io/dicom/dicom_reader.h"
#include "io/dicom/elements/dicom_scan.h"
#include "io/headers/meta_image.h"
#include "io/headers/nrrd.h"
#include "io/kretz/kretz_items.h"
#include "io/kretz/kretz_reader.h"
#include "io/nifti/nifti_header.h"
#include "io/nifti/nifti_reader.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

/// Whether bytes are the beginning of a signature, but not all of it.
bool isPartOf(std::string_view signature, std::string_view bytes) {
    return !bytes.empty() && bytes.size() < signature.size() && signature.starts_with(bytes);
}

const std::vector<FileFormat>& formats() {
    static const std::vector<FileFormat> rows{
        {.name = "MetaImage",
         .oneOfThem = "a MetaImage",
         .endings = {".mha", ".mhd"},
         .otherNames = {},
         .isBegunBy = looksLikeMetaImage,
         .mayBeCutAt = [](std::string_view whole) { return isPartOf("ObjectType", whole); },
         .reader = [](const InputFile& file, bool framesAsSlices,
                      const Progress&) { return readMetaImageHeader(file, framesAsSlices); },
         .mimeType = "application/x-metaimage",
         .definesMimeType = true,
         .mimeMagic = ""},
        {.name = "NRRD",
         .oneOfThem = "an NRRD file",
         .endings = {".nrrd", ".nhdr"},
         .otherNames = {},
         .isBegunBy = looksLikeNrrd,
         .mayBeCutAt = [](std::string_view whole) { return isPartOf(nrrdSignature, whole); },
         .reader = [](const InputFile& file, bool framesAsSlices,
                      const Progress&) { return readNrrdHeader(file, framesAsSlices); },
         .mimeType = "application/x-nrrd",
         .definesMimeType = true,
         .mimeMagic = nrrdSignature},
        {.name = "NIfTI",
         .oneOfThem = "a NIfTI header",
         .endings = {".nii"},
         .otherNames = {"*.hdr", "*.img"},
         .isBegunBy = looksLikeNifti,
         .mayBeCutAt = beginsLikeNifti,
         .reader = readNiftiHeader,
         .mimeType = "",
         .mimeMagic = ""},
        {.name = "DICOM",
         .oneOfThem = "a DICOM file",
         .endings = {dicomEndings.begin(), dicomEndings.end()},
         .otherNames = {"DICOMDIR*"},
         .isBegunBy = looksLikeDicom,
         .mayBeCutAt = [](std::string_view) { return false; },
         .reader = readDicom,
         .needsDicomTables = true,
         .mimeType = "application/dicom",
         .mimeMagic = ""},
        {.name = "GE Voluson (Kretz)",
         .oneOfThem = "a GE Voluson volume (Kretz)",
         .endings = {},
         .otherNames = {"*.vol", "*.v0?"},
         .isBegunBy = looksLikeKretz,
         .mayBeCutAt = [](std::string_view whole) { return isPartOf(kretzSignature, whole); },
         .reader = [](const InputFile& file, const ReadOptions& options,
                      const Progress& progress) { return readKretz(kretzSource(file), options, progress); },
         .mimeType = "",
         .mimeMagic = ""},
    };
    return rows;
}

}  // namespace

std::span<const FileFormat> fileFormats() { return formats(); }

const FileFormat* formatFromContent(std::string_view beginning) {
    const auto found =
        std::ranges::find_if(formats(), [&](const FileFormat& format) { return format.isBegunBy(beginning); });
    return found == formats().end() ? nullptr : &*found;
}

const FileFormat* formatFromName(const std::string& path) {
    const std::string ending = lowerCase(std::filesystem::path(path).extension().string());
    const auto found = std::ranges::find_if(formats(), [&](const FileFormat& format) {
        return std::ranges::find(format.endings, ending) != format.endings.end();
    });
    return found == formats().end() ? nullptr : &*found;
}

std::string namesOfFormats() {
    std::string names;
    const std::span<const FileFormat> all = fileFormats();
    for (const FileFormat& format : all) {
        if (!names.empty()) names += &format == &all.back() ? " or " : ", ";
        names += format.name;
    }
    return names;
}

std::string namesAndEndingsOfFormats() {
    std::string formats;
    for (const FileFormat& format : fileFormats()) {
        std::string names;
        for (const auto* patterns : {&format.endings, &format.otherNames})
            for (const std::string_view pattern : *patterns)
                names += (names.empty() ? "" : ", ") + std::string(pattern.substr(pattern.starts_with('*') ? 1 : 0));
        formats += fmt::format("{}{} ({})", formats.empty() ? "" : ", ", format.name, names);
    }
    return formats;
}

std::string namesOfVolumes() {
    std::string patterns;
    for (const FileFormat& format : fileFormats()) {
        for (const std::string_view ending : format.endings) patterns += '*' + std::string(ending) + ' ';
        for (const std::string_view name : format.otherNames) patterns += std::string(name) + ' ';
    }
    return patterns + "*.raw *.gz";
}

}  // namespace echolucent
