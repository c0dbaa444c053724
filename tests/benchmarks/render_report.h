// The figures as tables for people, on the terminal and in a page between its marks.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "processing/result.h"

namespace echolucent::bench {

struct Table {
    std::string name;   ///< of its place in the page
    std::string title;  ///< a line above it
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

/// A summary of the figures: "unshaded" and "shaded", each with the median ratios over all rows and the least ratio.
/// "unshaded" also counts the rows in which our RMSE is not larger than VTK's.
[[nodiscard]] nlohmann::ordered_json summaryOf(const nlohmann::ordered_json& rows);

/// The tables of the parts that a report has.
[[nodiscard]] std::vector<Table> tablesOf(const nlohmann::ordered_json& report);

[[nodiscard]] std::string asText(const Table& table);
[[nodiscard]] std::string asMarkdown(const Table& table);

/// Puts each table between "<!-- NAME -->" and "<!-- /NAME -->" of a page. The rest of the page stays. Fails if the
/// page lacks a mark.
[[nodiscard]] Result<void> writeIntoPage(const std::string& path, const std::vector<Table>& tables);

}  // namespace echolucent::bench
