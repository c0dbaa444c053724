// Files appear whole or not at all, and what stood at the path keeps its kind.
#include "io/output/atomic_file.h"
#include "io/files/input_file.h"
#include "io/output/interruption.h"
#include "io/output/overwriting.h"
#include "io/output/unfinished_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/io/written_files/temporary_folder.h"

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

TEST(AtomicFile, AFileWithTheLongestNameIsReplaced) {
    const TemporaryFolder folder;
    const std::string path = folder.file(std::string(NAME_MAX, 'n'));
    for (const std::string bytes : {"old", "new"}) {
        const auto written = writeFileAtomically(path, bytes);
        ASSERT_TRUE(written) << written.error().sentence();
        EXPECT_EQ(readWholeFile(path, 100).value(), bytes);
    }
    auto unfinished = UnfinishedFile::beside(path, ".mp4");
    ASSERT_TRUE(unfinished) << unfinished.error().sentence();
    EXPECT_TRUE(unfinished->name().ends_with(".mp4"));
    ASSERT_TRUE(unfinished->putInPlace());
    EXPECT_EQ(readWholeFile(path, 100).value(), "");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
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

/// The sentence that a file of this name is refused with; an empty one where it is written.
std::string refusalOf(const std::string& path) {
    const auto written = writeFileAtomically(path, std::string(100000, 'x'));
    if (written) return {};
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
    return written.error().sentence();
}

TEST(AtomicFile, WhatIsNoFileIsRefusedAtOnceAndStaysWhatItIs) {
    const TemporaryFolder folder;
    const std::string pipe = folder.file("pipe"), link = folder.file("link.png"), socket = folder.file("socket");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink(pipe, link);
    sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
    socket.copy(address.sun_path, sizeof address.sun_path - 1);
    const int listening = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    // Nobody reads from the pipe: whoever opened it would wait for ever.
    for (const std::string& name : {pipe, link}) {
        EXPECT_NE(refusalOf(name).find("could not be written: it is a named pipe."), std::string::npos);
        EXPECT_FALSE(UnfinishedFile::beside(name));
    }
    EXPECT_NE(refusalOf(socket).find("it is a socket."), std::string::npos);
    EXPECT_NE(refusalOf("/dev/null").find("it is a device."), std::string::npos);
    EXPECT_NE(refusalOf(folder.path()).find("it is a folder."), std::string::npos);
    EXPECT_NE(refusalOf(folder.file("none/x")).find("its folder is not there."), std::string::npos);
    EXPECT_NE(refusalOf("/dev/fd/987").find("it is not open for writing."), std::string::npos);
    EXPECT_TRUE(S_ISFIFO(modeOf(pipe)));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
    close(listening);
}

TEST(AtomicFile, ADescriptorThatTheProgramWasStartedWithIsWrittenInto) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    EXPECT_EQ(refusalOf("/dev/fd/" + std::to_string(ends[0])).empty(), false) << "that end is only read from";
    ASSERT_TRUE(writeFileAtomically("/dev/fd/" + std::to_string(ends[1]), "through"));
    std::array<char, 16> bytes{};
    EXPECT_EQ(
        std::string(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(read(ends[0], bytes.data(), 16), 0))),
        "through");
    for (const int end : ends) close(end);
}

/// What ended a process that did this.
template <typename Do>
int endOf(const Do& what) {
    const pid_t child = fork();
    if (child == 0) {
        what();
        _exit(0);
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/// The kernel ends the process at the 64th kilobyte; nothing can be done about it.
TEST(AtomicFile, NothingIsLeftWhereTheProgramIsKilledWhileItWrites) {
    const TemporaryFolder folder;
    const std::string old = folder.file("old.txt");
    std::ofstream(old) << "old";
    const int probe = open(folder.path().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (probe < 0) GTEST_SKIP() << "this file system has no files without a name";
    close(probe);
    for (const std::string& name : {old, folder.file("new.txt")})
        EXPECT_EQ(endOf([&] {
                      const rlimit limit{.rlim_cur = 65536, .rlim_max = 65536}, noCore{.rlim_cur = 0, .rlim_max = 0};
                      setrlimit(RLIMIT_CORE, &noCore);
                      setrlimit(RLIMIT_FSIZE, &limit);
                      (void)writeFileAtomically(name, std::string(1 << 20, 'x'));
                  }),
                  SIGXFSZ);
    EXPECT_EQ(readWholeFile(old, 100).value(), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(AtomicFile, NothingIsLeftOfAFileThatASignalInterrupts) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const TemporaryFolder folder;
        EXPECT_EQ(endOf([&] {
                      removeUnfinishedOnSignals();
                      auto kept = UnfinishedFile::beside(folder.file("kept"));
                      auto movie = UnfinishedFile::beside(folder.file("movie.avi"), ".avi");
                      if (kept && movie && kept->putInPlace()) raise(signal);
                  }),
                  signal);
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
        EXPECT_TRUE(std::filesystem::exists(folder.file("kept")));
    }
}

TEST(AtomicFile, ASignalThatIsIgnoredStaysIgnored) {
    EXPECT_EQ(endOf([] {
                  ::signal(SIGHUP, SIG_IGN);
                  removeUnfinishedOnSignals();
                  raise(SIGHUP);
              }),
              0);
}

TEST(KeptFiles, NoFileOfAnotherKindTakesTheirPlace) {
    const TemporaryFolder folder;
    const std::string voxels = folder.file("v.raw"), curve = folder.file("curve.json"), link = folder.file("x.png");
    std::ofstream(voxels) << "voxels";
    std::ofstream(curve) << "curve";
    std::filesystem::create_hard_link(voxels, link);
    auto unfinished = UnfinishedFile::beside(voxels);
    ASSERT_TRUE(unfinished);
    {
        const KeptFiles read({voxels}), curves({curve}, OutputKind::curve);
        for (const std::string& name :
             {voxels, link,
              folder.file("../" + folder.path().substr(folder.path().find_last_of('/') + 1) + "/v.raw")}) {
            const auto written = writeFileAtomically(name, "x");
            ASSERT_FALSE(written) << name;
            EXPECT_EQ(written.error().kind, FailureKind::wrongUsage);
            EXPECT_FALSE(writeFileAtomically(name, "x", OutputKind::curve)) << name;
        }
        EXPECT_FALSE(unfinished->putInPlace()) << "it was begun before the file was read";
        EXPECT_FALSE(writeFileAtomically(curve, "session", OutputKind::session));
        EXPECT_FALSE(writeFileAtomically(curve, "picture"));
        EXPECT_TRUE(writeFileAtomically(curve, "a newer curve", OutputKind::curve));
    }
    EXPECT_EQ(readWholeFile(voxels, 100).value(), "voxels");
    EXPECT_EQ(readWholeFile(curve, 100).value(), "a newer curve");
    EXPECT_TRUE(writeFileAtomically(voxels, "new")) << "it is kept no longer";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
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
