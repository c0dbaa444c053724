// Slices of a series. Some of them are spoiled.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hostile_file.h"

namespace echolucent {

/// One slice of 4 x 2 grey pixels of 8 bits. Elements with an empty text are left out.
struct HostileSlice {
    std::string series = "1.2.3", instance = "1", position = "0\\0\\0", orientation = "1\\0\\0\\0\\1\\0";
    std::string spacing = "0.5\\0.5", frame = "1.2.9", modality = "US", photometric = "MONOCHROME2";
    std::string patientName = "Muster^Anna", patientId = "P-4711", birthDate = "19800517";
    std::string slope, intercept, description, acquisition;
    std::uint16_t columns = 4, rows = 2, bits = 8, representation = 0;
    bool sized = true;       ///< whether it has Rows and Columns
    bool hasPixels = true;   ///< whether it has Pixel Data
    std::uint32_t cut = 0;   ///< bytes cut off the file's end
    std::uint32_t kept = 0;  ///< bytes kept of the file; 0: all
    std::string syntax = "1.2.840.10008.1.2.1";
    std::string pixels;  ///< in place of the slice's own, if not empty
};

[[nodiscard]] std::string bytesOf(const HostileSlice& slice);

/// Spoils slice `number` (from 0) of a series.
using SpoilSlice = std::function<void(int number, HostileSlice& slice)>;

/// Writes a series of `count` slices 1 mm apart, "s00" to "s99", then spoils them. Each slice's pixels are 10 + its
/// number.
void writeSeries(const std::filesystem::path& folder, int count, const SpoilSlice& spoil,
                 const std::string& prefix = "s");

/// A row with a folder of `count` spoiled slices.
[[nodiscard]] HostileFile hostileSeries(const std::string& name, int count, SpoilSlice spoil, HostileOutcome outcome,
                                        std::vector<std::string> words);
/// A row with a folder that `write` fills.
[[nodiscard]] HostileFile hostileFolder(const std::string& name,
                                        std::function<void(const std::filesystem::path& folder)> write,
                                        HostileOutcome outcome, std::vector<std::string> words);

}  // namespace echolucent
