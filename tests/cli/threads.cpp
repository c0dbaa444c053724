// --threads is the program's, so every command takes it, before its name and behind it.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/document/document_file.h"
#include "processing/document/panes.h"
#include "program.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

/// The commands that the help of a command lists; empty where it has none.
std::set<std::string> commandsOf(const std::string& command) {
    std::istringstream help(runProgram(command + " --help").output);
    std::set<std::string> names;
    bool listing = false;
    for (std::string line; std::getline(help, line);) {
        if (line.starts_with("Subcommands:"))
            listing = true;
        else if (listing && line.size() > 2 && line.starts_with("  ") && line[2] != ' ')
            names.insert(line.substr(2, line.find(' ', 2) - 2));
        else if (listing && !line.starts_with("  "))
            listing = false;
    }
    return names;
}

/// What each command needs to do something quickly; FOLDER is an empty folder.
std::vector<std::pair<std::string, std::string>> quickRuns(const std::string& volume) {
    const std::string quoted = "\"" + volume + "\"";
    Document compared;
    compared.study = StudyFile{.path = volume, .options = {}, .checksum = {}};
    if (!writeDocument(volume + ".json", withPaneCount(compared, 2))) ADD_FAILURE() << "no document";
    return {{"info", quoted},
            {"files", "\"FOLDER/\" -o \"FOLDER/f.md\""},
            {"parameters", ""},
            {"otf", quoted},
            {"compare", "\"" + volume + ".json\""},
            {"render", quoted + " --size 32x32 -o \"FOLDER/p.png\""},
            {"quiet", quoted + " -o \"FOLDER/q.mha\""},
            {"phantom", "\"FOLDER/p.mha\" --scene shapes --size 20"},
            {"sweep", quoted + " --from 0 --to 1"},
            {"near", quoted},
            {"bench otf", quoted + " --runs 1"},
            {"study otf", "--phantoms --size 48 --repeats 1 -o \"FOLDER/s\""},
            {"study contrast", "--size 48"},
            {"study cut", quoted + " --turn 0"},
            {"study sides", quoted + " --picture-size 16 -o \"FOLDER/s\""},
            {"study designers", "--size 32 --seeds 1 --repeats 1 --picture-size 16 -o \"FOLDER/s\""},
            {"study light", "--phantom-size 24 --size 16x16 --rings 1 --repeats 1 -o \"FOLDER/s\""},
            {"study quiet", "--size 40 --seeds 1 --timed-edge 24 --repeats 1 -o \"FOLDER/s\""},
            {"study motion", "--phantoms --phantom-size 40 --picture-size 32 --step 15 -o \"FOLDER/s\""},
            {"study stability", "-o \"FOLDER/s\""},
            {"study render", "--quick --phantom-size 32 --size 48x48 --repeats 1 -o \"FOLDER/s\""}};
}

std::string inFolder(std::string arguments, const Folder& folder) {
    const std::string word = "FOLDER/";
    for (std::size_t at = arguments.find(word); at != std::string::npos; at = arguments.find(word))
        arguments.replace(at, word.size(), folder / "");
    return arguments;
}

std::set<std::string> allCommands() {
    std::set<std::string> all;
    for (const std::string& command : commandsOf("")) {
        const auto below = commandsOf(command);
        if (below.empty()) all.insert(command);
        for (const std::string& name : below) all.insert(command + " " + name);
    }
    return all;
}

TEST(Threads, AreTakenByEveryCommandBeforeItsNameAndBehindIt) {
    const auto commands = allCommands();
    for (const char* known : {"info", "otf", "render", "phantom", "study otf", "study stability"})
        EXPECT_TRUE(commands.contains(known)) << known;
    for (const std::string& command : commands) {
        // It is refused before anything is read, and by its name: the option is known there.
        std::vector<std::string> lines{"--threads 0 " + command, command + " --threads 0", command + " --threads two"};
        if (takesSomeInputs) lines = {lines[command.size() % lines.size()]};
        for (const std::string& line : lines) {
            const Outcome refused = runProgram(line);
            EXPECT_EQ(refused.status, 2) << line;
            EXPECT_NE(refused.errors.find("--threads"), std::string::npos) << line << ": " << refused.errors;
        }
    }
}

TEST(LongThreads, EveryCommandRunsWithTheOptionInEachPlace) {
    const auto commands = allCommands();
    const auto runs = quickRuns(phantomFile("tiny.mha", "--scene shapes --size 40 --seed 5"));
    for (const std::string& command : commands)
        EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return run.first == command; }))
            << command << " has no run here: add one";
    for (const auto& [command, arguments] : runs) {
        if (!commands.contains(command)) continue;
        // The slow studies are run once, the others with the option in every place.
        const bool slow = command.starts_with("study") || command.starts_with("bench");
        std::vector<std::string> lines{command + " --threads 2 " + arguments};
        if (!slow)
            lines.insert(lines.end(),
                         {"--threads 1 " + command + " " + arguments, command + " " + arguments + " --threads 7"});
        for (const std::string& line : lines) {
            const Folder folder;
            const Outcome outcome = runProgram(inFolder(line, folder));
            EXPECT_EQ(outcome.status, 0) << line << "\n" << outcome.errors;
        }
    }
}

}  // namespace
}  // namespace echolucent
