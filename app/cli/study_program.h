// What measures is a program of its own, echolucent-study, which the command line starts for `study` and `bench`.
#pragma once

#include "app/cli/command.h"

namespace echolucent::cli {

/// Adds the commands that echolucent-study does, for the help and the sentences that list all commands.
void addStudyProgram(CLI::App& program);

/// Whether a command line asks for one of these.
[[nodiscard]] bool isForStudyProgram(int count, char** arguments);

/// This process becomes echolucent-study (it lies beside the program, else where it is installed), with the same
/// arguments, input, outputs and parent. Returns only where that fails (unreadable): the program is missing or cannot
/// be run.
[[nodiscard]] Result<void> becomeStudyProgram(int count, char** arguments);

}  // namespace echolucent::cli
