// The numbers of the method beside those of the textbook formulas in the same precision.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "app/measuring/stability/study_stability.h"
#include "app/measuring/stability/study_stability_inputs.h"
#include "app/measuring/stability/study_stability_reference.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent::cli {

namespace {

constexpr char ours[] = "as here";
constexpr double infiniteError = std::numeric_limits<double>::infinity();

/// To see a double's error, a number needs more digits than a double has.
long double numberFrom(const std::string& digits) { return std::strtold(digits.c_str(), nullptr); }

/// The worst value of one way in one condition.
class Worst {
public:
    Worst(std::string quantity, std::string condition, std::string way, std::optional<double> allowed) {
        m_check = {std::move(quantity), std::move(condition), std::move(way), 0.0, "", -1.0, allowed, {}};
    }
    /// The error is given in multiples of `scale`.
    void add(double value, long double exact, const std::string& digits, long double scale = 1.0L) {
        const long double error = std::abs(static_cast<long double>(value) - exact) / scale;
        const double counted = std::isfinite(value) ? static_cast<double>(error) : infiniteError;
        if (counted <= m_check.error) return;
        m_check.error = counted;
        m_check.value = value;
        m_check.reference = digits;
    }
    [[nodiscard]] NumericCheck at(std::optional<double> abscissa = {}) const {
        NumericCheck check = m_check;
        check.abscissa = abscissa;
        return check;
    }

private:
    NumericCheck m_check;
};

/// Eqs. 5 and 6 literally, with the erratum, in double.
double literalBasis(double x, double low, double high) {
    const double b = 2.0 / ((high - low) * (high - low));
    const double c = 1.0 / std::sqrt(2.0 * b) + low;
    const double a = std::sqrt(2.0 * b * std::numbers::e);
    return a * (x - c) * std::exp(-b * (x - c) * (x - c));
}

void checkBasis(std::vector<NumericCheck>& checks) {
    const auto& rows = reference::basisReferences;
    for (std::size_t first = 0; first < rows.size();) {
        const double gap = rows[first].gap;
        const std::string condition = fmt::format("I_H - I_L = {:.3g}", gap);
        Worst here("basis function", condition, ours, 4e-16);
        Worst literal("basis function", condition, "eq. 6 literally: a, b, c", {});
        for (; first < rows.size() && rows[first].gap == gap; ++first) {
            const auto& row = rows[first];
            const long double exact = numberFrom(row.digits);
            here.add(basisFunction(row.intensity, row.low, row.high), exact, row.digits);
            literal.add(literalBasis(row.intensity, row.low, row.high), exact, row.digits);
        }
        checks.push_back(here.at(gap));
        checks.push_back(literal.at(gap));
    }
}

std::vector<TubeCore> tubesOf(const reference::LogOpacityReference& row) {
    std::vector<TubeCore> tubes(static_cast<std::size_t>(row.tubes));
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        const auto input = reference::tubeInput(t, row.dMax);
        tubes[t].status = TubeStatus::surface;
        tubes[t].d = input.d;
        tubes[t].lowIntensity = input.range.low;
        tubes[t].highIntensity = input.range.high;
    }
    return tubes;
}

/// ln of x^2 prod (1 + d)^g, multiplied as in eq. 4.
double logOfProduct(const std::vector<TubeCore>& tubes, double x) {
    double product = x * x;
    for (const TubeCore& tube : tubes)
        product *= std::pow(1.0 + tube.d, basisFunction(x, *tube.lowIntensity, *tube.highIntensity));
    return std::log(product);
}

void checkLogOpacity(std::vector<NumericCheck>& checks) {
    for (const auto& row : reference::logOpacityReferences) {
        constexpr int few = 225;
        const std::string quantity = "log opacity, error over the sum of magnitudes";
        const std::string condition =
            fmt::format("T = {}, d_max = {:g}, x = {}/255", row.tubes, row.dMax, row.intensity);
        Worst here(quantity, condition, ours, row.tubes > few ? 1e-11 : 1e-12);
        Worst product(quantity, condition, "plain product, then ln", {});
        const auto tubes = tubesOf(row);
        const long double exact = numberFrom(row.digits), scale = std::max(1.0, row.magnitudes);
        constexpr int count = AdaptiveOtf::sampleCount;
        here.add(adaptedLogOpacity(PowerCurve{2, 1.0}, tubes, count)[static_cast<std::size_t>(row.intensity)], exact,
                 row.digits, scale);
        product.add(logOfProduct(tubes, row.intensity / (count - 1.0)), exact, row.digits, scale);
        checks.push_back(here.at());
        checks.push_back(product.at());
    }
}

void checkSteps(std::vector<NumericCheck>& checks) {
    for (const auto& row : reference::stepReferences) {
        const std::string quantity = "opacity for another step, relative";
        const std::string condition = fmt::format("opacity {:.15g}, {} steps", row.opacity, row.ratio);
        Worst here(quantity, condition, ours, 1e-15);
        Worst doubles(quantity, condition, "pow in double", {}), floats(quantity, condition, "pow in float", {});
        const long double exact = numberFrom(row.digits);
        here.add(opacityForStep(row.opacity, row.ratio), exact, row.digits, exact);
        doubles.add(1.0 - std::pow(1.0 - row.opacity, row.ratio), exact, row.digits, exact);
        const auto opacity = static_cast<float>(row.opacity), ratio = static_cast<float>(row.ratio);
        floats.add(1.0f - std::pow(1.0f - opacity, ratio), exact, row.digits, exact);
        for (const Worst& worst : {here, doubles, floats}) checks.push_back(worst.at());
    }
}

/// Cells in the far corner of a cube of 16-bit voxels. The voxels take 5 values around a mean.
class BrightCube {
public:
    static constexpr std::size_t edge = 160, cell = 5;
    explicit BrightCube(int mean) : m_mean(mean) {
        // Sums over all voxels before a corner; 0 along the faces (Crow 1984).
        for (std::size_t z = 1; z <= edge; ++z)
            for (std::size_t y = 1; y <= edge; ++y) {
                double row = 0.0, rowOfSquares = 0.0;
                for (std::size_t x = 1; x <= edge; ++x) {
                    const double value = voxel(x - 1, y - 1, z - 1);
                    row += value;
                    rowOfSquares += value * value;
                    const auto add = [&](std::vector<double>& table, double all) {
                        table[at(x, y, z)] =
                            all + table[at(x, y - 1, z)] + table[at(x, y, z - 1)] - table[at(x, y - 1, z - 1)];
                    };
                    add(m_sums, row);
                    add(m_squares, rowOfSquares);
                }
            }
    }
    [[nodiscard]] std::uint16_t voxel(std::size_t x, std::size_t y, std::size_t z) const {
        return static_cast<std::uint16_t>(m_mean - 2 + static_cast<int>(splitmix64(x + edge * (y + edge * z)) % 5));
    }
    /// The variance of the cell that begins at a voxel, from the eight corners of the summed-area tables.
    [[nodiscard]] double varianceByTable(std::size_t x, std::size_t y, std::size_t z) const {
        constexpr double n = cell * cell * cell;
        const auto box = [&](const std::vector<double>& table) {
            double sum = 0.0;
            for (int corner = 0; corner < 8; ++corner) {
                const auto part = [&](int bit, std::size_t from) {
                    return (corner >> bit & 1) != 0 ? from + cell : from;
                };
                const int sign = (corner & 1) + (corner >> 1 & 1) + (corner >> 2 & 1);
                sum += (sign % 2 == 1 ? 1.0 : -1.0) * table[at(part(0, x), part(1, y), part(2, z))];
            }
            return sum;
        };
        const double mean = box(m_sums) / n;
        return box(m_squares) / n - mean * mean;
    }

private:
    static std::size_t at(std::size_t x, std::size_t y, std::size_t z) { return x + (edge + 1) * (y + (edge + 1) * z); }
    int m_mean;
    std::vector<double> m_sums = std::vector<double>((edge + 1) * (edge + 1) * (edge + 1), 0.0), m_squares = m_sums;
};

template <typename Real>
double varianceByMeans(const std::vector<std::uint16_t>& values) {
    Real sum = 0, squares = 0;
    for (const std::uint16_t stored : values) {
        const auto value = static_cast<Real>(stored);
        sum += value;
        squares += value * value;
    }
    const Real mean = sum / static_cast<Real>(values.size());
    return static_cast<double>(squares / static_cast<Real>(values.size()) - mean * mean);
}

double varianceHere(const std::vector<std::uint16_t>& values) {
    SlabSums slabs;
    slabs.counts.resize(BrightCube::cell);
    slabs.sums.resize(BrightCube::cell);
    slabs.sumsOfSquares.resize(BrightCube::cell);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t slab = i / (BrightCube::cell * BrightCube::cell);
        ++slabs.counts[slab];
        slabs.sums[slab] += values[i];
        slabs.sumsOfSquares[slab] += std::uint64_t{values[i]} * values[i];
    }
    CellStatistics cells;
    cellsFrom(slabs, static_cast<int>(BrightCube::cell), 1.0, cells);
    return cells.variances.front();
}

void checkVariance(std::vector<NumericCheck>& checks) {
    for (const int mean : {30000, 65000}) {
        const std::string quantity = "cell variance, relative",
                          condition = fmt::format("16-bit voxels of mean {}", mean);
        Worst here(quantity, condition, ours, 3e-16), floats(quantity, condition, "E[x²] - E[x]² in float", {});
        Worst doubles(quantity, condition, "E[x²] - E[x]² in double", {});
        Worst table(quantity, condition, "summed-area table in double", {});
        const BrightCube cube(mean);
        constexpr std::size_t cells = 100, cell = BrightCube::cell;
        for (std::size_t i = 0; i < cells; ++i) {
            const std::size_t x = BrightCube::edge - cell - i % 10, y = BrightCube::edge - cell - i / 10;
            const std::size_t z = BrightCube::edge - cell;
            std::vector<std::uint16_t> values;
            std::int64_t sum = 0, squares = 0;
            for (std::size_t k = 0; k < cell * cell * cell; ++k) {
                values.push_back(cube.voxel(x + k % cell, y + k / cell % cell, z + k / (cell * cell)));
                // The reference uses deviations from a known mean: small whole numbers.
                const std::int64_t deviation = values.back() - mean;
                sum += deviation;
                squares += deviation * deviation;
            }
            const auto n = static_cast<std::int64_t>(values.size());
            const std::int64_t scaled = n * squares - sum * sum;
            const long double exact = static_cast<long double>(scaled) / static_cast<long double>(n * n);
            const std::string digits = fmt::format("{} / {}", scaled, n * n);
            here.add(varianceHere(values), exact, digits, exact);
            floats.add(varianceByMeans<float>(values), exact, digits, exact);
            doubles.add(varianceByMeans<double>(values), exact, digits, exact);
            table.add(cube.varianceByTable(x, y, z), exact, digits, exact);
        }
        for (const Worst& worst : {here, floats, doubles, table}) checks.push_back(worst.at());
    }
}

/// Weights of the parabola's value at the newest of five times, by the normal equations in the unshifted times.
std::array<double, 5> weightsByNormalEquations(const std::array<double, 5>& times) {
    std::array<std::array<double, 4>, 3> equations{};  // moments | powers of the newest time
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            for (const double time : times)
                equations[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] +=
                    std::pow(time, row + column);
        equations[static_cast<std::size_t>(row)][3] = std::pow(times.back(), row);
    }
    for (std::size_t pivot = 0; pivot < 3; ++pivot)
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == pivot) continue;
            const double factor = equations[row][pivot] / equations[pivot][pivot];
            for (std::size_t column = pivot; column < 4; ++column)
                equations[row][column] -= factor * equations[pivot][column];
        }
    std::array<double, 5> weights{};
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t power = 0; power < 3; ++power)
            weights[i] +=
                equations[power][3] / equations[power][power] * std::pow(times[i], static_cast<double>(power));
    return weights;
}

void checkMovingLeastSquares(std::vector<NumericCheck>& checks) {
    constexpr std::array<int, 5> exact{3, -5, -3, 9, 31};  // of 35
    for (const double origin : {0.0, 1.7e9, 1.7e12}) {
        const std::string quantity = "weights of moving least squares";
        const std::string condition = fmt::format("frames every 40 ms from {:g} ms on", origin);
        Worst here(quantity, condition, ours, 1e-14),
            normal(quantity, condition, "normal equations, times as they are", {});
        std::array<double, 5> times{};
        for (std::size_t i = 0; i < times.size(); ++i) times[i] = origin + 40.0 * static_cast<double>(i);
        const auto weights = smoothingWeights(OtfSmoothing::movingLeastSquares, times);
        const auto byNormalEquations = weightsByNormalEquations(times);
        for (std::size_t i = 0; i < times.size(); ++i) {
            const long double value = exact[i] / 35.0L;
            here.add(weights[i], value, fmt::format("{} / 35", exact[i]));
            normal.add(byNormalEquations[i], value, fmt::format("{} / 35", exact[i]));
        }
        checks.push_back(here.at());
        checks.push_back(normal.at());
    }
}

}  // namespace

std::vector<NumericCheck> numericChecks() {
    std::vector<NumericCheck> checks;
    checkBasis(checks);
    checkLogOpacity(checks);
    checkVariance(checks);
    checkSteps(checks);
    checkMovingLeastSquares(checks);
    return checks;
}

}  // namespace echolucent::cli
