// Files appear whole or not at all, and what stood at the path keeps its kind.
#include "io/output/atomic_file.h"
#include "io/input_file.h"
#include "io/output/unfinished_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/io/temporary_folder.h"

namespace echolucent {
namespace {

mode_t modeOf(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0);
    return status.st_mode;
}

TEST(AtomicFile, ANewFileHoldsTheBytesAndNothingElseIsLeft) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder.file("new.txt"), "some bytes"));
    EXPECT_EQ(readWholeFile(folder.file("new.txt"), 100).value(), "some bytes");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(AtomicFile, AFileKeepsItsPermissionsAndALinkStaysALink) {
    const TemporaryFolder folder;
    const std::string target = folder.file("target"), link = folder.file("link");
    std::ofstream(target) << "old";
    ASSERT_EQ(chmod(target.c_str(), 0600), 0);
    std::filesystem::create_symlink(target, link);
    ASSERT_TRUE(writeFileAtomically(link, "new"));
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(readWholeFile(target, 100).value(), "new");
    EXPECT_EQ(modeOf(target) & 07777, 0600u);
}

/// Whose umask is set for a moment makes files that everybody may write.
TEST(AtomicFile, FilesThatOthersMakeMeanwhileHaveTheirPermissions) {
    const TemporaryFolder folder;
    const auto modeOfAPlainFile = [&] {
        const std::string plain = folder.file("plain");
        std::filesystem::remove(plain);
        std::ofstream(plain) << "x";
        return modeOf(plain) & 07777;
    };
    const mode_t usual = modeOfAPlainFile();
    std::atomic<int> making = 3;
    std::vector<std::thread> makers;
    for (int i = 0; i < 3; ++i)
        makers.emplace_back([&, i] {
            for (int file = 0; file < 1000; ++file)
                EXPECT_TRUE(UnfinishedFile::beside(folder.file("file" + std::to_string(i))));
            --making;
        });
    int other = 0;
    do other += modeOfAPlainFile() != usual;
    while (making > 0);
    for (std::thread& maker : makers) maker.join();
    EXPECT_EQ(other, 0);
    EXPECT_EQ(modeOfAPlainFile(), usual);
    ASSERT_TRUE(writeFileAtomically(folder.file("new.txt"), "some bytes"));
    EXPECT_EQ(modeOf(folder.file("new.txt")) & 07777, usual);
}

TEST(AtomicFile, APipeIsWrittenIntoAndStaysAPipe) {
    const TemporaryFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] {
        std::ifstream stream(pipe);
        received.assign(std::istreambuf_iterator<char>(stream), {});
    });
    const auto written = writeFileAtomically(pipe, "through");
    reader.join();
    EXPECT_TRUE(written);
    EXPECT_EQ(received, "through");
    EXPECT_TRUE(S_ISFIFO(modeOf(pipe)));
}

TEST(AtomicFile, AFullDeviceIsAFailureAndStaysADevice) {
    struct stat status {};
    if (stat("/dev/full", &status) != 0 || !S_ISCHR(status.st_mode)) GTEST_SKIP() << "there is no /dev/full here";
    const auto written = writeFileAtomically("/dev/full", std::string(100000, 'x'));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
    EXPECT_TRUE(S_ISCHR(modeOf("/dev/full")));
}

TEST(AtomicFile, AFolderIsRefusedAndAnOldFileSurvivesAFailure) {
    const TemporaryFolder folder;
    const auto written = writeFileAtomically(folder.path(), "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
    EXPECT_FALSE(writeFileAtomically(folder.file("no such folder/file"), "x"));
}

}  // namespace
}  // namespace echolucent
