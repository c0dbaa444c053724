// The commands that measure are a program of their own, echolucent-study. The command line starts it for `study` and
// `bench`.
#pragma once

#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// Adds `study` and `bench` by name and meaning, since help and sentences list all commands. echolucent-study runs
/// them.
void addStudyProgram(CLI::App& program);

/// Whether a command line asks for `study` or `bench`.
[[nodiscard]] bool isForStudyProgram(int count, char** arguments);

/// Replaces this process by echolucent-study, with the same arguments, input, outputs and parent. Looks for that
/// program beside this one, then in its place of installation. Returns only if the program cannot be started
/// (unreadable).
[[nodiscard]] Result<void> becomeStudyProgram(int count, char** arguments);

}  // namespace echolucent::cli
