// What echolucent-cli and the program that it starts for studies are to each other.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "tests/cli/program.h"

namespace echolucent {
namespace {

TEST(StudyProgram, IsMissedInOneSentence) {
    const Folder folder;
    const std::string alone = folder / "echolucent-cli";
    std::filesystem::copy_file(ECHOLUCENT_CLI, alone);
    for (const std::string command : {"study stability -o x", "--threads 1 bench otf"}) {
        const int raw = std::system(("\"" + alone + "\" " + command + " 2>\"" + folder / "err" + "\"").c_str());
        EXPECT_TRUE(WIFEXITED(raw) && WEXITSTATUS(raw) == 3) << raw;
        const std::string errors = contentsOf(folder / "err");
        EXPECT_NE(errors.find("echolucent-study: cannot be started to measure: it is not there. Install Echolucent "
                              "again.\n"),
                  std::string::npos)
            << errors;
    }
}

TEST(StudyProgram, TakesArgumentsAsTheyAreAndWritesWhereTheCommandLineWould) {
    const Folder folder;
    const Outcome outcome = runProgram("study --threads 1 cut \"" + folder / "no such; file.mha" + "\"");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.output, "");
    EXPECT_NE(outcome.errors.find("no such; file.mha"), std::string::npos) << outcome.errors;
    const Outcome version = runProgram("--version study");
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.output, runProgram("--version").output);
}

/// The study takes minutes; the signal comes once its folder is there.
TEST(StudyProgram, ASignalToTheCommandLineEndsIt) {
    const Folder folder;
    const std::string output = folder / "out";
    const pid_t child = fork();
    if (child == 0) {
        execl(ECHOLUCENT_CLI, ECHOLUCENT_CLI, "study", "quiet", "--seeds", "1-900", "-o", output.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    while (!std::filesystem::exists(output)) {
        ASSERT_EQ(waitpid(child, &status, WNOHANG), 0) << "the study ended before it began";
        sched_yield();
    }
    const auto running = std::filesystem::read_symlink("/proc/" + std::to_string(child) + "/exe");
    EXPECT_EQ(running.filename(), "echolucent-study") << "the signal goes to the program that measures";
    ASSERT_EQ(kill(child, SIGINT), 0);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGINT);
}

}  // namespace
}  // namespace echolucent
