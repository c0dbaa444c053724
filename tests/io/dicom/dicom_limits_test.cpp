// Numbers that are too large, no numbers, or too many: each is refused in a sentence, and in time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom_images.h"
#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/study/slice_stack.h"
#include "io/study/study_assembly.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

TEST(DicomLimits, ValuesThatAreNoNumbersOrHugeNeverBecomeAVolume) {
    for (const char* text : {"nan\\0.5", "inf\\inf", "1e308\\1e308", "1e-320\\1e-320"}) {
        const TemporaryFolder folder;
        for (int i = 0; i < 2; ++i) {
            TestImage image = sliceAt({0, 0, 1.0 * i});
            image.pixelSpacingText = text;
            writeDicom(folder.file("s" + std::to_string(i)), image);
        }
        const auto study = readStudy(folder.path());
        if (!study)
            EXPECT_THAT(study.error().sentence(), HasSubstr("(0028,0030)")) << text;
        else
            EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << text;
    }
}

TEST(DicomLimits, TimesThatAreTooFarApartAreUnknown) {
    const TemporaryFolder folder;
    TestImage image = cineOf(4);
    for (const double seconds : {-1.5e308, 1.5e308})
        for (const double depth : {0.0, 1.0}) image.functionalGroups.push_back({{0, 0, depth}, seconds, ""});
    writeDicom(folder.file("v"), image);
    const auto study = readStudy(folder.file("v"), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 2u);
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
}

TEST(SliceStacks, PositionsThatAreNoNumbersAreRefused) {
    for (const double bad : {noNumber, infinite, -infinite, 1e308})
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<SlicePlane> planes(3);
            for (std::size_t i = 0; i < planes.size(); ++i) planes[i].position = Vec3(0, 0, static_cast<double>(i));
            planes[1].position[axis] = bad;
            const auto stack = stackSlices("a file", "a tag", planes);
            ASSERT_FALSE(stack) << bad << " along " << axis;
            EXPECT_THAT(stack.error().sentence(), AllOf(HasSubstr("a file"), HasSubstr("a tag")));
        }
}

TEST(StudyAssembly, AGeometryThatIsNoNumberIsRefused) {
    for (const double bad : {noNumber, infinite, -1.0, 0.0})
        for (int axis = 0; axis < 3; ++axis)
            for (const bool ofSpacing : {true, false}) {
                if (!ofSpacing && std::isfinite(bad)) continue;
                StudyParts parts;
                parts.path = "a file";
                parts.spacingSource = "a tag";
                parts.geometry.size = {2, 1, 1};
                parts.voxels.phases.emplace_back(std::vector<std::uint8_t>{1, 2});
                (ofSpacing ? parts.geometry.spacing : parts.geometry.origin)[axis] = bad;
                const auto study = assembleStudy(parts, {}, {});
                ASSERT_FALSE(study) << bad << " along " << axis;
                EXPECT_THAT(study.error().sentence(), HasSubstr("a file"));
            }
}

double secondsOf(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The bound is far above what a linear reader needs, even under a sanitizer, and far below what a quadratic one takes
/// (10 s for half of the values that took 40).
constexpr double inTime = 5.0;

TEST(DicomLimits, AsManyFrameOffsetsAsFramesAreReadInTime) {
    constexpr int frames = 100000;  // as long for its pixels of 0.25 mm as a volume may be
    const TemporaryFolder folder;
    TestImage image = cineOf(frames);
    image.columns = image.rows = 1;
    image.pixels8.assign(frames, 7);
    for (int i = 0; i < frames; ++i) image.gridOffsets.push_back(0.25 * i);
    writeDicom(folder.file("v"), image, TestSyntax::implicitLittle);
    EXPECT_LT(secondsOf([&] {
                  const auto study = readStudy(folder.file("v"), withoutGuess());
                  ASSERT_TRUE(study) << study.error().sentence();
                  EXPECT_EQ(study->phases[0]->geometry().size[2], frames);
                  EXPECT_EQ(study->phases[0]->geometry().spacing[2], 0.25);
              }),
              inTime);
}

TEST(DicomLimits, CancelEndsScanAndParsing) {
    const TemporaryFolder folder;
    writeDicom(folder.file("v"), cineOf(2));
    std::atomic<bool> cancel{true};
    const Progress progress{{}, &cancel};
    const auto scan = scanDicom(*InputFile::open(folder.file("v")), progress);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().kind, FailureKind::cancelled);
    const auto file = DicomFile::load(folder.file("v"), false, progress);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().kind, FailureKind::cancelled);
}

TEST(DicomLimits, LookingAtBytesOfAMebibyteAndMoreDoesNotLoseThem) {
    constexpr DicomTag description{0x0008, 0x103e};
    for (const unsigned long bytes : {16UL, (1UL << 20) + 2}) {
        DcmDataset dataset;
        const std::vector<Uint8> letters(bytes, 'x');
        auto* element = new DcmOtherByteOtherWord(DcmTag(description.group, description.element, DcmVR(EVR_UN)));
        ASSERT_TRUE(element->putUint8Array(letters.data(), bytes).good());
        ASSERT_TRUE(dataset.insert(element).good());
        EXPECT_TRUE(dicomHas(dataset, description));
        EXPECT_EQ(dicomText(dataset, description), bytes == 16 ? std::string(16, 'x') : "")
            << "longer ones are missing";
        DcmElement* after = nullptr;
        ASSERT_TRUE(dataset.findAndGetElement(DcmTagKey(description.group, description.element), after).good());
        EXPECT_EQ(after->getLength(), bytes);
    }
}

}  // namespace
}  // namespace echolucent
