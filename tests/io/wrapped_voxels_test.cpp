// Data files that are files of another format, packed or not: their headers are skipped or refused, never shown.
#include <gtest/gtest.h>

#include "bzip2_bytes.h"
#include "nifti_files.h"
#include "split_volume.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

const std::string bytesNrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 0.5 0.25 2\n";
const std::string bytesMetaImage =
    "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nElementSpacing = 0.5 0.25 2\n";

class WrappedVoxels : public testing::Test {
protected:
    [[nodiscard]] Result<Study> nrrd(const std::string& fields) const {
        return readStudy(m_folder.write("v.nhdr", bytesNrrd + fields), withoutGuess());
    }
    [[nodiscard]] Result<Study> metaImage(const std::string& keys) const {
        return readStudy(m_folder.write("v.mhd", bytesMetaImage + keys), withoutGuess());
    }
    static void expectVoxels(const Result<Study>& study, const std::string& note) {
        ASSERT_TRUE(study) << study.error().sentence();
        const auto values = storedValues(*study->phases[0]);
        ASSERT_EQ(values.size(), 24U);
        for (std::size_t i = 0; i < 24; ++i) ASSERT_EQ(values[i], i + 1) << note;
        if (note.empty())
            EXPECT_TRUE(study->warnings.empty()) << study->warnings.front();
        else
            EXPECT_TRUE(warnsOf(*study, note)) << note;
    }
    static void expectRefused(const Result<Study>& study, const std::string& words) {
        ASSERT_FALSE(study);
        EXPECT_NE(study.error().sentence().find(words), std::string::npos) << study.error().sentence();
    }
    TemporaryFolder m_folder;
};

/// Files of the same voxels in other formats, by the name that a note gives them.
std::vector<std::pair<std::string, std::string>> foreignFiles() {
    NiftiFields second;
    second.version = 2;
    NiftiFields extended;
    extended.bigEndian = true;
    extended.voxOffset = 368;
    std::vector<std::pair<std::string, std::string>> files{
        {"A NIfTI header", niftiHeader({}) + countedVoxels},
        {"A NIfTI header", niftiHeader(second) + countedVoxels},
        {"A NIfTI header", niftiHeader(extended) + std::string(16, 'e') + countedVoxels},
        {"An NRRD file", bytesNrrd + "encoding: raw\n\n" + countedVoxels},
        {"A MetaImage", bytesMetaImage + "ElementDataFile = LOCAL\n" + countedVoxels}};
    return files;
}

TEST_F(WrappedVoxels, HeadersAreSkippedWhereTheLengthProvesThem) {
    for (const auto& [name, bytes] : foreignFiles()) {
        m_folder.write("f.dat", bytes);
        m_folder.write("f.gz", deflated(bytes, 31));
        m_folder.write("f.z", deflated(bytes));
        m_folder.write("f.bz2", bzipped(bytes));
        expectVoxels(nrrd("encoding: raw\ndata file: f.dat\n"), name);
        expectVoxels(nrrd("encoding: gzip\ndata file: f.gz\n"), name);
        expectVoxels(nrrd("encoding: bzip2\ndata file: f.bz2\n"), name);
        expectVoxels(metaImage("ElementDataFile = f.dat\n"), name);
        expectVoxels(metaImage("CompressedData = True\nElementDataFile = f.z\n"), name);
    }
    m_folder.write("p.img", niftiHeader({}) + countedVoxels);
    NiftiFields apart;
    apart.apart = true;
    expectVoxels(readStudy(m_folder.write("p.hdr", niftiHeader(apart)), withoutGuess()), "A NIfTI header");
}

TEST_F(WrappedVoxels, SkipsThatTheHeaderAsksForNeedNoNote) {
    m_folder.write("f.nii", niftiHeader({}) + countedVoxels);
    m_folder.write("f.nii.gz", deflated(niftiHeader({}) + countedVoxels, 31));
    m_folder.write("f.mha", bytesMetaImage + "ElementDataFile = LOCAL\n" + countedVoxels);
    expectVoxels(nrrd("encoding: raw\nbyte skip: 352\ndata file: f.nii\n"), "");
    expectVoxels(nrrd("encoding: raw\nbyte skip: -1\ndata file: f.nii\n"), "");
    expectVoxels(nrrd("encoding: gzip\nbyte skip: 352\ndata file: f.nii.gz\n"), "");
    expectVoxels(nrrd("encoding: gzip\nbyte skip: -1\ndata file: f.nii.gz\n"), "");
    expectVoxels(nrrd("encoding: raw\nline skip: 6\ndata file: f.mha\n"), "");
    expectVoxels(metaImage("HeaderSize = 352\nElementDataFile = f.nii\n"), "");
    expectVoxels(metaImage("HeaderSize = -1\nElementDataFile = f.nii\n"), "");
    m_folder.write("short.gz", deflated(countedVoxels.substr(1), 31));
    expectRefused(nrrd("encoding: gzip\nbyte skip: -1\ndata file: short.gz\n"), "only 23");
}

TEST_F(WrappedVoxels, HeadersOfAllFilesOfAListAreSkipped) {
    for (std::size_t z = 0; z < 4; ++z) {
        NiftiFields slice;
        slice.dim = {3, 2, 3, 1};
        m_folder.write("s" + std::to_string(z) + ".nii", niftiHeader(slice) + countedVoxels.substr(z * 6, 6));
    }
    expectVoxels(nrrd("encoding: raw\ndata file: s%d.nii 0 3 1\n"), "A NIfTI header");
    m_folder.write("s2.nii", countedVoxels.substr(12, 6));
    expectRefused(nrrd("encoding: raw\ndata file: s%d.nii 0 3 1\n"), "do not begin at one place");
}

TEST_F(WrappedVoxels, HeadersThatNothingProvesAreRefused) {
    NiftiFields apart;
    apart.apart = true;
    std::string analyze = niftiHeader({});
    analyze.replace(344, 4, std::string(4, '\0'));
    analyze[38] = 'r';
    for (const auto& [words, bytes] : std::vector<std::pair<std::string, std::string>>{
             {"where a NIfTI header stands", niftiHeader({}) + countedVoxels + "more"},
             {"where a NIfTI header stands", niftiHeader(apart) + std::string(4, '\0') + countedVoxels},
             {"where an Analyze 7.5 header stands", analyze + countedVoxels},
             {"where a DICOM file stands", std::string(128, '\0') + "DICM" + countedVoxels},
             {"where a DICOM file stands", std::string("\x02\0\0\0UL\x04\0", 8) + std::string(400, 'd')},
             {"where a GE Voluson volume (Kretz) stands", "KRETZFILE 1.0   " + countedVoxels},
             {"where an NRRD file stands", bytesNrrd + "encoding: gzip\n\n" + deflated(countedVoxels, 31)},
             {"where a MetaImage stands", bytesMetaImage + "ElementDataFile = other.raw\n"}}) {
        m_folder.write("f.dat", bytes);
        m_folder.write("f.gz", deflated(bytes, 31));
        for (const auto& study :
             {nrrd("encoding: raw\ndata file: f.dat\n"), nrrd("encoding: gzip\ndata file: f.gz\n"),
              metaImage("ElementDataFile = f.dat\n"), metaImage("CompressedData = True\nElementDataFile = f.gz\n")})
            expectRefused(study, words);
    }
}

TEST_F(WrappedVoxels, OfALayoutBeginNoHeaderEither) {
    RawLayout layout;
    layout.size = {2, 3, 4};
    layout.type = "uint8";
    layout.headerBytes = 5;
    const std::string raw = m_folder.write("f.raw", "first" + niftiHeader({}) + countedVoxels);
    ASSERT_TRUE(rememberRawLayout(raw, layout));
    expectVoxels(readStudy(raw, withoutGuess()), "A NIfTI header");
}

TEST_F(WrappedVoxels, RawOnesThatArePackedAreUnpacked) {
    for (const std::string& bytes : {countedVoxels, niftiHeader({}) + countedVoxels}) {
        m_folder.write("f.raw.gz", deflated(bytes, 31));
        expectVoxels(nrrd("encoding: raw\ndata file: f.raw.gz\n"), "holds gzip, of which the header says nothing");
        expectVoxels(metaImage("ElementDataFile = f.raw.gz\n"), "holds gzip, of which the header says nothing");
    }
    expectVoxels(nrrd("encoding: raw\nbyte skip: -1\ndata file: f.raw.gz\n"), "holds gzip");
    // As many bytes as declared are voxels, however they begin; so are more that do not unpack.
    const std::string chance = "\x1f\x8b\x08" + std::string(21, '\x07');
    for (const std::string& bytes : {chance, chance + "more"}) {
        m_folder.write("f.raw", bytes);
        const auto study = nrrd("encoding: raw\ndata file: f.raw\n");
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->storedValue(0), 0x1f);
    }
}

/// Bytes that deflate and bzip2 make longer.
std::string noise(std::size_t count) {
    std::string bytes;
    std::uint32_t state = 7;
    for (std::size_t i = 0; i < count; ++i) {
        state = state * 1664525U + 1013904223U;
        bytes += static_cast<char>(state >> 24);
    }
    return bytes;
}

TEST_F(WrappedVoxels, RawOnesThatUnpackToAllVoxelsAreUnpackedHoweverLongTheyAre) {
    const std::string voxels = noise(24 * 32 * 40);
    const std::string meta = "NDims = 3\nDimSize = 24 32 40\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\n";
    const std::string fields = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 24 32 40\nspacings: 1 1 1\nencoding: raw\n";
    NiftiFields nifti;
    nifti.dim = {3, 24, 32, 40};
    nifti.apart = true;
    const std::vector<std::pair<std::string, std::string>> packings{
        {"gzip", deflated(voxels, 31)}, {"zlib", deflated(voxels)}, {"bzip2", bzipped(voxels)}};
    for (const auto& [name, packed] : packings) {
        ASSERT_GT(packed.size(), voxels.size());
        m_folder.write("p.raw", packed);
        m_folder.write("n.img", packed);
        for (const std::string& file :
             {m_folder.write("v.nrrd", fields + "\n" + packed), m_folder.write("v.nhdr", fields + "data file: p.raw\n"),
              m_folder.write("v.mha", meta + "ElementDataFile = LOCAL\n" + packed),
              m_folder.write("v.mhd", meta + "ElementDataFile = p.raw\n"),
              m_folder.write("n.hdr", niftiHeader(nifti))}) {
            const auto study = readStudy(file, withoutGuess());
            ASSERT_TRUE(study) << file << study.error().sentence();
            EXPECT_TRUE(warnsOf(*study, "holds " + name + ", of which")) << file;
            for (std::int64_t i = 0; i < 24 * 32 * 40; i += 7)
                ASSERT_EQ(study->phases[0]->fileValue(i),
                          static_cast<unsigned char>(voxels[static_cast<std::size_t>(i)]))
                    << file << name;
        }
    }
}

TEST_F(WrappedVoxels, RawOnesThatOnlyBeginLikePackedOnesStayVoxels) {
    const std::string packed = deflated(countedVoxels + "more");
    // As many bytes as declared, but another checksum; more voxels than declared; the beginning of zlib alone.
    std::string wrong = deflated(countedVoxels);
    wrong.back() = static_cast<char>(wrong.back() ^ 1);
    for (const std::string& bytes : {wrong, packed, "\x78\x9c" + std::string(30, 'v'), std::string(24, '\x78'),
                                     "BZh91AY&SY" + std::string(20, 'v')}) {
        m_folder.write("f.raw", bytes);
        const auto study = nrrd("encoding: raw\ndata file: f.raw\n");
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->storedValue(0), static_cast<unsigned char>(bytes[0]));
        EXPECT_FALSE(warnsOf(*study, "is unpacked"));
    }
}

}  // namespace
}  // namespace echolucent
