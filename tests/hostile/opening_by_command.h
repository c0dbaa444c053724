// Opens a stranger's file through the real command line, and checks how the command ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "measured_run.h"
#include "processing/document/read_options.h"

namespace echolucent {

/// A command that runs longer hangs. It is killed, and its row fails. This bounds hangs and measures no speed. Under a
/// sanitizer it is four times as long.
[[nodiscard]] double hangSeconds();

/// The most memory that a command may take for files of less than 10 MB: 1 GiB.
constexpr std::int64_t memoryForSmallFiles = std::int64_t{1} << 30;

/// These options as a command line. They must not hold a polar layout.
[[nodiscard]] std::vector<std::string> commandLineOf(const ReadOptions& options);

/// Counts over many commands.
class CommandTally {
public:
    void add(const std::string& name, const MeasuredRun& run);
    /// "2 crashes, 0 hangs; largest memory 31 MiB (NAME), longest 0.21 s (NAME)".
    [[nodiscard]] std::string inWords() const;

private:
    std::mutex m_mutex;
    std::int64_t m_commands = 0, m_crashes = 0, m_hangs = 0;
    std::int64_t m_memoryBytes = 0;
    double m_seconds = 0.0;
    std::string m_largest, m_longest;
};

/// The bytes of all files in a folder and below it. Links are not followed.
[[nodiscard]] std::int64_t bytesBelow(const std::filesystem::path& folder);

/// Runs echolucent-cli with a command ("info") on a file and counts it. `inputBytes`: size of the files that it reads.
/// The faults are sentences about its end: a signal, a hang, processes left behind, too much memory, an exit status
/// that docs/cli.md does not list, or a failure that is not one sentence in one line.
struct OpeningByCommand {
    MeasuredRun run;
    std::vector<std::string> faults;
};
[[nodiscard]] OpeningByCommand openByCommand(const std::string& name, const std::vector<std::string>& command,
                                             const std::filesystem::path& scratch, std::int64_t inputBytes,
                                             CommandTally& tally);

/// Calls work(0) to work(count-1) in two threads. A free thread takes the next one.
void twoAtATime(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace echolucent
