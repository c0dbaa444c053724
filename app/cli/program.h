// What the command line's programs share: options, sentences and exit status.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"

namespace echolucent::cli {

/// The words of a command line that do not begin with "-": a command, the commands below it and their arguments. The
/// number of "--threads N" is left out; values of other options are not.
[[nodiscard]] std::vector<std::string> wordsOf(int count, char** arguments);

/// Adds a program's commands.
using AddCommands = std::function<void(CLI::App& program, Action& action)>;

/// Parses a command line, --threads included, and does what it asks for. Returns the exit status. --version prints
/// `version`.
[[nodiscard]] int runProgram(CLI::App& program, const std::string& version, const AddCommands& addCommands, int count,
                             char** arguments);

}  // namespace echolucent::cli
