// Uncompressed luma and colour differences: their length says how they lie, whatever they are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

struct Ybr {
    std::string photometric = "YBR_FULL_422";
    std::uint16_t columns = 4;
    std::uint16_t rows = 2;
    int frames = 2;
    std::uint16_t planar = 0;
};

Result<Study> readYbr(const Ybr& ybr, const std::string& pixels) {
    const TemporaryFolder folder;
    DicomBytes file;
    file.word(0x0028, 0x0002, 3).text(0x0028, 0x0004, "CS", ybr.photometric).word(0x0028, 0x0006, ybr.planar);
    file.text(0x0028, 0x0008, "IS", std::to_string(ybr.frames)).word(0x0028, 0x0010, ybr.rows);
    file.word(0x0028, 0x0011, ybr.columns).word(0x0028, 0x0100, 8).word(0x0028, 0x0101, 8);
    file.word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    file.put(0x7fe0, 0x0010, "OB", pixels + std::string(pixels.size() % 2, '\0'));
    return readStudy(folder.write("a.dcm", file.file(cineClass)), framesAsSlices());
}

/// The luma of pixel `index`, all different; colour differences are 200 and above.
char lumaOf(std::int64_t index) { return static_cast<char>(20 + 3 * index); }

std::vector<double> lumas(std::int64_t count) {
    std::vector<double> values;
    for (std::int64_t i = 0; i < count; ++i) values.push_back(lumaOf(i));
    return values;
}

std::string full(std::int64_t pixels) {
    std::string bytes;
    for (std::int64_t i = 0; i < pixels; ++i) bytes += {lumaOf(i), '\xc8', '\xd2'};
    return bytes;
}

/// 4:2:2 of rows of this many pixels; an odd one ends with a pair whose second pixel is `filled`.
std::string halvedRows(std::int64_t pixels, std::int64_t columns, char filled) {
    std::string bytes;
    for (std::int64_t i = 0; i < pixels; ++i) {
        const bool alone = i % columns == columns - 1;
        bytes += {lumaOf(i), alone ? filled : lumaOf(i + 1), '\xc8', '\xd2'};
        i += alone ? 0 : 1;
    }
    return bytes;
}

void expectLumas(const Result<Study>& study, std::int64_t count) {
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), lumas(count));
}

TEST(NativeYbr, TheLengthOf444IsReadAsThatWhateverItIsCalled) {
    for (const std::string name : {"YBR_FULL_422", "YBR_FULL"}) {
        const auto study = readYbr({name}, full(16));
        expectLumas(study, 16);
        EXPECT_EQ(warnsOf(*study, "is YBR_FULL_422, but Pixel Data has the length of 4:4:4"), name == "YBR_FULL_422");
    }
    // In planes, as the planar configuration says.
    std::string planes;
    for (int frame = 0; frame < 2; ++frame) {
        for (int i = 0; i < 8; ++i) planes += lumaOf(8 * frame + i);
        planes += std::string(16, '\xc8');
    }
    expectLumas(readYbr({.planar = 1}, planes), 16);
}

TEST(NativeYbr, TheLengthOf422IsReadAsThatWhateverItIsCalled) {
    const std::string halved = halvedRows(16, 4, 0);
    for (const std::string name : {"YBR_FULL_422", "YBR_FULL"}) {
        const auto study = readYbr({name}, halved);
        expectLumas(study, 16);
        EXPECT_EQ(warnsOf(*study, "is YBR_FULL, but Pixel Data has the length of 4:2:2"), name == "YBR_FULL");
    }
    const auto planar = readYbr({.planar = 1}, halved);
    expectLumas(planar, 16);
    EXPECT_TRUE(warnsOf(*planar, "Planar Configuration is 1, which 4:2:2 cannot have"));
    // Two of three frames are left, as far as anybody can tell.
    const auto lost = readYbr({.photometric = "YBR_FULL", .frames = 3}, halvedRows(24, 4, 0));
    ASSERT_FALSE(lost);
    EXPECT_THAT(lost.error().sentence(), HasSubstr("holds 48 bytes where 4 x 2 pixels in 3 frame(s) need 72"));
}

TEST(NativeYbr, RowsOfAnOddNumberOfPixelsMayEndWithHalfAPair) {
    const auto study = readYbr({.columns = 5}, halvedRows(20, 5, '\x7b'));
    expectLumas(study, 20);
    EXPECT_TRUE(warnsOf(*study, "4:2:2 with rows that end in half a pair"));
    // Or the pairs go on across the ends of rows.
    const auto across = readYbr({.columns = 5}, halvedRows(20, 20, 0));
    expectLumas(across, 20);
    EXPECT_FALSE(warnsOf(*across, "half a pair"));
    expectLumas(readYbr({.columns = 5}, full(20)), 20);
}

TEST(NativeYbr, LumaFrom16To235IsStretched) {
    std::string pixels = halvedRows(16, 4, 0);
    pixels[0] = 16;
    pixels[1] = '\xeb';
    pixels[4] = 4;
    const auto study = readYbr({"YBR_PARTIAL_422"}, pixels);
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    EXPECT_EQ(values[0], 0);
    EXPECT_EQ(values[1], 255);
    EXPECT_EQ(values[2], 0);
    EXPECT_TRUE(warnsOf(*study, "YBR_PARTIAL_422 has luma from 16 to 235"));
    EXPECT_TRUE(readYbr({"YBR_PARTIAL_420"}, full(16)));
    EXPECT_TRUE(readYbr({"YBR_PARTIAL_420"}, halvedRows(16, 4, 0)));
    const auto quarter = readYbr({"YBR_PARTIAL_420"}, std::string(24, 'a'));
    ASSERT_FALSE(quarter);
    EXPECT_THAT(quarter.error().sentence(), HasSubstr("holds 24 bytes"));
}

/// The palettes of three colours, and how they are stored.
struct Palette {
    std::vector<std::uint16_t> descriptor{4, 0, 16};
    std::vector<std::uint16_t> red{}, green{}, blue{};
    std::string vr = "OW";
    std::string descriptorVr = "US";
};

Result<Study> readPalette(const Palette& palette, std::uint16_t bits = 8, std::uint16_t sign = 0,
                          std::vector<std::uint16_t> pixels = {0, 1, 2, 3}) {
    const TemporaryFolder folder;
    DicomBytes file;
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "PALETTE COLOR").text(0x0028, 0x0008, "IS", "2");
    file.word(0x0028, 0x0010, 1).word(0x0028, 0x0011, 2).word(0x0028, 0x0100, bits).word(0x0028, 0x0101, bits);
    file.word(0x0028, 0x0102, static_cast<std::uint16_t>(bits - 1)).word(0x0028, 0x0103, sign);
    for (const std::uint16_t i : {1, 2, 3})
        file.put(0x0028, 0x1100 + i, palette.descriptorVr, bytesFrom<std::uint16_t>(palette.descriptor));
    file.put(0x0028, 0x1201, palette.vr, bytesFrom<std::uint16_t>(palette.red));
    file.put(0x0028, 0x1202, palette.vr, bytesFrom<std::uint16_t>(palette.green));
    file.put(0x0028, 0x1203, palette.vr, bytesFrom<std::uint16_t>(palette.blue));
    std::string bytes;
    for (const std::uint16_t pixel : pixels) {
        bytes += static_cast<char>(pixel);
        if (bits == 16) bytes += static_cast<char>(pixel >> 8);
    }
    file.put(0x7fe0, 0x0010, "OW", bytes);
    return readStudy(folder.write("a.dcm", file.file(cineClass)), framesAsSlices());
}

void expectGrey(const Result<Study>& study, const std::vector<double>& values) {
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), values);
}

TEST(DicomPalettes, EightOr16BitsAreDecidedOnceForAllColours) {
    // A palette of 16 bits whose green and blue are too dark to show.
    Palette palette{.red = {0, 100 << 8, 200 << 8, 0xffff}, .green = {0, 100, 200, 255}, .blue = {0, 90, 180, 250}};
    expectGrey(readPalette(palette), {0, 30, 60, 76});
    EXPECT_FALSE(warnsOf(*readPalette(palette), "taken as 8 bits"));
    // All three hold 8 bits in 16.
    palette.red = {0, 100, 200, 255};
    expectGrey(readPalette(palette), {0, 99, 198, 254});
    EXPECT_TRUE(warnsOf(*readPalette(palette), "declares 16 bits, but none of its colours exceeds 255"));
    // In the upper bytes of words that are declared as 8 bits.
    for (auto* colour : {&palette.red, &palette.green, &palette.blue})
        for (std::uint16_t& value : *colour) value = static_cast<std::uint16_t>(value << 8);
    palette.descriptor[2] = 8;
    expectGrey(readPalette(palette), {0, 99, 198, 254});
    // Two entries in a word, of some colours only.
    palette.descriptor[2] = 16;
    palette.red = {100 << 8, 200 | 255 << 8};
    expectGrey(readPalette(palette), {0, 99, 198, 254});
    // 12 bits, as declared.
    palette = {.descriptor = {4, 0, 12}, .red = {0, 1600, 3200, 4095}};
    palette.green = palette.blue = palette.red;
    expectGrey(readPalette(palette), {0, 100, 200, 255});
}

TEST(DicomPalettes, TheFirstPixelValueHasThePixelsSign) {
    Palette palette{.descriptor = {4, 65534, 16}, .red = {0, 1 << 8, 2 << 8, 3 << 8}};
    palette.green = palette.blue = palette.red;
    const std::vector<std::uint16_t> pixels{65534, 65535, 0, 1};
    expectGrey(readPalette(palette, 16, 1, pixels), {0, 1, 2, 3});
    // The numbers of the descriptor stand with a sign beside unsigned pixels.
    palette.descriptor = {4, 65532, 16};
    palette.descriptorVr = "SS";
    expectGrey(readPalette(palette, 16, 0, {65532, 65533, 65534, 65535}), {0, 1, 2, 3});
}

TEST(DicomPalettes, EntriesStoredAsBytesAreRead) {
    Palette palette{.red = {0, 100 << 8, 200 << 8, 0xffff}, .vr = "OB"};
    palette.green = palette.blue = palette.red;
    expectGrey(readPalette(palette), {0, 100, 200, 255});
    palette.vr = "UN";
    expectGrey(readPalette(palette), {0, 100, 200, 255});
}

}  // namespace
}  // namespace echolucent
