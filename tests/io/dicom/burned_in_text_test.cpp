// Burnt-in text: what DICOM files declare, what silence means, and that other formats have none.
#include <gtest/gtest.h>

#include "dicom_bytes.h"
#include "dicom_images.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// A study of two frames of this SOP class, grey or in a palette, with this Burned In Annotation.
Result<Study> readAnnotated(const std::string& stated, const std::string& sopClass, bool palette = false) {
    const TemporaryFolder folder;
    DicomBytes file;
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", palette ? "PALETTE COLOR" : "MONOCHROME2");
    file.text(0x0028, 0x0008, "IS", "2").word(0x0028, 0x0010, 2).word(0x0028, 0x0011, 4).word(0x0028, 0x0100, 8);
    file.word(0x0028, 0x0101, 8).word(0x0028, 0x0102, 7).word(0x0028, 0x0103, 0);
    if (!stated.empty()) file.text(0x0028, 0x0301, "CS", stated);
    for (const std::uint16_t colour : {1, 2, 3})
        file.put(0x0028, 0x1100 + colour, "US", bytesFrom<std::uint16_t>({2, 0, 8}));
    for (const std::uint16_t colour : {1, 2, 3}) file.put(0x0028, 0x1200 + colour, "OW", std::string(2, '\x20'));
    file.put(0x7fe0, 0x0010, "OW", std::string(16, 'a'));
    return readStudy(folder.write("a.dcm", file.file(sopClass)), framesAsSlices());
}

TEST(BurnedInText, IsWhatACineDeclaresAndUnknownWhereItIsSilent) {
    for (const bool palette : {false, true}) {
        EXPECT_EQ(readAnnotated("YES", cineClass, palette)->burnedInText, BurnedInText::yes);
        EXPECT_EQ(readAnnotated("NO", cineClass, palette)->burnedInText, BurnedInText::no);
        EXPECT_EQ(readAnnotated("", cineClass, palette)->burnedInText, BurnedInText::unknown);
        EXPECT_EQ(readAnnotated("PERHAPS", cineClass, palette)->burnedInText, BurnedInText::unknown);
    }
    const auto silent = readAnnotated("", cineClass);
    EXPECT_EQ(factOf(*silent, "burnt-in text"), "unknown");
    EXPECT_EQ(sourceOf(*silent, "burnt-in text"), "(0028,0301) Burned In Annotation is absent");
    EXPECT_EQ(sourceOf(*readAnnotated("NO", cineClass), "burnt-in text"), "(0028,0301) Burned In Annotation");
}

TEST(BurnedInText, InOneSliceIsInTheStudy) {
    const TemporaryFolder folder;
    TestImage slice = writeThreeSlices(folder);
    auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->burnedInText, BurnedInText::no) << "grey slices in space are no pictures of a screen";
    slice.burnedInAnnotation = "YES";
    slice.instance = 2;
    slice.position = Vec3{0, 0, 1.5};
    writeDicom(folder.file("1.dcm"), slice);
    study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->burnedInText, BurnedInText::yes);
}

TEST(BurnedInText, IsNoneInFormatsThatCannotSay) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("a.mha",
                     "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
                     "ElementDataFile = LOCAL\n12345678");
    const auto study = readStudy(path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->burnedInText, BurnedInText::no);
    EXPECT_EQ(factOf(*study, "burnt-in text"), "none");
}

}  // namespace
}  // namespace echolucent
