// The studies of the command line (`echolucent-cli study ...`) and what they share: an output folder, tables as CSV.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/cli/command.h"
#include "processing/result.h"

namespace echolucent::cli {

/// The commands of echolucent-study, which echolucent-cli starts.
void addBenchCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);

/// Each adds one subcommand of `study` and sets `action` when it was chosen.
void addStudyOtfCommand(CLI::App& study, Action& action);
void addStudyContrastCommand(CLI::App& study, Action& action);
void addStudyMotionCommand(CLI::App& study, Action& action);
void addStudyStabilityCommand(CLI::App& study, Action& action);
void addStudyRenderCommand(CLI::App& study, Action& action);
void addStudyLightCommand(CLI::App& study, Action& action);
void addStudyQuietCommand(CLI::App& study, Action& action);
void addStudyCutCommand(CLI::App& study, Action& action);
void addStudyDesignersCommand(CLI::App& study, Action& action);

/// Where a study writes its files.
class StudyFolder {
public:
    /// Makes the folder, and those above it, where they are missing. `names` are all files that the study may write
    /// into it, so that paths() can be compared with what is read. Fails (unwritable) where the folder cannot be made.
    [[nodiscard]] static Result<StudyFolder> at(const std::string& path, std::vector<std::string> names);
    /// Writes one of the files whole or not at all, over a file of that name. Throws std::invalid_argument where `name`
    /// was not given to at().
    [[nodiscard]] Result<void> write(const std::string& name, std::string_view bytes) const;
    [[nodiscard]] std::string pathOf(const std::string& name) const;
    /// The paths of all files that the study may write.
    [[nodiscard]] std::vector<std::string> paths() const;

private:
    StudyFolder(std::string path, std::vector<std::string> names)
        : m_path(std::move(path)), m_names(std::move(names)) {}
    std::string m_path;
    std::vector<std::string> m_names;
};

/// A number is written with the digits that tell doubles apart, and one that is not finite as an empty cell.
using CsvCell = std::variant<std::string, double, std::int64_t>;

/// Comma-separated values (RFC 4180, lines end in a line feed): the columns' names first, then row by row.
class CsvTable {
public:
    explicit CsvTable(const std::vector<std::string>& columns);
    /// Adds a row of one cell a column; throws std::invalid_argument where there are more or fewer.
    void row(const std::vector<CsvCell>& cells);
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::size_t m_columns;
    std::string m_text;
};

/// "1,2,5" or "3" or "1-4": whole numbers from 0, in the order given. Fails (wrong usage) with `option` named.
[[nodiscard]] Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text, const std::string& option);

}  // namespace echolucent::cli
