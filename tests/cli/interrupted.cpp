// What the program leaves where something ends it, and the sentences where an output is no file.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "program.h"

namespace echolucent {
namespace {

/// The program with these arguments, in a process of its own.
pid_t begin(const std::vector<std::string>& arguments) {
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> words{const_cast<char*>(ECHOLUCENT_CLI)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    execv(words.front(), words.data());
    _exit(127);
}

/// The files of a folder whose names end as movies that are being written do.
std::vector<std::string> moviesIn(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".avi") names.push_back(entry.path().string());
    return names;
}

class Interrupted : public testing::TestWithParam<int> {};

/// The movie takes minutes; the signal comes once it has begun.
TEST_P(Interrupted, AMovieLeavesNothingAndTheSignalIsSeen) {
    const Folder folder;
    const std::string movie = folder / "movie.avi";
    const pid_t child =
        begin({"sweep", shapesFile(), "--to", "45", "--step", "0.01", "--static", "--size", "64x64", "--movie", movie});
    int status = 0;
    while (moviesIn(folder / "").empty()) {
        ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "the program ended before the movie began";
        sched_yield();
    }
    ASSERT_EQ(kill(child, GetParam()), 0);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

INSTANTIATE_TEST_SUITE_P(Commands, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(NoFile, AnOutputThatIsNoFileIsRefusedBeforeAnythingIsRead) {
    const Folder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink(folder / "pipe", folder / "link.avi");
    std::filesystem::create_directory(folder / "folder.png");
    const std::string none = "\"" + folder / "no.mha" + "\"", in = " \"" + folder / "";
    for (const auto& [arguments, why] : std::vector<std::pair<std::string, std::string>>{
             {"render " + none + " -o" + in + "pipe\"", "pipe: could not be written: it is a named pipe."},
             {"otf " + none + " --json" + in + "pipe\"", "it is a named pipe."},
             {"otf " + none + " --csv" + in + "pipe\"", "it is a named pipe."},
             {"otf " + none + " --tubes-csv" + in + "pipe\"", "it is a named pipe."},
             {"sweep " + none + " --movie" + in + "link.avi\"", "link.avi: could not be written: it is a named pipe."},
             {"sweep " + none + " --csv" + in + "pipe\"", "it is a named pipe."},
             {"quiet " + none + " -o" + in + "pipe\"", "it is a named pipe."},
             {"info " + none + " --json" + in + "pipe\"", "it is a named pipe."},
             {"files" + in + "\" -o" + in + "pipe\"", "it is a named pipe."},
             {"phantom" + in + "pipe\"", "it is a named pipe."},
             {"phantom" + in + "x.mha\" --truth" + in + "pipe\"", "it is a named pipe."},
             {"render " + none + " -o" + in + "folder.png\"", "it is a folder."},
             {"render " + none + " -o /dev/null", "/dev/null: could not be written: it is a device."},
             {"render " + none + " -o" + in + "none/x.png\"", "its folder is not there."}}) {
        const Outcome outcome = runProgram(arguments);
        EXPECT_EQ(outcome.status, 4) << arguments;
        EXPECT_NE(outcome.errors.find(why), std::string::npos) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }
}

TEST(NoFile, TheStandardOutputMayBeNamedAsADevice) {
    const Outcome outcome = runProgram("otf \"" + shapesFile() + "\" --csv /dev/stdout | cat");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.output.substr(0, 9), "intensity");
}

/// What a command may take, in KiB. Under the address sanitizer freed memory stays in quarantine, also that of this
/// process, which the kernel counts as the child's until it starts the command.
#ifdef __SANITIZE_ADDRESS__
constexpr long mostKibibytes = 1024 << 10;
#else
constexpr long mostKibibytes = 256 << 10;
#endif

/// One line of voxels as MetaImage.
std::string lineOfVoxels(const std::string& size, std::size_t count) {
    return "ObjectType = Image\nNDims = 3\nDimSize = " + size +
           "\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + std::string(count, 'x');
}

TEST(LinesOfVoxels, AreRefusedWhereTheyAreLongerThanAnyScanAndTakeLittleMemoryWhereNot) {
    const Folder folder;
    const std::string file = folder / "line.mha", png = folder / "x.png", quiet = folder / "q.mha";
    const std::vector<std::vector<std::string>> commands{
        {"otf", file, "--json", folder / "o.json"},
        {"render", file, "--size", "64x64", "-o", png},
        {"render", file, "--near", "auto", "--size", "64x64", "-o", png},
        {"quiet", file, "-o", quiet}};
    for (const char* shape : {"4000000 1 1", "1 4000000 1", "1 1 4000000"}) {
        write(file, lineOfVoxels(shape, 4'000'000));
        const Outcome outcome = runProgram("otf \"" + file + "\" --json -");
        EXPECT_EQ(outcome.status, 3);
        EXPECT_NE(outcome.errors.find("4000000 times as long as its smallest spacing; the most is 100000."),
                  std::string::npos)
            << outcome.errors;
    }
    for (const char* shape : {"100000 1 1", "1 100000 1", "1 1 100000"}) {
        write(file, lineOfVoxels(shape, 100'000));
        for (const auto& command : commands) {
            int status = 0;
            rusage used{};
            const pid_t child = begin(command);
            ASSERT_EQ(wait4(child, &status, 0, &used), child);
            EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << shape << ": " << command.front();
            EXPECT_LT(used.ru_maxrss, mostKibibytes) << "KiB; " << shape << ": " << command.front();
        }
    }
}

}  // namespace
}  // namespace echolucent
