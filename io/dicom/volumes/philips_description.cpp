#include "io/dicom/volumes/philips_description.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

constexpr DicomTag slicesTag{0x3001, 0x1001};
constexpr DicomTag sliceSpacingTag{0x3001, 0x1003};
constexpr std::uint16_t scannerGroup = 0x200d;
constexpr const char* shapeCreator = "Philips US Imaging DD 036";
constexpr const char* voxelCreator = "Philips US Imaging DD 033";
/// Ultrasound reaches no farther. The unit that a longer volume names is false.
constexpr double farthestReachMm = 1000;

using Volume3 = std::array<std::int64_t, 3>;

bool allAbove0(const Volume3& size) {
    return std::all_of(size.begin(), size.end(), [](std::int64_t edge) { return edge > 0; });
}

std::optional<std::int64_t> voxelsOf(const Volume3& size) {
    const auto slice = checkedProduct(size[0], size[1]);
    return slice ? checkedProduct(*slice, size[2]) : slice;
}

bool isSpacing(const Vec3& spacing) {
    return std::all_of(spacing.val, spacing.val + 3, [](double mm) { return std::isfinite(mm) && mm > 0; });
}

double longestEdge(const Vec3& spacing, const Volume3& size) {
    double longest = 0;
    for (int axis = 0; axis < 3; ++axis)
        longest = std::max(longest, spacing[axis] * static_cast<double>(size[static_cast<std::size_t>(axis)]));
    return longest;
}

/// The times of the volumes of a QLAB file. A frame of it is a volume.
std::optional<DicomTimes> timesOfVolumes(DcmItem& dataset, std::int64_t volumes) {
    if (volumes < 2 || volumes > mostPhases) return std::nullopt;
    auto times = statedFrameTimes(dataset, static_cast<std::size_t>(volumes));
    return times ? times : statedFrameRate(dataset, static_cast<std::size_t>(volumes));
}

bool isOrAbsent(DcmItem& dataset, DicomTag tag, std::int64_t value) {
    return dicomText(dataset, tag).empty() || dicomWholeNumber(dataset, tag) == value;
}

void takeQlabSpacing(DcmItem& dataset, PhilipsVolume& volume) {
    const auto x = dicomNumber(dataset, {0x0018, 0x602c}), y = dicomNumber(dataset, {0x0018, 0x602e});
    const auto z = dicomNumber(dataset, sliceSpacingTag);
    const bool centimetre = isOrAbsent(dataset, {0x0018, 0x6024}, 3) && isOrAbsent(dataset, {0x0018, 0x6026}, 3);
    if (!x || !y || !z || !centimetre) return;
    const Vec3 centimetres(std::abs(*x), std::abs(*y), std::abs(*z));
    if (!isSpacing(centimetres * 10.0)) return;
    volume.spacing = centimetres * 10.0;
    volume.spacingSource = "(0018,602c), (0018,602e), (3001,1003) in cm";
    if (longestEdge(*volume.spacing, volume.size) <= farthestReachMm) return;
    volume.warning = fmt::format(
        "The spacing in cm, as this format has it, would make a volume {:.3g} m long, farther than ultrasound reaches; "
        "its numbers are taken as mm, which is a guess.",
        longestEdge(*volume.spacing, volume.size) / 1000);
    volume.spacing = centimetres;
    volume.spacingSource.clear();
}

Result<std::optional<PhilipsVolume>> qlabVolume(const DicomFile& file) {
    DcmItem& dataset = file.dataset();
    const auto refuse = [&](const std::string& element, const std::string& problem) {
        return fail(FailureKind::unreadable, file.path(), element, problem, "Export it from QLAB again, uncompressed.");
    };
    PhilipsVolume volume;
    volume.size = {dicomWholeNumber(dataset, {0x0028, 0x0011}).value_or(0),
                   dicomWholeNumber(dataset, {0x0028, 0x0010}).value_or(0),
                   dicomWholeNumber(dataset, slicesTag).value_or(0)};
    if (volume.size[0] < 1) return refuse("(0028,0011) Columns", "is missing or not above 0");
    if (volume.size[1] < 1) return refuse("(0028,0010) Rows", "is missing or not above 0");
    if (volume.size[2] < 1) return refuse("(3001,1001) Number of Slices", "is missing or not above 0");
    volume.sizeSource = "(0028,0011), (0028,0010), (3001,1001)";
    if (!dicomText(dataset, {0x0028, 0x0008}).empty()) {
        volume.phases = dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(0);
        if (volume.phases < 1) return refuse("(0028,0008) Number of Frames", "is not above 0");
    }
    if (!isOrAbsent(dataset, {0x0028, 0x0100}, 8))
        return refuse("(0028,0100) Bits Allocated", "is not 8, as QLAB writes it");
    if (!isOrAbsent(dataset, {0x0028, 0x0002}, 1))
        return refuse("(0028,0002) Samples per Pixel", "is not 1, as QLAB writes it");
    const DicomScan& scan = file.scan();
    const bool encapsulated = DcmXfer(scan.transferSyntax.c_str()).isEncapsulated();
    if (!scan.hasPixelData || scan.pixelStart == 0 || scan.pixelBytesDeclared == 0 || encapsulated)
        return refuse(
            "", "is a Philips QLAB Cartesian volume, and (7fe0,0010) Pixel Data is absent, deflated or compressed");
    const std::uint64_t held = scan.fileBytes - std::min(scan.pixelStart, scan.fileBytes);
    const std::optional<std::int64_t> one = voxelsOf(volume.size);
    // The end of the last row may be missing. These voxels are no data then.
    if (!one || held + static_cast<std::uint64_t>(volume.size[0]) <= static_cast<std::uint64_t>(*one))
        return fail(FailureKind::unreadable, file.path(), "(7fe0,0010) Pixel Data",
                    fmt::format("holds {} bytes where one volume of {} voxels needs {}", held, sizeText(volume.size),
                                one ? std::to_string(*one) : "more than can be counted"),
                    incompleteFile);
    takeQlabSpacing(dataset, volume);
    volume.times = timesOfVolumes(dataset, volume.phases);
    return std::optional(volume);
}

/// The text of a private element, also if it is stored as bytes.
std::string privateText(DcmItem& dataset, DicomTag tag) {
    DcmElement* element = nullptr;
    Uint8* bytes = nullptr;
    if (dataset.findAndGetElement(DcmTagKey(tag.group, tag.element), element).bad() || element == nullptr) return {};
    const bool raw = element->getVR() == EVR_UN || element->getVR() == EVR_OB;
    if (!raw) return dicomText(dataset, tag);
    if (element->getUint8Array(bytes).bad() || bytes == nullptr) return {};
    const std::string text(reinterpret_cast<const char*>(bytes), element->getLength());
    return trimmed(text.substr(0, text.find('\0')));
}

/// The block (0x10 to 0xff) of a maker's elements in the scanner's group; no value if there is none.
std::optional<std::uint16_t> blockOf(DcmItem& dataset, const std::string& creator) {
    for (DcmObject* one = dataset.nextInContainer(nullptr); one != nullptr; one = dataset.nextInContainer(one)) {
        const std::uint16_t element = one->getETag();
        const bool creatorTag = one->getGTag() == scannerGroup && element >= 0x10 && element <= 0xff;
        if (creatorTag && privateText(dataset, {scannerGroup, element}) == creator) return element;
    }
    return std::nullopt;
}

DicomTag inBlock(std::uint16_t block, std::uint16_t element) {
    return {scannerGroup, static_cast<std::uint16_t>(block << 8 | element)};
}

/// Three finite numbers above 0 with backslashes or blanks between them; else no value.
std::optional<Vec3> threeNumbers(const std::string& text) {
    std::string spaced = text;
    std::replace(spaced.begin(), spaced.end(), '\\', ' ');
    const auto numbers = realNumbers(spaced);
    if (!numbers || numbers->size() != 3) return std::nullopt;
    const Vec3 values((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    if (!isSpacing(values)) return std::nullopt;
    return values;
}

/// The size of a scanner's volume; all 0 if the element does not state three whole numbers up to 100000.
Volume3 scannerSize(DcmItem& dataset, DicomTag tag) {
    Volume3 size{0, 0, 0};
    const auto numbers = threeNumbers(privateText(dataset, tag));
    if (!numbers) return size;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double edge = (*numbers)[static_cast<int>(axis)];
        if (edge > 100000 || edge != std::floor(edge)) return {0, 0, 0};
        size[axis] = static_cast<std::int64_t>(edge);
    }
    return size;
}

/// Finds the voxels of a scanner's volume: the frames of Pixel Data if their size and number fit, else the private
/// element. False if neither holds them in plain form.
bool placeVoxels(const DicomFile& file, PhilipsVolume& volume) {
    DcmItem& dataset = file.dataset();
    const auto frames = dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(1);
    const bool asFrames = dicomWholeNumber(dataset, {0x0028, 0x0011}) == volume.size[0] &&
                          dicomWholeNumber(dataset, {0x0028, 0x0010}) == volume.size[1] && frames >= volume.size[2] &&
                          frames % volume.size[2] == 0;
    if (asFrames && file.scan().hasPixelData) {
        volume.kind = PhilipsVolume::Kind::frames;
        volume.phases = frames / volume.size[2];
        return true;
    }
    const auto block = blockOf(dataset, voxelCreator);
    const auto voxels = voxelsOf(volume.size);
    if (!block || !voxels) return false;
    volume.voxels = inBlock(*block, 0x0b);
    DcmElement* element = nullptr;
    const DcmTagKey key(volume.voxels.group, volume.voxels.element);
    if (dataset.findAndGetElement(key, element).bad() || element == nullptr) return false;
    const auto held = static_cast<std::int64_t>(element->getLength());
    if (held < *voxels || held > *voxels + 1) return false;
    volume.kind = PhilipsVolume::Kind::privateElement;
    return true;
}

Result<std::optional<PhilipsVolume>> scannerVolume(const DicomFile& file) {
    DcmItem& dataset = file.dataset();
    const auto block = blockOf(dataset, shapeCreator);
    if (!block) return std::optional<PhilipsVolume>();
    PhilipsVolume volume;
    volume.size = scannerSize(dataset, inBlock(*block, 0x01));
    if (!allAbove0(volume.size) || volume.size[2] < 2) return std::optional<PhilipsVolume>();
    volume.sizeSource = tagText(inBlock(*block, 0x01)) + " Philips private";
    if (const auto spacing = threeNumbers(privateText(dataset, inBlock(*block, 0x03)))) {
        volume.spacing = *spacing;
        volume.spacingSource = tagText(inBlock(*block, 0x03)) + " Philips private";
    }
    if (placeVoxels(file, volume)) return std::optional(volume);
    const auto pictures = dicomWholeNumber(dataset, {0x0028, 0x0008}).value_or(1);
    auto refused = fail(
        FailureKind::unreadable, file.path(), tagText(inBlock(*block, 0x01)),
        fmt::format("declares a 3D volume of {} voxels, which is kept in Philips's own coding", sizeText(volume.size)),
        pictures > 1
            ? "Export it from QLAB as a Cartesian volume, or add --frames-as-slices to take the pictures beside "
              "it as slices; their distance stays unknown unless the file states it."
            : "Export it from QLAB as a Cartesian volume.");
    refused.value().framesCouldBeSlices = pictures > 1;
    return refused;
}

}  // namespace

Result<std::optional<PhilipsVolume>> philipsVolumeOf(const DicomFile& file) {
    return file.scan().sopClass == qlabSopClass ? qlabVolume(file) : scannerVolume(file);
}

}  // namespace echolucent
