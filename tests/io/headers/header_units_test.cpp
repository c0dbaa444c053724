// Units of lengths in headers: quoted or not, for all axes or for some, of every name, and those that nobody knows.
#include <gtest/gtest.h>

#include <utility>

#include "io/headers/header_units.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

TEST(HeaderUnits, HaveManyNames) {
    for (const auto& [name, mm] : std::vector<std::pair<std::string, double>>{{"nm", 1e-6},
                                                                              {"um", 1e-3},
                                                                              {"\xc2\xb5m", 1e-3},
                                                                              {"\xce\xbcm", 1e-3},
                                                                              {"\xb5m", 1e-3},
                                                                              {"micrometer", 1e-3},
                                                                              {"Micrometres", 1e-3},
                                                                              {"microns", 1e-3},
                                                                              {"mm", 1},
                                                                              {"MM", 1},
                                                                              {"millimetre", 1},
                                                                              {"cm", 10},
                                                                              {"centimeters", 10},
                                                                              {" dm ", 100},
                                                                              {"m", 1000},
                                                                              {"meter", 1000},
                                                                              {"metres", 1000},
                                                                              {"nanometers", 1e-6},
                                                                              {"inch", 25.4},
                                                                              {"in", 25.4},
                                                                              {"decimetre", 100},
                                                                              {"millimeters", 1.0}})
        EXPECT_DOUBLE_EQ(mmOfUnit(name).value_or(-1), mm) << name;
    for (const char* name : {"", "furlong", "s", "ms", "pixel", "mmm", "kilometer", "metermeter", "1"})
        EXPECT_FALSE(mmOfUnit(name)) << name;
    for (const auto& [name, seconds] : std::vector<std::pair<std::string, double>>{{"s", 1},
                                                                                   {"sec", 1},
                                                                                   {"Seconds", 1},
                                                                                   {"ms", 1e-3},
                                                                                   {"msec", 1e-3},
                                                                                   {"milliseconds", 1e-3},
                                                                                   {"us", 1e-6},
                                                                                   {"\xc2\xb5s", 1e-6},
                                                                                   {"microseconds", 1e-6},
                                                                                   {"min", 60},
                                                                                   {"h", 3600}})
        EXPECT_DOUBLE_EQ(secondsOfUnit(name).value_or(-1), seconds) << name;
    for (const char* name : {"", "mm", "m", "frame", "%"}) EXPECT_FALSE(secondsOfUnit(name)) << name;
}

/// Counts the warnings that hold these words.
long warningsOf(const Study& study, const std::string& words) {
    return std::ranges::count_if(study.warnings,
                                 [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

Result<Study> nrrd(const std::string& fields) {
    const TemporaryFolder folder;
    return readStudy(folder.write("v.nrrd", "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 2 1 2\n" + fields +
                                                "encoding: raw\n\nabcd"),
                     withoutGuess());
}

void expectSpacing(const std::string& fields, const Vec3& spacing) {
    const auto study = nrrd(fields);
    ASSERT_TRUE(study) << study.error().sentence();
    const VolumeGeometry& geometry = study->phases[0]->geometry();
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(geometry.spacing[axis], spacing[axis], 1e-12) << fields;
    EXPECT_TRUE(geometry.spacingKnown) << fields;
}

void expectUnknown(const std::string& fields, const std::string& words) {
    const auto study = nrrd(fields);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << fields;
    EXPECT_EQ(warningsOf(*study, words), 1) << fields;
    EXPECT_EQ(warningsOf(*study, "spacing of the voxels is unknown"), 1) << fields;
}

TEST(HeaderUnits, OfNrrdSpacingsCountQuotedOrNot) {
    expectSpacing("spacings: 0.038 0.038 0.076\nunits: cm cm cm\n", {0.38, 0.38, 0.76});
    expectSpacing("spacings: 38 40 76\nunits: \"um\" microns \"micrometers\"\n", {0.038, 0.04, 0.076});
    expectSpacing("spacings: 0.0003 0.4 0.05\nunits: m\tmm   cm\n", {0.3, 0.4, 0.5});
    expectSpacing("spacings: 0.01 0.02 0.04\nunits: \"in\" inch \"inches\"\n", {0.254, 0.508, 1.016});
    expectSpacing("spacings: 300 400 500\nunits: \xc2\xb5m \xc2\xb5m \xc2\xb5m\n", {0.3, 0.4, 0.5});
    expectSpacing("spacings: 1 2 3\nunits: \"\" \"\" \"\"\n", {1, 2, 3});
    expectSpacing("spacings: 1 2 3\nunits: mm none ???\n", {1, 2, 3});
    expectSpacing("spacings: 1 2 3\nunits: cm\n", {10, 20, 30});
}

TEST(HeaderUnits, OfNrrdDirectionsCountForStepsAndOrigin) {
    const std::string space =
        "space: left-posterior-superior\nspace directions: (0.05,0,0) (0,0.06,0) (0,0,0.07)\n"
        "space origin: (1,2,3)\n";
    for (const char* units : {"space units: \"cm\" \"cm\" \"cm\"\n", "space units: cm cm cm\n", "units: cm cm cm\n",
                              "space units: \"\" \"\" \"\"\nunits: cm cm cm\n",
                              "space units: centimeters centimetres cm\nunits: mm mm mm\n",
                              "space units: cm cm cm\nspacings: 0.05 0.06 0.07\n"}) {
        expectSpacing(space + units, {0.5, 0.6, 0.7});
        EXPECT_FALSE(warnsOf(*nrrd(space + units), "space directions counts")) << units;
        EXPECT_EQ(nrrd(space + units)->phases[0]->geometry().origin, Vec3(10, 20, 30)) << units;
    }
    // Spacings beside them show that the directions are in mm.
    expectSpacing(space + "spacings: 0.005 0.006 0.007\nunits: cm cm cm\n", {0.05, 0.06, 0.07});
}

TEST(HeaderUnits, OfNrrdThatNobodyKnowsMakeTheSpacingUnknown) {
    const std::string directions =
        "space: left-posterior-superior\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,1)\nspace origin: (1,2,3)\n";
    expectUnknown("spacings: 1 2 3\nunits: furlong furlong furlong\n", "\"furlong\", which is not a known length");
    expectUnknown("spacings: 1 2 3\nunits: \"mm\" \"mm\" \"pixel\"\n", "\"pixel\", which is not a known length");
    expectUnknown("spacings: 1 2 3\nunits: \"ms\" \"mm\" \"mm\"\n", "\"ms\", which is not a known length");
    expectUnknown("spacings: 1 2 3\nunits: \"um\" \"um\" \"\"\n", "for some axes and nothing for the others");
    expectUnknown(directions + "space units: \"parsec\" \"parsec\" \"parsec\"\n", "space units names \"parsec\"");
    expectUnknown(directions + "units: \"um\" \"um\" \"mm\"\n", "units names several lengths");
}

TEST(HeaderUnits, EndsOfAxesGiveSpacingWhereCenteringsSayOfWhat) {
    const std::string ends = "axis mins: 0 10 0\naxis maxs: 2 13 8\n";
    expectSpacing(ends + "centerings: cell cell cell\n", {1, 3, 4});
    expectSpacing(ends + "centers: node cell node\nunits: cm cm cm\n", {20, 30, 80});
    expectUnknown(ends, "axis mins and axis maxs give no spacing");
}

Result<Study> metaImage(const std::string& keys) {
    const TemporaryFolder folder;
    return readStudy(folder.write("v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 1 2\nElementType = MET_UCHAR\n" +
                                               keys + "ElementDataFile = LOCAL\nabcd"),
                     withoutGuess());
}

TEST(HeaderUnits, OfMetaImageAreItsDistanceUnits) {
    for (const auto& [unit, factor] :
         std::vector<std::pair<std::string, double>>{{"um", 1e-3}, {"mm", 1}, {"cm", 10}, {"?", 1}}) {
        const auto study = metaImage("DistanceUnits = " + unit + "\nElementSpacing = 30 40 50\nOffset = 100 200 300\n");
        ASSERT_TRUE(study) << study.error().sentence();
        const VolumeGeometry& geometry = study->phases[0]->geometry();
        EXPECT_NEAR(geometry.spacing[1], 40 * factor, 1e-12) << unit;
        EXPECT_NEAR(geometry.origin[2], 300 * factor, 1e-12) << unit;
        EXPECT_TRUE(geometry.spacingKnown) << unit;
    }
    const auto study = metaImage("DistanceUnits = ells\nElementSpacing = 1 1 1\nSpacingKnown = True\n");
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(warningsOf(*study, "DistanceUnits names \"ells\""), 1);
}

}  // namespace
}  // namespace echolucent
