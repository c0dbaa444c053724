#include "io/dicom/series/image_header.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/frames/dicom_geometry.h"
#include "io/dicom/frames/frame_layout.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/dicom/pixels/native_pixels.h"
#include "io/dicom/series/series_description.h"
#include "io/dicom/volumes/philips_volume.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/voxels/gzip_file.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

constexpr DicomTag positionTag{0x0020, 0x0032};
constexpr DicomTag rowsTag{0x0028, 0x0010};
constexpr DicomTag columnsTag{0x0028, 0x0011};

/// Whether the pixels of many frames are wrong, as far as the header and the file's length tell. No value if nothing is
/// wrong. Frames in fragments are refused if the file cannot hold as many.
std::optional<Failure> wrongPixels(const DicomFile& file, const InputFile& input) {
    const auto failure = [&](const PixelFormatProblem& problem) {
        return fail(FailureKind::unreadable, file.path(), problem.element, problem.text, "Export it again.").value();
    };
    DicomPixelFormat format;
    if (const auto problem = readPixelFormat(file.dataset(), format)) return failure(*problem);
    const DicomScan& scan = file.scan();
    if (!DcmXfer(scan.transferSyntax.c_str()).isEncapsulated()) {
        // Deflated pixels are read only if the file is opened.
        const auto problem = wrongPixelBytes(format, scan.pixelBytesHeld, [&](std::uint64_t from, auto bytes) {
            return scan.pixelStart == 0 || input.readAt(scan.pixelStart + from, bytes).has_value();
        });
        return problem ? std::optional(failure(*problem)) : std::nullopt;
    }
    constexpr std::uint64_t itemBytes = 8;  // a frame has at least one fragment
    if (static_cast<std::uint64_t>(format.frames) <= input.size() / itemBytes) return std::nullopt;
    return failure({"(0028,0008) Number of Frames",
                    fmt::format("says {}, more than a file of {} bytes can hold", format.frames, input.size())});
}

/// Why the frames of one file are no volume, as far as the header tells.
std::optional<Failure> whyNoVolume(DcmItem& dataset, const ImageHeader& header, const Progress& progress) {
    const auto count = static_cast<std::size_t>(header.frames);
    const auto layout = layOutFrames(dataset, header.file.path, {count, header.columns, header.rows}, progress);
    return layout ? std::nullopt : std::optional(layout.error());
}

/// Finds out whether the file holds a maker's private volume, and if not, why its frames are no volume. The size of a
/// Philips volume replaces the size of the frames.
void takeVolume(const DicomFile& file, const InputFile& input, ImageHeader& header, const Progress& progress) {
    header.volume = file.scan().holdsKretz;
    if (header.volume) return;
    const auto philips = philipsVolumeOf(file);
    header.volume = philips && *philips;
    const bool inFrames = !header.volume || (*philips)->kind == PhilipsVolume::Kind::frames;
    if (inFrames && header.frames > 1) header.whyNot = wrongPixels(file, input);
    if (header.whyNot) return;
    if (!philips)
        header.whyNot = philips.error();
    else if (!header.volume && header.frames > 1 && !header.part)
        header.whyNot = whyNoVolume(file.dataset(), header, progress);
    if (!header.volume) return;
    header.columns = (*philips)->size[0];
    header.rows = (*philips)->size[1];
    header.frames = (*philips)->size[2];
}

/// Takes the rescaling of a single picture and whether it states padding, as far as both can be read.
void takeValues(DcmItem& dataset, SeriesFile& file) {
    DicomPixelFormat format;
    if (readPixelFormat(dataset, format)) return;
    if (const auto rescales = readRescales(dataset, format)) file.rescale = rescales->of(0);
    file.padded = format.padding.has_value();
}

/// A text for comparing, as programs differ in case and padding ("DOE^JANE^^^").
std::string comparable(DcmItem& dataset, DicomTag tag) {
    std::string text = lowerCase(dicomText(dataset, tag));
    while (!text.empty() && (text.back() == '^' || text.back() == ' ')) text.pop_back();
    return text;
}

PictureTraits traitsOf(DcmItem& dataset) {
    PictureTraits traits;
    traits.patientId = comparable(dataset, {0x0010, 0x0020});
    traits.patientName = comparable(dataset, {0x0010, 0x0010});
    traits.birthDate = comparable(dataset, {0x0010, 0x0030});
    traits.frameOfReference = dicomText(dataset, {0x0020, 0x0052});
    traits.photometric = dicomText(dataset, {0x0028, 0x0004});
    if (const auto scale = pictureScaleOf(dataset)) traits.scale = {scale->spacing[0], scale->spacing[1]};
    return traits;
}

std::string wrongPlaceOf(DcmItem& dataset) {
    constexpr DicomTag orientationTag{0x0020, 0x0037};
    const auto stated = [&](DicomTag tag, const char* name, const char* problem) {
        return fmt::format("{} {} is {}, which is {}", tagText(tag), name, quotedText(dicomText(dataset, tag)),
                           problem);
    };
    if (!dicomPoint(dataset, positionTag) && !dicomText(dataset, positionTag).empty())
        return stated(positionTag, "Image Position", "no position");
    if (!dicomOrientation(dataset, orientationTag) && !dicomText(dataset, orientationTag).empty())
        return stated(orientationTag, "Image Orientation", "no pair of perpendicular directions");
    return {};
}

ImageHeader headerOf(const DicomFile& file) {
    DcmItem& dataset = file.dataset();
    ImageHeader header;
    header.file.path = file.path();
    header.file.instance = dicomWholeNumber(dataset, {0x0020, 0x0013}).value_or(0);
    if (const auto placement = topLevelPlacement(dataset))
        header.file.plane =
            SlicePlane{*placement->position, (*placement->orientation)[0], (*placement->orientation)[1], file.path()};
    else
        header.wrongPlace = wrongPlaceOf(dataset);
    header.rows = dicomWholeNumber(dataset, rowsTag).value_or(0);
    header.columns = dicomWholeNumber(dataset, columnsTag).value_or(0);
    header.frames = dicomFrameCount(dataset);
    header.series = dicomText(dataset, {0x0020, 0x000e});
    header.object = dicomText(dataset, {0x0008, 0x0018});
    header.study = dicomText(dataset, {0x0020, 0x000d});
    header.description = seriesDescription(dataset);
    header.modality = dicomText(dataset, {0x0008, 0x0060});
    header.traits = traitsOf(dataset);
    header.part = concatenationPartOf(dataset);
    if (header.frames == 1) header.moments = momentsOf(dataset);
    return header;
}

/// What a picture lacks and must have; empty if it lacks nothing, or if the file is no picture.
const char* lackOf(const DicomFile& file) {
    DcmItem& dataset = file.dataset();
    const bool sized = dicomWholeNumber(dataset, rowsTag) && dicomWholeNumber(dataset, columnsTag);
    const bool named = dicomHas(dataset, rowsTag) || dicomHas(dataset, columnsTag) || dicomHas(dataset, positionTag);
    if (file.scan().hasPixelData) return sized ? "" : "has pixels without Rows and Columns, their size";
    return named ? "has no (7fe0,0010) Pixel Data: it was cut off or never written" : "";
}

LookedAt lookAtDicom(const InputFile& input, const Progress& progress) {
    LookedAt looked;
    auto file = DicomFile::load(input, true, progress);
    if (!file) {
        looked.kind = LookedAt::Kind::damaged;
        looked.damage = file.error();
        if (const auto rest = DicomFile::loadRest(input, progress))
            looked.header = std::make_unique<ImageHeader>(headerOf(*rest));
        return looked;
    }
    const bool kretz = file->scan().holdsKretz;
    if (const std::string lack = kretz ? "" : lackOf(*file); !lack.empty()) {
        looked.kind = LookedAt::Kind::damaged;
        looked.damage = fail(FailureKind::unreadable, input.path(), "", lack, copyAgain).value();
        looked.header = std::make_unique<ImageHeader>(headerOf(*file));
        return looked;
    }
    if (!file->scan().hasPixelData && !kretz) {
        looked.kind = LookedAt::Kind::otherDicom;
        looked.series = dicomText(file->dataset(), {0x0020, 0x000e});
        looked.sopClass = file->scan().sopClass;
        return looked;
    }
    looked.kind = LookedAt::Kind::image;
    looked.header = std::make_unique<ImageHeader>(headerOf(*file));
    if (looked.header->frames == 1) takeValues(file->dataset(), looked.header->file);
    looked.header->sopClass = file->scan().sopClass;
    takeVolume(*file, input, *looked.header, progress);
    return looked;
}

}  // namespace

LookedAt lookAt(const std::string& path, const Progress& progress) {
    LookedAt looked;
    if (progress.cancelled()) return looked;
    const auto input = InputFile::open(path);
    const auto beginning = input ? input->beginning(132) : Result<std::string>(tl::unexpected(input.error()));
    if (!beginning) {
        looked.kind = LookedAt::Kind::unopened;
        looked.damage = beginning.error();
        return looked;
    }
    if (looksLikeDicom(*beginning)) return lookAtDicom(*input, progress);
    if (looksLikeGzip(*beginning))
        looked.kind = LookedAt::Kind::packed;
    else if (beginning->empty())
        looked.kind = LookedAt::Kind::empty;
    return looked;
}

}  // namespace echolucent
