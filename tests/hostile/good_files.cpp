#include "good_files.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "bzip2_bytes.h"
#include "dicom_bytes.h"
#include "dicom_files.h"
#include "enhanced_us_files.h"
#include "kretz_files.h"
#include "nifti_files.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

constexpr int goodColumns = 12, goodRows = 10, goodSlices = 8;
constexpr int sliceVoxels = goodColumns * goodRows, voxelCount = sliceVoxels * goodSlices;

/// Bytes without a pattern that could be found elsewhere, none of them 0.
std::string speckle(int count) {
    std::string bytes;
    std::uint32_t state = 12345;
    for (int i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        bytes.push_back(static_cast<char>(1 + (state >> 24) % 254));
    }
    return bytes;
}

std::string goodMetaImage(const std::string& type, const std::string& more) {
    return fmt::format(
        "ObjectType = Image\nNDims = 3\nDimSize = {} {} {}\nElementSpacing = 0.5 0.4 0.3\n"
        "ElementType = {}\n{}",
        goodColumns, goodRows, goodSlices, type, more);
}

std::string goodNrrd(const std::string& encoding) {
    return fmt::format(
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: {} {} {}\nspacings: 0.5 0.4 0.3\n"
        "encoding: {}\n\n",
        goodColumns, goodRows, goodSlices, encoding);
}

GoodFile one(const std::string& name, const std::string& file, const std::string& bytes, VoxelCoding coding,
             const std::string& voxels) {
    return {name, file, {{file, bytes}}, coding, voxels};
}

std::vector<GoodFile> textHeaders() {
    const std::string voxels = speckle(voxelCount), wide = speckle(2 * voxelCount);
    const std::string local = "ElementDataFile = LOCAL\n";
    std::string hexadecimal, decimal;
    for (const char byte : voxels) {
        hexadecimal += fmt::format("{:02x}", static_cast<unsigned char>(byte));
        decimal += fmt::format("{} ", static_cast<unsigned char>(byte));
    }
    GoodFile apart{"metaimage-in-two-files",
                   "v.mhd",
                   {{"v.mhd", goodMetaImage("MET_UCHAR", "ElementDataFile = v.raw\n")}, {"v.raw", voxels}},
                   VoxelCoding::plain,
                   voxels};
    return {
        one("metaimage", "v.mha", goodMetaImage("MET_UCHAR", local) + voxels, VoxelCoding::plain, voxels),
        one("metaimage-of-16-bits", "v.mha", goodMetaImage("MET_USHORT", local) + wide, VoxelCoding::plain, wide),
        one("metaimage-zlib", "v.mha", goodMetaImage("MET_UCHAR", "CompressedData = True\n" + local) + deflated(voxels),
            VoxelCoding::checked, voxels),
        apart,
        one("nrrd", "v.nrrd", goodNrrd("raw") + voxels, VoxelCoding::plain, voxels),
        one("nrrd-of-two-phases", "v.nrrd",
            fmt::format("NRRD0004\ntype: uchar\ndimension: 4\nsizes: {} {} {} 2\nspacings: 0.5 0.4 0.3 0.04\n"
                        "kinds: domain domain domain time\nencoding: raw\n\n",
                        goodColumns, goodRows, goodSlices / 2) +
                voxels,
            VoxelCoding::plain, voxels),
        one("nrrd-gzip", "v.nrrd", goodNrrd("gzip") + deflated(voxels, 31), VoxelCoding::checked, voxels),
        one("nrrd-bzip2", "v.nrrd", goodNrrd("bzip2") + bzipped(voxels), VoxelCoding::checked, voxels),
        one("nrrd-text", "v.nrrd", goodNrrd("ascii") + decimal, VoxelCoding::decimal, voxels),
        one("nrrd-hexadecimal", "v.nrrd", goodNrrd("hex") + hexadecimal, VoxelCoding::hexadecimal, voxels),
    };
}

std::vector<GoodFile> niftiAndKretz() {
    const std::string voxels = speckle(voxelCount);
    NiftiFields fields;
    fields.dim = {3, goodColumns, goodRows, goodSlices};
    NiftiFields inTwo = fields;
    inTwo.apart = true;
    GoodFile pair{
        "nifti-in-two-files", "v.hdr", {{"v.hdr", niftiHeader(inTwo)}, {"v.img", voxels}}, VoxelCoding::plain, voxels};
    KretzParts cartesian;
    cartesian.planeAngles = cartesian.lineAngles = cartesian.firstSample = cartesian.planesAxis = "";
    cartesian.voxels = kretzItem(0xD000, 1, speckle(400));
    KretzParts polar;
    polar.voxels = kretzItem(0xD000, 1, speckle(400));
    return {
        one("nifti", "v.nii", niftiHeader(fields) + voxels, VoxelCoding::plain, voxels),
        one("nifti-gzip", "v.nii.gz", deflated(niftiHeader(fields) + voxels, 31), VoxelCoding::checked, voxels),
        pair,
        one("kretz-on-a-grid", "v.vol", cartesian.bytes(), VoxelCoding::plain, speckle(400)),
        one("kretz-along-beams", "v.vol", polar.bytes(), VoxelCoding::converted, ""),
    };
}

TestImage multiFrame() {
    TestImage image;
    image.columns = goodColumns;
    image.rows = goodRows;
    image.frames = goodSlices;
    image.pixelSpacing = {0.4, 0.5};
    image.spacingBetweenSlices = 0.3;
    for (const char byte : speckle(voxelCount)) image.pixels8.push_back(static_cast<std::uint8_t>(byte));
    return image;
}

GoodFile dicomFile(const std::string& name, TestSyntax syntax, VoxelCoding coding) {
    const TemporaryFolder folder;
    writeDicom(folder.file("v.dcm"), multiFrame(), syntax);
    return one("dicom-" + name, "v.dcm", contentsOf(folder.file("v.dcm")), coding,
               syntax == TestSyntax::jpegBaseline ? "" : speckle(voxelCount));
}

GoodFile jpeg2000() {
    const TemporaryFolder folder;
    std::vector<std::uint8_t> pixels;
    for (const char byte : speckle(32 * 24)) pixels.push_back(static_cast<std::uint8_t>(byte));
    writeJpeg2000Dicom(folder.file("v.dcm"), 32, 24, pixels);
    GoodFile file = one("dicom-jpeg-2000", "v.dcm", contentsOf(folder.file("v.dcm")), VoxelCoding::coded,
                        speckle(32 * 24) + speckle(32 * 24));
    file.options.framesAsSlices = true;
    return file;
}

GoodFile folderOfSlices() {
    const TemporaryFolder folder;
    GoodFile series{"dicom-folder", ".", {}, VoxelCoding::plain, speckle(voxelCount)};
    const TestImage all = multiFrame();
    for (int z = 0; z < goodSlices; ++z) {
        TestImage slice = all;
        slice.frames = 0;
        slice.instance = z + 1;
        slice.spacingBetweenSlices.reset();
        slice.position = Vec3(0, 0, 0.3 * z);
        slice.orientation = {1, 0, 0, 0, 1, 0};
        slice.pixels8.assign(all.pixels8.begin() + z * sliceVoxels, all.pixels8.begin() + (z + 1) * sliceVoxels);
        const std::string name = fmt::format("s{}.dcm", z);
        writeDicom(folder.file(name), slice);
        series.files.emplace_back(name, contentsOf(folder.file(name)));
    }
    return series;
}

GoodFile kretzInDicom() {
    const TemporaryFolder folder;
    TestImage image;
    image.pixels8.assign(12, 7);
    const std::string path = folder.file("v.dcm");
    writeDicom(path, image);
    KretzParts parts;
    parts.planeAngles = parts.lineAngles = parts.firstSample = parts.planesAxis = "";
    parts.voxels = kretzItem(0xD000, 1, speckle(400));
    std::string value = parts.bytes();
    value.resize((value.size() + 1) / 2 * 2, '\0');
    DcmFileFormat file;
    if (file.loadFile(path.c_str()).bad()) throw std::runtime_error("a good file cannot be read again");
    file.loadAllDataIntoMemory();
    file.getDataset()->putAndInsertString(DcmTag(0x7FE1, 0x10, EVR_LO), "KRETZ_US");
    auto* element = new DcmOtherByteOtherWord(DcmTag(0x7FE1, 0x1001, EVR_OB));
    element->putUint8Array(reinterpret_cast<const Uint8*>(value.data()), static_cast<unsigned long>(value.size()));
    file.getDataset()->insert(element);
    if (file.saveFile(path.c_str(), EXS_LittleEndianExplicit).bad())
        throw std::runtime_error("a good file cannot be written");
    return one("kretz-in-dicom", "v.dcm", contentsOf(path), VoxelCoding::plain, speckle(400));
}

/// Two volumes in Philips's own way: the private elements say how many frames make one.
GoodFile qlab() {
    const std::string voxels = speckle(voxelCount);
    DicomBytes file;
    file.text(0x0018, 0x1063, "DS", "40").word(0x0018, 0x6024, 3).word(0x0018, 0x6026, 3);
    file.real(0x0018, 0x602c, 0.02).real(0x0018, 0x602e, 0.04);
    file.picture(goodColumns, goodRows, 2).put(0x3001, 0x1001, "UL", bytesFrom<std::uint32_t>({goodSlices / 2}));
    file.real(0x3001, 0x1003, 0.05);
    return one("dicom-qlab", "v.dcm", file.put(0x7fe0, 0x0010, "OW", voxels).file("1.2.840.113543.6.6.1.3.10002"),
               VoxelCoding::plain, voxels);
}

/// Two phases of 8 slices each.
GoodFile enhancedUs() {
    const TemporaryFolder folder;
    VolumeGeometry geometry = obliqueGeometry();
    geometry.patientFrameKnown = true;
    const SharedPhases phases = simulatedPhases(geometry, 8, 2);
    const std::string path = folder.file("v.dcm");
    if (!writeEnhancedUs(path, phases, {.phaseSeconds = 0.04, .apexMm = Vec3(1, 2, -9)}))
        throw std::runtime_error("a good file cannot be written");
    std::string voxels;
    for (const auto& phase : phases) {
        const auto& bytes = std::get<VoxelArray<std::uint8_t>>(phase->voxels());
        voxels.append(bytes.begin(), bytes.end());
    }
    return one("dicom-enhanced-us", "v.dcm", contentsOf(path), VoxelCoding::plain, voxels);
}

}  // namespace

std::vector<GoodFile> goodFiles() {
    std::vector<GoodFile> files = textHeaders();
    for (GoodFile& file : niftiAndKretz()) files.push_back(std::move(file));
    files.push_back(kretzInDicom());
    files.push_back(dicomFile("explicit", TestSyntax::explicitLittle, VoxelCoding::plain));
    files.push_back(dicomFile("implicit", TestSyntax::implicitLittle, VoxelCoding::plain));
    files.push_back(dicomFile("big-endian", TestSyntax::explicitBig, VoxelCoding::plain));
    files.push_back(dicomFile("deflated", TestSyntax::deflated, VoxelCoding::deflated));
    files.push_back(dicomFile("rle", TestSyntax::rle, VoxelCoding::coded));
    files.push_back(dicomFile("jpeg-lossless", TestSyntax::jpegLossless, VoxelCoding::coded));
    files.push_back(dicomFile("jpeg", TestSyntax::jpegBaseline, VoxelCoding::coded));
    files.push_back(dicomFile("jpeg-ls", TestSyntax::jpegLs, VoxelCoding::coded));
    files.push_back(jpeg2000());
    files.push_back(qlab());
    files.push_back(enhancedUs());
    files.push_back(folderOfSlices());
    return files;
}

}  // namespace echolucent
