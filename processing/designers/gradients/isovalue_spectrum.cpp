#include "processing/designers/gradients/isovalue_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <type_traits>
#include <variant>

#include "processing/parallel.h"
#include "processing/progress_count.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {

namespace {

constexpr std::size_t isovalueCount = ContourSpectrum::count;
constexpr double lastIsovalue = isovalueCount - 1;

/// Sums over the isovalues as whole numbers: no order of adding changes a bit, and 0 stays 0. 2^39 voxels fit.
class SpreadSums {
public:
    static constexpr double one = 1 << 24;

    /// Spreads an amount evenly over [low, high[. Isovalue i stands at i + 1/2 of this axis and owns [i, i + 1[.
    void add(double amount, double low, double high) {
        const auto whole = static_cast<std::int64_t>(std::llround(amount * one));
        const auto first = static_cast<std::size_t>(low),
                   last = std::min(static_cast<std::size_t>(high), isovalueCount - 1);
        if (first == last) {
            m_single[first] += whole;
            return;
        }
        const double rate = static_cast<double>(whole) / (high - low);
        const auto begun = static_cast<std::int64_t>(rate * (static_cast<double>(first + 1) - low));
        const auto between = static_cast<std::int64_t>(rate);
        m_single[first] += begun;
        m_step[first + 1] += between;
        m_step[last] -= between;
        m_single[last] += whole - begun - between * static_cast<std::int64_t>(last - first - 1);
    }

    void add(const SpreadSums& other) {
        for (std::size_t i = 0; i < isovalueCount; ++i) {
            m_single[i] += other.m_single[i];
            m_step[i] += other.m_step[i];
        }
    }

    [[nodiscard]] std::array<double, isovalueCount> sums() const {
        std::array<double, isovalueCount> sums{};
        std::int64_t between = 0;
        for (std::size_t i = 0; i < isovalueCount; ++i) {
            between += m_step[i];
            sums[i] = static_cast<double>(m_single[i] + between) / one;
        }
        return sums;
    }

private:
    std::array<std::int64_t, isovalueCount> m_single{};
    std::array<std::int64_t, isovalueCount> m_step{};  ///< how much more each isovalue holds from here on
};

struct Sums {
    SpreadSums voxels, gradients, squares;
};

/// Adds the rows of a slice. `edge` is a voxel's edge, units.
template <typename Voxel>
void addSlice(const Volume& volume, const VoxelArray<Voxel>& voxels, const GradientMagnitude& gradients, std::int64_t z,
              double edge, Sums& sums) {
    const VolumeGeometry& geometry = volume.geometry();
    std::vector<float> row(static_cast<std::size_t>(geometry.size[0]));
    for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
        gradients.row(y, z, row);
        const std::int64_t begin = geometry.offset(0, y, z);
        for (std::size_t x = 0; x < row.size(); ++x) {
            const std::int64_t at = begin + static_cast<std::int64_t>(x);
            const auto stored = static_cast<double>(voxels[static_cast<std::size_t>(at)]);
            if (!volume.hasData(at)) continue;
            if constexpr (std::is_floating_point_v<Voxel>)
                if (!std::isfinite(stored)) continue;
            const auto gradient = static_cast<double>(row[x]);
            const double share = stored / volume.whiteLevel();
            const double middle = 0.5 + lastIsovalue * (share > 0.0 ? std::min(share, 1.0) : 0.0);
            const double reach = std::max(0.5, 0.5 * lastIsovalue * edge * gradient);
            // A range is cut at black and white; its whole amount goes to the rest.
            const double low = std::max(middle - reach, 0.5), high = std::min(middle + reach, lastIsovalue + 0.5);
            sums.voxels.add(1.0, low, high);
            sums.gradients.add(gradient, low, high);
            sums.squares.add(gradient * gradient, low, high);
        }
    }
}

/// A row of isovalues, smoothed by a Gaussian with a standard deviation of two steps. The ends are no surfaces: they
/// take no part, and become 0.
std::vector<double> smoothedOverIsovalues(const std::vector<double>& values) {
    constexpr int taps = 13;
    std::vector<double> inner(values.begin() + 1, values.end() - 1);
    cv::Mat row(1, static_cast<int>(inner.size()), CV_64F, inner.data());
    cv::GaussianBlur(row, row, {taps, 1}, 2.0, 2.0, cv::BORDER_REFLECT);
    std::vector<double> all(values.size(), 0.0);
    std::copy(inner.begin(), inner.end(), all.begin() + 1);
    return all;
}

std::vector<double> ratios(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios(above.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < ratios.size(); ++i)
        if (below[i] > 0.0) ratios[i] = above[i] / below[i];
    return ratios;
}

/// How far the values fall from a place in one direction, before a value exceeds that of the place; NaN ends the way.
double fallFrom(const std::vector<double>& values, std::size_t from, std::ptrdiff_t step) {
    double least = values[from];
    for (auto i = static_cast<std::ptrdiff_t>(from) + step; i >= 0 && i < static_cast<std::ptrdiff_t>(values.size());
         i += step) {
        const double value = values[static_cast<std::size_t>(i)];
        // Of equal values the first is the maximum: it ends the way of the later ones.
        if (std::isnan(value) || value > values[from] || (step < 0 && value == values[from])) break;
        least = std::min(least, value);
    }
    return values[from] - least;
}

}  // namespace

std::vector<double> ContourSpectrum::meanGradient() const { return ratios(gradientIntegral, area); }

std::optional<ContourSpectrum> contourSpectrum(const Volume& volume, const Progress& progress) {
    const Volume filled = filledVoxels(volume);
    const GradientMagnitude gradients(filled);
    const VolumeGeometry& geometry = volume.geometry();
    const auto slices = static_cast<std::size_t>(geometry.size[2]);
    const double unit = geometry.unit();
    const double voxelVolume = geometry.spacing[0] / unit * (geometry.spacing[1] / unit) * (geometry.spacing[2] / unit);
    const double edge = std::cbrt(voxelVolume);
    constexpr std::size_t mostParts = 16;
    std::vector<Sums> found(std::min(mostParts, slices));
    ProgressCount done(progress, slices);
    parallelFor(std::size_t{0}, found.size(), [&](std::size_t part) {
        for (std::size_t z = part; z < slices && !progress.cancelled(); z += found.size()) {
            std::visit(
                [&](const auto& voxels) {
                    addSlice(volume, voxels, gradients, static_cast<std::int64_t>(z), edge, found[part]);
                },
                volume.voxels());
            done.oneDone();
        }
    });
    if (progress.cancelled()) return std::nullopt;
    for (std::size_t part = 1; part < found.size(); ++part) {
        found[0].voxels.add(found[part].voxels);
        found[0].gradients.add(found[part].gradients);
        found[0].squares.add(found[part].squares);
    }
    const std::array<double, isovalueCount> voxels = found[0].voxels.sums(), first = found[0].gradients.sums(),
                                            second = found[0].squares.sums();
    ContourSpectrum spectrum{std::vector<double>(isovalueCount), std::vector<double>(isovalueCount),
                             std::vector<double>(isovalueCount)};
    double above = 0.0;
    for (std::size_t i = isovalueCount; i-- > 0;) {
        const double width = ContourSpectrum::width(i);
        spectrum.area[i] = first[i] * voxelVolume / width;
        spectrum.gradientIntegral[i] = second[i] * voxelVolume / width;
        // Half of an isovalue's share lies below it; at 0 all of it lies above, at 1 nothing.
        const double half = i == 0 ? 1.0 : i + 1 == isovalueCount ? 0.0 : 0.5;
        spectrum.volume[i] = (above + half * voxels[i]) * voxelVolume;
        above += voxels[i];
    }
    return spectrum;
}

std::vector<SpectrumMaximum> maximaOf(const ContourSpectrum& spectrum, double leastArea) {
    constexpr double leastFall = 0.05;
    const std::vector<double> area = smoothedOverIsovalues(spectrum.area);
    std::vector<double> steepness = ratios(smoothedOverIsovalues(spectrum.gradientIntegral), area);
    const double needed = leastArea * *std::ranges::max_element(area);
    for (std::size_t i = 0; i < isovalueCount; ++i)
        if (!(area[i] >= needed)) steepness[i] = std::numeric_limits<double>::quiet_NaN();
    std::vector<SpectrumMaximum> maxima;
    for (std::size_t i = 0; i < isovalueCount; ++i) {
        if (!(steepness[i] > 0.0)) continue;
        const double fall = leastFall * steepness[i];
        if (fallFrom(steepness, i, -1) >= fall && fallFrom(steepness, i, 1) >= fall)
            maxima.push_back({i, ContourSpectrum::isovalue(i), spectrum.area[i], steepness[i]});
    }
    std::ranges::stable_sort(maxima, [](const SpectrumMaximum& one, const SpectrumMaximum& other) {
        return one.meanGradient > other.meanGradient;
    });
    return maxima;
}

}  // namespace echolucent
