// The table of files that open and files that do not, on files of its own and on real ones beside the source tree.
#include "app/cli/report/file_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "shared_data.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using cli::fileRow;
using cli::fileTable;
using testing::HasSubstr;

TEST(FileTable, SaysOfEveryFileHowItOpensOrWhyItDoesNot) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("deep"));
    std::ofstream(folder.file("deep/note|.txt")) << "no volume";
    std::ofstream(folder.file("a.mha")) << "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\n"
                                           "ElementSpacing = 0.5 0.5 1\nElementDataFile = LOCAL\n"
                                        << std::string(24, 'x');
    std::ofstream(folder.file(".hidden")) << "x";
    const auto table = fileTable(folder.path(), {});
    ASSERT_TRUE(table) << table.error().sentence();
    EXPECT_THAT(*table, HasSubstr("| `a.mha` | opens | MetaImage {keys of the header}; 2 x 3 x 4 uint8; "
                                  "0.5 x 0.5 x 1 mm {ElementSpacing}; white 255 {8-bit voxels}; 0.0 % {"));
    EXPECT_THAT(*table, HasSubstr("| `deep/note\\|.txt` | refused |")) << "a bar in a name would end the cell";
    EXPECT_THAT(*table, Not(HasSubstr("hidden")));
    EXPECT_THAT(*table, Not(HasSubstr(folder.path()))) << "the row names the file already";
}

TEST(FileTable, RefusesWhatIsNoFolder) {
    const auto table = fileTable("/nowhere/at/all", {});
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().kind, FailureKind::unreadable);
}

/// The lines of docs/formats-read.md that are rows of a file: "| `name` | opens | ..." by name.
std::map<std::string, std::string> documentedRows() {
    std::ifstream page(ECHOLUCENT_SOURCE_DIR "/docs/formats-read.md");
    std::map<std::string, std::string> rows;
    for (std::string line; std::getline(page, line);)
        for (const char* outcome : {"` | opens | ", "` | refused | "})
            if (const auto end = line.find(outcome); line.starts_with("| `") && end != std::string::npos)
                rows[line.substr(3, end - 3)] = line;
    return rows;
}

class SharedFiles : public testing::TestWithParam<const char*> {};

/// docs/formats-read.md says with which command a row is made anew.
TEST_P(SharedFiles, OpenOrAreRefusedAsTheTableSays) {
    const std::string folder = sharedData + "/" + GetParam();
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the shared data are not here: " << folder;
    const auto rows = documentedRows();
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto row = rows.find(name);
        ASSERT_NE(row, rows.end()) << name << " has no row in docs/formats-read.md";
        EXPECT_EQ(fileRow(entry.path().string(), name), row->second);
        ++files;
    }
    EXPECT_GT(files, 8);
}

INSTANTIATE_TEST_SUITE_P(All, SharedFiles, testing::Values("dicom", "bad", "volumes"),
                         [](const auto& folder) { return std::string(folder.param); });

}  // namespace
}  // namespace echolucent
