#include "opening_by_command.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <system_error>
#include <thread>

#include <fmt/format.h>

namespace echolucent {

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The beginning of a text, for a message of the test.
std::string shortened(const std::string& text) { return text.size() < 400 ? text : text.substr(0, 400) + "..."; }

std::string joined(const std::array<std::int64_t, 3>& numbers) {
    return fmt::format("{}x{}x{}", numbers[0], numbers[1], numbers[2]);
}

}  // namespace

double hangSeconds() {
#ifdef ECHOLUCENT_SANITIZED
    return 20.0;
#else
    return 5.0;
#endif
}

std::vector<std::string> commandLineOf(const ReadOptions& options) {
    std::vector<std::string> words;
    const auto add = [&](const std::string& option, const std::string& value) {
        words.push_back(option);
        words.push_back(value);
    };
    if (options.raw) {
        const RawLayout& raw = *options.raw;
        add("--raw-size", joined(raw.size));
        add("--raw-type", raw.type);
        if (raw.bigEndian) add("--raw-byte-order", "big");
        if (raw.headerBytes != 0) add("--raw-header-bytes", std::to_string(raw.headerBytes));
        if (raw.spacingKnown)
            add("--raw-spacing", fmt::format("{}x{}x{}", raw.spacing[0], raw.spacing[1], raw.spacing[2]));
    }
    if (options.framesAsSlices) words.emplace_back("--frames-as-slices");
    if (!options.guessNoData) words.emplace_back("--all-voxels");
    if (options.blackAtZero) words.emplace_back("--black-at-zero");
    if (!options.series.empty()) add("--series", options.series);
    if (options.conversionMebibytes != ReadOptions{}.conversionMebibytes)
        add("--conversion-memory", std::to_string(options.conversionMebibytes));
    if (options.studyMebibytes) add("--study-memory", std::to_string(*options.studyMebibytes));
    return words;
}

void CommandTally::add(const std::string& name, const MeasuredRun& run) {
    const std::scoped_lock lock(m_mutex);
    ++m_commands;
    if (run.hangs)
        ++m_hangs;
    else if (run.signal != 0)
        ++m_crashes;
    if (run.memoryBytes() > m_memoryBytes) {
        m_memoryBytes = run.memoryBytes();
        m_largest = name;
    }
    if (run.seconds > m_seconds) {
        m_seconds = run.seconds;
        m_longest = name;
    }
}

std::string CommandTally::inWords() const {
    return fmt::format("{} commands, {} crashes, {} hangs; largest memory {} MiB ({}), longest {:.2f} s ({})",
                       m_commands, m_crashes, m_hangs, m_memoryBytes >> 20, m_largest, m_seconds, m_longest);
}

std::int64_t bytesBelow(const std::filesystem::path& folder) {
    std::int64_t sum = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::error_code error;
        if (!entry.is_symlink() && entry.is_regular_file(error)) sum += static_cast<std::int64_t>(entry.file_size());
    }
    return sum;
}

OpeningByCommand openByCommand(const std::string& name, const std::vector<std::string>& command,
                               const std::filesystem::path& scratch, std::int64_t inputBytes, CommandTally& tally) {
    std::vector<std::string> words{ECHOLUCENT_CLI};
    words.insert(words.end(), command.begin(), command.end());
    OpeningByCommand opening{measuredRun(words, scratch, hangSeconds()), {}};
    const MeasuredRun& run = opening.run;
    tally.add(name + ", " + command.front(), run);

    const auto fault = [&](const std::string& sentence) {
        opening.faults.push_back(command.front() + ": " + sentence);
    };
    if (run.hangs) {
        fault(fmt::format("it went on for more than {} s", hangSeconds()));
        return opening;
    }
    if (run.signal != 0) {
        fault(fmt::format("it crashed: {}; it said: {}", strsignal(run.signal), shortened(run.errors)));
        return opening;
    }
    if (run.leavesProcesses) fault("it left processes behind");
#ifndef ECHOLUCENT_SANITIZED  // a sanitizer's own memory is no memory of the program
    if (inputBytes < 10'000'000 && run.memoryBytes() > memoryForSmallFiles)
        fault(fmt::format("it took {} MiB for {} bytes", run.memoryBytes() >> 20, inputBytes));
#else
    static_cast<void>(inputBytes);
#endif
    if (run.status != 0 && (run.status < 2 || run.status > 4))
        fault(fmt::format("its exit status was {}; it said: {}", run.status, shortened(run.errors)));
    if (run.status == 0) return opening;
    // Before they fail, render and otf may say what they guessed.
    const std::vector<std::string> lines = linesOf(run.errors);
    if (lines.empty() || !lines.back().ends_with('.') || (command.front() == "info" && lines.size() != 1))
        fault("it failed without one sentence in one line: " + shortened(run.errors));
    return opening;
}

void twoAtATime(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    std::thread other(take);
    take();
    other.join();
}

}  // namespace echolucent
