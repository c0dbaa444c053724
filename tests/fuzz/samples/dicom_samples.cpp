#include "tests/fuzz/samples/dicom_samples.h"

#include <numeric>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "enhanced_us_files.h"
#include "kretz_files.h"
#include "tests/fuzz/mutations/dicom_elements.h"
#include "tests/fuzz/samples/written_file.h"
#include "zlib_bytes.h"

namespace echolucent {

namespace {

const std::string qlabClass = "1.2.840.113543.6.6.1.3.10002";

std::string counted(std::size_t count) {
    std::string bytes(count, '\0');
    std::iota(bytes.begin(), bytes.end(), '\1');
    return bytes;
}

constexpr std::size_t jpeg2000Form = 12;  // of fragmentForms()

DicomBytes cine(int frames = 2) {
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "US").text(0x0018, 0x0088, "DS", "1").text(0x0020, 0x000e, "UI", "1.2.3");
    file.picture(4, 2, frames).text(0x0028, 0x0030, "DS", "1\\1");
    return file;
}

TestImage image(int samples = 1, int bits = 8) {
    TestImage one;
    one.frames = 3;
    one.samples = samples;
    one.spacingBetweenSlices = 1.0;
    one.pixelSpacing = {{0.5, 0.5}};
    one.bitsAllocated = bits;
    one.bitsStored = bits == 16 ? 12 : 8;
    const auto count = static_cast<std::size_t>(one.columns * one.rows * one.frames * samples);
    if (bits == 16)
        one.pixels16.assign(count, 300);
    else
        one.pixels8.assign(count, 77);
    if (samples == 3) one.photometric = "RGB";
    return one;
}

std::string written(const TestImage& one, TestSyntax syntax = TestSyntax::explicitLittle) {
    return bytesOfWritten("v.dcm", [&](const std::string& path) { return writeDicom(path, one, syntax), true; });
}

std::string writtenEnhanced(int bits, int phases) {
    return bytesOfWritten("v.dcm", [&](const std::string& path) {
        EnhancedUsDetails details;
        if (phases > 1) details.phaseSeconds = 0.04;
        VolumeGeometry geometry = obliqueGeometry();
        geometry.size = {8, 8, 8};
        return writeEnhancedUs(path, simulatedPhases(geometry, bits, phases), details).has_value();
    });
}

std::string qlab() {
    DicomBytes file;
    file.text(0x0018, 0x1063, "DS", "40").word(0x0018, 0x6024, 3).word(0x0018, 0x6026, 3);
    file.real(0x0018, 0x602c, 0.02).real(0x0018, 0x602e, 0.04);
    file.picture(3, 2, 2).put(0x3001, 0x1001, "UL", bytesFrom<std::uint32_t>({4}));
    file.real(0x3001, 0x1003, 0.05);
    return file.put(0x7fe0, 0x0010, "OW", counted(48)).file(qlabClass);
}

std::string groups() {
    TestImage one = image();
    one.orientation = {{1, 0, 0, 0, 1, 0}};
    for (int frame = 0; frame < 3; ++frame)
        one.functionalGroups.push_back({Vec3(0, 0, frame), frame * 0.1, "TISSUE_INTENSITY"});
    one.windowCentre = "79";
    one.windowWidth = "158";
    one.rescaleSlope = "2";
    one.rescaleIntercept = "-5";
    one.windowInGroups = true;
    return written(one);
}

std::string palette() {
    TestImage one = image();
    one.photometric = "PALETTE COLOR";
    TestPalette colours;
    for (std::uint16_t i = 0; i < 256; ++i) {
        colours.red.push_back(static_cast<std::uint16_t>(i * 257));
        colours.green.push_back(static_cast<std::uint16_t>(i * 257));
        colours.blue.push_back(static_cast<std::uint16_t>(65535 - i * 257));
    }
    one.palette = colours;
    return written(one);
}

/// Frames in the order of time slots and slices, as nuclear medicine has them.
std::string nuclear() {
    DicomBytes file = DicomBytes().text(0x0008, 0x0060, "CS", "NM").text(0x0018, 0x0088, "DS", "1");
    file.text(0x0018, 0x1063, "DS", "50").picture(4, 2, 4).text(0x0028, 0x0030, "DS", "1\\1");
    file.put(0x0028, 0x0009, "AT", bytesFrom<std::uint16_t>({0x0054, 0x0070, 0x0054, 0x0080}));
    DicomBytes phase = DicomBytes().text(0x0018, 0x1242, "IS", "40").text(0x0054, 0x0036, "IS", "5");
    file.sequence(0x0054, 0x0032, {phase}).put(0x0054, 0x0070, "US", bytesFrom<std::uint16_t>({1, 1, 2, 2}));
    file.put(0x0054, 0x0080, "US", bytesFrom<std::uint16_t>({1, 2, 1, 2}));
    return file.put(0x7fe0, 0x0010, "OW", counted(32)).file("1.2.840.10008.5.1.4.1.1.20");
}

/// Ultrasound regions of two scales beside Spacing Between Slices.
std::string regions() {
    std::vector<DicomBytes> items;
    for (const double delta : {0.05, 0.07}) {
        DicomBytes item = DicomBytes().word(0x0018, 0x6012, 1).put(0x0018, 0x6018, "UL", std::string(4, '\0'));
        item.put(0x0018, 0x601c, "UL", bytesFrom<std::uint32_t>({3})).word(0x0018, 0x6024, 3).word(0x0018, 0x6026, 3);
        items.push_back(item.real(0x0018, 0x602c, delta).real(0x0018, 0x602e, delta));
    }
    DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").sequence(0x0018, 0x6011, items).picture(4, 2, 2);
    return file.text(0x0028, 0x0034, "IS", "2\\1").put(0x7fe0, 0x0010, "OW", counted(16)).file(cineClass);
}

/// Uncompressed 4:2:2 of rows of three pixels.
std::string halved() {
    DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").word(0x0028, 0x0002, 3);
    file.text(0x0028, 0x0004, "CS", "YBR_FULL_422").word(0x0028, 0x0006, 0).text(0x0028, 0x0008, "IS", "2");
    file.word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 3).text(0x0028, 0x0030, "DS", "1\\1");
    file.word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    return file.put(0x7fe0, 0x0010, "OW", counted(32)).file(cineClass);
}

/// The first frame's fragment of a file.
std::string fragmentOf(const std::string& bytes) {
    const DicomFileBytes parts = dicomParts(bytes);
    for (const DicomElementBytes& element : parts.elements)
        if (element.encapsulated && element.fragments.size() > 1) return element.fragments[1];
    throw std::runtime_error("a sample holds no fragment");
}

std::string jpeg2000Fragment() {
    return fragmentOf(bytesOfWritten("v.dcm", [](const std::string& path) {
        return writeJpeg2000Dicom(path, 8, 8, std::vector<std::uint8_t>(64, 99)), true;
    }));
}

}  // namespace

std::vector<FuzzSample> dicomSamples() {
    const std::string pixels = counted(16);
    const auto nested = DicomBytes().sequence(0x0008, 0x1140, {DicomBytes().text(0x0008, 0x1150, "UI", "1.2")});
    DicomBytes deep = cine();
    deep.sequence(0x0040, 0xa730, {nested, nested}).put(0x7fe0, 0x0010, "OW", pixels);
    DicomBytes kretz = cine(0);
    kretz.put(0x7fe0, 0x0010, "OW", counted(8)).text(0x7fe1, 0x0011, "LO", "KRETZ_US");
    kretz.put(0x7fe1, 0x1101, "OB", KretzParts().bytes() + std::string(KretzParts().bytes().size() % 2, '\0'));
    std::vector<FuzzSample> samples{
        {"cine", cine().put(0x7fe0, 0x0010, "OW", pixels).file(cineClass)},
        {"sequences", deep.file(cineClass)},
        {"kretz", kretz.file(pictureClass)},
        {"qlab", qlab()},
        {"groups", groups()},
        {"palette", palette()},
        {"enhanced", writtenEnhanced(8, 1)},
        {"enhanced-phases", writtenEnhanced(16, 2)},
        {"implicit", written(image(), TestSyntax::implicitLittle)},
        {"big", written(image(1, 16), TestSyntax::explicitBig)},
        {"colour", written(image(3))},
        {"deflated", written(image(), TestSyntax::deflated)},
        {"rle", written(image(1, 16), TestSyntax::rle)},
        {"jpeg", written(image(), TestSyntax::jpegBaseline)},
        {"jpeg-lossless", written(image(1, 16), TestSyntax::jpegLossless)},
        {"jpeg-ls", written(image(), TestSyntax::jpegLs)},
        {"slice", dicomSlice(1)},
        {"nuclear", nuclear()},
        {"regions", regions()},
        {"halved", halved()},
    };
    samples.push_back({"jpeg-2000", dicomOfFragment(jpeg2000Form, jpeg2000Fragment())});
    return samples;
}

std::string dicomSlice(int instance) {
    DicomBytes file;
    file.text(0x0008, 0x0016, "UI", pictureClass).text(0x0008, 0x0018, "UI", "1.2.3." + std::to_string(instance));
    file.text(0x0008, 0x0060, "CS", "US").text(0x0020, 0x000e, "UI", "1.2.3");
    file.text(0x0020, 0x0013, "IS", std::to_string(instance));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(instance));
    file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").text(0x0020, 0x0052, "UI", "1.2.4").picture(4, 2, 0);
    file.text(0x0028, 0x0030, "DS", "0.5\\0.5");
    return file.put(0x7fe0, 0x0010, "OW", counted(8)).file(pictureClass);
}

std::string dicomPart(int number) {
    constexpr int frames = 2;
    std::vector<DicomBytes> groups;
    for (int frame = 0; frame < frames; ++frame) {
        const std::string place = "0\\0\\" + std::to_string(frames * (number - 1) + frame);
        groups.push_back(DicomBytes().sequence(0x0020, 0x9113, {DicomBytes().text(0x0020, 0x0032, "DS", place)}));
    }
    DicomBytes shared;
    shared.sequence(0x0020, 0x9116, {DicomBytes().text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0")});
    shared.sequence(0x0028, 0x9110, {DicomBytes().text(0x0028, 0x0030, "DS", "0.5\\0.5")});
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", "1.2.6." + std::to_string(number)).text(0x0020, 0x000e, "UI", "1.2.6");
    file.text(0x0020, 0x0242, "UI", "1.2.6.9").text(0x0020, 0x9161, "UI", "1.2.6.8");
    file.word(0x0020, 0x9162, static_cast<std::uint16_t>(number)).word(0x0020, 0x9163, 2);
    file.put(0x0020, 0x9228, "UL", std::string{static_cast<char>(frames * (number - 1)), 0, 0, 0});
    file.picture(4, 2, frames).sequence(0x5200, 0x9229, {shared}).sequence(0x5200, 0x9230, groups);
    return file.put(0x7fe0, 0x0010, "OW", counted(16)).file("1.2.840.10008.5.1.4.1.1.2.1");
}

std::string dicomMoment(int number) {
    const std::string moment = std::to_string(1 + number / 2);
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", "1.2.7." + std::to_string(number)).text(0x0008, 0x0022, "DA", "20200101");
    file.text(0x0008, 0x0032, "TM", "12000" + moment + ".5").text(0x0018, 0x1060, "DS", moment + "0");
    file.text(0x0020, 0x000e, "UI", "1.2.7").text(0x0020, 0x0013, "IS", std::to_string(number));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(number % 2));
    file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").text(0x0020, 0x0100, "IS", moment);
    file.text(0x0020, 0x0110, "DS", "40").picture(4, 2, 0);
    return file.put(0x7fe0, 0x0010, "OW", counted(8)).file(pictureClass);
}

std::string dicomLoneSlice(int number) {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", "1.2.8." + std::to_string(number)).text(0x0020, 0x000d, "UI", "1.2.8");
    file.text(0x0020, 0x000e, "UI", "1.2.8.1" + std::to_string(number)).text(0x0020, 0x0013, "IS", "1");
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(number));
    file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").text(0x0020, 0x0052, "UI", "1.2.9").picture(6, 2, 0);
    return file.put(0x7fe0, 0x0010, "OW", counted(12)).file(pictureClass);
}

const std::vector<FragmentForm>& fragmentForms() {
    static const std::vector<FragmentForm> forms{
        {"1.2.840.10008.1.2.5", 4, 3, 1, 8},     {"1.2.840.10008.1.2.5", 4, 3, 1, 16},
        {"1.2.840.10008.1.2.5", 4, 3, 3, 8},     {"1.2.840.10008.1.2.4.50", 4, 3, 1, 8},
        {"1.2.840.10008.1.2.4.50", 4, 3, 3, 8},  {"1.2.840.10008.1.2.4.51", 4, 3, 1, 16},
        {"1.2.840.10008.1.2.4.70", 4, 3, 1, 16}, {"1.2.840.10008.1.2.4.70", 4, 3, 1, 8},
        {"1.2.840.10008.1.2.4.57", 4, 3, 1, 8},  {"1.2.840.10008.1.2.4.80", 4, 3, 1, 8},
        {"1.2.840.10008.1.2.4.81", 4, 3, 1, 16}, {"1.2.840.10008.1.2.4.80", 4, 3, 3, 8},
        {"1.2.840.10008.1.2.4.90", 8, 8, 1, 8},  {"1.2.840.10008.1.2.4.91", 8, 8, 3, 8},
        {"1.2.840.10008.1.2.4.90", 8, 8, 1, 16}, {"1.2.840.10008.1.2.4.50", 4, 3, 1, 16},
        {"1.2.840.10008.1.2.4.80", 4, 3, 1, 16}, {"1.2.840.10008.1.2.4.70", 4, 3, 3, 8}};
    return forms;
}

std::string dicomOfFragment(std::size_t form, const std::string& fragment) {
    const FragmentForm& one = fragmentForms()[form];
    const auto bits = static_cast<std::uint16_t>(one.bits);
    DicomBytes file;
    file.text(0x0008, 0x0060, "CS", "US").text(0x0018, 0x0088, "DS", "1");
    file.word(0x0028, 0x0002, static_cast<std::uint16_t>(one.samples));
    file.text(0x0028, 0x0004, "CS", one.samples == 3 ? "RGB" : "MONOCHROME2");
    if (one.samples == 3) file.word(0x0028, 0x0006, 0);
    file.text(0x0028, 0x0008, "IS", "2").word(0x0028, 0x0010, static_cast<std::uint16_t>(one.rows));
    file.word(0x0028, 0x0011, static_cast<std::uint16_t>(one.columns)).text(0x0028, 0x0030, "DS", "1\\1");
    file.word(0x0028, 0x0100, bits).word(0x0028, 0x0101, bits);
    file.word(0x0028, 0x0102, static_cast<std::uint16_t>(bits - 1)).word(0x0028, 0x0103, 0);
    const std::string even = fragment + std::string(fragment.size() % 2, '\0');
    return file.fragments("", {even, even}).file(cineClass, one.transferSyntax);
}

std::vector<FuzzSample> fragmentSamples() {
    const auto behind = [](char form, const std::string& bytes) { return std::string(1, form) + fragmentOf(bytes); };
    std::vector<FuzzSample> samples{
        {"rle", behind(0, written(image(), TestSyntax::rle))},
        {"rle-words", behind(1, written(image(1, 16), TestSyntax::rle))},
        {"rle-colour", behind(2, written(image(3), TestSyntax::rle))},
        {"jpeg", behind(3, written(image(), TestSyntax::jpegBaseline))},
        {"jpeg-colour", behind(4, written(image(3), TestSyntax::jpegBaseline))},
        {"jpeg-lossless", behind(6, written(image(1, 16), TestSyntax::jpegLossless))},
        {"jpeg-lossless-bytes", behind(7, written(image(), TestSyntax::jpegLossless))},
        {"jpeg-ls", behind(9, written(image(), TestSyntax::jpegLs))},
        {"jpeg-ls-words", behind(10, written(image(1, 16), TestSyntax::jpegLs))},
    };
    samples.push_back({"jpeg-2000", static_cast<char>(jpeg2000Form) + jpeg2000Fragment()});
    const std::vector<int> plane(64, 90);
    samples.push_back({"jpeg-2000-colour", static_cast<char>(jpeg2000Form + 1) +
                                               codedJpeg2000({.transform = true, .planes = {plane, plane, plane}})});
    samples.push_back({"jpeg-in-words", behind(15, written(image(), TestSyntax::jpegBaseline))});
    samples.push_back({"jpeg-ls-in-words", behind(16, written(image(), TestSyntax::jpegLs))});
    samples.push_back({"jpeg-lossless-colour", behind(17, written(image(3), TestSyntax::jpegLossless))});
    samples.push_back({"rle-in-words", behind(1, written(image(), TestSyntax::rle))});
    return samples;
}

}  // namespace echolucent
