// What the programs of the command line share from their first to their last word: options, sentences, exit status.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace echolucent::cli {

/// The words of a command line that are no options: a command, the commands below it and what these read.
[[nodiscard]] std::vector<std::string> wordsOf(int count, char** arguments);

/// Adds what a program has to offer.
using AddCommands = std::function<void(CLI::App& program, Action& action)>;

/// Parses a command line, --threads among it, and does what it asks for. Returns the exit status. `version` is what
/// --version prints.
[[nodiscard]] int runProgram(CLI::App& program, const std::string& version, const AddCommands& addCommands, int count,
                             char** arguments);

}  // namespace echolucent::cli
