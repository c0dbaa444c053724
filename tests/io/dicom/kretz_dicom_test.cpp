#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_files.h"
#include "kretz_files.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// A single picture with a private block in group 7FE1 that begins at `block`.
std::string pictureWith(const TemporaryFolder& folder, const std::string& creator, Uint16 block,
                        const std::string& value, const DcmEVR vr = EVR_OB,
                        E_TransferSyntax syntax = EXS_LittleEndianExplicit) {
    TestImage image;
    image.pixels8.assign(12, 7);
    const std::string path = folder.file("v.dcm");
    writeDicom(path, image);
    DcmFileFormat file;
    if (file.loadFile(path.c_str()).bad()) return {};
    file.loadAllDataIntoMemory();
    DcmDataset& dataset = *file.getDataset();
    dataset.putAndInsertString(DcmTag(0x7FE1, block, EVR_LO), creator.c_str());
    std::string even = value + std::string(value.size() % 2, '\0');
    auto* element = new DcmOtherByteOtherWord(DcmTag(0x7FE1, static_cast<Uint16>(block << 8 | 1), vr));
    element->putUint8Array(reinterpret_cast<const Uint8*>(even.data()), static_cast<unsigned long>(even.size()));
    dataset.insert(element);
    if (file.saveFile(path.c_str(), syntax).bad()) return {};
    return path;
}

TEST(KretzDicom, VolumeInAPrivateElementIsRead) {
    const TemporaryFolder folder;
    for (const Uint16 block : {0x10, 0x11, 0xFF})
        for (const E_TransferSyntax syntax :
             {EXS_LittleEndianExplicit, EXS_LittleEndianImplicit, EXS_DeflatedLittleEndianExplicit}) {
            const auto study = readStudy(pictureWith(folder, "KRETZ_US", block, KretzParts().bytes(), EVR_OB, syntax));
            ASSERT_TRUE(study) << study.error().sentence() << " " << block << " " << syntax;
            EXPECT_EQ(factOf(*study, "polar volume"), "wobbler: 20 samples x 5 lines x 4 planes");
            EXPECT_EQ(study->facts.front().name, "format");
            EXPECT_THAT(study->facts.front().source, HasSubstr("KRETZFILE 1.0 in (7fe1,"));
        }
}

// The filler byte of an odd length is no beginning of an item.
TEST(KretzDicom, FillerByteIsPassedOver) {
    const TemporaryFolder folder;
    KretzParts parts;
    parts.end = kretzItem(0x0110, 3, "x");
    ASSERT_EQ(parts.bytes().size() % 2, 1U);
    EXPECT_TRUE(readStudy(pictureWith(folder, "KRETZ_US", 0x11, parts.bytes())));
}

TEST(KretzDicom, DamageIsToldWithTheFileAndTheItem) {
    const TemporaryFolder folder;
    KretzParts parts;
    parts.lineAngles = "";
    const auto study = readStudy(pictureWith(folder, "KRETZ_US", 0x11, parts.bytes()));
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("v.dcm: C300:0002 is missing"));
}

TEST(KretzDicom, OtherPrivateElementsAreNoVolume) {
    const TemporaryFolder folder;
    for (const auto& path : {pictureWith(folder, "OTHER", 0x11, KretzParts().bytes()),
                             pictureWith(folder, "KRETZ_US", 0x11, "settings of the scanner"),
                             pictureWith(folder, "KRETZ_US", 0x11, "K")}) {
        const auto study = readStudy(path);
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), testing::Not(HasSubstr("Kretz")));
    }
}

}  // namespace
}  // namespace echolucent
