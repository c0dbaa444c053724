// The colours and the bits of compressed frames, where the codestream says one thing and the data set another.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "dicom_bytes.h"
#include "dicom_images.h"
#include "io/dicom/pixels/jpeg.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

constexpr int edge = 16;
const std::string lossyOf12Bits = "1.2.840.10008.1.2.4.51";
const std::string jpegLosslessOfAnyKind = "1.2.840.10008.1.2.4.57";

/// What a data set says of frames of 16 x 16 pixels.
struct Label {
    std::string photometric = "RGB";
    std::uint16_t samples = 3;
    std::uint16_t allocated = 8;
    std::uint16_t stored = 8;
    std::uint16_t sign = 0;
};

Result<Study> readFrames(const Label& label, const std::string& syntax, std::vector<std::string> frames) {
    const TemporaryFolder folder;
    DicomBytes file;
    file.word(0x0028, 0x0002, label.samples).text(0x0028, 0x0004, "CS", label.photometric);
    if (label.samples == 3) file.word(0x0028, 0x0006, 0);
    file.text(0x0028, 0x0008, "IS", std::to_string(frames.size()))
        .word(0x0028, 0x0010, edge)
        .word(0x0028, 0x0011, edge);
    file.word(0x0028, 0x0100, label.allocated).word(0x0028, 0x0101, label.stored);
    file.word(0x0028, 0x0102, static_cast<std::uint16_t>(label.stored - 1)).word(0x0028, 0x0103, label.sign);
    for (std::string& frame : frames) frame.resize(frame.size() + frame.size() % 2);
    const std::string bytes = file.fragments("", frames).file(cineClass, syntax);
    return readStudy(folder.write("a.dcm", bytes), framesAsSlices());
}

/// A red picture that darkens to the right: its luma is far from its first sample.
TestImage redRamp() {
    TestImage image;
    image.columns = image.rows = edge;
    image.samples = 3;
    image.photometric = "RGB";
    for (int i = 0; i < edge * edge; ++i)
        for (const int value : {250 - 10 * (i % edge), 20, 20})
            image.pixels8.push_back(static_cast<std::uint8_t>(value));
    return image;
}

double lumaAt(int column) { return 0.299 * (250 - 10 * column) + 0.701 * 20; }

/// A JPEG stream without APP0 and APP14, with this marker segment in their place.
std::string withMarker(const std::string& stream, const std::string& marker) {
    std::string rest = stream.substr(2);
    while (rest.size() > 4 && (rest[1] == '\xe0' || rest[1] == '\xee'))
        rest = rest.substr(2 + (static_cast<unsigned char>(rest[2]) << 8 | static_cast<unsigned char>(rest[3])));
    return stream.substr(0, 2) + marker + rest;
}

/// The stream with other names for its three components.
std::string withNames(std::string stream, const std::string& names) {
    for (std::size_t at = 2; at + 4 < stream.size();) {
        const auto marker = static_cast<unsigned char>(stream[at + 1]);
        const bool isFrame = marker == 0xc0 || marker == 0xc3, isScan = marker == 0xda;
        for (std::size_t i = 0; i < 3 && (isFrame || isScan); ++i)
            stream[at + (isFrame ? 10 + 3 * i : 5 + 2 * i)] = names[i];
        if (isScan) break;
        at += 2 + (static_cast<unsigned char>(stream[at + 2]) << 8 | static_cast<unsigned char>(stream[at + 3]));
    }
    return stream;
}

const std::string jfif("\xff\xe0\0\x10JFIF\0\1\1\0\0\1\0\1\0\0", 18);
std::string adobe(char transform) {
    return std::string(
               "\xff\xee\0\x0e"
               "Adobe\0\x64\0\0\0\0",
               15) +
           transform;
}

/// Baseline JPEG of redRamp(), as luma and colour differences.
const std::string& lumaStream() {
    static const std::string stream = withMarker(codedFullChroma(redRamp()), "");
    return stream;
}
/// Lossless JPEG of redRamp(), as red, green and blue.
const std::string& rgbStream() {
    static const std::string stream = withMarker(codedFrame(redRamp(), TestSyntax::jpegLossless), "");
    return stream;
}

/// The first row of the first frame.
std::vector<double> firstRow(const Study& study) {
    auto values = storedValues(*study.phases[0]);
    values.resize(edge);
    return values;
}

void expectLuma(const Result<Study>& study, double tolerance, const std::string& what) {
    ASSERT_TRUE(study) << what << ": " << study.error().sentence();
    const auto row = firstRow(*study);
    for (int column = 0; column < edge; ++column)
        EXPECT_NEAR(row[static_cast<std::size_t>(column)], lumaAt(column), tolerance) << what << ", column " << column;
}

void expectRed(const Result<Study>& study, const std::string& what) {
    ASSERT_TRUE(study) << what << ": " << study.error().sentence();
    const auto row = firstRow(*study);
    for (int column = 0; column < edge; ++column)
        EXPECT_EQ(row[static_cast<std::size_t>(column)], 250 - 10 * column) << what << ", column " << column;
}

TEST(StreamColours, MarkersOfLumaDecideAgainstTheNameRgb) {
    const std::vector<std::pair<std::string, std::string>> streams{
        {"the JFIF marker", withMarker(lumaStream(), jfif)},
        {"APP14, colour transform 1", withMarker(lumaStream(), adobe('\1'))},
        {"chroma of fewer samples", withMarker(codedFrame(redRamp(), TestSyntax::jpegBaseline), "")},
        {"components called 1, 2 and 3", withNames(lumaStream(), "\1\2\3")}};
    for (const auto& [source, stream] : streams) {
        const auto study = readFrames({"RGB"}, jpegSyntax, {stream, stream});
        expectLuma(study, 3, source);
        EXPECT_TRUE(warnsOf(*study, "is RGB, but the JPEG frames hold luma and colour differences (" + source + ")"));
        const auto named = readFrames({"YBR_FULL_422"}, jpegSyntax, {stream, stream});
        expectLuma(named, 3, source);
        EXPECT_FALSE(warnsOf(*named, "but the JPEG frames"));
    }
}

TEST(StreamColours, MarkersOfRedGreenAndBlueDecideAgainstNamesOfLuma) {
    const std::vector<std::pair<std::string, std::string>> streams{
        {"APP14, colour transform 0", withNames(withMarker(rgbStream(), adobe('\0')), std::string("\0\1\2", 3))},
        {"components called R, G and B", withNames(rgbStream(), "RGB")}};
    for (const auto& [source, stream] : streams)
        for (const std::string name : {"YBR_FULL", "YBR_FULL_422"}) {
            const auto study = readFrames({name}, jpegLosslessSyntax, {stream, stream});
            expectLuma(study, 0.5, name + ", " + source);
            EXPECT_TRUE(
                warnsOf(*study, "is " + name + ", but the JPEG frames hold red, green and blue (" + source + ")"));
        }
}

TEST(StreamColours, WithoutMarkersTheNameDecides) {
    const std::string unnamed = withNames(rgbStream(), std::string("\0\1\2", 3));
    expectLuma(readFrames({"RGB"}, jpegLosslessSyntax, {unnamed, unnamed}), 0.5, "RGB");
    expectRed(readFrames({"YBR_FULL"}, jpegLosslessSyntax, {unnamed, unnamed}), "YBR_FULL");
    // Nobody loses colours to a lossless stream: numbers for names and a JFIF marker are what libraries write anyway.
    const std::string numbered = withMarker(withNames(rgbStream(), "\1\2\3"), jfif);
    expectLuma(readFrames({"RGB"}, jpegLosslessSyntax, {numbered, numbered}), 0.5, "lossless");
    // Two markers that contradict each other say nothing.
    const std::string both = withMarker(lumaStream(), jfif + adobe('\0'));
    expectLuma(readFrames({"YBR_FULL_422"}, jpegSyntax, {both, both}), 3, "contradiction");
    const auto study = readFrames({"RGB"}, jpegSyntax, {both, both});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_GT(firstRow(*study)[0], lumaAt(0) + 15) << "the name RGB decides";
}

TEST(StreamColours, EachFrameDecidesForItself) {
    const std::string luma = withMarker(lumaStream(), jfif);
    const std::string unmarked = withNames(lumaStream(), std::string("\0\1\2", 3));
    const auto study = readFrames({"RGB"}, jpegSyntax, {luma, unmarked, luma});
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    EXPECT_NEAR(values[0], lumaAt(0), 3);
    EXPECT_GT(values[edge * edge], lumaAt(0) + 15);
    EXPECT_NEAR(values[2 * edge * edge], lumaAt(0), 3);
    EXPECT_TRUE(warnsOf(*study, "(Said of 2 of 3 frames.)"));
}

TEST(StreamColours, ChromaOfFewerSamplesTellsOfLuma) {
    std::string header = withNames(lumaStream(), "abc");
    const JpegFrame expected{edge, edge, 3, 8, false};
    const auto bytes = [&] { return std::vector<std::uint8_t>(header.begin(), header.end()); };
    EXPECT_EQ(readJpegHeader(bytes(), expected).colours.kind, StreamColours::Kind::unsaid);
    const std::size_t frame = header.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    header[frame + 11] = '\x22';
    const JpegHeader read = readJpegHeader(bytes(), expected);
    EXPECT_EQ(read.problem, "");
    EXPECT_EQ(read.colours.kind, StreamColours::Kind::lumaFirst);
    EXPECT_EQ(read.colours.source, "chroma of fewer samples");
}

TEST(StreamColours, OtherNumbersOfSamplesAreRefusedInWords) {
    TestImage grey;
    grey.columns = grey.rows = edge;
    grey.pixels8.assign(edge * edge, 90);
    const std::string one = codedFrame(grey, TestSyntax::jpegBaseline);
    const auto colour = readFrames({"RGB"}, jpegSyntax, {one, one});
    ASSERT_FALSE(colour);
    EXPECT_THAT(colour.error().sentence(), HasSubstr("16 x 16 pixels, 1 sample(s), where 16 x 16, 3 are declared"));
    const auto study = readFrames({"MONOCHROME2", 1}, jpegSyntax, {lumaStream(), lumaStream()});
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("3 sample(s), where 16 x 16, 1 are declared"));
}

/// The planes of redRamp().
TestPlanes redPlanes(bool transform) {
    TestPlanes frame{.columns = edge, .rows = edge, .transform = transform, .planes = {{}, {}, {}}};
    const TestImage image = redRamp();
    for (std::size_t i = 0; i < image.pixels8.size(); ++i) frame.planes[i % 3].push_back(image.pixels8[i]);
    return frame;
}

TEST(StreamColours, TheComponentTransformOfJpeg2000Decides) {
    const std::string transformed = codedJpeg2000(redPlanes(true)), plain = codedJpeg2000(redPlanes(false));
    for (const std::string name : {"YBR_RCT", "RGB", "YBR_FULL"}) {
        const auto study = readFrames({name}, jpeg2000Syntax, {transformed, transformed});
        expectLuma(study, 0.5, name);
        EXPECT_EQ(warnsOf(*study, "hold red, green and blue (its component transform)"), name == "YBR_FULL") << name;
    }
    const auto rgb = readFrames({"RGB"}, jpeg2000Syntax, {plain, plain});
    expectLuma(rgb, 0.5, "RGB without transform");
    EXPECT_FALSE(warnsOf(*rgb, "no component transform"));
    const auto named = readFrames({"YBR_RCT"}, jpeg2000Syntax, {plain, plain});
    expectLuma(named, 0.5, "YBR_RCT without transform");
    EXPECT_TRUE(warnsOf(*named, "is YBR_RCT, but the JPEG 2000 frames have no component transform"));
    expectRed(readFrames({"YBR_FULL"}, jpeg2000Syntax, {plain, plain}), "YBR_FULL without transform");
}

TEST(StreamBits, Jpeg2000OfOtherBitsOrSignIsSaid) {
    TestPlanes frame{.columns = edge, .rows = edge, .bits = 10, .planes = {std::vector<int>(edge * edge, 700)}};
    const auto fewer =
        readFrames({"MONOCHROME2", 1, 16, 12}, jpeg2000Syntax, {codedJpeg2000(frame), codedJpeg2000(frame)});
    ASSERT_TRUE(fewer) << fewer.error().sentence();
    EXPECT_EQ(storedValues(*fewer->phases[0])[5], 700);
    EXPECT_TRUE(warnsOf(*fewer, "JPEG 2000 frames hold 10 bits where (0028,0101) Bits Stored says 12."));
    frame.isSigned = true;
    frame.planes[0].assign(edge * edge, 300);
    frame.planes[0][5] = -300;
    const auto study =
        readFrames({"MONOCHROME2", 1, 16, 10}, jpeg2000Syntax, {codedJpeg2000(frame), codedJpeg2000(frame)});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0])[5], 0);
    EXPECT_TRUE(warnsOf(*study, "JPEG 2000 frames hold signed values"));
}

/// A grey ramp of 8 bits and its codestream.
TestImage greyRamp() {
    TestImage image;
    image.columns = image.rows = edge;
    for (int i = 0; i < edge * edge; ++i) image.pixels8.push_back(static_cast<std::uint8_t>(i));
    return image;
}

TEST(StreamBits, FramesOf8BitsAreReadWhere16AreAllocated) {
    const std::vector<std::tuple<TestSyntax, std::string, double>> codings{
        {TestSyntax::jpegBaseline, jpegSyntax, 6},
        {TestSyntax::jpegBaseline, lossyOf12Bits, 6},
        {TestSyntax::jpegLossless, jpegLosslessSyntax, 0},
        {TestSyntax::jpegLossless, jpegLosslessOfAnyKind, 0},
        {TestSyntax::jpegLs, jpegLsSyntax, 0},
        {TestSyntax::rle, rleSyntax, 0}};
    for (const auto& [coding, syntax, tolerance] : codings) {
        const std::string frame = codedFrame(greyRamp(), coding);
        for (const std::uint16_t stored : {8, 12}) {
            const auto study = readFrames({"MONOCHROME2", 1, 16, stored}, syntax, {frame, frame});
            ASSERT_TRUE(study) << syntax << ": " << study.error().sentence();
            EXPECT_EQ(study->phases[0]->typeName(), "uint16");
            const auto values = storedValues(*study->phases[0]);
            for (std::size_t i = 0; i < 2 * edge * edge; ++i)
                EXPECT_NEAR(values[i], static_cast<double>(i % 256), tolerance) << syntax << ", pixel " << i;
            const bool isSaid = warnsOf(*study, "frames hold 8 bits where");
            EXPECT_EQ(isSaid, stored == 12 || coding == TestSyntax::rle) << syntax;
        }
    }
}

TEST(StreamBits, RleOf16BitsIsReadWhere8AreAllocatedIfTheUpperOnesAre0) {
    TestImage image = greyRamp();
    image.bitsAllocated = 16;
    image.pixels16.assign(image.pixels8.begin(), image.pixels8.end());
    image.pixels8.clear();
    std::string frame = codedFrame(image, TestSyntax::rle);
    const auto study = readFrames({"MONOCHROME2", 1}, rleSyntax, {frame, frame});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0])[200], 200);
    image.pixels16[3] = 256;
    image.bitsStored = 16;
    frame = codedFrame(image, TestSyntax::rle);
    const auto refused = readFrames({"MONOCHROME2", 1}, rleSyntax, {frame, frame});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("RLE frame of 16 bits where 8 are allocated"));
}

TEST(StreamBits, SignedValuesBeyondTheStoredBitsBecomeTheNearest) {
    TestImage image;
    image.columns = image.rows = edge;
    image.bitsAllocated = image.bitsStored = 16;
    image.isSigned = true;
    image.pixels16.assign(edge * edge, 100);
    image.pixels16[1] = 5000;
    image.pixels16[2] = static_cast<std::uint16_t>(-3000);
    image.pixels16[3] = static_cast<std::uint16_t>(-5);
    const std::string frame = codedFrame(image, TestSyntax::jpegLossless);
    const auto study = readFrames({"MONOCHROME2", 1, 16, 12, 1}, jpegLosslessSyntax, {frame, frame});
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    EXPECT_EQ((std::vector<double>{values[0], values[1], values[2], values[3]}),
              (std::vector<double>{100, 2047, -2048, -5}));
    EXPECT_TRUE(warnsOf(*study, "do not fit into the 12 signed bits"));
}

}  // namespace
}  // namespace echolucent
