// The voxel types that files store, and their way into the three types kept in memory.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/voxels/voxel_bytes.h"
#include "processing/volume/volume.h"

namespace echolucent {

enum class StoredType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

/// The name of a type as storedTypeFromName() takes it: "uint8".
[[nodiscard]] std::string_view nameOf(StoredType type);
/// The type of that name, from "uint8" to "float64"; no value for any other name.
[[nodiscard]] std::optional<StoredType> storedTypeFromName(std::string_view name);
/// How many bytes one value of a type takes.
[[nodiscard]] std::int64_t bytesOf(StoredType type);

/// Swaps the bytes of every value of `bytes` in place where `bigEndian` is not this machine's order.
void toMachineByteOrder(VoxelBytes& bytes, StoredType type, bool bigEndian);

/// Interleaved red, green, blue values reduced to luma (ITU-R BT.601: 0.299, 0.587, 0.114; rounded). `type` is
/// uint8 or uint16. A grey pixel keeps its value.
void reduceToLuma(VoxelBytes& bytes, StoredType type);

/// Voxels of all phases in one type, and what happened to them.
struct ConvertedVoxels {
    std::vector<Voxels> phases;
    std::string story;    ///< how they were stored and are kept: "int16, kept as uint16"
    std::string warning;  ///< a sentence where values changed or are negative; else empty
};

/// Turns the bytes of every phase (machine byte order) into voxels, all phases alike: uint8, uint16 and float32 stay;
/// integers that fit become uint8 (from int8) or uint16, everything else becomes float32. The memory of `phases` is
/// given free on the way.
[[nodiscard]] ConvertedVoxels convertVoxels(std::vector<VoxelBytes> phases, StoredType type);

/// A line by which stored values become the file's values: slope * stored + intercept.
struct Rescale {
    double slope = 1.0;
    double intercept = 0.0;
    [[nodiscard]] double of(double stored) const { return slope * stored + intercept; }
    [[nodiscard]] bool isIdentity() const { return slope == 1.0 && intercept == 0.0; }
    friend bool operator==(const Rescale&, const Rescale&) = default;
};
/// What is wrong with a line that puts stored values from `smallest` to `largest` beyond float32, or makes them all one
/// there, lower case and without full stop: "is 1e+300 with intercept 0, which makes values from 0 to inf". No value
/// where all is well.
[[nodiscard]] std::optional<std::string> problemOf(const Rescale& rescale, double smallest, double largest);
/// The smallest and the largest value of a whole-number type; -1 and 1, which stand for all, of a float type.
[[nodiscard]] std::array<double, 2> rangeOf(StoredType type);

/// What is wrong with keeping these values (machine byte order) of a float type as float32, on the line where there is
/// one: finite ones become too large for it, or different ones become all the same. Lower case and without full stop;
/// no value where all is well, as it always is of whole numbers.
[[nodiscard]] std::optional<std::string> problemOfFloats(const std::vector<VoxelBytes>& phases, StoredType type,
                                                         const Rescale& rescale);

/// As convertVoxels(), but every value is put on that line, in double, and kept as float32.
[[nodiscard]] ConvertedVoxels convertRescaledVoxels(std::vector<VoxelBytes> phases, StoredType type,
                                                    const Rescale& rescale);

}  // namespace echolucent
