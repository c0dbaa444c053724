#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include <numeric>

#include "io/document/curve_file.h"
#include "io/writers/picture_file.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(CurveFile, GivesBackTheSameNumbers) {
    const TemporaryFolder folder;
    const ManualCurve curve{{{0.0, 1.0 / 3.0}, {0.1, 0.2}, {0.1, 0.7}, {1.0, 1.0}}};
    ASSERT_TRUE(writeCurve(folder.file("c.json"), curve));
    const auto read = readCurve(folder.file("c.json"));
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(*read, curve);
}

TEST(CurveFile, IgnoresUnknownKeys) {
    const TemporaryFolder folder;
    const auto read =
        readCurve(folder.write("c.json", R"({"format": "echolucent-opacity-curve", "version": 1, "by": "me",
        "nodes": [{"intensity": 0.5, "opacity": 1, "colour": "red"}]})"));
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->nodes, (std::vector<CurveNode>{{0.5, 1.0}}));
}

TEST(CurveFile, EveryMistakeIsNamed) {
    const TemporaryFolder folder;
    const auto sentenceOf = [&](const std::string& text) {
        const auto read = readCurve(folder.write("c.json", text));
        return read ? std::string("was read") : read.error().sentence();
    };
    const auto nodes = [&](const std::string& list) {
        return sentenceOf(R"({"format": "echolucent-opacity-curve", "version": 1, "nodes": )" + list + "}");
    };
    EXPECT_THAT(sentenceOf("{\n\"format\":\n]"), HasSubstr("line 3"));
    EXPECT_THAT(sentenceOf(""), HasSubstr("line 1"));
    EXPECT_THAT(sentenceOf("[]"), HasSubstr("JSON object"));
    EXPECT_THAT(sentenceOf("{}"), HasSubstr("format must be"));
    EXPECT_THAT(sentenceOf(R"({"format": 7})"), HasSubstr("format must be"));
    EXPECT_THAT(sentenceOf(R"({"format": "echolucent-opacity-curve", "version": 2})"), HasSubstr("version must be 1"));
    EXPECT_THAT(nodes("[]"), HasSubstr("nodes must be a list"));
    EXPECT_THAT(nodes("{}"), HasSubstr("nodes must be a list"));
    EXPECT_THAT(nodes("[3]"), HasSubstr("nodes[0] must be a JSON object"));
    EXPECT_THAT(nodes(R"([{"intensity": 0.5}])"), HasSubstr("nodes[0].opacity is missing"));
    EXPECT_THAT(nodes(R"([{"intensity": "a", "opacity": 0}])"), HasSubstr("nodes[0].intensity must be a number"));
    EXPECT_THAT(nodes(R"([{"intensity": 1.5, "opacity": 0}])"),
                HasSubstr("nodes[0].intensity must be 0 to 1, not 1.5"));
    EXPECT_THAT(nodes(R"([{"intensity": 0.5, "opacity": -0.1}])"),
                HasSubstr("nodes[0].opacity must be 0 to 1, not -0.1"));
    EXPECT_THAT(nodes(R"([{"intensity": 0.5, "opacity": 1e999}])"), HasSubstr("number too large"));
    EXPECT_THAT(nodes(R"([{"intensity": 0.5, "opacity": 0}, {"intensity": 0.4, "opacity": 0}])"),
                HasSubstr("nodes[1].intensity must not be below"));
    EXPECT_THAT(readCurve(folder.file("none.json")).error().sentence(),
                AllOf(HasSubstr("none.json"), HasSubstr("could not be opened: it does not exist")));
}

TEST(PictureFile, PngHoldsThePixels) {
    const TemporaryFolder folder;
    constexpr int width = 7;
    constexpr int height = 3;
    std::vector<std::uint8_t> rgb(width * height * 3);
    std::iota(rgb.begin(), rgb.end(), std::uint8_t{40});
    ASSERT_TRUE(writePng(folder.file("p.png"), width, height, rgb));
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&image, folder.file("p.png").c_str()), 0);
    EXPECT_EQ(image.width, 7U);
    EXPECT_EQ(image.height, 3U);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
    EXPECT_EQ(read, rgb);
}

TEST(PictureFile, APaletteGivesTheSamePixelsInFewerBytes) {
    const std::vector<std::uint8_t> palette{10, 20, 30, 200, 100, 50, 255, 255, 255};
    std::vector<std::uint8_t> indices, rgb;
    for (std::size_t i = 0; i < 64 * 32; ++i) {
        indices.push_back(static_cast<std::uint8_t>((i + i / 5) % 3));
        for (std::size_t channel = 0; channel < 3; ++channel) rgb.push_back(palette[indices.back() * 3u + channel]);
    }
    const std::string bytes = palettePngBytes(64, 32, indices, palette);
    EXPECT_LT(bytes.size(), pngBytes(64, 32, rgb).size());
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
    EXPECT_EQ(read, rgb);
    EXPECT_THROW((void)palettePngBytes(64, 32, indices, std::span(palette).first(6)), std::invalid_argument)
        << "a place outside the palette";
    EXPECT_THROW((void)palettePngBytes(64, 31, indices, palette), std::invalid_argument);
}

TEST(PictureFile, RefusesWhatDoesNotFit) {
    EXPECT_THROW((void)writePng("p.png", 2, 2, std::vector<std::uint8_t>(11)), std::invalid_argument);
    const auto written = writePng("/nonexistent-folder/p.png", 1, 1, std::vector<std::uint8_t>(3));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
}

}  // namespace
}  // namespace echolucent
