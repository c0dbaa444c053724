// Every hostile file through the real command line, each command a process of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <regex>
#include <string>

#include <fmt/format.h>

#include "hostile_file.h"
#include "opening_by_command.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

bool holds(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

/// A sentence without the name of the test's own folder, so that no word of it counts.
std::string without(std::string text, const std::string& folder) {
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) text.erase(at, folder.size());
    return text;
}

/// What lies in a folder, and how large each file is.
std::map<std::string, std::uintmax_t> sizesBelow(const std::filesystem::path& folder) {
    std::map<std::string, std::uintmax_t> contents;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        std::error_code error;
        contents[entry.path()] = !entry.is_symlink() && entry.is_regular_file(error) ? entry.file_size() : 0;
    }
    return contents;
}

/// How many rows ended in which way.
struct RowEnds {
    std::atomic<int> refused{0}, openedWithNote{0}, opened{0}, otherwise{0};
};

class RowByCommand {
public:
    RowByCommand(const HostileFile& row, RowEnds& ends, CommandTally& tally)
        : m_row(row), m_ends(ends), m_tally(tally) {}

    void run() {
        m_files = m_folder.file("files");
        m_scratch = m_folder.file("scratch");
        std::filesystem::create_directory(m_files);
        std::filesystem::create_directory(m_scratch);
        m_row.write(m_files);
        m_bytes = bytesBelow(m_files);
        const auto before = sizesBelow(m_files);
        if (endsAsTheTableSays(command({"info"})) && m_row.outcome != HostileOutcome::refused) {
            command({"render", "--size", "64x64", "-o", m_folder.file("picture.png")});
            command({"otf"});
        }
        EXPECT_EQ(sizesBelow(m_files), before) << m_row.name << ": reading changed what lies beside the file";
    }

private:
    MeasuredRun command(std::vector<std::string> words) {
        words.push_back(m_row.opened == "." ? m_files.string() : (m_files / m_row.opened).string());
        for (const std::string& word : commandLineOf(m_row.options)) words.push_back(word);
        OpeningByCommand opening = openByCommand(m_row.name, words, m_scratch, m_bytes, m_tally);
        for (const std::string& fault : opening.faults) ADD_FAILURE() << m_row.name << ": " << fault;
        return std::move(opening.run);
    }

    bool endsAsTheTableSays(const MeasuredRun& run) {
        if (run.status != 0) {
            // What an option says falsely is wrong usage, which ends in 2.
            const bool usage = run.status == 2 && (m_row.options.raw || !m_row.options.series.empty());
            const bool refused = m_row.outcome == HostileOutcome::refused && (run.status == 3 || usage);
            EXPECT_TRUE(refused) << m_row.name << ": the status is " << run.status << ": " << run.errors;
            if (refused) expectWords(without(run.errors, m_files), true);
            ++(refused ? m_ends.refused : m_ends.otherwise);
            return refused;
        }
        EXPECT_NE(m_row.outcome, HostileOutcome::refused) << m_row.name << ": it opens";
        if (m_row.outcome == HostileOutcome::refused) {
            ++m_ends.otherwise;
            return false;
        }
        const bool withNote = m_row.outcome == HostileOutcome::opensWithNote;
        std::string notes;
        for (std::size_t at = run.output.find("  Note: "); at != std::string::npos;
             at = run.output.find("  Note: ", at + 1))
            notes += run.output.substr(at, run.output.find('\n', at) - at) + "\n";
        expectWords(notes + listOfSeries(run.output), withNote);
        ++(withNote ? m_ends.openedWithNote : m_ends.opened);
        return true;
    }

    /// What the library says where nobody chose among series, put together from the list that info prints in its place:
    /// "There are 2 series here; that of 4 x 2, 4 slices was read."
    static std::string listOfSeries(const std::string& output) {
        int count = 0;
        while (output.find(fmt::format("\n  series {}", count + 1)) != std::string::npos) ++count;
        std::smatch read;
        const std::regex readOne("series [0-9]+, read +.*?([0-9]+ x [0-9]+, [0-9]+ (slices|frames))");
        if (count < 2 || !std::regex_search(output, read, readOne)) return {};
        return fmt::format("There are {} series here; that of {} was read.\n", count, read[1].str());
    }

    void expectWords(const std::string& text, bool wanted) {
        for (const std::string& word : m_row.words)
            EXPECT_EQ(holds(text, word), wanted) << m_row.name << ": \"" << word << "\" in: " << text;
    }

    const HostileFile& m_row;
    RowEnds& m_ends;
    CommandTally& m_tally;
    TemporaryFolder m_folder;
    std::filesystem::path m_files, m_scratch;
    std::int64_t m_bytes = 0;
};

/// The rows that a command line can open.
std::vector<HostileFile> rowsForCommands() {
    std::vector<HostileFile> rows = hostileFiles();
    if (const char* words = std::getenv("ECHOLUCENT_ROWS"))
        std::erase_if(rows, [&](const HostileFile& row) { return !holds(row.name, words); });
    std::erase_if(rows, [](const HostileFile& row) { return row.options.raw && row.options.raw->polar; });
    return rows;
}

void endAsTheTableSays(const std::vector<HostileFile>& rows) {
    RowEnds ends;
    CommandTally tally;
    twoAtATime(rows.size(), [&](std::size_t i) { RowByCommand(rows[i], ends, tally).run(); });
    const std::string summary = fmt::format("{} rows: {} refused, {} opened with a note, {} opened, {} otherwise; {}",
                                            rows.size(), ends.refused.load(), ends.openedWithNote.load(),
                                            ends.opened.load(), ends.otherwise.load(), tally.inWords());
    std::cout << summary << "\n";
    testing::Test::RecordProperty("summary", summary);
}

TEST(HostileCli, SomeRowsEndAsTheTableSays) { endAsTheTableSays(sampleOf(rowsForCommands())); }
TEST(LongHostileCli, EveryRowEndsAsTheTableSays) { endAsTheTableSays(rowsForCommands()); }

}  // namespace
}  // namespace echolucent
