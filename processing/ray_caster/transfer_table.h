// Colour and opacity of an intensity as one look-up.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/ray_caster.h"

namespace echolucent::ray_casting {

/// Four floats the compiler keeps in one register: red, green, blue, alpha.
using Float4 = float __attribute__((vector_size(16)));

/// Entries are colour times opacity, then opacity, for one step of the ray; linear between entries.
class TransferTable {
public:
    /// Eight steps between two 8-bit values, so that each 8-bit value and each node of a 256-value curve is an entry.
    static constexpr int intervals = 255 * 8;

    /// stepRatio: the ray's step in reference steps, > 0.
    TransferTable(const OpacityCurve& curve, ColourMap colourMap, double stepRatio);

    /// `position`: normalised intensity times `intervals`, within [0, intervals].
    [[nodiscard]] Float4 at(float position) const {
        const int left = static_cast<int>(position);
        const float share = position - static_cast<float>(left);
        const Float4* entry = m_entries.data() + left;
        return entry[0] + share * (entry[1] - entry[0]);
    }

    /// True where every intensity between two positions is fully transparent.
    [[nodiscard]] bool transparentBetween(float lowest, float highest) const;
    /// True where some intensities above 0 are transparent, so that looking for empty regions can pay.
    [[nodiscard]] bool hasTransparentRange() const { return transparentBetween(0.0f, 8.0f); }

private:
    std::vector<Float4> m_entries;             ///< intervals + 2: at(intervals) reads one beyond
    std::vector<std::int32_t> m_opaqueBefore;  ///< entries with opacity above 0 before each entry
};

}  // namespace echolucent::ray_casting
