// MetaImage and NRRD files that are wrong, each with the words its sentence must hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

struct MalformedRow {
    std::string file;
    std::string bytes;
    std::vector<std::string> words;
};

std::string mha(const std::string& replaced, const std::string& with,
                const std::string& voxels = std::string(24, 'v')) {
    std::string text =
        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\n"
        "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with) + voxels;
}

std::string nrrd(const std::string& replaced, const std::string& with,
                 const std::string& voxels = std::string(24, 'v')) {
    std::string text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n";
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with) + "\n" + voxels;
}

const std::string last = "ElementDataFile";

std::vector<MalformedRow> metaImageRows() {
    const std::string key = "ElementDataFile = LOCAL";
    return {
        {"a.mha", "", {"ElementDataFile is missing"}},
        {"a.mha", "\x01\x02\x03 garbage \xff\xfe\n", {"line 1", "no \"Key = Value\""}},
        {"a.mha", mha("ElementType", "no equals here\nElementType"), {"line 5", "no equals here"}},
        {"a.mha", "ObjectType = Image\nNDims = 3\nDim", {"line 3", "\"Dim\""}},
        {"a.mha", mha(key + "\n", "", ""), {"ElementDataFile is missing"}},
        {"a.mha", mha("ObjectType = Image", "ObjectType = Tube"), {"ObjectType", "\"Tube\""}},
        {"a.mha", mha("NDims = 3\n", ""), {"NDims is missing"}},
        {"a.mha", mha("NDims = 3", "NDims = 2"), {"NDims is 2", "2D picture"}},
        {"a.mha", mha("NDims = 3", "NDims = 5"), {"NDims must be 3 or 4"}},
        {"a.mha", mha("NDims = 3", "NDims = three"), {"NDims", "\"three\""}},
        {"a.mha", mha("NDims = 3", "NDims = 99999999999999999999"), {"NDims", "9999"}},
        {"a.mha", mha("DimSize = 2 3 4\n", ""), {"DimSize is missing"}},
        {"a.mha", mha("2 3 4", "2 3"), {"DimSize must be 3 whole numbers above 0", "\"2 3\""}},
        {"a.mha", mha("2 3 4", "2 0 4"), {"DimSize must be 3 whole numbers above 0"}},
        {"a.mha", mha("2 3 4", "2 -3 4"), {"DimSize must be 3 whole numbers above 0", "-3"}},
        {"a.mha", mha("2 3 4", "2 3.5 4"), {"DimSize must be 3 whole numbers above 0", "3.5"}},
        {"a.mha", mha("2 3 4", "2 3 nan"), {"DimSize", "nan"}},
        {"a.mha", mha("2 3 4", "4000000000 4000000000 4000000000"), {"DimSize declares more voxels than any file"}},
        {"a.mha", mha("2 3 4", "2000000000 2000000000 2"), {"DimSize declares 8000000000000000000 bytes", "only 24"}},
        {"a.mha", mha("2 3 4", "2 3 5"), {"DimSize declares 30 bytes", "holds only 24"}},
        {"a.mha", mha("2 3 4", "2 3 4", ""), {"DimSize declares 24 bytes", "holds only 0"}},
        {"a.mha", mha("1 1 1", "1 0 1"), {"ElementSpacing must be finite and not 0", "1 0 1"}},
        {"a.mha", mha("1 1 1", "1 NaN 1"), {"ElementSpacing must be finite"}},
        {"a.mha", mha("1 1 1", "1 inf 1"), {"ElementSpacing must be finite"}},
        {"a.mha", mha("1 1 1", "1 1"), {"ElementSpacing must be 3 numbers"}},
        {"a.mha", mha("1 1 1", "1 1 1 1"), {"ElementSpacing must be 3 numbers"}},
        {"a.mha", mha("1 1 1", "1 one 1"), {"ElementSpacing must be 3 numbers", "one"}},
        {"a.mha", mha("ElementType = MET_UCHAR\n", ""), {"ElementType is missing"}},
        {"a.mha", mha("MET_UCHAR", "MET_STRING"), {"ElementType", "MET_STRING"}},
        {"a.mha", mha(key, "ElementNumberOfChannels = 2\n" + key), {"ElementNumberOfChannels must be 1"}},
        {"a.mha", mha(key, "BinaryData = False\n" + key), {"DimSize declares 24 bytes", "only 24 characters"}},
        {"a.mha",
         mha(key, "BinaryDataByteOrderMSB = perhaps\n" + key),
         {"BinaryDataByteOrderMSB must be True or False"}},
        {"a.mha", mha(key, "CompressedData = 7\n" + key), {"CompressedData must be True or False"}},
        {"a.mha", mha(key, "TransformMatrix = 1 0 0 0 1 0 0 0\n" + key), {"TransformMatrix must be 9 numbers"}},
        {"a.mha",
         mha(key, "TransformMatrix = 1 0 0 1 0 0 0 0 1\n" + key),
         {"TransformMatrix", "independent directions"}},
        {"a.mha",
         mha(key, "TransformMatrix = 0 0 0 0 0 0 0 0 0\n" + key),
         {"TransformMatrix", "independent directions"}},
        {"a.mha", mha(key, "Offset = 1 2\n" + key), {"Offset must be 3 finite numbers"}},
        {"a.mha", mha(key, "Offset = 1 2 nan\n" + key), {"Offset must be 3 finite numbers"}},
        {"a.mha", mha(key, "WhiteLevel = 0\n" + key), {"WhiteLevel must be a number above 0"}},
        {"a.mha", mha(key, "WhiteLevel = NaN\n" + key), {"WhiteLevel must be a number above 0"}},
        {"a.mha", mha(key, "HeaderSize = -2\n" + key), {"HeaderSize must be -1, 0 or above"}},
        {"a.mha", mha(key, "HeaderSize = 3\n" + key), {"HeaderSize is 3", "header is"}},
        {"a.mha", mha(key, "HeaderSize = 9000000000000000000\n" + key), {"DimSize declares 24 bytes", "holds only 0"}},
        {"a.mha", mha(key, "CompressedData = True\nHeaderSize = -1\n" + key), {"HeaderSize is -1"}},
        {"a.mha", mha(key, "DimSize = 2 3 4\n" + key), {"DimSize appears twice"}},
        {"a.mha", mha("LOCAL", "LIST"), {"ElementDataFile names 1 data files where the volume has 4 parts"}},
        {"a.mha", mha("LOCAL", "slice%03d.raw 1 4 1"), {"slice001.raw", "could not be opened"}},
        {"a.mhd", mha("LOCAL", "/etc/passwd"), {"ElementDataFile", "/etc/passwd", "own folder"}},
        {"a.mhd", mha("LOCAL", "../a.raw"), {"ElementDataFile", "../a.raw", "own folder"}},
        {"a.mhd", mha("LOCAL", "sub/a.raw"), {"sub/a.raw", "could not be opened"}},
        {"a.mhd", mha("LOCAL", "sub/../../a.raw"), {"ElementDataFile", "own folder"}},
        {"a.mhd", mha("LOCAL", "..\\a.raw"), {"ElementDataFile", "own folder"}},
        {"a.mhd", mha("LOCAL", ".."), {"ElementDataFile", "own folder"}},
        {"a.mhd", mha("LOCAL", ""), {"ElementDataFile names no file"}},
        {"a.mhd", mha("LOCAL", "missing.raw"), {"missing.raw", "could not be opened"}},
        {"a.mha", mha(key, "CompressedData = True\n" + key, "not zlib at all, but long"), {"damaged compressed data"}},
        {"a.mha", mha(key, "CompressedData = True\n" + key, deflated(std::string(23, 'v'))), {"holds only 23 bytes"}},
        {"a.mha",
         mha(key, "CompressedData = True\n" + key, deflated(std::string(24, 'v')).substr(0, 4)),
         {"holds only"}},
        {"a.mha", mha(key, "CompressedData = True\n" + key, ""), {"holds none"}},
        {"a.mha",
         mha(key, "CompressedData = True\nCompressedDataSize = 999\n" + key),
         {"CompressedDataSize declares 999", "only 24"}},
        {"a.mha",
         mha(key, "CompressedData = True\nCompressedDataSize = x\n" + key),
         {"CompressedDataSize must be a whole number"}},
        {"a.mha",
         mha("2 3 4", "1000000 1000000 4").replace(0, 0, "CompressedData = True\n"),
         {"declares 4000000000000 bytes", "hold at most"}},
        {"a.mha",
         mha("2 3 4\nElementSpacing", "100 275 4\nCompressedData = True\nElementSpacing",
             deflated(std::string(100000, 'v'))),
         {"declares 110000 bytes", "hold only 100000"}},
    };
}

std::vector<MalformedRow> nrrdRows() {
    const std::string encoding = "encoding: raw";
    const auto four = [](const std::string& more) {
        return "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 3 2 2\nencoding: raw\n" + more + "\n" +
               std::string(24, 'v');
    };
    return {
        {"a.nrrd", "", {"ends after 0 bytes"}},
        {"a.nrrd", "garbage", {"does not begin with NRRD"}},
        {"a.nrrd", nrrd("NRRD0004", "NRRD0009"), {"version", "0009"}},
        {"a.nrrd", nrrd("dimension: 3", "dimension 3"), {"line 3", "dimension 3"}},
        {"a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nencoding: raw\n", {"empty line"}},
        {"a.nrrd", nrrd("type: uchar\n", ""), {"type is missing"}},
        {"a.nrrd", nrrd("uchar", "block"), {"type", "\"block\""}},
        {"a.nrrd", nrrd("dimension: 3\n", ""), {"dimension is missing"}},
        {"a.nrrd", nrrd("dimension: 3", "dimension: 2"), {"dimension is 2", "2D picture"}},
        {"a.nrrd", nrrd("dimension: 3", "dimension: 7"), {"dimension must be 3 or 4"}},
        {"a.nrrd", nrrd("sizes: 2 3 4\n", ""), {"sizes is missing"}},
        {"a.nrrd", nrrd("2 3 4", "2 3"), {"sizes must be 3 whole numbers above 0"}},
        {"a.nrrd", nrrd("2 3 4", "2 -3 4"), {"sizes must be 3 whole numbers above 0"}},
        {"a.nrrd", nrrd("2 3 4", "2 0 4"), {"sizes must be 3 whole numbers above 0"}},
        {"a.nrrd", nrrd("2 3 4", "9223372036854775807 2 2"), {"sizes declares more voxels"}},
        {"a.nrrd", nrrd("2 3 4", "2 3 5"), {"sizes declares 30 bytes", "holds only 24"}},
        {"a.nrrd", nrrd("1 1 1", "1 nan 1"), {"spacings must be finite and not 0"}},
        {"a.nrrd", nrrd("1 1 1", "1 0 1"), {"spacings must be finite and not 0"}},
        {"a.nrrd", nrrd("1 1 1", "1 1"), {"spacings must be 3 numbers"}},
        {"a.nrrd", nrrd(encoding, "encoding: ascii"), {"sizes declares 24 bytes", "only 24 characters"}},
        {"a.nrrd", nrrd(encoding, "encoding: bzip2"), {"damaged compressed data", "do not begin like bzip2"}},
        {"a.nrrd", nrrd(encoding, "encoding: hex"), {"sizes declares 24 bytes", "only 24 characters"}},
        {"a.nrrd", nrrd(encoding, "encoding: zstd"), {"encoding is \"zstd\", which is not known"}},
        {"a.nrrd", nrrd(encoding + "\n", ""), {"encoding is missing"}},
        {"a.nrrd", nrrd("uchar", "short"), {"endian is missing"}},
        {"a.nrrd", nrrd(encoding, "endian: middle\n" + encoding), {"endian must be little or big"}},
        {"a.nrrd", nrrd(encoding, "kinds: domain domain\n" + encoding), {"kinds must be 3 words"}},
        {"a.nrrd",
         nrrd(encoding, "space directions: (1,0,0) (0,1,0)\n" + encoding),
         {"space directions must be 3 vectors"}},
        {"a.nrrd", nrrd(encoding, "space directions: (1,0,0 (0,1,0) (0,0,1)\n" + encoding), {"space directions"}},
        {"a.nrrd",
         nrrd(encoding, "space directions: (1,0,0) (0,1,0) none\n" + encoding),
         {"space directions must hold a vector"}},
        {"a.nrrd",
         nrrd(encoding, "space directions: (1,0,0) (0,1,0) (0,0,0)\n" + encoding),
         {"space directions", "not 0"}},
        {"a.nrrd",
         nrrd(encoding, "space directions: (1,0,0) (0,1,0) (0,0,nan)\n" + encoding),
         {"space directions", "finite"}},
        {"a.nrrd",
         nrrd(encoding, "space directions: (1,0,0) (2,0,0) (0,0,1)\n" + encoding),
         {"independent directions"}},
        {"a.nrrd", nrrd(encoding, "space origin: (1,2)\n" + encoding), {"space origin must be one vector"}},
        {"a.nrrd", nrrd(encoding, "space: upside-down\n" + encoding), {"space is \"upside-down\""}},
        {"a.nrrd", nrrd(encoding, "byte skip: -2\n" + encoding), {"byte skip must be -1 or above"}},
        {"a.nrrd",
         nrrd(encoding, "byte skip: 9223372036854775807\n" + encoding),
         {"sizes declares 24 bytes", "holds only 0"}},
        {"a.nrrd", nrrd(encoding, "line skip: 2\n" + encoding), {"line skip is 2", "only 0 lines"}},
        {"a.nrrd", nrrd(encoding, "byte skip: -1\nencoding: gzip"), {"byte skip must be 0 or above"}},
        {"a.nrrd", nrrd(encoding, "WhiteLevel:=-1\n" + encoding), {"WhiteLevel must be a number above 0"}},
        {"a.nrrd", nrrd(encoding, "sizes: 2 3 4\n" + encoding), {"\"sizes\" appears twice"}},
        {"a.nhdr", nrrd(encoding, encoding + "\ndata file: ../x.raw"), {"data file", "own folder"}},
        {"a.nhdr", nrrd(encoding, encoding + "\ndata file: /etc/passwd"), {"data file", "own folder"}},
        {"a.nhdr",
         nrrd(encoding, encoding + "\ndata file: LIST"),
         {"data file names 1 data files where the volume has 4 parts"}},
        {"a.nhdr", nrrd(encoding, encoding + "\ndata file: s%d.raw 0 3 1"), {"s0.raw", "could not be opened"}},
        {"a.nhdr", nrrd(encoding, encoding + "\ndata file: missing.raw"), {"missing.raw", "could not be opened"}},
        {"a.nrrd", nrrd(encoding, "encoding: gzip", "this is not gzip, though long"), {"damaged compressed data"}},
        {"a.nrrd", nrrd(encoding, "encoding: gzip", deflated(std::string(20, 'v'), 31)), {"holds only 20 bytes"}},
        {"a.nrrd", four("kinds: time domain domain time\n"), {"kinds names more than one axis"}},
        {"a.nrrd", four("kinds: domain time domain domain\n"), {"kinds has its time axis in the middle"}},
        {"a.nrrd", four("kinds: vector domain domain domain\n"), {"kinds has an axis of kind \"vector\""}},
        {"a.nrrd", four("kinds: rgb-color domain domain domain\n"), {"colour axis"}},
        {"a.nrrd", nrrd(encoding, "kinds: RGB-color domain domain\n" + encoding), {"2D colour picture"}},
        {"a.nrrd", nrrd(encoding, "kinds: vector domain domain\n" + encoding), {"2D picture of several values"}},
    };
}

void expectRefused(const MalformedRow& row) {
    const TemporaryFolder folder;
    const std::string file = folder.write(row.file, row.bytes);
    const auto study = readStudy(file);
    ASSERT_FALSE(study) << "was read: " << row.words[0];
    EXPECT_EQ(study.error().kind, FailureKind::unreadable);
    const std::string sentence = study.error().sentence();
    EXPECT_THAT(sentence, HasSubstr(folder.path()));
    EXPECT_THAT(sentence, EndsWith("."));
    EXPECT_THAT(sentence, Not(HasSubstr("\n")));
    for (const std::string& words : row.words) EXPECT_THAT(sentence, HasSubstr(words));
}

TEST(MalformedMetaImage, EachGetsItsOwnSentence) {
    for (const MalformedRow& row : metaImageRows()) expectRefused(row);
}

TEST(MalformedNrrd, EachGetsItsOwnSentence) {
    for (const MalformedRow& row : nrrdRows()) expectRefused(row);
}

TEST(MalformedText, EveryTruncationOfAHeaderIsRefused) {
    const TemporaryFolder folder;
    for (const auto& [name, whole] : {std::pair{"a.mha", mha(last, last)}, std::pair{"a.nrrd", nrrd("type", "type")}})
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto study = readStudy(folder.write(name, whole.substr(0, length)));
            ASSERT_FALSE(study) << name << " cut to " << length;
            EXPECT_FALSE(study.error().problem.empty());
        }
}

TEST(MalformedText, HeaderWithoutEndIsNotReadForEver) {
    const TemporaryFolder folder;
    const auto study = readStudy(folder.write("a.mha", "ObjectType = Image\n" + std::string(3 << 20, '\n')));
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("looked through 1048576 bytes"));
}

TEST(UnknownFiles, AreRefusedWithWhatToDo) {
    const TemporaryFolder folder;
    const auto sentenceOf = [&](const std::string& bytes) {
        const auto study = readStudy(folder.write("file.bin", bytes));
        return study ? std::string("was read") : study.error().sentence();
    };
    EXPECT_THAT(
        sentenceOf("whatever"),
        AllOf(HasSubstr("is no MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz) file"), HasSubstr("--raw-size")));
    EXPECT_THAT(sentenceOf(""), HasSubstr("is empty"));
    EXPECT_THAT(sentenceOf("PK\x03\x04 and more"), HasSubstr("is a ZIP archive"));
    EXPECT_THAT(sentenceOf("KRETZFILE 1.0   "), HasSubstr("the size of the volume is not known"));
    EXPECT_THAT(readStudy(folder.file("nothing.mha")).error().sentence(), HasSubstr("does not exist"));
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("folder without DICOM images"));
}

}  // namespace
}  // namespace echolucent
