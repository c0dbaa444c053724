#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "app/measuring/study.h"
#include "io/output/atomic_file.h"

namespace echolucent::cli {

namespace {

std::string csvText(const CsvCell& cell) {
    if (const auto* number = std::get_if<double>(&cell))
        return std::isfinite(*number) ? fmt::format("{}", *number) : std::string();
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
    const auto& text = std::get<std::string>(cell);
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

bool parseWhole(std::string_view text, std::uint64_t& value) {
    const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && stop == text.data() + text.size();
}

}  // namespace

Result<StudyFolder> StudyFolder::at(const std::string& path, std::vector<std::string> names) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error || !std::filesystem::is_directory(path))
        return fail(FailureKind::unwritable, path, "",
                    error ? "could not be made a folder: " + error.message() : "is not a folder",
                    "Choose another name.");
    return StudyFolder(path, std::move(names));
}

std::string StudyFolder::pathOf(const std::string& name) const {
    return (std::filesystem::path(m_path) / name).string();
}

Result<void> StudyFolder::write(const std::string& name, std::string_view bytes) const {
    if (std::find(m_names.begin(), m_names.end(), name) == m_names.end())
        throw std::invalid_argument("StudyFolder::write: " + name + " was not announced");
    return writeFileAtomically(pathOf(name), bytes);
}

std::vector<std::string> StudyFolder::paths() const {
    std::vector<std::string> paths;
    for (const std::string& name : m_names) paths.push_back(pathOf(name));
    return paths;
}

CsvTable::CsvTable(const std::vector<std::string>& columns) : m_columns(columns.size()) {
    row({columns.begin(), columns.end()});
}

void CsvTable::row(const std::vector<CsvCell>& cells) {
    if (cells.size() != m_columns) throw std::invalid_argument("CsvTable::row: as many cells as columns are needed");
    for (std::size_t i = 0; i < cells.size(); ++i) m_text += (i == 0 ? "" : ",") + csvText(cells[i]);
    m_text += '\n';
}

Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text, const std::string& option) {
    constexpr std::uint64_t most = 1000;
    std::vector<std::uint64_t> seeds;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const std::string_view part = std::string_view(text).substr(at, comma - at);
        const std::size_t dash = part.find('-');
        std::uint64_t first = 0, last = 0;
        const bool understood =
            parseWhole(part.substr(0, dash), first) &&
            (dash == std::string_view::npos ? (last = first, true) : parseWhole(part.substr(dash + 1), last));
        if (!understood || last < first || last - first >= most)
            return fail(FailureKind::wrongUsage, "", option, "is \"" + text + "\"",
                        "Use whole numbers with commas between them, or a range: 1,2,5 or 1-4.");
        for (std::uint64_t i = 0; i <= last - first; ++i) seeds.push_back(first + i);
        at = comma + 1;
    }
    return seeds;
}

}  // namespace echolucent::cli
