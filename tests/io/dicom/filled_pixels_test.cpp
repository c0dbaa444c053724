// Uncompressed pixels with bytes behind the last one: filling, or a picture of another size.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

constexpr std::uint16_t pictureColumns = 20, pictureRows = 16;
constexpr int pictureFrames = 3;
constexpr std::size_t pictureBytes = std::size_t{pictureColumns} * pictureRows;

/// Pixels that count up from 1.
std::string countedPixels(std::size_t bytes) {
    std::string pixels;
    for (std::size_t i = 0; i < bytes; ++i) pixels += static_cast<char>(1 + i % 200);
    return pixels;
}

Result<Study> readFilled(const std::string& filling) {
    const TemporaryFolder folder;
    DicomBytes file = DicomBytes().text(0x0018, 0x0088, "DS", "1").picture(pictureColumns, pictureRows, pictureFrames);
    file.text(0x0028, 0x0030, "DS", "1\\1")
        .put(0x7fe0, 0x0010, "OB", countedPixels(pictureFrames * pictureBytes) + filling);
    return readStudy(folder.write("a.dcm", file.file(cineClass)), withoutGuess());
}

TEST(FilledPixels, AreReadIfTheFillingIsBlank) {
    for (const std::string& filling :
         {std::string(128, '\0'), std::string(100, '\xff'), std::string(pictureBytes - 2, '\0')}) {
        const auto study = readFilled(filling);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->storedValue(0), 1);
        EXPECT_EQ(study->phases[0]->storedValue(3 * pictureBytes - 1), 1 + (3 * pictureBytes - 1) % 200);
        EXPECT_TRUE(warnsOf(*study, std::to_string(filling.size()) + " bytes of (7fe0,0010) Pixel Data belong to "));
    }
}

TEST(FilledPixels, AreRefusedIfTheSizeOfThePictureIsInDoubt) {
    std::string broken(128, '\0');
    broken[77] = 1;
    for (const std::string& filling :
         {broken, std::string(128, 'a'), std::string(pictureBytes, '\0'), std::string(2 * pictureBytes, '\0'),
          std::string(3 * pictureColumns, '\0'), std::string(6 * pictureRows, '\0')}) {
        const auto study = readFilled(filling);
        ASSERT_FALSE(study) << filling.size();
        EXPECT_THAT(study.error().sentence(), HasSubstr("cannot be told what the picture's size is"));
    }
}

TEST(FilledPixels, OfSlicesAreReadToo) {
    const TemporaryFolder folder;
    for (int number = 0; number < 3; ++number) {
        DicomBytes file;
        file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(number));
        file.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0").picture(pictureColumns, pictureRows, 0);
        file.put(0x7fe0, 0x0010, "OB",
                 std::string(pictureBytes, static_cast<char>(10 + number)) + std::string(192, '\0'));
        folder.write(std::to_string(number), file.file(pictureClass));
    }
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(pictureBytes), 11);
    EXPECT_EQ(study->phases[0]->storedValue(3 * pictureBytes - 1), 12);
    EXPECT_TRUE(warnsOf(*study, "The last 192 bytes of (7fe0,0010) Pixel Data"));
}

}  // namespace
}  // namespace echolucent
