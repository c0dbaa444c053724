// The file's value to show as black, where 0 would hide what a volume holds.
#pragma once

#include <cstdint>
#include <optional>

#include "processing/volume/value_scale.h"
#include "processing/volume/white_level.h"

namespace echolucent {

/// What one quick look at all finite values says.
struct ValueExtent {
    double lowest = 0.0;            ///< 0 if `any` is false
    double highest = 0.0;           ///< 0 if `any` is false
    double leastAboveLowest = 0.0;  ///< the lowest value but one; `lowest` if there is one value only
    double leastAboveZero = 0.0;    ///< the lowest value above 0; 0 if there is none
    std::int64_t atLowest = 0;      ///< how many hold `lowest`
    std::int64_t below = 0;         ///< how many lie below 0
    std::int64_t above = 0;         ///< how many lie above 0
    bool any = false;               ///< whether any value is finite

    void add(double value);
};

/// Where black is, in the values of a file.
struct BlackLevel {
    double level = 0.0;
    std::int64_t below = 0;  ///< number of voxels below `level`
    double lowest = 0.0;     ///< the lowest finite value
    /// A value that many voxels hold, so far below all others that it can be no echo. It counts for nothing.
    std::optional<double> padding{};
};

/// Whether 0 may be the wrong black, or float32 too small for the values. If not, blackLevelOf() is 0 and scaleFrom()
/// changes nothing: both take several passes, which ordinary volumes are spared.
[[nodiscard]] bool mayNeedWindow(const ValueExtent& extent);

/// Whether 0 hides much, as far as the extent tells: blackLevelOf() is 0 if not, and may be 0 if so.
[[nodiscard]] bool mayHideMuch(const ValueExtent& extent);

/// Black is 0 unless 0 hides much:
/// - More than a tenth of the voxels that are not 0 lie below 0, by more than 1 % of the whole range. Black is then the
///   low end of the data, found as whiteLevelOf() finds the high one: cold voxels, alone below a gap, move nothing.
/// - All voxels that are not 0 lie within 1/64 below the highest value: they could not be told apart. Black is then the
///   lowest of them.
/// One value that more than a few voxels hold, and that lies farther below all others than these reach, is padding and
/// counts for nothing. If 2 % of the voxels or more hold the lowest value, it is the outside and hides nothing; nor do
/// the few values that interpolation or means of blocks make between it and the data. It is padding if it lies farther
/// below the data than these reach. Black is then where the data begin to lie close together.
[[nodiscard]] BlackLevel blackLevelOf(const ValueBlocks& values, bool wholeNumbers, const ValueExtent& extent);

/// The scale of values that are shown from `black` on. Its factor is 1 if float32 holds the range from there to the
/// high end of the data. Else it is the power of two that makes this range 1 to 4.
[[nodiscard]] ValueScale scaleFrom(double black, const ValueBlocks& values, bool wholeNumbers,
                                   const ValueExtent& extent);

/// Whether a black that a file declares suits its values: it lies below the highest one, and not more than eight times
/// the data's range below their low end, where the picture would be white.
[[nodiscard]] bool suitsAsBlack(double declared, const BlackLevel& measured, const ValueExtent& extent);

}  // namespace echolucent
