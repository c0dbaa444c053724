// Volumes whose voxels lie in several data files or are written as text.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "bzip2_bytes.h"
#include "split_volume.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

constexpr std::size_t sliceBytes = 12;

class DataFiles : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directory(m_folder.file("sub"));
        for (std::size_t z = 0; z < 4; ++z) {
            const std::string slice = splitVoxels().substr(z * sliceBytes, sliceBytes);
            m_folder.write("s" + std::to_string(z) + ".raw", slice);
            m_folder.write("p" + std::to_string(z) + ".raw", "head\n" + slice);
            m_folder.write("z" + std::to_string(z) + ".raw.gz", deflated(slice, 31));
            m_folder.write(fmt::format("sub/n{:03}.raw", 10 + 5 * z), slice);
        }
        m_folder.write("low.raw", splitVoxels().substr(0, 2 * sliceBytes));
        m_folder.write("high.raw", splitVoxels().substr(2 * sliceBytes));
    }
    void expectVoxels(const std::string& header, std::size_t files) const {
        const auto study = readStudy(m_folder.write("v.nhdr", header), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        const auto values = storedValues(*study->phases[0]);
        ASSERT_EQ(values.size(), 24U);
        for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(values[i], i + 1) << header;
        EXPECT_EQ(study->files.size(), files + 1) << header;
        EXPECT_EQ(factOf(*study, "data files"), files > 1 ? std::to_string(files) : "none");
    }
    [[nodiscard]] std::string sentenceOf(const std::string& header) const {
        const auto study = readStudy(m_folder.write("v.nhdr", header));
        return study ? "was read" : study.error().sentence();
    }
    TemporaryFolder m_folder;
};

TEST_F(DataFiles, OfNrrdAreAListOrAPattern) {
    expectVoxels(splitNrrd("encoding: raw\ndata file: LIST\ns0.raw\ns1.raw\n./s2.raw\ns3.raw\n"), 4);
    expectVoxels(splitNrrd("encoding: raw\ndata file: LIST 2\ns0.raw\ns1.raw\ns2.raw\ns3.raw"), 4);
    expectVoxels(splitNrrd("encoding: raw\ndata file: LIST 3\nlow.raw\nhigh.raw\n"), 2);
    expectVoxels(splitNrrd("encoding: raw\nline skip: 1\ndata file: LIST\np0.raw\np1.raw\np2.raw\np3.raw\n"), 4);
    expectVoxels(splitNrrd("encoding: raw\nbyte skip: 5\ndata file: p%d.raw 0 3 1\n"), 4);
    expectVoxels(splitNrrd("encoding: raw\nbyte skip: -1\ndata file: p%d.raw 0 3 1\n"), 4);
    expectVoxels(splitNrrd("encoding: gzip\ndata file: z%d.raw.gz 0 3 1 2\n"), 4);
    expectVoxels(splitNrrd("encoding: raw\ndata file: sub/n%03d.raw 10 25 5\n"), 4);
}

TEST_F(DataFiles, OfNrrdMayCountDown) {
    const auto study = readStudy(m_folder.write("v.nhdr", splitNrrd("encoding: raw\ndata file: s%d.raw 3 0 -1\n")));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(0), 19);
}

TEST_F(DataFiles, OfMetaImageAreAListOrAPattern) {
    expectVoxels(splitMetaImage("ElementDataFile = LIST\ns0.raw\ns1.raw\ns2.raw\ns3.raw\n"), 4);
    expectVoxels(splitMetaImage("ElementDataFile = LIST 2\ns0.raw\ns1.raw\ns2.raw\ns3.raw\n"), 4);
    expectVoxels(splitMetaImage("HeaderSize = 5\nElementDataFile = p%d.raw 0 3 1\n"), 4);
    expectVoxels(splitMetaImage("HeaderSize = -1\nElementDataFile = p%d.raw 0 3\n"), 4);
    expectVoxels(splitMetaImage("CompressedData = True\nElementDataFile = z%d.raw.gz 0\n"), 4);
    expectVoxels(splitMetaImage("ElementDataFile = sub/n%03d.raw 10 25 5\n"), 4);
    m_folder.write("whole.raw", splitVoxels());
    expectVoxels(splitMetaImage("ElementDataFile = LIST 3\nwhole.raw\n"), 1);
}

TEST_F(DataFiles, OfAMovingVolumeMayHoldAPhaseOrASlice) {
    const std::string begin = "NDims = 4\nDimSize = 2 3 2 2\nElementType = MET_USHORT\nBinaryDataByteOrderMSB = True\n";
    for (const char* data :
         {"LIST\nlow.raw\nhigh.raw\n", "LIST 3\nlow.raw\nhigh.raw\n", "LIST 2\ns0.raw\ns1.raw\ns2.raw\ns3.raw\n"}) {
        const auto study = readStudy(m_folder.write("v.mhd", begin + "ElementDataFile = " + data), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        ASSERT_EQ(study->phases.size(), 2U);
        EXPECT_EQ(study->phases[1]->storedValue(0), 13) << data;
    }
}

TEST_F(DataFiles, MayBeLinksWithinTheFolder) {
    std::filesystem::create_symlink(m_folder.file("low.raw"), m_folder.file("sub/inside.raw"));
    EXPECT_EQ(sentenceOf(splitNrrd("encoding: raw\ndata file: LIST 3\nsub/inside.raw\nhigh.raw\n")), "was read");
}

std::string hexOf(const std::string& bytes) {
    std::string text;
    for (const char byte : bytes)
        text += fmt::format("{:02x}{}", static_cast<unsigned char>(byte), text.size() % 7 ? "" : "\n");
    return text;
}

TEST_F(DataFiles, MayBeTextHexadecimalOrBzip2) {
    const auto attached = [&](const std::string& encoding, const std::string& bytes) {
        const auto study =
            readStudy(m_folder.write("v.nrrd", splitNrrd("encoding: " + encoding + "\n\n") + bytes), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        for (int i = 0; i < 24; ++i) EXPECT_EQ(study->phases[0]->storedValue(i), i + 1) << encoding;
    };
    for (const char* name : {"ascii", "ASCII", "text", "txt"}) attached(name, splitVoxelsAsText);
    attached("hex", hexOf(splitVoxels()));
    std::string capitals = hexOf(splitVoxels());
    std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                   [](char c) { return c >= 'a' ? c - 'a' + 'A' : c; });
    attached("hex", capitals);
    for (const char* name : {"bzip2", "bz2"}) attached(name, bzipped(splitVoxels()));
    const auto study = readStudy(
        m_folder.write("v.mha", splitMetaImage("BinaryData = False\nElementDataFile = LOCAL\n") + splitVoxelsAsText),
        withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    for (int i = 0; i < 24; ++i) EXPECT_EQ(study->phases[0]->storedValue(i), i + 1);
    EXPECT_EQ(factOf(*study, "compression"), "none, written as decimal text");
}

TEST_F(DataFiles, AsTextKeepEveryType) {
    for (const auto& [type, text] :
         {std::pair{"uchar", "0 255 7 1"}, std::pair{"int8", "-128 127 0 1"}, std::pair{"short", "-32768 32767 0 1"},
          std::pair{"uint", "0 4294967295 1 1"}, std::pair{"int64", "-9223372036854775808 5 0 1"},
          std::pair{"uint64", "18446744073709551615 0 1 1"}, std::pair{"float", "-1.5 2.25e3 nan 1"},
          std::pair{"double", "0.5 -0.25 inf 1"}}) {
        const std::string header =
            "NRRD0004\ntype: " + std::string(type) + "\ndimension: 3\nsizes: 2 1 2\nencoding: ascii\n\n";
        EXPECT_EQ(sentenceOf(header + text), "was read") << type;
    }
}

// As pigz, pbzip2 and "cat a.gz b.gz" write them.
TEST_F(DataFiles, MayBeCompressedInSeveralMembers) {
    const auto gzipped = [](const std::string& bytes) { return deflated(bytes, 31); };
    const auto bzip2 = [](const std::string& bytes) { return bzipped(bytes); };
    const std::string all = splitVoxels();
    const auto members = [&](const auto& packed) {
        return packed(all.substr(0, 7)) + packed("") + packed(all.substr(7, 20)) + packed(all.substr(27));
    };
    const auto expectAll = [&](const std::string& name, const std::string& bytes) {
        const auto study = readStudy(m_folder.write(name, bytes), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        for (int i = 0; i < 24; ++i) EXPECT_EQ(study->phases[0]->storedValue(i), i + 1) << name;
        EXPECT_FALSE(warnsOf(*study, "more than the declared voxels"));
    };
    expectAll("g.nrrd", splitNrrd("encoding: gzip\n\n") + members(gzipped));
    expectAll("b.nrrd", splitNrrd("encoding: bzip2\n\n") + members(bzip2));
    expectAll("z.mha", splitMetaImage("CompressedData = True\nElementDataFile = LOCAL\n") + members(gzipped));
    // Padding is no member, and neither is what follows zlib's own format.
    expectAll("p.nrrd", splitNrrd("encoding: gzip\n\n") + members(gzipped) + std::string(9, '\0'));
    expectAll("q.nrrd", splitNrrd("encoding: bzip2\n\n") + members(bzip2) + "BZ");
    expectAll("o.mha",
              splitMetaImage("CompressedData = True\nElementDataFile = LOCAL\n") + deflated(all) + gzipped("more"));
}

TEST_F(DataFiles, OfAListMayFollowATab) {
    expectVoxels(splitNrrd("encoding: raw\ndata file: LIST\t2\n") + "s0.raw\ns1.raw\ns2.raw\ns3.raw\n", 4);
    expectVoxels(splitMetaImage("ElementDataFile = LIST\t2\n") + "s0.raw\ns1.raw\ns2.raw\ns3.raw\n", 4);
}

TEST_F(DataFiles, WithMoreThanTheVoxelsSaySo) {
    const auto saysSo = [&](const std::string& bytes) {
        const auto study = readStudy(m_folder.write("v.nrrd", bytes), withoutGuess());
        EXPECT_TRUE(study) << study.error().sentence();
        return study && warnsOf(*study, "more than the declared voxels");
    };
    EXPECT_FALSE(saysSo(splitNrrd("encoding: ascii\n\n") + splitVoxelsAsText + " \n"));
    EXPECT_TRUE(saysSo(splitNrrd("encoding: ascii\n\n") + splitVoxelsAsText + " 25"));
    EXPECT_TRUE(saysSo(splitNrrd("encoding: ascii\n\n") + splitVoxelsAsText + " end"));
    EXPECT_TRUE(saysSo(splitNrrd("encoding: gzip\n\n") + deflated(splitVoxels() + "xx", 31)));
    EXPECT_FALSE(saysSo(splitNrrd("encoding: gzip\n\n") + deflated(splitVoxels(), 31)));
}

// German and French programs write numbers so.
TEST_F(DataFiles, OfTextHaveDecimalCommasWhereTheNumberOfVoxelsProvesIt) {
    const std::string meta =
        "NDims = 3\nDimSize = 2 1 2\nElementSpacing = 1 2 3\nElementType = MET_FLOAT\nBinaryData = False\n"
        "ElementDataFile = ";
    const std::string nrrd = "NRRD0004\ntype: float\ndimension: 3\nsizes: 2 1 2\nspacings: 1 2 3\nencoding: ascii\n";
    const auto valuesOf = [&](const std::string& name, const std::string& bytes, bool noted) {
        const auto study = readStudy(m_folder.write(name, bytes), withoutGuess());
        EXPECT_TRUE(study) << study.error().sentence();
        if (!study) return std::vector<double>{};
        EXPECT_EQ(warnsOf(*study, "decimal commas, which are read as points"), noted) << bytes;
        return storedValues(*study->phases[0]);
    };
    const std::vector<double> decimal{75.5, 2.25, 3, 150}, plain{75, 50, 2, 25};
    for (const std::string text : {"75,50 2,25 3 1,5e2", "75,50\t2,25\r\n3,0\n150,0\n"}) {
        EXPECT_EQ(valuesOf("v.mha", meta + "LOCAL\n" + text, true), decimal);
        EXPECT_EQ(valuesOf("v.nrrd", nrrd + "\n" + text, true), decimal);
    }
    for (const std::string text : {"75,50,2,25", "75, 50, 2, 25\n", "75,50\n2,25\n", "75,50 2,25"}) {
        EXPECT_EQ(valuesOf("v.mha", meta + "LOCAL\n" + text, false), plain);
        EXPECT_EQ(valuesOf("v.nrrd", nrrd + "\n" + text, false), plain);
    }
    m_folder.write("a.txt", "75,5 2,25\n");
    m_folder.write("b.txt", "3 150\n");
    EXPECT_EQ(valuesOf("v.nhdr", nrrd + "data file: LIST\na.txt\nb.txt\n", true), decimal);
    for (const std::string text : {"75,50 2,25 3,00 150,0 7,5", "75,50, 2,25, 3,00, 150,0", "1,2,3,4,5"})
        for (const auto& study : {readStudy(m_folder.write("v.mha", meta + "LOCAL\n" + text), withoutGuess()),
                                  readStudy(m_folder.write("v.nrrd", nrrd + "\n" + text), withoutGuess())}) {
            ASSERT_FALSE(study) << text;
            EXPECT_NE(study.error().sentence().find("may be decimal commas"), std::string::npos)
                << study.error().sentence();
        }
}

TEST_F(DataFiles, MayBeNamedWithBackslashesWhichAreSlashesUnlessAFileIsCalledSo) {
    m_folder.write("sub/R&D (1).raw", splitVoxels());
    expectVoxels(splitNrrd("encoding: raw\ndata file: sub\\R&D (1).raw\n"), 1);
    expectVoxels(splitNrrd("encoding: raw\ndata file: .\\sub\\R&D (1).raw\n"), 1);
    expectVoxels(splitMetaImage("ElementDataFile = sub\\R&D (1).raw\n"), 1);
    expectVoxels(splitNrrd("encoding: raw\ndata file: sub\\n%03d.raw 10 25 5\n"), 4);
    expectVoxels(splitMetaImage("ElementDataFile = LIST\nsub\\n010.raw\nsub\\n015.raw\nsub/n020.raw\nsub\\n025.raw\n"),
                 4);
    m_folder.write("sub/x.raw", std::string(48, 'x'));
    m_folder.write("sub\\x.raw", splitVoxels());
    expectVoxels(splitNrrd("encoding: raw\ndata file: sub\\x.raw\n"), 1);
}

}  // namespace
}  // namespace echolucent
