// Splits the program's tables into cells.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace echolucent {

/// The cells of a table with commas, row by row. A cell in quotes may hold commas and ends of lines.
inline std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool quoted = false;
    for (const char c : csv) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            rows.back().emplace_back();
        else if (c == '\n' && !quoted)
            rows.push_back({""});
        else
            rows.back().back() += c;
    }
    if (rows.back() == std::vector<std::string>{""}) rows.pop_back();
    return rows;
}

/// One row by the names of its columns.
using NamedRow = std::map<std::string, std::string>;

/// The rows below the names of the columns. Fails the test if a row has another number of cells.
inline std::vector<NamedRow> namedRowsOf(const std::string& csv) {
    const auto rows = rowsOf(csv);
    std::vector<NamedRow> named;
    for (std::size_t row = 1; row < rows.size(); ++row) {
        EXPECT_EQ(rows[row].size(), rows[0].size()) << "row " << row;
        named.emplace_back();
        for (std::size_t i = 0; i < std::min(rows[0].size(), rows[row].size()); ++i)
            named.back()[rows[0][i]] = rows[row][i];
    }
    return named;
}

}  // namespace echolucent
