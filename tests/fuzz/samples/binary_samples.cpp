#include "tests/fuzz/samples/binary_samples.h"

#include "enhanced_us_files.h"
#include "io/writers/nifti_writer.h"
#include "kretz_files.h"
#include "nifti_files.h"
#include "tests/fuzz/samples/dicom_samples.h"
#include "tests/fuzz/samples/text_header_samples.h"
#include "tests/fuzz/samples/written_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

std::string writtenNifti(int bits, int phases, const std::string& name) {
    return bytesOfWritten(name, [&](const std::string& path) {
        return writeNifti(path, simulatedPhases(obliqueGeometry(), bits, phases), 0.04).has_value();
    });
}

std::string niftiOf(const NiftiFields& fields) { return niftiHeader(fields) + countedVoxels; }

}  // namespace

std::vector<FuzzSample> niftiSamples() {
    NiftiFields second;
    second.version = 2;
    NiftiFields big;
    big.bigEndian = true;
    big.datatype = 4;
    big.bitpix = 16;
    big.dim = {3, 2, 3, 2};
    NiftiFields turned;
    turned.qformCode = turned.sformCode = 1;
    turned.quatern = {0.1, 0.2, 0.3};
    turned.qoffset = {1, 2, 3};
    turned.srow = {{{0.5, 0, 0, 1}, {0, 0.25, 0, 2}, {0, 0, 2, 3}}};
    NiftiFields moving;
    moving.dim = {4, 2, 3, 2, 2};
    moving.pixdim = {1, 1, 1, 1, 0.04};
    moving.units = 10;
    NiftiFields scaled;
    scaled.slope = 2;
    scaled.inter = -5;
    scaled.calMax = 40;
    NiftiFields colour;
    colour.datatype = 128;
    colour.bitpix = 24;
    colour.dim = {3, 2, 2, 2};
    NiftiFields apart;
    apart.apart = true;
    NiftiFields formless;
    formless.dim = {7, 2, 3, 4, 0, 0, 0, 0};
    formless.sformCode = formless.qformCode = 1;
    formless.quatern = {1, 1, 1};
    formless.pixdim = {1, -0.5, 0.25, 2};
    formless.voxOffset = 0;
    return {{"first", niftiOf({})},
            {"second", niftiOf(second)},
            {"big", niftiOf(big)},
            {"turned", niftiOf(turned)},
            {"moving", niftiOf(moving)},
            {"scaled", niftiOf(scaled)},
            {"colour", niftiOf(colour)},
            {"apart", niftiHeader(apart)},
            {"formless", niftiOf(formless)},
            {"one-file", niftiHeader(apart) + std::string(4, '\0') + countedVoxels},
            {"written", writtenNifti(8, 2, "v.nii")}};
}

std::vector<FuzzSample> kretzSamples() {
    KretzParts cartesian;
    cartesian.resolution = cartesian.firstSample = cartesian.planesAxis = cartesian.planeAngles = cartesian.lineAngles =
        "";
    cartesian.more = kretzNumbers(0x0010, 0x0022, {0.5});
    KretzParts sequence;
    sequence.more = kretzItem(0xD600, 1, std::string(1200, 's'));
    KretzParts packed;
    packed.more = kretzItem(0x0002, 0x1000, "packed");
    std::vector<FuzzSample> samples{{"wobbler", KretzParts().bytes()},
                                    {"cartesian", cartesian.bytes()},
                                    {"sequence", sequence.bytes()},
                                    {"packed", packed.bytes()}};
    const PolarGeometry polar{.samples = 9,
                              .rangeStartMm = 4,
                              .rangeStepMm = 0.5,
                              .lines = {PolarSpread::angles, {-0.2, -0.1, 0, 0.1, 0.2, 0.3}, 20},
                              .planes = {PolarSpread::angles, {-0.1, -0.05, 0, 0.05, 0.1}, 30}};
    samples.push_back({"written", kretzBytes(polar, std::vector(2, std::vector<std::uint8_t>(9 * 6 * 5, 77)))});
    return samples;
}

std::vector<FuzzSample> gzipSamples() {
    std::vector<FuzzSample> samples{{"written-nifti", writtenNifti(16, 1, "v.nii.gz")},
                                    {"nifti", deflated(niftiOf({}), 31)},
                                    {"kretz", deflated(KretzParts().bytes(), 31)},
                                    {"meta-image", deflated(metaImageSamples().front().bytes, 31)},
                                    {"nrrd", deflated(nrrdSamples().front().bytes, 31)},
                                    {"dicom", deflated(dicomSamples().front().bytes, 31)},
                                    {"zeros", deflated(std::string(std::size_t{1} << 20, '\0'), 31)}};
    samples.push_back({"two-members", deflated("ObjectType = Image\n", 31) + samples[3].bytes});
    return samples;
}

}  // namespace echolucent
