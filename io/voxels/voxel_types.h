// What is known of the voxel types that files store, and their conversion to the three types in memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/voxels/stored_type.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The name of a type for storedTypeFromName(): "uint8".
[[nodiscard]] std::string_view nameOf(StoredType type);
/// The type of that name, from "uint8" to "float64"; no value for any other name.
[[nodiscard]] std::optional<StoredType> storedTypeFromName(std::string_view name);
/// How many bytes one value of a type takes.
[[nodiscard]] std::int64_t bytesOf(StoredType type);

/// Swaps the bytes of every value in place if `bigEndian` is not this machine's order.
void toMachineByteOrder(VoxelBytes& bytes, StoredType type, bool bigEndian);

/// Reduces interleaved red, green, blue values to luma (ITU-R BT.601: 0.299, 0.587, 0.114; rounded). `type` is uint8 or
/// uint16. A grey pixel keeps its value.
void reduceToLuma(VoxelBytes& bytes, StoredType type);

/// Voxels of all phases in one type, and what happened to them.
struct ConvertedVoxels {
    std::vector<Voxels> phases;
    std::string story;    ///< how they were stored and are kept: "int16, kept as uint16"
    std::string warning;  ///< a sentence if values changed or are negative; else empty
    ValueScale scale{};   ///< from the voxels to the file's values
};

/// Converts the bytes of every phase (machine byte order) into voxels of one type. uint8, uint16 and float32 stay.
/// Integers that fit become uint8 (from int8) or uint16, everything else float32. The memory of `phases` is freed on
/// the way.
[[nodiscard]] ConvertedVoxels convertVoxels(std::vector<VoxelBytes> phases, StoredType type);

/// The line that turns stored values into the file's values: slope * stored + intercept.
struct Rescale {
    double slope = 1.0;
    double intercept = 0.0;
    [[nodiscard]] double of(double stored) const { return slope * stored + intercept; }
    [[nodiscard]] bool isIdentity() const { return slope == 1.0 && intercept == 0.0; }
    friend bool operator==(const Rescale&, const Rescale&) = default;
};
/// The problem of a line that puts stored values from `smallest` to `largest` beyond float32, or makes them all the
/// same. Lower case, no full stop: "is 1e+300 with intercept 0, which makes values from 0 to inf". No value if there is
/// none.
[[nodiscard]] std::optional<std::string> problemOf(const Rescale& rescale, double smallest, double largest);
/// The smallest and the largest value of a whole-number type; for a float type -1 and 1, in place of all values.
[[nodiscard]] std::array<double, 2> rangeOf(StoredType type);

/// The problem of a line on which doubles cannot tell the values from `smallest` to `largest` apart, or not hold them.
/// As problemOf().
[[nodiscard]] std::optional<std::string> problemInDouble(const Rescale& rescale, double smallest, double largest);

/// The problem of putting float values (machine byte order) on the line of `rescale`: finite ones become too large for
/// doubles, or different ones become all the same. In lower case without full stop. No value if there is none, as for
/// all whole-number types and for floats that are not rescaled.
[[nodiscard]] std::optional<std::string> problemOfFloats(const std::vector<VoxelBytes>& phases, StoredType type,
                                                         const Rescale& rescale);

/// As convertVoxels(), but every value is rescaled, in double, and kept as float32.
[[nodiscard]] ConvertedVoxels convertRescaledVoxels(std::vector<VoxelBytes> phases, StoredType type,
                                                    const Rescale& rescale);

}  // namespace echolucent
