// Writes for studies: tables as CSV, on pages and on the terminal, and series of plots. Also reads lists of seeds.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/pages/html_page.h"
#include "processing/result.h"

namespace echolucent::cli {

/// A cell of a CsvTable. A number has the digits that tell doubles apart. A number that is unknown or not finite is an
/// empty cell.
class CsvCell {
public:
    CsvCell(double number);
    CsvCell(std::optional<double> number) : CsvCell(number.value_or(unknown)) {}
    CsvCell(std::integral auto number) : m_text(std::to_string(number)) {}
    template <std::convertible_to<std::string_view> Text>
    CsvCell(const Text& text) : m_text(quoted(text)) {}
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    [[nodiscard]] static std::string quoted(std::string_view text);
    std::string m_text;
};

/// Comma-separated values (RFC 4180, lines end in a line feed): the names of the columns, then row by row.
class CsvTable {
public:
    explicit CsvTable(const std::vector<std::string>& columns);
    /// Adds a row, one cell a column. Throws std::invalid_argument if there are more or fewer.
    void row(const std::vector<CsvCell>& cells);
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::size_t m_columns;
    std::string m_text;
};

struct TextTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows{};
};
/// The table for the terminal, columns padded with spaces.
[[nodiscard]] std::string plainText(const TextTable& table);
void addTable(HtmlPage& page, const TextTable& table, const std::string& caption = {});
/// Two digits behind the point, or `unknown` if there is no value.
[[nodiscard]] std::string shown(const std::optional<double>& value, const std::string& unknown = "-");

/// The nameOf() of all items, each once, in the order in which they first occur.
template <typename Items, typename NameOf>
[[nodiscard]] std::vector<std::string> namesIn(Items&& items, const NameOf& nameOf) {
    std::vector<std::string> names;
    for (const auto& item : items)
        if (const std::string name = nameOf(item); std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

/// A curve of opacities at evenly spaced intensities from 0 to 1.
[[nodiscard]] PlotSeries curveSeries(const std::string& name, const std::vector<double>& opacities);
/// The lower left front of points (time, error), as steps: no point lies below and left of them.
[[nodiscard]] PlotSeries frontSeries(std::vector<std::pair<double, double>> points);
/// Whether another time and error are no worse in both and better in one.
[[nodiscard]] inline bool isBeaten(double time, double error, double otherTime, double otherError) {
    return otherTime <= time && otherError <= error && (otherTime < time || otherError < error);
}

/// "1,2,5" or "3" or "1-4": whole numbers from 0, in the given order. Fails (wrong usage), naming `option`, if the text
/// is something else or a range has more than 1000 numbers.
[[nodiscard]] Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text, const std::string& option);

}  // namespace echolucent::cli
