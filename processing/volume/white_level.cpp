#include "processing/volume/white_level.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <vector>

namespace echolucent {

namespace {

/// Bins of positive doubles by their upper 19 bits: 128 an octave, each less than 1 % wide. Whole numbers up to 255
/// have bins of their own.
constexpr int bitsBelowBin = 45;
constexpr std::size_t binsPerOctave = 128;
constexpr std::size_t binCount = 0x3FF80;  // the next one begins at infinity

std::size_t binOf(double value) { return std::bit_cast<std::uint64_t>(value) >> bitsBelowBin; }

/// The least value of a bin; infinity for binCount.
double beginOf(std::size_t bin) { return std::bit_cast<double>(static_cast<std::uint64_t>(bin) << bitsBelowBin); }

/// The voxels above 0 of all phases, counted by bin. `forEach` calls its argument with each block of values.
class BinCounts {
public:
    template <typename ForEach>
    explicit BinCounts(const ForEach& forEach) : m_counts(binCount) {
        forEach([&](const auto& values) {
            for (const auto value : values)
                if (const auto real = static_cast<double>(value); real > 0.0 && std::isfinite(real))
                    ++m_counts[binOf(real)];
        });
        m_all = voxelsBelow(binCount);
    }

    [[nodiscard]] std::int64_t all() const { return m_all; }

    [[nodiscard]] std::int64_t voxelsBelow(std::size_t endBin) const {
        std::int64_t below = 0;
        for (std::size_t bin = 0; bin < endBin; ++bin) below += m_counts[bin];
        return below;
    }

    /// The bin of the voxel that has `below` voxels before it in the order of values; 0 <= below < all().
    [[nodiscard]] std::size_t binOfRank(std::int64_t below) const {
        std::size_t bin = 0;
        for (std::int64_t counted = m_counts[0]; counted <= below; counted += m_counts[bin]) ++bin;
        return bin;
    }

    /// The last bin below `endBin` that is reached from `bin` without a gap.
    [[nodiscard]] std::size_t lastWithoutGap(std::size_t bin, std::size_t endBin, bool wholeNumbers) const {
        constexpr double widestGap = 1.1;
        for (std::size_t next = bin + 1; next < endBin; ++next) {
            if (m_counts[next] == 0) continue;
            const bool neighbours = wholeNumbers && beginOf(next) - beginOf(bin) <= 1.0;
            if (!neighbours && beginOf(next) > widestGap * beginOf(bin + 1)) break;
            bin = next;
        }
        return bin;
    }

private:
    std::vector<std::int64_t> m_counts;
    std::int64_t m_all = 0;
};

/// How many of `all` voxels may be hot.
std::int64_t mostHot(std::int64_t all) {
    constexpr std::int64_t rare = 10000, fewVoxels = 8;
    return std::max(all / rare, std::min(fewVoxels, all / 100));
}

/// The first bin of absurd values, or binCount if there are none. Values from this bin on do not count.
std::size_t firstAbsurdBin(const BinCounts& counts) {
    constexpr std::size_t absurdOctaves = 20, keptOctaves = 2;
    const std::size_t common = counts.binOfRank((99 * counts.all() + 99) / 100 - 1);
    const std::size_t bound = (common / binsPerOctave + 1) * binsPerOctave;
    const std::size_t typical = counts.binOfRank(counts.all() - 1 - mostHot(counts.all()));
    return typical >= bound + absurdOctaves * binsPerOctave ? std::min(bound + keptOctaves * binsPerOctave, binCount)
                                                            : binCount;
}

template <typename ForEach>
void measureAround(const ForEach& forEach, double end, WhiteLevel& white) {
    forEach([&](const auto& values) {
        for (const auto stored : values) {
            const double value = static_cast<double>(stored);
            if (!std::isfinite(value)) continue;
            white.largest = std::max(white.largest, value);
            if (value < end)
                white.level = std::max(white.level, value);
            else
                ++white.above;
        }
    });
}

template <typename ForEach>
WhiteLevel measured(const ForEach& forEach, bool wholeNumbers) {
    WhiteLevel white;
    const BinCounts counts(forEach);
    white.all = counts.all();
    if (counts.all() == 0) return white;
    white.middle = beginOf(counts.binOfRank(counts.all() / 2));
    const std::size_t end = firstAbsurdBin(counts);
    const std::int64_t looked = counts.voxelsBelow(end);
    const std::size_t typical = counts.binOfRank(looked - 1 - mostHot(looked));
    measureAround(forEach, beginOf(counts.lastWithoutGap(typical, end, wholeNumbers) + 1), white);
    return white;
}

}  // namespace

WhiteLevel whiteLevelOf(std::span<const Voxels> phases) {
    const bool wholeNumbers = std::none_of(phases.begin(), phases.end(), [](const Voxels& voxels) {
        return std::holds_alternative<VoxelArray<float>>(voxels);
    });
    return measured(
        [&](const auto& take) {
            for (const Voxels& phase : phases) std::visit(take, phase);
        },
        wholeNumbers);
}

WhiteLevel whiteLevelOf(const ValueBlocks& values, bool wholeNumbers) {
    return measured([&](const auto& take) { values(take); }, wholeNumbers);
}

DeclaredWhite judgeDeclaredWhite(double declared, const WhiteLevel& measured) {
    constexpr double blackBeyond = 8.0;
    if (!std::isfinite(declared) || !(declared > 0.0)) return DeclaredWhite::notAboveZero;
    if (!(measured.level > 0.0)) return DeclaredWhite::suits;
    if (declared > blackBeyond * measured.level) return DeclaredWhite::tooHigh;
    return declared < measured.middle ? DeclaredWhite::tooLow : DeclaredWhite::suits;
}

}  // namespace echolucent
