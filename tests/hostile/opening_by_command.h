// A file of strangers through the real command line: what its end has to be, whatever the file holds.
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

/// A command that runs longer hangs: it is killed, and its row fails. It bounds hangs and measures no speed; under
/// a sanitizer it is four times as long.
[[nodiscard]] double hangSeconds();

/// The most memory that a command may take for files of less than 10 MB: 1 GiB.
constexpr std::int64_t memoryForSmallFiles = std::int64_t{1} << 30;

/// The options of the command line that say what these say. They must state no polar layout.
[[nodiscard]] std::vector<std::string> commandLineOf(const ReadOptions& options);

/// What was seen over many commands.
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

/// The bytes of all files in a folder and below it, links not followed.
[[nodiscard]] std::int64_t bytesBelow(const std::filesystem::path& folder);

/// Runs echolucent-cli with a command ("info") on `opened` and counts it. `inputBytes` is how large the files are that
/// it reads. What is wrong with its end whatever was read, each as a sentence: a signal, a hang, processes left behind,
/// too much memory, an exit status that docs/cli.md does not list, or a failure that is not one sentence in one line.
struct OpeningByCommand {
    MeasuredRun run;
    std::vector<std::string> faults;
};
[[nodiscard]] OpeningByCommand openByCommand(const std::string& name, const std::vector<std::string>& command,
                                             const std::filesystem::path& scratch, std::int64_t inputBytes,
                                             CommandTally& tally);

/// Calls work(0) to work(count-1) in two threads, each next one as soon as a thread is free.
void twoAtATime(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace echolucent
