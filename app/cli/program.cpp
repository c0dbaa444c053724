#include "app/cli/program.h"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>
#include <optional>
#include <string_view>
#include <thread>

#include "app/cli/options/option_text.h"
#include "app/cli/options/typed_numbers.h"
#include "io/output/interruption.h"

namespace echolucent::cli {

namespace {

/// Joins "--beam-axis -y" to "--beam-axis=-y": else CLI11 would take the axis for an option. The order is reversed, as
/// CLI11 wants it.
std::vector<std::string> joinedArguments(int count, char** arguments) {
    std::vector<std::string> joined;
    for (int i = 1; i < count; ++i) {
        if (!joined.empty() && joined.back() == "--beam-axis")
            joined.back() += std::string("=") + arguments[i];
        else
            joined.emplace_back(arguments[i]);
    }
    std::reverse(joined.begin(), joined.end());
    return joined;
}

/// A command, or the program itself, that needs another command after it.
struct NeedsCommand {
    const CLI::App* command;
    std::string word;  ///< the word that is no command; empty if the line ends after `command`
};

/// The first command of a command line that is wrong or missing. No value if all are right.
std::optional<NeedsCommand> wrongCommand(const CLI::App& program, int count, char** arguments) {
    const CLI::App* command = &program;
    for (const std::string& word : wordsOf(count, arguments)) {
        if (command->get_require_subcommand_min() == 0) return std::nullopt;
        const auto named = command->get_subcommands([&](const CLI::App* other) { return other->check_name(word); });
        if (named.empty()) return NeedsCommand{command, word};
        command = named.front();
    }
    if (command->get_require_subcommand_min() == 0) return std::nullopt;
    return NeedsCommand{command, ""};
}

/// The commands of a program or of a command, in words: "info, otf or render".
std::string commandsOf(const CLI::App& program) {
    std::vector<std::string_view> names;
    for (const CLI::App* command : program.get_subcommands({})) names.emplace_back(command->get_name());
    return listed(names);
}

std::string sentenceOn(const NeedsCommand& wrong, const CLI::App& program) {
    const bool top = wrong.command == &program;
    const std::string use = ": use " + commandsOf(*wrong.command) + ".";
    if (!wrong.word.empty())
        return "\"" + (top ? "" : wrong.command->get_name() + " ") + wrong.word + "\" is not a command" + use;
    if (top) return "No command is given" + use;
    return "\"" + wrong.command->get_name() + "\" is only the beginning of a command" + use;
}

/// One sentence only: CLI11 would add a line about --help.
std::string failureMessage(const CLI::App* /*program*/, const CLI::Error& error) {
    std::string sentence = error.what();
    if (!sentence.empty() && sentence.back() != '.') sentence += '.';
    return sentence + '\n';
}

}  // namespace

int exitStatus(const Failure& failure) {
    switch (failure.kind) {
        case FailureKind::wrongUsage: return 2;
        case FailureKind::unwritable: return 4;
        case FailureKind::unreadable:
        case FailureKind::cancelled: break;
    }
    return 3;
}

std::vector<std::string> wordsOf(int count, char** arguments) {
    std::vector<std::string> words;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        if (word == "--threads") ++i;
        if (!word.starts_with("-")) words.push_back(word);
    }
    return words;
}

int runProgram(CLI::App& program, const std::string& version, const AddCommands& addCommands, int count,
               char** arguments) {
    removeUnfinishedOnSignals();
    program.set_version_flag("--version", version);
    program.require_subcommand(1);
    program.failure_message(failureMessage);
    program.fallthrough();
    int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    program.add_option("--threads", threads, "Number of threads")->check(CLI::Range(1, 1024))->capture_default_str();

    Action action;
    addCommands(program, action);
    understandCommas(program);
    try {
        program.parse(joinedArguments(count, arguments));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0)
            if (const auto wrong = wrongCommand(program, count, arguments)) {
                std::fprintf(stderr, "%s\n", sentenceOn(*wrong, program).c_str());
                return 2;
            }
        return program.exit(error) == 0 ? 0 : 2;
    }

    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    try {
        const auto done = action();
        if (done) return 0;
        std::fprintf(stderr, "%s\n", done.error().sentence().c_str());
        return exitStatus(done.error());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "This needs more memory than the machine has.\n");
        return 3;
    }
}

}  // namespace echolucent::cli
