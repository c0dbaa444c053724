// The commands of echolucent-cli.
#pragma once

#include <functional>

#include "app/cli/options/invocation.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// Exit statuses: 0 done, 2 wrong usage, 3 an input could not be read, 4 an output could not be written.
[[nodiscard]] int exitStatus(const Failure& failure);

/// What a command does once its options are parsed. A failure becomes one sentence on stderr and an exit status.
using Action = std::function<Result<void>()>;

/// Each function adds one subcommand with its options, help and example. Parsing sets `action` if that subcommand was
/// chosen.
void addInfoCommand(CLI::App& program, Action& action);
void addFilesCommand(CLI::App& program, Action& action);
void addOtfCommand(CLI::App& program, Action& action, const Invocation& invocation);
void addParametersCommand(CLI::App& program, Action& action);
void addRenderCommand(CLI::App& program, Action& action);
void addCompareCommand(CLI::App& program, Action& action);
void addLessonCommand(CLI::App& program, Action& action, const Invocation& invocation);
void addPhantomCommand(CLI::App& program, Action& action);
void addQuietCommand(CLI::App& program, Action& action);
void addSweepCommand(CLI::App& program, Action& action, const Invocation& invocation);

}  // namespace echolucent::cli
