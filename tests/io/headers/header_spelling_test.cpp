// Headers as other programs and editors spell them: decimal commas, marks of byte order, line ends, tabs, capitals.
#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

Result<Study> readFile(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    return readStudy(folder.write(name, bytes), withoutGuess());
}

void expectVolume(const Result<Study>& study, const Vec3& spacing, const std::string& what) {
    ASSERT_TRUE(study) << what << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().spacing, spacing) << what;
    EXPECT_EQ(storedValues(*study->phases[0]), (std::vector<double>{'a', 'b', 'c', 'd'})) << what;
}

std::string replaced(std::string text, const std::string& one, const std::string& other) {
    for (std::size_t at = 0; (at = text.find(one, at)) != std::string::npos; at += other.size())
        text.replace(at, one.size(), other);
    return text;
}

const std::string plainMetaImage =
    "ObjectType = Image\nNDims = 3\nDimSize = 2 1 2\nElementType = MET_UCHAR\nElementSpacing = 0.5 0.25 2\n"
    "ElementDataFile = LOCAL\n";
const std::string plainNrrd =
    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 2\nspacings: 0.5 0.25 2\nencoding: raw\n\n";

TEST(HeaderSpelling, LineEndsTabsBlanksAndMarksOfByteOrderMeanNothing) {
    const std::string mark = "\xef\xbb\xbf";
    const Vec3 spacing(0.5, 0.25, 2);
    for (const std::string& header :
         {mark + plainMetaImage, replaced(plainMetaImage, "\n", "\r\n"), replaced(plainMetaImage, " = ", "\t=\t"),
          replaced(plainMetaImage, "\n", "  \t\n"), replaced(plainMetaImage, " = ", "="),
          replaced(plainMetaImage, "ElementSpacing", "ElementSize")})
        expectVolume(readFile("v.mha", header + "abcd"), spacing, header);
    for (const std::string& header :
         {mark + plainNrrd, replaced(plainNrrd, "\n", "\r\n"), replaced(plainNrrd, ": ", ":\t"),
          replaced(plainNrrd, "2\n", "2 \t\n"), replaced(plainNrrd, "NRRD0004", "NRRD0004 "),
          replaced(plainNrrd, "sizes", "SIZES"),
          replaced(plainNrrd, "encoding", "content: x\nold min: 0\nold max: 9\nnumber: 4\nencoding")})
        expectVolume(readFile("v.nrrd", header + "abcd"), spacing, header);
}

TEST(HeaderSpelling, AxesOfOneValueAreNoPhases) {
    const std::string fields = "NRRD0004\ntype: uchar\ndimension: 4\nencoding: raw\n";
    for (const std::string& more :
         {std::string("sizes: 1 2 2 2\nspacings: 1 0.5 0.25 2\n"),
          std::string("sizes: 2 2 2 1\nspacings: 0.5 0.25 2 1\n"),
          std::string("sizes: 1 2 2 2\nkinds: scalar domain domain domain\nspacings: nan 0.5 0.25 2\n")}) {
        const auto study = readFile("v.nrrd", fields + more + "\nabcdefgh");
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases.size(), 1U) << more;
        EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.5, 0.25, 2)) << more;
    }
    const auto image = readFile("v.mha",
                                "NDims = 4\nDimSize = 2 2 2 1\nElementType = MET_UCHAR\n"
                                "ElementSpacing = 0.5 0.25 2 1\nElementDataFile = LOCAL\nabcdefgh");
    ASSERT_TRUE(image) << image.error().sentence();
    EXPECT_EQ(image->phases.size(), 1U);
}

TEST(HeaderSpelling, OfMetaImageKeysMayHaveOtherCapitals) {
    for (const std::string& header :
         {replaced(plainMetaImage, "DimSize", "DIMSIZE"), replaced(plainMetaImage, "ElementSpacing", "elementspacing"),
          replaced(plainMetaImage, "ElementDataFile = LOCAL", "elementDataFile = Local"),
          replaced(plainMetaImage, "MET_UCHAR", "met_uchar"), replaced(plainMetaImage, "ObjectType", "objecttype")})
        expectVolume(readFile("v.mha", header + "abcd"), {0.5, 0.25, 2}, header);
    const auto twice = readFile("v.mha", "ndims = 4\n" + plainMetaImage + "abcd");
    ASSERT_FALSE(twice);
    EXPECT_NE(twice.error().sentence().find("NDims appears twice"), std::string::npos) << twice.error().sentence();
}

TEST(HeaderSpelling, DecimalCommasAreReadWhereTheyLeaveNoDoubt) {
    const auto image = readFile("v.mha", replaced(replaced(plainMetaImage, "0.5 0.25 2", "0,5 0,25 2,0"), "ElementType",
                                                  "Offset = 1,5 -2,25 3\nElementType") +
                                             "abcd");
    expectVolume(image, {0.5, 0.25, 2}, "MetaImage");
    EXPECT_EQ(image->phases[0]->geometry().origin, Vec3(1.5, -2.25, 3));
    EXPECT_TRUE(warnsOf(*image, "ElementSpacing has decimal commas"));
    const auto nrrd = readFile("v.nrrd", replaced(plainNrrd, "0.5 0.25 2", "0,5 0,25 2") + "abcd");
    expectVolume(nrrd, {0.5, 0.25, 2}, "NRRD");
    EXPECT_TRUE(warnsOf(*nrrd, "spacings has decimal commas"));
}

TEST(HeaderSpelling, CommasThatMayMeanEitherAreRefusedInWords) {
    for (const std::string& header :
         {replaced(plainMetaImage, "0.5 0.25 2", "0,5, 0,25, 2"), replaced(plainMetaImage, "0.5 0.25 2", "0.5,0.25,2"),
          replaced(plainMetaImage, "0.5 0.25 2", "1.000,5 0,25 2")}) {
        const auto refused = readFile("v.mha", header + "abcd");
        ASSERT_FALSE(refused) << header;
        EXPECT_NE(refused.error().sentence().find("a comma may be either"), std::string::npos);
    }
    const std::string space = "space: left-posterior-superior\nspace directions: ";
    for (const std::string vectors : {"(0,5,0,0) (0,0,25,0) (0,0,2)", "(0,5,0,0) (0,0,5,0) (0,0,0,5)",
                                      "(0.5,0,0) (0,0.5,0) (0,0,1)\nspace origin: (1,5,2,3)"}) {
        const auto refused =
            readFile("v.nrrd", replaced(plainNrrd, "spacings: 0.5 0.25 2\n", space + vectors + "\n") + "abcd");
        ASSERT_FALSE(refused) << vectors;
        EXPECT_NE(refused.error().sentence().find("must hold vectors of 3 numbers"), std::string::npos)
            << refused.error().sentence();
    }
}

TEST(HeaderSpelling, AKeyThatStandsTwiceWithOneValueIsNoted) {
    const Vec3 spacing(0.5, 0.25, 2);
    const std::string note = "stands twice in the header, with the same value";
    const auto meta = readFile("v.mha", "elementspacing = 0.50 0.25 2\n" + plainMetaImage + "abcd");
    expectVolume(meta, spacing, "MetaImage");
    EXPECT_TRUE(warnsOf(*meta, "\"ElementSpacing\" " + note));
    const auto nrrd =
        readFile("v.nrrd", replaced(plainNrrd, "sizes: 2 1 2\n", "sizes: 2 1 2\nSizes:  2 1 2\n") + "abcd");
    expectVolume(nrrd, spacing, "NRRD");
    EXPECT_TRUE(warnsOf(*nrrd, "\"sizes\" " + note));
    const auto several =
        readFile("v.nrrd", replaced(plainNrrd, "encoding", "type: uchar\nsizes: 2 1 2\nencoding") + "abcd");
    expectVolume(several, spacing, "two fields");
    EXPECT_TRUE(warnsOf(*several, "\"sizes\" and 1 more stand twice"));
    for (const auto& refused :
         {readFile("v.mha", "DimSize = 2 2 1\n" + plainMetaImage + "abcd"),
          readFile("v.nrrd", replaced(plainNrrd, "encoding", "sizes: 2 2 1\nencoding") + "abcd")}) {
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().sentence().find("appears twice in the header, with different values"),
                  std::string::npos)
            << refused.error().sentence();
    }
}

TEST(HeaderSpelling, LinesThatEndWithCrAloneAreRefusedByName) {
    for (const std::string name : {"v.mha", "v.nrrd"}) {
        const std::string& header = name == "v.mha" ? plainMetaImage : plainNrrd;
        const auto refused = readFile(name, replaced(header, "\n", "\r") + "abcd");
        ASSERT_FALSE(refused) << name;
        EXPECT_NE(refused.error().sentence().find("end with CR alone"), std::string::npos)
            << refused.error().sentence();
    }
    // Voxels may hold any bytes, and files that were converted twice end their lines so.
    expectVolume(readFile("v.mha", replaced(plainMetaImage, "\n", "\r\r\n") + "abcd"), {0.5, 0.25, 2}, "CR CR LF");
}

TEST(HeaderSpelling, NumbersBelowTheSmallestDoubleAreZero) {
    for (const std::string tiny :
         {"1e-400", "-6.9e-310", "4.9e-324", "1e-99999999999999999999", "-1E-330", "0.0000000001e-320"}) {
        const auto meta = readFile("v.mha", replaced(plainMetaImage, "ElementDataFile",
                                                     "Offset = " + tiny + " 2 3\nTransformMatrix = 1 " + tiny +
                                                         " 0 0 1 0 0 0 1\nElementDataFile") +
                                                "abcd");
        ASSERT_TRUE(meta) << tiny << meta.error().sentence();
        EXPECT_NEAR(meta->phases[0]->geometry().origin[0], 0, 1e-300);
        EXPECT_EQ(meta->phases[0]->geometry().origin[1], 2);
        const auto nrrd = readFile("v.nrrd", replaced(plainNrrd, "spacings: 0.5 0.25 2",
                                                      "space: LPS\nspace directions: (0.5," + tiny +
                                                          ",0) (0,0.25,0) (0,0,2)\nspace origin: (1,2," + tiny + ")") +
                                                 "abcd");
        ASSERT_TRUE(nrrd) << tiny << nrrd.error().sentence();
        EXPECT_EQ(nrrd->phases[0]->geometry().spacing, Vec3(0.5, 0.25, 2));
        const auto text =
            readFile("v.nrrd", replaced(replaced(plainNrrd, "uchar", "float"), "raw", "ascii") + "1 2 3 " + tiny);
        ASSERT_TRUE(text) << tiny << text.error().sentence();
        EXPECT_NEAR(text->phases[0]->fileValue(3), 0, 1e-300);
    }
    for (const std::string& huge :
         {std::string("1e400"), std::string("1e99999999999999999999"), "1" + std::string(400, '0') + "e-5"}) {
        const auto refused = readFile(
            "v.mha",
            replaced(plainMetaImage, "ElementDataFile", "Offset = 1 2 " + huge + "\nElementDataFile") + "abcd");
        EXPECT_FALSE(refused) << huge;
    }
    EXPECT_FALSE(readFile("v.mha", replaced(plainMetaImage, "0.25", "1e-400") + "abcd")) << "a spacing of 0";
}

TEST(HeaderSpelling, GziIsGzip) {
    expectVolume(readFile("v.nrrd", replaced(plainNrrd, "raw", "gzi") + deflated("abcd", 31)), {0.5, 0.25, 2}, "gzi");
}

}  // namespace
}  // namespace echolucent
