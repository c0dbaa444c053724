#include "tests/benchmarks/render_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "io/files/input_file.h"
#include "io/output/atomic_file.h"
#include "processing/median.h"
#include "tests/benchmarks/measured_cost.h"

namespace echolucent::bench {

namespace {

using nlohmann::ordered_json;

std::string fixed(const ordered_json& row, const char* key, int digits) {
    if (!row.contains(key) || !row[key].is_number()) return "";
    return fmt::format("{:.{}f}", row[key].get<double>(), digits);
}

/// The number with no more digits than it needs: steps are 0.25, 0.75 and 1.
std::string shortest(const ordered_json& row, const char* key) { return fmt::format("{:g}", row[key].get<double>()); }

std::string pair(const ordered_json& row, const char* first, const char* second, int digits) {
    return fixed(row, first, digits) + " / " + fixed(row, second, digits);
}

std::string wordOf(bool shaded) { return shaded ? "shaded" : "unshaded"; }

double ratioOf(const ordered_json& rows, bool shaded, const char* key, bool least) {
    std::vector<double> ratios;
    for (const auto& row : rows)
        if (row["shaded"] == shaded) ratios.push_back(row[key].get<double>());
    if (least && !ratios.empty()) return *std::min_element(ratios.begin(), ratios.end());
    return ratios.empty() ? std::numeric_limits<double>::quiet_NaN() : echolucent::medianOf(ratios);
}

Table machineTable(const ordered_json& report) {
    Table table{"machine", "Machine", {"", ""}, {}};
    const ordered_json& machine = report["machine"];
    for (const auto& [key, value] : machine.items())
        table.rows.push_back({key, value.is_string() ? value.get<std::string>() : value.dump()});
    table.rows.push_back({"OpenGL", report.value("opengl", "not asked for")});
    return table;
}

Table skippedTable(const ordered_json& report) {
    Table table{"skipped", "SKIP", {"volume", "reason"}, {}};
    for (const auto& skipped : report["skipped"])
        table.rows.push_back({skipped["volume"].get<std::string>(), skipped["reason"].get<std::string>()});
    return table;
}

Table summaryTable(const ordered_json& summary) {
    Table table{"summary",
                "VTK's CPU mapper / ours, medians over volumes, curves and sizes",
                {"", "CPU time", "least", "wall time", "CPU time at VTK's own error",
                 "CPU time, ours with no-data mask", "rows", "our RMSE not larger"},
                {}};
    for (const auto& [kind, figures] : summary.items())
        table.rows.push_back({kind, fixed(figures, "cpu_ratio_median", 1), fixed(figures, "cpu_ratio_least", 1),
                              fixed(figures, "wall_ratio_median", 1), fixed(figures, "equal_error_cpu_ratio_median", 1),
                              fixed(figures, "masked_cpu_ratio_median", 1), figures["rows"].dump(),
                              fixed(figures, "ours_rmse_not_larger", 0)});
    return table;
}

Table rowsTable(const ordered_json& rows, bool shaded) {
    Table table{wordOf(shaded),
                "Ours / VTK's CPU mapper, " + wordOf(shaded) + ": ms a picture, and 8-bit levels from the reference",
                {"volume", "OTF", "pixels", "CPU ms", "wall ms", "CPU ratio", "wall ratio", "RMSE", "max"},
                {}};
    for (const auto& row : rows)
        if (row["shaded"] == shaded)
            table.rows.push_back({row["volume"].get<std::string>(), row["otf"].get<std::string>(), row["size"].dump(),
                                  pair(row, "ours_cpu_ms", "vtk_cpu_ms", 1),
                                  pair(row, "ours_wall_ms", "vtk_wall_ms", 1), fixed(row, "cpu_ratio", 1),
                                  fixed(row, "wall_ratio", 1), pair(row, "ours_rmse", "vtk_rmse", 2),
                                  pair(row, "ours_max", "vtk_max", 1)});
    return table;
}

Table equalErrorTable(const ordered_json& rows) {
    Table table{"equal-error",
                "Ours at VTK's own error, unshaded / VTK's CPU mapper",
                {"volume", "OTF", "pixels", "reduction", "step", "RMSE", "CPU ms", "CPU ratio"},
                {}};
    for (const auto& row : rows)
        if (row.contains("coarse_cpu_ratio"))
            table.rows.push_back({row["volume"].get<std::string>(), row["otf"].get<std::string>(), row["size"].dump(),
                                  shortest(row, "coarse_reduction"), shortest(row, "coarse_step"),
                                  pair(row, "coarse_rmse", "vtk_rmse", 2),
                                  pair(row, "ours_coarse_cpu_ms", "vtk_cpu_ms", 1), fixed(row, "coarse_cpu_ratio", 1)});
    return table;
}

/// This tells what comes before a first picture, and around VTK's rays, in the rows of one size and curve.
Table aroundTable(const ordered_json& rows) {
    Table table{"around",
                "CPU ms that are not in the tables above",
                {"volume", "", "ours: once a volume", "ours: first picture", "ours: with no-data mask",
                 "ours: with light that reaches", "VTK: first frame", "VTK: set-up a frame", "VTK: whole frame"},
                {}};
    for (const auto& row : rows)
        if (row["size"] == rows[0]["size"] && row["otf"] == "parabolic")
            table.rows.push_back({row["volume"].get<std::string>(), wordOf(row["shaded"].get<bool>()),
                                  fixed(row, "ours_prepare_cpu_ms", 1), fixed(row, "ours_first_cpu_ms", 1),
                                  fixed(row, "ours_masked_cpu_ms", 1), fixed(row, "ours_reaching_cpu_ms", 1),
                                  fixed(row, "vtk_first_cpu_ms", 1), fixed(row, "vtk_set_up_cpu_ms", 1),
                                  fixed(row, "vtk_frame_cpu_ms", 1)});
    return table;
}

Table gpuTable(const ordered_json& rows) {
    Table table{"gpu",
                "Ours / VTK's GPU mapper (whole frame)",
                {"volume", "", "pixels", "CPU ms", "wall ms", "wall ratio", "GPU mapper's RMSE"},
                {}};
    for (const auto& row : rows)
        table.rows.push_back({row["volume"].get<std::string>(), wordOf(row["shaded"].get<bool>()), row["size"].dump(),
                              pair(row, "ours_cpu_ms", "gpu_cpu_ms", 1), pair(row, "ours_wall_ms", "gpu_wall_ms", 1),
                              fixed(row, "wall_ratio", 1), fixed(row, "gpu_rmse", 2)});
    return table;
}

Table growthTable(const ordered_json& rows) {
    Table table{"growth",
                "As the volume grows: ours / VTK's CPU mapper",
                {"voxels", "CPU ms", "wall ms", "CPU ratio", "ours: once a volume, CPU ms", "first picture, CPU ms"},
                {}};
    for (const auto& row : rows)
        table.rows.push_back({row["voxels"].dump() + "³" + (row["resampled"].get<bool>() ? " (resampled)" : ""),
                              pair(row, "ours_cpu_ms", "vtk_cpu_ms", 1), pair(row, "ours_wall_ms", "vtk_wall_ms", 1),
                              fixed(row, "cpu_ratio", 1), fixed(row, "ours_prepare_cpu_ms", 1),
                              pair(row, "ours_first_cpu_ms", "vtk_first_cpu_ms", 1)});
    return table;
}

Table threadsTable(const ordered_json& rows) {
    Table table{
        "threads", "As threads grow: ours / VTK's CPU mapper", {"threads", "wall ms", "CPU ms", "wall ratio"}, {}};
    for (const auto& row : rows)
        table.rows.push_back({row["threads"].dump(), pair(row, "ours_wall_ms", "vtk_wall_ms", 1),
                              pair(row, "ours_cpu_ms", "vtk_cpu_ms", 1), fixed(row, "wall_ratio", 1)});
    return table;
}

Table qualitiesTable(const ordered_json& rows) {
    Table table{"qualities",
                "Ours on two threads: qualities",
                {"volume", "OTF", "window", "reduction", "step", "wall ms", "pictures/s", "RMSE", "max"},
                {}};
    for (const auto& row : rows)
        if (row["what"] == "quality")
            table.rows.push_back({row["volume"].get<std::string>(), row["otf"].get<std::string>(), row["size"].dump(),
                                  fixed(row, "reduction", 1), shortest(row, "step"), fixed(row, "ours_wall_ms", 1),
                                  fixed(row, "frames_per_second", 0), fixed(row, "ours_rmse", 2),
                                  fixed(row, "ours_max", 1)});
    return table;
}

Table editsTable(const ordered_json& rows) {
    Table table{"edits",
                "Ours on two threads: OTF edits under a fixed camera, step 1",
                {"volume", "OTF", "window", "wall ms", "pictures/s", "first edit, wall ms", "samples kept, MB"},
                {}};
    for (const auto& row : rows)
        if (row["what"] == "edit")
            table.rows.push_back({row["volume"].get<std::string>(), row["otf"].get<std::string>(), row["size"].dump(),
                                  fixed(row, "ours_wall_ms", 1), fixed(row, "frames_per_second", 0),
                                  fixed(row, "first_edit_wall_ms", 1),
                                  fmt::format("{:.0f}", row["kept_bytes"].get<double>() / 1e6)});
    return table;
}

Table registrationTable(const ordered_json& registration) {
    Table table{"registration", "The same rays", {"measured", "value"}, {}};
    for (const auto& [key, who] : {std::pair{"ours_pixel_offset", "ours"},
                                   {"vtk_pixel_offset", "VTK's CPU mapper"},
                                   {"gpu_pixel_offset", "VTK's GPU mapper"}})
        table.rows.push_back(
            {fmt::format("one voxel's picture from where it is, {}, pixels", who), fixed(registration, key, 4)});
    for (const auto& shift : registration["ours_to_vtk_by_depth_shift"])
        table.rows.push_back({fmt::format("ours from VTK's, its sample planes moved by {:+.2f} steps of 2 units, RMSE",
                                          shift["shift_steps"].get<double>()),
                              fixed(shift, "rmse", 2)});
    for (const auto& [key, who] :
         {std::pair{"ours_rmse_at_reference_step", "ours"}, {"vtk_rmse_at_reference_step", "VTK's CPU mapper"}})
        table.rows.push_back({fmt::format("from the reference at its own step of 0.1 units, {}, RMSE", who),
                              fixed(registration, key, 3)});
    return table;
}

Table kernelTable(const ordered_json& rows) {
    Table table{"kernel", "Ours alone, the kernel", {"", "CPU ns a sample", "CPU ms in all"}, {}};
    for (const auto& row : rows)
        table.rows.push_back({row["name"].get<std::string>(), fixed(row, "ns_per_sample", 2), fixed(row, "cpu_ms", 1)});
    return table;
}

/// The width counts characters and not bytes: "³" is one.
std::size_t widthOf(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

ordered_json summaryOf(const ordered_json& rows) {
    ordered_json summary;
    for (const bool shaded : {false, true}) {
        int count = 0, notLarger = 0;
        std::vector<double> masked;
        for (const auto& row : rows)
            if (row["shaded"] == shaded) {
                ++count;
                if (row.contains("ours_masked_cpu_ms"))
                    masked.push_back(row["vtk_cpu_ms"].get<double>() / row["ours_masked_cpu_ms"].get<double>());
                notLarger += row["ours_rmse"].get<double>() <= row["vtk_rmse"].get<double>() ? 1 : 0;
            }
        if (count == 0) continue;
        ordered_json& figures = summary[wordOf(shaded)];
        figures = {{"cpu_ratio_median", ratioOf(rows, shaded, "cpu_ratio", false)},
                   {"cpu_ratio_least", ratioOf(rows, shaded, "cpu_ratio", true)},
                   {"wall_ratio_median", ratioOf(rows, shaded, "wall_ratio", false)},
                   {"rows", count}};
        if (!masked.empty()) figures["masked_cpu_ratio_median"] = echolucent::medianOf(masked);
        if (shaded) continue;  // each has another reference
        figures["equal_error_cpu_ratio_median"] = ratioOf(rows, shaded, "coarse_cpu_ratio", false);
        figures["ours_rmse_not_larger"] = notLarger;
    }
    return summary;
}

std::vector<Table> tablesOf(const ordered_json& report) {
    std::vector<Table> tables{machineTable(report), skippedTable(report)};
    if (report.contains("registration")) tables.push_back(registrationTable(report["registration"]));
    if (report.contains("rows")) {
        tables.push_back(rowsTable(report["rows"], false));
        tables.push_back(rowsTable(report["rows"], true));
        tables.push_back(equalErrorTable(report["rows"]));
        tables.push_back(aroundTable(report["rows"]));
    }
    if (report.contains("kernel")) tables.push_back(kernelTable(report["kernel"]));
    if (report.contains("gpu")) tables.push_back(gpuTable(report["gpu"]));
    if (report.contains("growth")) tables.push_back(growthTable(report["growth"]));
    if (report.contains("threads")) tables.push_back(threadsTable(report["threads"]));
    if (report.contains("frame_rates")) {
        tables.push_back(qualitiesTable(report["frame_rates"]));
        tables.push_back(editsTable(report["frame_rates"]));
    }
    if (report.contains("summary")) tables.push_back(summaryTable(report["summary"]));
    return tables;
}

std::string asText(const Table& table) {
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < table.head.size(); ++column) {
        std::size_t width = widthOf(table.head[column]);
        for (const auto& row : table.rows) width = std::max(width, widthOf(row[column]));
        widths.push_back(width);
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text;
        for (std::size_t column = 0; column < cells.size(); ++column) {
            const std::string room(widths[column] - widthOf(cells[column]), ' ');
            text += column == 0 ? cells[column] + room : "  " + room + cells[column];
        }
        return text + "\n";
    };
    std::string text = table.title + "\n" + line(table.head);
    for (const auto& row : table.rows) text += line(row);
    return text + "\n";
}

std::string asMarkdown(const Table& table) {
    const auto line = [](const std::vector<std::string>& cells) {
        return fmt::format("| {} |\n", fmt::join(cells, " | "));
    };
    if (table.rows.empty()) return "None.\n";
    std::string text = line(table.head) + line(std::vector<std::string>(table.head.size(), "---"));
    for (const auto& row : table.rows) text += line(row);
    return text;
}

Result<void> writeIntoPage(const std::string& path, const std::vector<Table>& tables) {
    constexpr std::size_t largestPage = 1 << 22;
    auto page = readWholeFile(path, largestPage);
    if (!page) return tl::unexpected<Failure>(page.error());
    for (const Table& table : tables) {
        const std::string begin = "<!-- " + table.name + " -->\n", end = "<!-- /" + table.name + " -->";
        const auto from = page->find(begin), to = page->find(end);
        if (from == std::string::npos || to == std::string::npos || to < from)
            return fail(FailureKind::unreadable, path, begin.substr(0, begin.size() - 1), "or its end is missing");
        page->replace(from + begin.size(), to - from - begin.size(), asMarkdown(table));
    }
    return writeFileAtomically(path, *page);
}

}  // namespace echolucent::bench
