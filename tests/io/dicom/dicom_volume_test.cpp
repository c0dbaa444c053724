// Slices and frames are put in their places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "dicom_images.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// A slice of 4 x 3 whose pixels all hold `value`.
TestImage valuedSlice(int value, const Vec3& position) {
    TestImage image = sliceAt(position);
    image.pixels8.assign(12, static_cast<std::uint8_t>(value));
    image.instance = 100 - value;
    return image;
}

/// Writes slices under names in an order that has nothing to do with their place.
void writeShuffled(const TemporaryFolder& folder, const std::vector<TestImage>& slices) {
    std::vector<int> names(slices.size());
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = static_cast<int>(i);
    std::shuffle(names.begin(), names.end(), std::mt19937(5));
    for (std::size_t i = 0; i < slices.size(); ++i) writeDicom(folder.file("IM" + std::to_string(names[i])), slices[i]);
}

TEST(DicomFolder, SlicesAreSortedByPosition) {
    const TemporaryFolder folder;
    std::vector<TestImage> slices;
    for (int i = 0; i < 7; ++i) slices.push_back(valuedSlice(10 + i, {-5, 6, 2.0 * i - 3}));
    writeShuffled(folder, slices);
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    EXPECT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{4, 3, 7}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.25, 0.5, 2));
    EXPECT_EQ(volume.geometry().patientFromVoxel({0, 0, 0}), Vec3(-5, 6, -3));
    EXPECT_EQ(volume.geometry().patientFromVoxel({2, 2, 1}), Vec3(-4.5, 7, -1));
    EXPECT_TRUE(volume.geometry().patientFrameKnown);
    for (int z = 0; z < 7; ++z) EXPECT_EQ(volume.storedValue(volume.geometry().offset(3, 2, z)), 10 + z);
    EXPECT_THAT(factOf(*study, "format"), HasSubstr("7 slices"));
}

TEST(DicomFolder, ObliqueOrientationIsKept) {
    const TemporaryFolder folder;
    const Mat3 turn = rotationX(25) * rotationY(-40);
    const Vec3 row = turn * Vec3(1, 0, 0);
    const Vec3 column = turn * Vec3(0, 1, 0);
    const Vec3 normal = turn * Vec3(0, 0, 1);
    std::vector<TestImage> slices;
    for (int i = 0; i < 5; ++i) {
        slices.push_back(valuedSlice(50 + i, Vec3(10, 20, 30) + normal * (1.5 * i)));
        slices.back().orientation = {row[0], row[1], row[2], column[0], column[1], column[2]};
    }
    writeShuffled(folder, slices);
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_NEAR(geometry.spacing[2], 1.5, 1e-6);
    const Vec3 expected = Vec3(10, 20, 30) + row * (0.25 * 3) + column * (0.5 * 2) + normal * (1.5 * 4);
    EXPECT_LT(length(geometry.patientFromVoxel({3, 2, 4}) - expected), 1e-6);
    EXPECT_EQ(study->phases[0]->storedValue(geometry.offset(0, 0, 4)), 54);
    EXPECT_NEAR(cv::determinant(geometry.direction), 1, 1e-9);
}

TEST(DicomFolder, TheSeriesWithMostSlicesIsRead) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("below"));
    for (int i = 0; i < 3; ++i)
        writeDicom(folder.file("below/a" + std::to_string(i)), valuedSlice(1 + i, {0, 0, 1.0 * i}));
    for (int i = 0; i < 2; ++i) {
        TestImage other = valuedSlice(9, {0, 0, 1.0 * i});
        other.series = "1.2.9";
        writeDicom(folder.file("b" + std::to_string(i)), other);
    }
    folder.write("notes.txt", "not DICOM at all, and long enough to be looked at twice over");
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 3);
    EXPECT_EQ(study->phases[0]->storedValue(0), 1);
    EXPECT_TRUE(warnsOf(*study, "2 series"));
}

struct FolderRow {
    std::vector<double> depths;
    std::string words;
};

TEST(DicomFolder, UnevenAndDoubleSlicesAreRefused) {
    const std::vector<FolderRow> rows{{{0, 1, 2, 4, 5}, "between 1 and 2 mm apart"},
                                      {{0, 1, 1, 2}, "is the same for two slices"},
                                      {{0, 0}, "is the same for two slices"}};
    for (const FolderRow& row : rows) {
        const TemporaryFolder folder;
        std::vector<TestImage> slices;
        for (const double depth : row.depths)
            slices.push_back(valuedSlice(static_cast<int>(slices.size()) + 1, {0, 0, depth}));
        writeShuffled(folder, slices);
        const auto study = readStudy(folder.path());
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), HasSubstr(row.words));
        EXPECT_THAT(study.error().sentence(), HasSubstr("(0020,0032) Image Position"));
    }
}

TEST(DicomFolder, ARefusalNamesTheFileConcerned) {
    const auto refusalOf = [](const std::vector<TestImage>& slices) {
        const TemporaryFolder folder;
        for (std::size_t i = 0; i < slices.size(); ++i) writeDicom(folder.file("IM" + std::to_string(i)), slices[i]);
        return std::filesystem::path(readStudy(folder.path()).error().file).filename().string();
    };
    auto at = [value = 0](double depth) mutable {
        TestImage slice = valuedSlice(++value, {0, 0, depth});
        slice.instance = 1;
        return slice;
    };
    EXPECT_EQ(refusalOf({at(0), at(1), at(2), at(4), at(5)}), "IM3");  // the slice behind the gap
    EXPECT_EQ(refusalOf({at(0), at(1), at(2), at(2), at(3)}), "IM3");
    TestImage turned = at(2);
    turned.orientation = {0, 1, 0, -1, 0, 0};
    EXPECT_EQ(refusalOf({at(0), at(1), turned}), "IM2");
    EXPECT_EQ(refusalOf({at(0), at(1), at(1e9)}), "IM2");
}

TEST(DicomFolder, SlightlyUnevenSlicesAreReadWithAWarning) {
    const TemporaryFolder folder;
    writeShuffled(folder, {valuedSlice(1, {0, 0, 0}), valuedSlice(2, {0, 0, 1.04}), valuedSlice(3, {0, 0, 2})});
    const auto study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().spacing[2], 1);
    EXPECT_TRUE(warnsOf(*study, "between 0.96 and 1.04 mm apart"));
}

TEST(DicomFolder, SlicesThatAreNotParallelAreRefused) {
    const TemporaryFolder folder;
    TestImage turned = valuedSlice(2, {0, 0, 1});
    turned.orientation = {0, 1, 0, -1, 0, 0};
    writeShuffled(folder, {valuedSlice(1, {0, 0, 0}), turned});
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("not parallel"));
}

TEST(DicomFolder, PicturesWithoutPositionAreSlicesOnlyWhenAsked) {
    const TemporaryFolder folder;
    for (int i = 0; i < 4; ++i) {
        TestImage image = valuedSlice(i + 1, {0, 0, 0});
        image.position.reset();
        image.orientation.reset();
        image.instance = i;
        writeDicom(folder.file("z" + std::to_string(9 - i)), image);
    }
    const auto refused = readStudy(folder.path());
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().framesCouldBeSlices);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("--frames-as-slices"));
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    const auto study = readStudy(folder.path(), options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    for (int z = 0; z < 4; ++z) EXPECT_EQ(study->phases[0]->storedValue(12 * z), z + 1);
}

TEST(DicomFolder, WithoutPixelSpacingItIsUnknown) {
    const TemporaryFolder folder;
    std::vector<TestImage> slices{valuedSlice(1, {0, 0, 0}), valuedSlice(2, {0, 0, 3})};
    for (TestImage& image : slices) image.pixelSpacing.reset();
    writeShuffled(folder, slices);
    const auto study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(3, 3, 3));
}

TEST(DicomFolder, UnreadableSlicesAreMentioned) {
    const TemporaryFolder folder;
    writeShuffled(folder, {valuedSlice(1, {0, 0, 0}), valuedSlice(2, {0, 0, 1}), valuedSlice(3, {0, 0, 2})});
    std::ifstream stream(folder.file("IM0"), std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(stream)), {});
    folder.write("cut.dcm", whole.substr(0, whole.size() - 5));
    const auto study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 3);
    EXPECT_TRUE(warnsOf(*study, "1 damaged file(s) were left out: \"cut.dcm\""));
}

/// An Enhanced US Volume of 4 x 3 pixels; frame f holds the value 10 + f everywhere.
TestImage enhanced(const std::vector<TestFrame>& frames) {
    TestImage image;
    image.frames = static_cast<int>(frames.size());
    image.functionalGroups = frames;
    image.pixelSpacing = {0.5, 0.25};
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
        image.pixels8.insert(image.pixels8.end(), 12, static_cast<std::uint8_t>(10 + frame));
    return image;
}

TEST(DicomMultiframe, FunctionalGroupsPlaceTheFrames) {
    for (const bool patient : {false, true}) {
        TestImage image = enhanced({{{1, 2, 7}, {}, ""}, {{1, 2, 3}, {}, ""}, {{1, 2, 5}, {}, ""}});
        image.patientFrame = patient;
        const auto study = writtenAndRead(image);
        ASSERT_TRUE(study) << study.error().sentence();
        const Volume& volume = *study->phases[0];
        EXPECT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{4, 3, 3}));
        EXPECT_EQ(volume.geometry().spacing, Vec3(0.25, 0.5, 2));
        EXPECT_EQ(volume.geometry().origin, Vec3(1, 2, 3));
        EXPECT_EQ(volume.geometry().patientFrameKnown, patient);
        EXPECT_TRUE(volume.geometry().spacingKnown);
        EXPECT_EQ(volume.storedValue(0), 11);
        EXPECT_EQ(volume.storedValue(12), 12);
        EXPECT_EQ(volume.storedValue(24), 10);
    }
}

TEST(DicomMultiframe, TemporalPositionsSplitPhasesWhateverTheFileOrder) {
    const auto study = writtenAndRead(enhanced({{{0, 0, 1}, 0.08, ""},
                                                {{0, 0, 0}, 0.00, ""},
                                                {{0, 0, 0}, 0.08, ""},
                                                {{0, 0, 1}, 0.00, ""},
                                                {{0, 0, 1}, 0.04, ""},
                                                {{0, 0, 0}, 0.04, ""}}));
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 3U);
    EXPECT_NEAR(study->phaseTimes.meanSeconds.value_or(0), 0.04, 1e-12);
    const std::vector<std::pair<int, int>> expected{{11, 13}, {15, 14}, {12, 10}};
    for (std::size_t phase = 0; phase < 3; ++phase) {
        EXPECT_EQ(study->phases[phase]->storedValue(0), expected[phase].first);
        EXPECT_EQ(study->phases[phase]->storedValue(12), expected[phase].second);
    }
}

TEST(DicomMultiframe, OnlyTissueIsReadWhereFlowIsThereToo) {
    const auto study = writtenAndRead(enhanced({{{0, 0, 0}, {}, "FLOW_VELOCITY"},
                                                {{0, 0, 0}, {}, "TISSUE_INTENSITY"},
                                                {{0, 0, 1}, {}, "FLOW_VELOCITY"},
                                                {{0, 0, 1}, {}, "TISSUE_INTENSITY"}}));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size[2], 2);
    EXPECT_EQ(study->phases[0]->storedValue(0), 11);
    EXPECT_EQ(study->phases[0]->storedValue(12), 13);
    EXPECT_TRUE(warnsOf(*study, "TISSUE_INTENSITY"));
}

TEST(DicomMultiframe, IncompletePhasesAreRefused) {
    const auto study = writtenAndRead(enhanced({{{0, 0, 0}, 0.0, ""}, {{0, 0, 1}, 0.0, ""}, {{0, 0, 0}, 1.0, ""}}));
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("2 slices at one time and 1 at another"));
}

TEST(DicomMultiframe, ClassicSpacingPlacesTheFrames) {
    TestImage image = enhanced({{}, {}, {}});
    image.functionalGroups.clear();
    image.spacingBetweenSlices = 1.5;
    auto study = writtenAndRead(image);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.25, 0.5, 1.5));

    image.spacingBetweenSlices.reset();
    image.gridOffsets = {0, -2, -4};
    image.position = Vec3(1, 1, 10);
    image.orientation = {1, 0, 0, 0, 1, 0};
    study = writtenAndRead(image);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().origin, Vec3(1, 1, 6));
    EXPECT_EQ(study->phases[0]->storedValue(0), 12);
}

TEST(DicomMultiframe, ACineIsRefusedUnlessItsFramesAreTakenAsSlices) {
    TestImage image = enhanced({{}, {}, {}});
    image.functionalGroups.clear();
    image.spacingBetweenSlices = 1.5;
    image.frameTime = true;  // frames follow each other in time, whatever else is said
    const auto refused = writtenAndRead(image);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().framesCouldBeSlices);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("2D cine of 3 frames without volume geometry"));
    EXPECT_THAT(refused.error().sentence(), HasSubstr("--frames-as-slices"));
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    const auto study = writtenAndRead(image, options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{4, 3, 3}));
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_TRUE(warnsOf(*study, "no true volume"));
}

TEST(DicomMultiframe, OnePlaneOverTimeIsACine) {
    const auto study = writtenAndRead(enhanced({{{0, 0, 0}, 0.0, ""}, {{0, 0, 0}, 1.0, ""}}));
    ASSERT_FALSE(study);
    EXPECT_TRUE(study.error().framesCouldBeSlices);
}

TEST(DicomMultiframe, ASinglePictureIsNoVolume) {
    const auto study = writtenAndRead(valuedSlice(7, {0, 0, 0}));
    ASSERT_FALSE(study);
    EXPECT_FALSE(study.error().framesCouldBeSlices);
    EXPECT_THAT(study.error().sentence(), HasSubstr("single 2D picture"));
}

TEST(DicomNesting, DeepSequencesAreRefusedBeforeTheyAreParsed) {
    const TemporaryFolder folder;
    for (const bool implicitVr : {false, true})
        for (const int depth : {65, 1000, 200000}) {
            const auto study = readStudy(folder.write("n.dcm", nestedDicom(depth, implicitVr)));
            ASSERT_FALSE(study);
            EXPECT_THAT(study.error().sentence(), HasSubstr("nested more than 64 deep")) << depth << implicitVr;
        }
    const auto allowed = readStudy(folder.write("n.dcm", nestedDicom(60, false)));
    ASSERT_FALSE(allowed);
    EXPECT_THAT(allowed.error().sentence(), HasSubstr("Pixel Data is absent"));
}

}  // namespace
}  // namespace echolucent
