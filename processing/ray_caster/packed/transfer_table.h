// Look-ups of the colour and opacity of an intensity.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/colour_map.h"

namespace echolucent::ray_casting {

/// A colour map for the kernel: linear in the table position within each of four equal ranges.
struct ColourRanges {
    static constexpr int count = 4;
    using Values = std::array<float, count>;
    std::array<Values, 3> base, slope;  ///< of red, green, blue: colour = base + slope * table position
};

/// The colours of ColourRanges as sums: colour = base + slope * x + the sum of change[i] * max(x - at(i), 0), x the
/// normalised intensity. With them, many samples together need no colour of their own.
struct ColourBends {
    static constexpr int count = ColourRanges::count - 1;
    static constexpr float at(int bend) { return static_cast<float>(bend + 1) / ColourRanges::count; }

    explicit ColourBends(ColourMap colourMap);

    bool any = false;  ///< false if one range is enough, as in the grey map
    std::array<float, 3> base{}, slope{};
    std::array<std::array<float, count>, 3> change{};
};

/// Opacities of one step of the ray at `intervals` + 1 intensities, linear between. Neighbouring rays through speckle
/// read all of the table. It is small enough for the nearest cache beside the voxels.
class TransferTable {
public:
    /// Eight intervals between two 8-bit values, so that each 8-bit value and each node of a 256-value curve is an
    /// entry.
    static constexpr int intervals = 255 * 8;

    /// `stepRatio` is the ray's step in reference steps, above 0.
    TransferTable(const OpacityCurve& curve, ColourMap colourMap, double stepRatio);

    /// Opacities at normalised intensity i / intervals, i = 0 ... intervals, and the last one once more.
    [[nodiscard]] const float* opacities() const { return m_opacities.data(); }
    /// The extinctions of the same step, for parts of a step: -log(1 - opacity), and mostExtinction for opacity 1.
    /// Opacities would not do: that of a long step has lost its digits near 1.
    [[nodiscard]] const float* extinctions() const { return m_extinctions.data(); }
    static constexpr double mostExtinction = 1e6;
    [[nodiscard]] const ColourRanges& colours() const { return m_colours; }
    /// Table positions up to this one have opacity 0.
    [[nodiscard]] float firstVisible() const { return m_firstVisible; }

    /// Whether all intensities between two table positions, within [0, intervals], have at most opacity `negligible`
    /// for a reference step.
    [[nodiscard]] bool transparentBetween(float lowest, float highest) const;

    /// The opacity of a reference step that counts as none in skipped regions. Over 4096 units it adds up to at most
    /// 1/16 of an 8-bit level.
    static constexpr double negligible = 1.0 / (16.0 * 255.0 * 4096.0);

private:
    std::vector<float> m_opacities, m_extinctions;
    std::vector<std::int32_t> m_visibleBefore;  ///< number of entries above `negligible` before each entry
    ColourRanges m_colours;
    float m_firstVisible;
};

/// Opacities of one step of the ray over the voxels' value, with perLevel entries between two bytes. They are dense
/// enough for reading the nearest one, and few enough for the nearest cache.
class ByteOpacities {
public:
    static constexpr int perLevel = 16;
    /// Below this white level, TransferTable has more entries up to white.
    static constexpr double leastWhite = 128.0;

    /// `toTable` is the factor from a voxel's value to its table position.
    ByteOpacities(const TransferTable& table, double toTable);
    [[nodiscard]] const float* data() const { return m_opacities.data(); }
    /// Positions below this one, in entries, have opacity 0.
    [[nodiscard]] float firstVisible() const { return m_firstVisible; }

private:
    std::vector<float> m_opacities;
    float m_firstVisible;
};

}  // namespace echolucent::ray_casting
