// How long the list of series takes: a folder of many small DICOM files, warm, and how soon a cancel ends it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "io/study/series_list.h"

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

template <typename T>
std::string little(T value) {
    return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

/// One element in explicit VR, little endian, with a length of 16 bits.
std::string element(std::uint16_t group, std::uint16_t number, const char* vr, std::string value) {
    if (value.size() % 2 == 1) value += std::string(vr) == "UI" ? '\0' : ' ';
    return little(group) + little(number) + vr + little(static_cast<std::uint16_t>(value.size())) + value;
}

/// A slice of 64 x 64 pixels with a header of the usual length.
std::string slice(int series, int number) {
    std::string meta = element(0x0002, 0x0002, "UI", "1.2.840.10008.5.1.4.1.1.6.1") +
                       element(0x0002, 0x0010, "UI", "1.2.840.10008.1.2.1");
    std::string bytes = std::string(128, '\0') + "DICM" +
                        element(0x0002, 0x0000, "UL", little(static_cast<std::uint32_t>(meta.size()))) + meta;
    bytes += element(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.6.1");
    bytes += element(0x0008, 0x0018, "UI", fmt::format("1.2.826.0.1.3680043.9.{}.{}", series, number));
    for (std::uint16_t tag = 0x0020; tag <= 0x0033; ++tag) bytes += element(0x0008, tag, "LO", "20200101");
    bytes += element(0x0008, 0x0060, "CS", "US") + element(0x0008, 0x103e, "LO", fmt::format("series {}", series));
    for (std::uint16_t tag = 0x0010; tag <= 0x0040; tag += 0x10) bytes += element(0x0010, tag, "LO", "ANONYMOUS");
    for (std::uint16_t tag = 0x1000; tag <= 0x1030; ++tag) bytes += element(0x0018, tag, "LO", "some value or other");
    bytes += element(0x0020, 0x000e, "UI", fmt::format("1.2.826.0.1.3680043.9.{}", series));
    bytes += element(0x0020, 0x0013, "IS", fmt::format("{}", number));
    bytes += element(0x0020, 0x0032, "DS", fmt::format("0\\0\\{}", number));
    bytes += element(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    bytes += element(0x0028, 0x0002, "US", little(std::uint16_t{1})) + element(0x0028, 0x0004, "CS", "MONOCHROME2");
    bytes += element(0x0028, 0x0010, "US", little(std::uint16_t{64})) +
             element(0x0028, 0x0011, "US", little(std::uint16_t{64}));
    bytes += element(0x0028, 0x0030, "DS", "0.3\\0.3") + element(0x0028, 0x0100, "US", little(std::uint16_t{8}));
    bytes += element(0x0028, 0x0101, "US", little(std::uint16_t{8})) +
             element(0x0028, 0x0102, "US", little(std::uint16_t{7}));
    bytes += element(0x0028, 0x0103, "US", little(std::uint16_t{0}));
    bytes += little(std::uint16_t{0x7fe0}) + little(std::uint16_t{0x0010}) + "OW" + std::string(2, '\0');
    return bytes + little(std::uint32_t{64 * 64}) + std::string(64 * 64, '\x55');
}

/// A folder of files, removed with this object.
class Files {
public:
    Files(int series, int slices) {
        std::string name = (std::filesystem::temp_directory_path() / "echolucent-series-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        m_folder = name;
        for (int one = 0; one < series; ++one)
            for (int number = 0; number < slices; ++number)
                std::ofstream(m_folder / fmt::format("{}-{:05}.dcm", one, number), std::ios::binary)
                    << slice(one, number);
    }
    ~Files() { std::filesystem::remove_all(m_folder); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    [[nodiscard]] std::string folder() const { return m_folder.string(); }

private:
    std::filesystem::path m_folder;
};

/// Milliseconds from a cancel, raised when a third of the files are read, to the return.
double cancelMilliseconds(const std::string& folder) {
    std::atomic<bool> cancel{false};
    Clock::time_point raised;
    const echolucent::Progress progress{[&](double share) {
                                            if (share < 0.1 || cancel) return;
                                            raised = Clock::now();
                                            cancel = true;
                                        },
                                        &cancel};
    const auto list = echolucent::listSeries(folder, progress);
    return list ? -1 : millisecondsSince(raised);
}

}  // namespace

int main(int argc, char** argv) {
    int count = 10000, series = 5, runs = 5;
    CLI::App program{"Lists the series of a folder of small DICOM files that it writes"};
    program.add_option("--files", count, "Files in the folder")->capture_default_str();
    program.add_option("--series", series, "Series that they make up")->capture_default_str();
    program.add_option("--runs", runs, "Lists that are made, of which the median is told")->capture_default_str();
    CLI11_PARSE(program, argc, argv);

    const Files files(series, count / series);
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const auto begin = Clock::now();
        const auto list = echolucent::listSeries(files.folder());
        times.push_back(millisecondsSince(begin));
        if (!list || list->series.size() != static_cast<std::size_t>(series)) {
            fmt::print(stderr, "The list is wrong: {}\n", list ? "not all series" : list.error().sentence());
            return 1;
        }
    }
    std::sort(times.begin(), times.end());
    fmt::print("| {} files of {} series listed | {:.0f} ms (best {:.0f}) |\n", count, series, times[times.size() / 2],
               times.front());
    fmt::print("| cancelled after a third | {:.1f} ms |\n", cancelMilliseconds(files.folder()));
    return 0;
}
