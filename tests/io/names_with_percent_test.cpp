// Data files whose names hold a per cent sign or blanks, which could be patterns.
#include <gtest/gtest.h>

#include "nifti_files.h"
#include "split_volume.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

class NamesWithPercent : public testing::Test {
protected:
    /// The header in either format, with `name` as its data file.
    [[nodiscard]] std::vector<Result<Study>> readBoth(const std::string& name) const {
        std::vector<Result<Study>> studies;
        studies.push_back(
            readStudy(m_folder.write("v.nhdr", splitNrrd("encoding: raw\ndata file: " + name + "\n")), withoutGuess()));
        studies.push_back(
            readStudy(m_folder.write("v.mhd", splitMetaImage("ElementDataFile = " + name + "\n")), withoutGuess()));
        return studies;
    }
    void expectBoth(const std::string& name, std::size_t files, const std::string& note = "") const {
        for (const auto& study : readBoth(name)) {
            ASSERT_TRUE(study) << study.error().sentence();
            const auto values = storedValues(*study->phases[0]);
            for (std::size_t i = 0; i < 24; ++i) ASSERT_EQ(values[i], i + 1) << name;
            EXPECT_EQ(study->files.size(), files + 1) << name;
            EXPECT_EQ(warnsOf(*study, "is taken for no pattern"), !note.empty()) << name;
            EXPECT_TRUE(note.empty() || warnsOf(*study, note)) << name;
        }
    }
    TemporaryFolder m_folder;
};

TEST_F(NamesWithPercent, OpenWhereTheFileExists) {
    for (const char* name : {"scan 50%.raw", "100%", "%", "a%%b.raw", "scan%2050.raw", "%s.raw", "50 % of it.raw",
                             "half %n.raw", "a%d%d.raw"}) {
        m_folder.write(name, splitVoxels());
        expectBoth(name, 1);
    }
}

TEST_F(NamesWithPercent, CountAsNamesBeforePatterns) {
    for (std::size_t z = 0; z < 4; ++z)
        m_folder.write("s" + std::to_string(z + 1) + ".raw", splitVoxels().substr(z * 12, 12));
    const std::string name = "s%d.raw 1 4 1";
    expectBoth(name, 4);
    m_folder.write(name, splitVoxels());
    expectBoth(name, 1, "A file is called \"s%d.raw 1 4 1\", word for word");
}

TEST_F(NamesWithPercent, MayBePatternsWithBlanks) {
    for (std::size_t z = 0; z < 4; ++z)
        m_folder.write("my scan 7 no 00" + std::to_string(z) + ".raw", splitVoxels().substr(z * 12, 12));
    expectBoth("my scan 7 no %03d.raw 0 3 1", 4);
    expectBoth("my scan 7 no 00%d.raw\t0  3 1 ", 4);
}

TEST_F(NamesWithPercent, AreNamedWholeIfTheyAreMissing) {
    for (const std::string name : {"scan 50%.raw", "70 % of it.raw", "scan %q 1 2 3"})
        for (const auto& study : readBoth(name)) {
            ASSERT_FALSE(study);
            EXPECT_NE(study.error().sentence().find("is \"" + name + "\", which is no pattern"), std::string::npos)
                << study.error().sentence();
        }
    // A space that a browser wrote is a pattern too; without such files, the whole name is told.
    const auto coded = readBoth("scan%20data.raw");
    EXPECT_NE(coded[0].error().sentence().find("\"scan%20data.raw\""), std::string::npos);
    EXPECT_NE(coded[1].error().sentence().find("ElementDataFile is \"scan%20data.raw\": neither that file"),
              std::string::npos)
        << coded[1].error().sentence();
}

TEST_F(NamesWithPercent, OfPairsListsAndLayoutsAreTakenWordForWord) {
    NiftiFields apart;
    apart.apart = true;
    m_folder.write("a 50%d.img", countedVoxels);
    EXPECT_TRUE(readStudy(m_folder.write("a 50%d.hdr", niftiHeader(apart))));
    m_folder.write("b%.raw", splitVoxels());
    EXPECT_TRUE(readStudy(m_folder.write("l.nhdr", splitNrrd("encoding: raw\ndata file: LIST 3\nb%.raw\n"))));
    const std::string raw = m_folder.write("c %s.raw", countedVoxels);
    RawLayout layout;
    layout.size = {2, 3, 4};
    layout.type = "uint8";
    ASSERT_TRUE(rememberRawLayout(raw, layout));
    const auto study = readStudy(raw, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(23), 24);
}

}  // namespace
}  // namespace echolucent
