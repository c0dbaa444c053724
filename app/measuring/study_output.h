// What studies write: tables as CSV, on pages and on the terminal, series of plots; and lists of seeds, which they
// read.
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

/// A cell of a CsvTable. A number is written with the digits that tell doubles apart; one that is not finite, or that
/// is not known, is an empty cell.
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

/// A table of text: the names of its columns, then its rows.
struct TextTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows{};
};
/// The table for the terminal, its columns padded with spaces.
[[nodiscard]] std::string plainText(const TextTable& table);
/// The table on a page.
void addTable(HtmlPage& page, const TextTable& table, const std::string& caption = {});
/// Two digits behind the point, or `unknown` where there is no value.
[[nodiscard]] std::string shown(const std::optional<double>& value, const std::string& unknown = "-");

/// What nameOf() says of the items, each name once, in the order in which they first occur.
template <typename Items, typename NameOf>
[[nodiscard]] std::vector<std::string> namesIn(Items&& items, const NameOf& nameOf) {
    std::vector<std::string> names;
    for (const auto& item : items)
        if (const std::string name = nameOf(item); std::ranges::find(names, name) == names.end()) names.push_back(name);
    return names;
}

/// A curve of opacities at evenly spaced intensities from 0 to 1.
[[nodiscard]] PlotSeries curveSeries(const std::string& name, const std::vector<double>& opacities);
/// The steps below and left of which there is no point, from points of a time and an error.
[[nodiscard]] PlotSeries frontSeries(std::vector<std::pair<double, double>> points);
/// Whether one of a time and an error is beaten by another: that is no worse in both and better in one.
[[nodiscard]] inline bool isBeaten(double time, double error, double otherTime, double otherError) {
    return otherTime <= time && otherError <= error && (otherTime < time || otherError < error);
}

/// "1,2,5" or "3" or "1-4": whole numbers from 0, in the order given. Fails (wrong usage) with `option` named.
[[nodiscard]] Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text, const std::string& option);

}  // namespace echolucent::cli
