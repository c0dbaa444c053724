#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include <fmt/format.h>

#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::ElementsAre;

std::string commentedNrrd(const std::string& fields) { return "NRRD0004\n# comment\n" + fields + "\n"; }
std::string cube(const std::string& type, const std::string& more) {
    return commentedNrrd("type: " + type + "\ndimension: 3\nsizes: 2 1 2\n" + more);
}

struct NrrdTypeRow {
    std::vector<std::string> names;
    std::function<std::string(bool)> bytes;
};
template <typename T>
NrrdTypeRow nrrdType(std::vector<std::string> names) {
    return {std::move(names), [](bool big) { return bytesFrom<T>({1, 2, 3, 100}, big); }};
}

TEST(Nrrd, EveryTypeNameByteOrderAndEncodingGivesTheSameValues) {
    const TemporaryFolder folder;
    const std::vector<NrrdTypeRow> rows{
        nrrdType<std::uint8_t>({"uchar", "unsigned char", "uint8", "uint8_t"}),
        nrrdType<std::int8_t>({"signed char", "int8", "int8_t"}),
        nrrdType<std::uint16_t>({"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}),
        nrrdType<std::int16_t>({"short", "short int", "signed short", "signed short int", "int16", "int16_t"}),
        nrrdType<std::uint32_t>({"uint", "unsigned int", "uint32", "uint32_t"}),
        nrrdType<std::int32_t>({"int", "signed int", "int32", "int32_t"}),
        nrrdType<std::uint64_t>({"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}),
        nrrdType<std::int64_t>({"longlong", "long long", "long long int", "int64", "int64_t"}),
        nrrdType<float>({"float"}),
        nrrdType<double>({"double"})};
    for (const NrrdTypeRow& row : rows)
        for (const std::string& name : row.names)
            for (const bool big : {false, true})
                for (const std::string encoding : {"raw", "gzip", "gz"}) {
                    const std::string voxels = encoding == "raw" ? row.bytes(big) : deflated(row.bytes(big), 31);
                    const auto file = folder.write(
                        "v.nrrd", cube(name, "spacings: 1 2 3\nendian: " + std::string(big ? "big" : "little") +
                                                 "\nencoding: " + encoding + "\n") +
                                      voxels);
                    const auto study = readStudy(file, withoutGuess());
                    ASSERT_TRUE(study) << study.error().sentence();
                    EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(1, 2, 3, 100)) << name << big << encoding;
                    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(1, 2, 3));
                }
}

TEST(Nrrd, DetachedDataAreReadWithSkips) {
    const TemporaryFolder folder;
    const std::string voxels = "abcd";
    folder.write("plain.raw", voxels);
    folder.write("skip.raw", "one line\nsecond\nXY" + voxels);
    folder.write("end.raw", "anything" + voxels);
    folder.write("packed.raw.gz", deflated("1234" + voxels, 31));
    const auto expectRead = [&](const std::string& name, const std::string& more) {
        const auto study = readStudy(folder.write(name, cube("uchar", more)), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre('a', 'b', 'c', 'd')) << more;
    };
    expectRead("a.nhdr", "encoding: raw\ndata file: plain.raw\n");
    expectRead("b.nhdr", "encoding: raw\ndatafile: ./plain.raw\n");
    expectRead("c.nhdr", "encoding: raw\nline skip: 2\nbyte skip: 2\ndata file: skip.raw\n");
    expectRead("d.nhdr", "encoding: raw\nbyte skip: -1\ndata file: end.raw\n");
    expectRead("e.nhdr", "encoding: gzip\nbyte skip: 4\ndata file: packed.raw.gz\n");
}

VolumeGeometry geometryOf(const std::string& more) {
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.nrrd", cube("uchar", more + "encoding: raw\n") + "abcd"));
    EXPECT_TRUE(study) << (study ? "" : study.error().sentence());
    return study ? study->phases[0]->geometry() : VolumeGeometry();
}

TEST(Nrrd, SpaceDirectionsGiveSpacingAndDirection) {
    const auto geometry = geometryOf(
        "space: left-posterior-superior\nspace directions: (0,2,0) (0,0,3) (4,0,0)\n"
        "space origin: (1,-2,3)\n");
    EXPECT_EQ(geometry.spacing, Vec3(2, 3, 4));
    EXPECT_EQ(geometry.patientFromVoxel({1, 1, 1}), Vec3(1 + 4, -2 + 2, 3 + 3));
    EXPECT_TRUE(geometry.spacingKnown);
}

TEST(Nrrd, OtherFramesAreTurnedIntoLps) {
    const std::string place = "space directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (10,20,30)\n";
    const Vec3 corner(1, 1, 1);
    EXPECT_EQ(geometryOf("space: right-anterior-superior\n" + place).patientFromVoxel(corner), Vec3(-11, -22, 33));
    EXPECT_EQ(geometryOf("space: RAS\n" + place).patientFromVoxel(corner), Vec3(-11, -22, 33));
    // Of LAS the second axis is counted from its other end.
    EXPECT_EQ(geometryOf("space: left-anterior-superior\n" + place).patientFromVoxel({1, 0, 1}), Vec3(11, -20, 33));
    EXPECT_EQ(geometryOf("space: LPS\n" + place).patientFromVoxel(corner), Vec3(11, 22, 33));
    EXPECT_EQ(geometryOf("space: scanner-xyz\n" + place).patientFromVoxel(corner), Vec3(11, 22, 33));
}

TEST(Nrrd, ThePatientsFrameIsKnownWhereDirectionsSayMoreThanTheAxes) {
    const std::string turned = "space directions: (0,2,0) (0,0,3) (4,0,0)\n";
    const std::string axes = "space directions: (2,0,0) (0,3,0) (0,0,4)\n";
    EXPECT_TRUE(geometryOf("space: LPS\n" + turned).patientFrameKnown);
    EXPECT_TRUE(geometryOf("space: right-anterior-superior\n" + turned).patientFrameKnown);
    EXPECT_FALSE(geometryOf("space: LPS\n" + axes).patientFrameKnown);
    EXPECT_FALSE(geometryOf("space: RAS\n" + axes).patientFrameKnown);
    // The axes of RAS, as written by programs that work in RAS and know no patient.
    EXPECT_FALSE(geometryOf("space: LPS\nspace directions: (-2,0,0) (0,-3,0) (0,0,4)\n").patientFrameKnown);
    EXPECT_TRUE(geometryOf("space: LPS\nspace directions: (-2,0,0) (0,3,0) (0,0,4)\n").patientFrameKnown);
    EXPECT_FALSE(geometryOf("space: scanner-xyz\n" + turned).patientFrameKnown);
    EXPECT_FALSE(geometryOf("space dimension: 3\n" + turned).patientFrameKnown);
    EXPECT_FALSE(geometryOf("spacings: 1 2 -3\n").patientFrameKnown);
}

TEST(Nrrd, UnitsOtherThanMillimetresAreConverted) {
    EXPECT_EQ(geometryOf("spacings: 1 2 500\nunits: \"cm\" \"mm\" \"um\"\n").spacing, Vec3(10, 2, 0.5));
    EXPECT_EQ(geometryOf("space dimension: 3\nspace units: \"cm\" \"cm\" \"cm\"\n"
                         "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\n")
                  .patientFromVoxel({1, 1, 1}),
              Vec3(20, 30, 40));
}

TEST(Nrrd, ObliqueVectorsWithSpacesAndNegativeSpacing) {
    const auto oblique = geometryOf("space: LPS\nspace directions: ( 3, 4, 0 ) (-4 , 3, 0) (0,0,-2)\n");
    EXPECT_EQ(oblique.spacing, Vec3(5, 5, 2));
    EXPECT_NEAR(oblique.direction(0, 0), 0.6, 1e-15);
    EXPECT_NEAR(oblique.direction(2, 2), 1, 1e-15);
    EXPECT_EQ(oblique.origin[2], -2.0) << "the third axis is counted from its other end";
    EXPECT_EQ(geometryOf("spacings: 1 1 -2\n").patientFromVoxel({0, 0, 0}), Vec3(0, 0, -2));
}

TEST(Nrrd, WithoutSpacingItIsMarkedUnknown) { EXPECT_FALSE(geometryOf("").spacingKnown); }

/// The file is 4D: two phases of 1 x 1 x 2, with the values 10, 11 and 20, 21.
Result<Study> readMoving(const std::string& sizes, const std::string& more, const std::vector<std::uint8_t>& values) {
    const TemporaryFolder folder;
    return readStudy(folder.write("v.nrrd", commentedNrrd("type: uint8\ndimension: 4\nsizes: " + sizes + "\n" + more +
                                                          "encoding: raw\n") +
                                                bytesFrom(values)),
                     withoutGuess());
}

TEST(Nrrd, TimeAxisMayBeLastOrFirst) {
    const std::vector<std::uint8_t> slowest{10, 11, 20, 21};
    const std::vector<std::uint8_t> fastest{10, 20, 11, 21};
    const std::vector<Result<Study>> studies{
        readMoving("1 1 2 2", "spacings: 1 2 3 NaN\nkinds: domain domain domain time\n", slowest),
        readMoving("1 1 2 2", "spacings: 1 2 3 NaN\nkinds: space space space list\n", slowest),
        readMoving("1 1 2 2", "spacings: 1 2 3 1\n", slowest),
        readMoving("1 1 2 2", "space: LPS\nspace directions: (1,0,0) (0,2,0) (0,0,3) none\n", slowest),
        readMoving("2 1 1 2", "spacings: NaN 1 2 3\nkinds: time domain domain domain\n", fastest),
        readMoving("2 1 1 2", "spacings: 0 1 2 3\nkinds: list domain domain domain\n", fastest),
        readMoving("2 1 1 2", "space: LPS\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n", fastest),
    };
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const auto& study = studies[i];
        ASSERT_TRUE(study) << study.error().sentence();
        ASSERT_EQ(study->phases.size(), 2U) << i;
        EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(10, 11)) << i;
        EXPECT_THAT(storedValues(*study->phases[1]), ElementsAre(20, 21)) << i;
        EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(1, 2, 3)) << i;
        EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{1, 1, 2})) << i;
        EXPECT_FALSE(study->phaseTimes.meanSeconds) << i;
    }
}

/// Counts up over 4 axes of which the first is the smallest.
Result<Study> readFour(const std::string& sizes, const std::string& more, std::size_t count) {
    std::vector<std::uint8_t> values(count);
    std::iota(values.begin(), values.end(), std::uint8_t{0});
    return readMoving(sizes, more, values);
}

TEST(Nrrd, AFirstAxisOfFewValuesWithoutAKindMayBeComponentsAndIsRefused) {
    for (const std::string& more :
         {std::string("spacings: 1 0.6 0.7 0.8\n"), std::string("spacings: nan 0.6 0.7 0.8\n"), std::string(),
          std::string("space: LPS\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n")})
        for (const int first : {2, 3, 4}) {
            const auto refused =
                readFour(std::to_string(first) + " 5 5 5", more, static_cast<std::size_t>(first) * 125);
            ASSERT_FALSE(refused) << more;
            EXPECT_NE(refused.error().sentence().find(
                          fmt::format("kinds is missing, and the first axis of {} may be colour or components", first)),
                      std::string::npos)
                << refused.error().sentence();
        }
    for (const std::string& more : {std::string("kinds: list domain domain domain\nspacings: nan 1 2 3\n"),
                                    std::string("spacings: 0.1 1 2 3\nunits: \"s\" \"mm\" \"mm\" \"mm\"\n")}) {
        const auto study = readFour("3 5 5 5", more, 375);
        EXPECT_TRUE(study) << more << study.error().sentence();
    }
}

TEST(Nrrd, AnAxisWithoutAKindIsTakenAsTimeIfItsSpacingIsNaNOrItIsTheLastAndThatIsNoted) {
    const auto study = readMoving("5 1 1 2", "spacings: nan 1 2 3\n", {10, 20, 30, 40, 50, 11, 21, 31, 41, 51});
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 5U);
    EXPECT_THAT(storedValues(*study->phases[1]), ElementsAre(20, 21));
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(1, 2, 3));
    EXPECT_TRUE(warnsOf(*study, "kinds is missing: the first axis is taken as time."));
    const auto last = readMoving("1 1 2 2", "spacings: 1 2 3 1\n", {10, 11, 20, 21});
    ASSERT_TRUE(last);
    EXPECT_TRUE(warnsOf(*last, "kinds is missing: the last axis is taken as time."));
}

TEST(Nrrd, TimeStepIsReadWithItsUnit) {
    const std::vector<std::uint8_t> values{10, 11, 20, 21};
    EXPECT_EQ(readMoving("1 1 2 2", "spacings: 1 1 1 40\nunits: \"mm\" \"mm\" \"mm\" \"ms\"\n", values)
                  ->phaseTimes.meanSeconds,
              0.04);
    EXPECT_EQ(
        readMoving("1 1 2 2", "spacings: 1 1 1 1\nunits: \"mm\" \"mm\" \"mm\" \"s\"\n", values)->phaseTimes.meanSeconds,
        1.0);
    EXPECT_EQ(readMoving("1 1 2 2", "spacings: 1 1 1 0.5\n", values)->phaseTimes.meanSeconds, 0.5);
}

TEST(Nrrd, ColourAxisIsReducedToLuma) {
    const auto study =
        readMoving("3 2 1 1", "spacings: NaN 1 1 1\nkinds: RGB-color domain domain domain\n", {200, 100, 50, 9, 9, 9});
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(124, 9));
}

TEST(Nrrd, WhiteLevelKeyAndOtherKeysAreAllowed) {
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("v.nrrd", cube("ushort",
                                                             "endian: little\nencoding: raw\ncontent: x\n"
                                                             "WhiteLevel:=1023\nsome key:=some value\n") +
                                                            bytesFrom<std::uint16_t>({1, 2, 3, 4})));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->whiteLevel(), 1023);
}

TEST(Nrrd, PicturesOverTimeAreTakenAsSlicesOnlyWhenAsked) {
    const TemporaryFolder folder;
    const auto file =
        folder.write("v.nrrd", cube("uchar", "kinds: domain domain time\nspacings: 1 1 NaN\nencoding: raw\n") + "abcd");
    const auto refused = readStudy(file);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().framesCouldBeSlices);
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    const auto study = readStudy(file, options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
}

}  // namespace
}  // namespace echolucent
