#include "app/measuring/study_output.h"
#include "app/cli/options/option_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace echolucent::cli {

namespace {

bool parseWhole(std::string_view text, std::uint64_t& value) {
    const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() && stop == text.data() + text.size();
}

}  // namespace

CsvCell::CsvCell(double number) : m_text(std::isfinite(number) ? fmt::format("{}", number) : std::string()) {}

std::string CsvCell::quoted(std::string_view text) {
    if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

CsvTable::CsvTable(const std::vector<std::string>& columns) : m_columns(columns.size()) {
    row({columns.begin(), columns.end()});
}

void CsvTable::row(const std::vector<CsvCell>& cells) {
    if (cells.size() != m_columns) throw std::invalid_argument("CsvTable::row: as many cells as columns are needed");
    for (std::size_t i = 0; i < cells.size(); ++i) m_text += (i == 0 ? "" : ",") + cells[i].text();
    m_text += '\n';
}

std::string plainText(const TextTable& table) {
    const auto characters = [](const std::string& text) {
        return static_cast<std::size_t>(
            std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    };
    std::vector<std::size_t> widths;
    for (const std::string& column : table.columns) widths.push_back(characters(column));
    for (const auto& row : table.rows)
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], characters(row[c]));
    std::string text;
    const auto add = [&](const std::vector<std::string>& row) {
        for (std::size_t c = 0; c < row.size(); ++c)
            text += row[c] + std::string(c + 1 < row.size() ? widths[c] - characters(row[c]) + 2 : 0, ' ');
        text += '\n';
    };
    add(table.columns);
    for (const auto& row : table.rows) add(row);
    return text;
}

void addTable(HtmlPage& page, const TextTable& table, const std::string& caption) {
    page.table(table.columns, table.rows, caption);
}

std::string shown(const std::optional<double>& value, const std::string& unknown) {
    return value ? fmt::format("{:.2f}", *value) : unknown;
}

PlotSeries curveSeries(const std::string& name, const std::vector<double>& opacities) {
    PlotSeries series{.name = name, .x = {}, .y = opacities, .labels = {}};
    for (std::size_t i = 0; i < opacities.size(); ++i)
        series.x.push_back(static_cast<double>(i) / static_cast<double>(opacities.size() - 1));
    return series;
}

PlotSeries frontSeries(std::vector<std::pair<double, double>> points) {
    std::ranges::sort(points);
    PlotSeries series{.name = "front", .x = {}, .y = {}, .labels = {}};
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [time, error] : points) {
        if (!(error < least)) continue;
        if (!series.x.empty()) {
            series.x.push_back(time);
            series.y.push_back(least);
        }
        least = error;
        series.x.push_back(time);
        series.y.push_back(error);
    }
    return series;
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
