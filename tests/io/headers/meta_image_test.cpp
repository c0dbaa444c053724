#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "io/writers/meta_image_writer.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// 2 x 3 x 2 voxels with the values 1 to 12.
template <typename T>
std::vector<T> twelve() {
    std::vector<T> values(12);
    std::iota(values.begin(), values.end(), T{1});
    return values;
}
const std::vector<double> twelveDoubles{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

std::string header(const std::string& type, const std::string& more, const std::string& dataFile = "LOCAL") {
    return "ObjectType = Image\nNDims = 3\nDimSize = 2 3 2\nElementSpacing = 0.5 0.25 2\nElementType = " + type + "\n" +
           more + "ElementDataFile = " + dataFile + "\n";
}

struct MetaImageTypeRow {
    const char* name;
    std::function<std::string(bool)> bytes;
    const char* kept;
};

class MetaImageTypes : public testing::TestWithParam<std::tuple<MetaImageTypeRow, bool>> {};

TEST_P(MetaImageTypes, KeepTheirValuesInBothByteOrders) {
    const auto& [row, big] = GetParam();
    const TemporaryFolder folder;
    const std::string order = std::string("BinaryDataByteOrderMSB = ") + (big ? "True\n" : "False\n");
    const auto study = readStudy(folder.write("v.mha", header(row.name, order) + row.bytes(big)), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases.at(0);
    EXPECT_EQ(storedValues(volume), twelveDoubles);
    EXPECT_EQ(volume.typeName(), row.kept);
    EXPECT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{2, 3, 2}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.5, 0.25, 2));
    EXPECT_TRUE(volume.geometry().spacingKnown);
    EXPECT_EQ(volume.whiteLevel(), volume.typeName() == "uint8" ? 255 : 12);
}

template <typename T>
MetaImageTypeRow metaImageType(const char* name, const char* kept) {
    return {name, [](bool big) { return bytesFrom(twelve<T>(), big); }, kept};
}

INSTANTIATE_TEST_SUITE_P(All, MetaImageTypes,
                         testing::Combine(testing::Values(metaImageType<std::uint8_t>("MET_UCHAR", "uint8"),
                                                          metaImageType<std::int8_t>("MET_CHAR", "uint8"),
                                                          metaImageType<std::uint16_t>("MET_USHORT", "uint16"),
                                                          metaImageType<std::int16_t>("MET_SHORT", "uint16"),
                                                          metaImageType<std::uint32_t>("MET_UINT", "uint16"),
                                                          metaImageType<std::int32_t>("MET_INT", "uint16"),
                                                          metaImageType<std::uint32_t>("MET_ULONG", "uint16"),
                                                          metaImageType<std::int32_t>("MET_LONG", "uint16"),
                                                          metaImageType<std::uint64_t>("MET_ULONG_LONG", "uint16"),
                                                          metaImageType<std::int64_t>("MET_LONG_LONG", "uint16"),
                                                          metaImageType<float>("MET_FLOAT", "float32"),
                                                          metaImageType<double>("MET_DOUBLE", "float32")),
                                          testing::Bool()),
                         [](const auto& row) {
                             return std::get<0>(row.param).name +
                                    std::string(std::get<1>(row.param) ? "Big" : "Little");
                         });

TEST(MetaImage, NegativeValuesBecomeFloatAndAreMentioned) {
    const TemporaryFolder folder;
    auto values = twelve<std::int16_t>();
    values[4] = -7;
    const auto study = readStudy(folder.write("v.mha", header("MET_SHORT", "") + bytesFrom(values)), withoutGuess());
    ASSERT_TRUE(study);
    EXPECT_EQ(study->phases[0]->typeName(), "float32");
    EXPECT_EQ(study->phases[0]->storedValue(4), -7);
    EXPECT_TRUE(warnsOf(*study, "negative values down to -7"));
    EXPECT_EQ(factOf(*study, "voxel type"), "int16, kept as float32");
}

TEST(MetaImage, ReadsVoxelsFromWhereverTheHeaderSaysTheyAre) {
    const TemporaryFolder folder;
    const std::string voxels = bytesFrom(twelve<std::uint8_t>());
    const std::string packed = deflated(voxels);
    folder.write("plain.raw", voxels);
    folder.write("begin.raw", "HEAD" + voxels);
    folder.write("end.raw", "some header of unknown length" + voxels);
    folder.write("packed.zraw", packed);
    folder.write("gzip.zraw", deflated(voxels, 31));
    const std::string compressed = "CompressedData = True\n";
    const std::vector<std::string> files{
        folder.write("a.mhd", header("MET_UCHAR", "", "plain.raw")),
        folder.write("b.mhd", header("MET_UCHAR", "HeaderSize = 4\n", "begin.raw")),
        folder.write("c.mhd", header("MET_UCHAR", "HeaderSize = -1\n", "end.raw")),
        folder.write("d.mhd", header("MET_UCHAR", compressed, "packed.zraw")),
        folder.write("e.mhd", header("MET_UCHAR", compressed, "./gzip.zraw")),
        folder.write("f.mha", header("MET_UCHAR", compressed) + packed),
        folder.write("g.mha",
                     header("MET_UCHAR", compressed + "CompressedDataSize = " + std::to_string(packed.size()) + "\n") +
                         packed + "trailing"),
        folder.write("h.mha", header("MET_UCHAR", "HeaderSize = -1\n") + voxels),
        folder.write("content-decides.dat", header("MET_UCHAR", "UnknownKey = anything at all\n") + voxels),
    };
    for (const std::string& file : files) {
        const auto study = readStudy(file, withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(storedValues(*study->phases[0]), twelveDoubles) << file;
    }
}

TEST(MetaImage, TransformMatrixRowsAreTheGridAxes) {
    const TemporaryFolder folder;
    // x runs along patient y, y along patient z, z along patient x.
    const std::string place = "TransformMatrix = 0 1 0 0 0 1 1 0 0\nOffset = 10 20 30\n";
    const auto study = readStudy(folder.write("v.mha", header("MET_UCHAR", place) + std::string(12, '\1')));
    ASSERT_TRUE(study);
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    EXPECT_EQ(geometry.patientFromVoxel({1, 0, 0}), Vec3(10, 20.5, 30));
    EXPECT_EQ(geometry.patientFromVoxel({0, 1, 0}), Vec3(10, 20, 30.25));
    EXPECT_EQ(geometry.patientFromVoxel({0, 0, 1}), Vec3(12, 20, 30));
    EXPECT_TRUE(geometry.patientFrameKnown);
}

TEST(MetaImage, TheAxesThemselvesAreNoWordOnThePatient) {
    const TemporaryFolder folder;
    const std::string axes = "TransformMatrix = 1 0 0 0 1 0 0 0 1\nAnatomicalOrientation = RAI\n";
    for (const std::string& place : {std::string(), axes}) {
        const auto study = readStudy(folder.write("v.mha", header("MET_UCHAR", place) + std::string(12, '\1')));
        ASSERT_TRUE(study);
        EXPECT_FALSE(study->phases[0]->geometry().patientFrameKnown);
    }
}

TEST(MetaImage, SynonymsOfPositionAndSpacingMeanTheSame) {
    const TemporaryFolder folder;
    for (const char* offset : {"Offset", "Position", "Origin"})
        for (const char* matrix : {"TransformMatrix", "Rotation", "Orientation"})
            for (const char* spacing : {"ElementSpacing", "ElementSize"}) {
                const std::string text = "NDims = 3\nDimSize = 1 1 1\nElementType = MET_UCHAR\n" +
                                         std::string(spacing) + " = 3 4 5\n" + matrix + " = 0 1 0 -1 0 0 0 0 1\n" +
                                         offset + " = 1 2 3\nElementDataFile = LOCAL\nx";
                const auto study = readStudy(folder.write("v.mha", text));
                ASSERT_TRUE(study) << study.error().sentence();
                EXPECT_EQ(study->phases[0]->geometry().patientFromVoxel({1, 1, 1}), Vec3(1 - 4, 2 + 3, 3 + 5));
            }
}

TEST(MetaImage, NegativeSpacingTurnsTheAxisRound) {
    const TemporaryFolder folder;
    const std::string text =
        "NDims = 3\nDimSize = 1 1 2\nElementType = MET_UCHAR\nElementSpacing = 1 1 -2\n"
        "Offset = 0 0 9\nElementDataFile = LOCAL\nab";
    const auto study = readStudy(folder.write("v.mha", text));
    ASSERT_TRUE(study);
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(1, 1, 2));
    // The axis runs from 9 to 7. Its grid is left-handed, so it is counted from 7 on.
    EXPECT_EQ(study->phases[0]->geometry().patientFromVoxel({0, 0, 0}), Vec3(0, 0, 7));
    EXPECT_EQ(study->phases[0]->storedValue(0), 'b');
    EXPECT_TRUE(warnsOf(*study, "negative along z"));
}

TEST(MetaImage, WithoutSpacingItIsMarkedUnknown) {
    const TemporaryFolder folder;
    const auto study = readStudy(
        folder.write("v.mha", "NDims = 3\nDimSize = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nx"));
    ASSERT_TRUE(study);
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_TRUE(warnsOf(*study, "spacing of the voxels is unknown"));
}

TEST(MetaImage, FourthAxisIsTimeWhateverItsSpacing) {
    const TemporaryFolder folder;
    const auto read = [&](const std::string& spacing) {
        const std::string text = "NDims = 4\nDimSize = 1 1 2 3\nElementType = MET_UCHAR\nElementSpacing = " + spacing +
                                 "\nElementDataFile = LOCAL\n";
        return readStudy(folder.write("v.mha", text + bytesFrom<std::uint8_t>({1, 2, 3, 4, 5, 6})), withoutGuess());
    };
    for (const char* spacing : {"1 2 3", "1 2 3 0", "1 2 3 NaN", "1 2 3 1", "1 2 3 -4"}) {
        const auto study = read(spacing);
        ASSERT_TRUE(study) << study.error().sentence();
        ASSERT_EQ(study->phases.size(), 3U);
        EXPECT_THAT(storedValues(*study->phases[1]), ElementsAre(3, 4));
        EXPECT_EQ(study->phases[2]->geometry().spacing, Vec3(1, 2, 3));
        EXPECT_FALSE(study->phaseTimes.meanSeconds) << spacing;
    }
    EXPECT_EQ(read("1 2 3 0.04")->phaseTimes.meanSeconds, 0.04);
}

TEST(MetaImage, PhasesShareOneWhiteLevelAndType) {
    const TemporaryFolder folder;
    const std::string text = "NDims = 4\nDimSize = 1 1 2 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
    const auto study =
        readStudy(folder.write("v.mha", text + bytesFrom<std::int16_t>({100, 7, 400, 8, -4, 9})), withoutGuess());
    ASSERT_TRUE(study);
    for (const auto& phase : study->phases) {
        EXPECT_EQ(phase->typeName(), "float32");
        EXPECT_EQ(phase->whiteLevel(), 400);
    }
    EXPECT_EQ(study->phases[0]->normalisedIntensity(0), 0.25);
}

TEST(MetaImage, ColourIsReducedToLuma) {
    const TemporaryFolder folder;
    const std::string text =
        "NDims = 3\nDimSize = 2 1 1\nElementType = MET_UCHAR\nElementNumberOfChannels = 3\n"
        "ElementDataFile = LOCAL\n";
    const auto study =
        readStudy(folder.write("v.mha", text + bytesFrom<std::uint8_t>({200, 100, 50, 77, 77, 77})), withoutGuess());
    ASSERT_TRUE(study);
    EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(124, 77));  // 59.8 + 58.7 + 5.7
    EXPECT_TRUE(warnsOf(*study, "luma"));
}

TEST(MetaImage, WhiteLevelKeyIsHonoured) {
    const TemporaryFolder folder;
    const auto study = readStudy(
        folder.write("v.mha", header("MET_USHORT", "WhiteLevel = 4095\n") + bytesFrom(twelve<std::uint16_t>())));
    ASSERT_TRUE(study);
    EXPECT_EQ(study->phases[0]->whiteLevel(), 4095);
}

TEST(MetaImage, NotFiniteVoxelsAreNoData) {
    const TemporaryFolder folder;
    std::vector<float> values(12, 1.0F);
    values[3] = std::numeric_limits<float>::quiet_NaN();
    values[7] = std::numeric_limits<float>::infinity();
    const auto study = readStudy(folder.write("v.mha", header("MET_FLOAT", "") + bytesFrom(values)), withoutGuess());
    ASSERT_TRUE(study);
    for (int i = 0; i < 12; ++i) EXPECT_EQ(study->phases[0]->hasData(i), i != 3 && i != 7) << i;
    EXPECT_EQ(factOf(*study, "voxels without data"), "16.7 %");
    EXPECT_EQ(study->phases[0]->whiteLevel(), 1.0);
}

class WriterRoundTrip : public testing::TestWithParam<int> {};

TEST_P(WriterRoundTrip, GivesBackVoxelsGeometryAndWhiteLevel) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = {3, 2, 2};
    geometry.spacing = {0.1, 1.0 / 3.0, 2.5};
    geometry.origin = {-1.25, 7, 1e-3};
    geometry.direction = rotationX(30) * rotationZ(-20);
    std::vector<std::shared_ptr<const Volume>> phases;
    for (int phase = 0; phase < GetParam(); ++phase) {
        std::vector<std::uint16_t> values(12);
        std::iota(values.begin(), values.end(), static_cast<std::uint16_t>(1000 * phase));
        phases.push_back(std::make_shared<const Volume>(geometry, values, 4095.0));
    }
    ASSERT_TRUE(writeMetaImage(folder.file("v.mha"), phases));
    const auto study = readStudy(folder.file("v.mha"), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), phases.size());
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
    for (std::size_t phase = 0; phase < phases.size(); ++phase) {
        const Volume& read = *study->phases[phase];
        EXPECT_EQ(read.voxels(), phases[phase]->voxels());
        EXPECT_EQ(read.whiteLevel(), 4095.0);
        EXPECT_EQ(read.geometry().spacing, geometry.spacing);
        EXPECT_EQ(read.geometry().origin, geometry.origin);
        EXPECT_LT(cv::norm(read.geometry().direction - geometry.direction), 1e-15);
    }
}
INSTANTIATE_TEST_SUITE_P(Phases, WriterRoundTrip, testing::Values(1, 2, 5));

TEST(MetaImageWriter, KeepsFloatAndByteTypesAndUnknownSpacing) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    geometry.spacingKnown = false;
    const std::vector<Voxels> kinds{std::vector<std::uint8_t>{3, 255}, std::vector<float>{-0.5F, 1e30F}};
    for (const Voxels& voxels : kinds) {
        ASSERT_TRUE(writeMetaImage(folder.file("v.mha"), {std::make_shared<const Volume>(geometry, voxels)}));
        const auto study = readStudy(folder.file("v.mha"), withoutGuess());
        ASSERT_TRUE(study);
        EXPECT_EQ(study->phases[0]->voxels(), voxels);
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    }
}

TEST(MetaImageWriter, SaysWhereItCouldNotWrite) {
    const auto written = writeMetaImage(
        "/nonexistent-folder/v.mha", {std::make_shared<const Volume>(VolumeGeometry(), std::vector<std::uint8_t>{1})});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
}

}  // namespace
}  // namespace echolucent
