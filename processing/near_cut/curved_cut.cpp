#include "processing/near_cut/curved_cut.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <vector>

namespace echolucent {

namespace {

constexpr int nodesAcross = 16;  // nodes along the longer side
constexpr int leastTubes = 30;   // fewer tell no shape
// Samples behind the place where a stretch begins: there the wall's ramp, as wide as the smoothing, is over.
constexpr double farEnoughInside = 2.5;
constexpr double steepest = 1.75;    // depth over distance, between neighbouring nodes
constexpr double flattening = 0.02;  // share of a node's mean weight with which the flat cut draws every node
constexpr int fits = 10;

/// A place that the surface should pass: there a tube core is just inside fluid.
struct Target {
    double column, row;  ///< in nodes
    double depth, weight;
};

/// A symmetric matrix that is 0 farther than `reach` from its diagonal. A node of a plate is bound to those two rows
/// away at most, so the equations of 256 nodes are solved in 0.16 ms here. For all of their entries, cv::solve() takes
/// 2.2 ms.
class BandMatrix {
public:
    BandMatrix(int size, int reach) : m_size(size), m_reach(reach), m_entries(size, reach + 1, 0.0) {}

    /// The entry (i, j), i - reach <= j <= i.
    [[nodiscard]] double& operator()(int i, int j) { return m_entries(i, j - i + m_reach); }

    /// Replaces `right` by the solution, and the matrix by its Cholesky factor. The solution is 0 if the matrix is not
    /// positive definite.
    void solve(cv::Mat1d& right) {
        BandMatrix& factor = *this;
        for (int i = 0; i < m_size; ++i) {
            const int first = std::max(0, i - m_reach);
            for (int j = first; j <= i; ++j) {
                double rest = factor(i, j);
                for (int k = std::max(first, j - m_reach); k < j; ++k) rest -= factor(i, k) * factor(j, k);
                if (j < i) {
                    factor(i, j) = rest / factor(j, j);
                } else if (rest > 0.0) {
                    factor(i, i) = std::sqrt(rest);
                } else {
                    right = 0.0;
                    return;
                }
            }
            for (int j = first; j < i; ++j) right(i) -= factor(i, j) * right(j);
            right(i) /= factor(i, i);
        }
        for (int i = m_size - 1; i >= 0; --i) {
            right(i) /= factor(i, i);
            for (int j = std::max(0, i - m_reach); j < i; ++j) right(j) -= factor(i, j) * right(i);
        }
    }

private:
    int m_size, m_reach;
    cv::Mat1d m_entries;
};

/// The least squares problem over the nodes of a height field.
class Plate {
public:
    Plate(int columns, int rows) : m_columns(columns), m_rows(rows) {}

    /// The heights that come nearest to the targets. The larger `stiffness`, the smoother they are; `pull` draws them
    /// to `level`.
    [[nodiscard]] cv::Mat1d fitted(std::span<const Target> targets, double stiffness, double pull, double level) const {
        const int nodes = m_columns * m_rows;
        BandMatrix normal(nodes, std::min(nodes - 1, 2 * m_columns));
        cv::Mat1d right(nodes, 1, 0.0);
        const auto add = [&](std::span<const std::pair<int, double>> row, double value, double weight) {
            for (const auto& [i, a] : row) {
                for (const auto& [j, b] : row)
                    if (j <= i) normal(i, j) += weight * a * b;
                right(i) += weight * a * value;
            }
        };
        for (const Target& target : targets) {
            const int column = std::min(static_cast<int>(target.column), m_columns - 2);
            const int row = std::min(static_cast<int>(target.row), m_rows - 2);
            const double x = target.column - column, y = target.row - row;
            const std::pair<int, double> corners[] = {{at(column, row), (1 - x) * (1 - y)},
                                                      {at(column + 1, row), x * (1 - y)},
                                                      {at(column, row + 1), (1 - x) * y},
                                                      {at(column + 1, row + 1), x * y}};
            add(corners, target.depth, target.weight);
        }
        addStiffness(stiffness, add);
        for (int node = 0; node < nodes; ++node) {
            normal(node, node) += pull;
            right(node) += pull * level;
        }
        normal.solve(right);
        return right;
    }
    [[nodiscard]] double heightAt(const cv::Mat1d& heights, const Target& target) const {
        const int column = std::min(static_cast<int>(target.column), m_columns - 2);
        const int row = std::min(static_cast<int>(target.row), m_rows - 2);
        const double x = target.column - column, y = target.row - row;
        return (1 - y) * ((1 - x) * heights(at(column, row)) + x * heights(at(column + 1, row))) +
               y * ((1 - x) * heights(at(column, row + 1)) + x * heights(at(column + 1, row + 1)));
    }
    /// The largest difference between neighbouring nodes.
    [[nodiscard]] double steepestStep(const cv::Mat1d& heights) const {
        double most = 0.0;
        for (int row = 0; row < m_rows; ++row)
            for (int column = 0; column < m_columns; ++column) {
                const double here = heights(at(column, row));
                if (column + 1 < m_columns) most = std::max(most, std::abs(heights(at(column + 1, row)) - here));
                if (row + 1 < m_rows) most = std::max(most, std::abs(heights(at(column, row + 1)) - here));
            }
        return most;
    }

private:
    [[nodiscard]] int at(int column, int row) const { return row * m_columns + column; }

    /// The bending energy of a thin plate.
    template <typename Add>
    void addStiffness(double stiffness, const Add& add) const {
        using Entry = std::pair<int, double>;
        for (int row = 0; row < m_rows; ++row)
            for (int column = 0; column < m_columns; ++column) {
                if (column > 0 && column + 1 < m_columns) {
                    const Entry bend[] = {
                        {at(column - 1, row), 1.0}, {at(column, row), -2.0}, {at(column + 1, row), 1.0}};
                    add(bend, 0.0, stiffness);
                }
                if (row > 0 && row + 1 < m_rows) {
                    const Entry bend[] = {
                        {at(column, row - 1), 1.0}, {at(column, row), -2.0}, {at(column, row + 1), 1.0}};
                    add(bend, 0.0, stiffness);
                }
                if (column + 1 < m_columns && row + 1 < m_rows) {
                    const Entry twist[] = {{at(column, row), 1.0},
                                           {at(column + 1, row), -1.0},
                                           {at(column, row + 1), -1.0},
                                           {at(column + 1, row + 1), 1.0}};
                    add(twist, 0.0, 2.0 * stiffness);
                }
            }
    }

    int m_columns, m_rows;
};

/// The nodes of a surface over the tube cores of a view.
struct Nodes {
    int columns, rows;
    double samplesApart;
};

Nodes nodesOver(const TubeEcho& tubes) {
    const double apart = std::max(1.0, (std::max(tubes.columns, tubes.rows) - 1.0) / (nodesAcross - 1.0));
    const auto count = [&](int samples) { return std::max(2, static_cast<int>(std::ceil((samples - 1) / apart)) + 1); };
    return {count(tubes.columns), count(tubes.rows), apart};
}

/// One fit. Every tube core votes with one of its stretches: at first as chooseFirst() says, then with the one that
/// enters fluid nearest to the surface.
class Fit {
public:
    Fit(const TubeEcho& tubes, std::span<const FluidStretch> stretches, double flatSample)
        : m_tubes(tubes),
          m_stretches(stretches),
          m_nodes(nodesOver(tubes)),
          m_plate(m_nodes.columns, m_nodes.rows),
          m_heights(m_nodes.columns * m_nodes.rows, 1, flatSample),
          m_flat(flatSample) {}

    [[nodiscard]] bool run() {
        chooseFirst();
        if (m_targets.size() < leastTubes) return false;
        double scale = 1e9;
        for (int i = 0; i < fits; ++i) {
            const bool first = i == 0;
            if (!first) chooseNearest();
            weigh(scale);
            solve();
            scale = std::max(2.0, 1.5 * medianMiss());
        }
        return true;
    }
    [[nodiscard]] CutSurface surface() const {
        double front = m_tubes.samples;
        for (std::size_t tube = 0; tube < m_tubes.tubes(); ++tube)
            for (int sample = 0; sample < front; ++sample)
                if (m_tubes.tube(tube)[sample] >= 0.0F) front = sample;
        CutSurface surface{m_tubes.frame,
                           m_tubes.firstRightMm,
                           m_tubes.firstDownMm,
                           m_nodes.samplesApart * m_tubes.stepMm,
                           m_nodes.columns,
                           m_nodes.rows,
                           {}};
        const auto [shallow, deep] = std::minmax_element(
            m_targets.begin(), m_targets.end(), [](const Target& a, const Target& b) { return a.depth < b.depth; });
        std::vector<float> depths;
        for (int node = 0; node < m_heights.rows; ++node)
            depths.push_back(static_cast<float>(
                m_tubes.depthMm(std::clamp(m_heights(node), std::max(front, shallow->depth), deep->depth))));
        surface.depthMm = std::move(depths);
        return surface;
    }

private:
    [[nodiscard]] Target targetOf(const FluidStretch& stretch) const {
        const int column = stretch.tube % m_tubes.columns, row = stretch.tube / m_tubes.columns;
        return {column / m_nodes.samplesApart, row / m_nodes.samplesApart,
                stretch.begin - 0.5 + std::min(farEnoughInside, stretch.length() / 2.0),
                std::min(1.0, stretch.length() / 10.0) * stretch.contrast};
    }
    /// Of each tube core the stretch for which `cost` is least.
    template <typename Cost>
    void choose(const Cost& cost) {
        m_targets.clear();
        for (std::size_t i = 0; i < m_stretches.size();) {
            std::size_t best = i;
            const int tube = m_stretches[i].tube;
            for (; i < m_stretches.size() && m_stretches[i].tube == tube; ++i)
                if (cost(m_stretches[i]) < cost(m_stretches[best])) best = i;
            m_targets.push_back(targetOf(m_stretches[best]));
        }
    }
    /// Before there is a surface: the stretch that the flat cut opens, else the longest one.
    void chooseFirst() {
        choose([&](const FluidStretch& stretch) {
            const bool opened = stretch.begin <= m_flat && m_flat < stretch.end;
            return -(stretch.length() + (opened ? 1000 : 0));
        });
    }
    void chooseNearest() {
        choose([&](const FluidStretch& stretch) {
            const Target target = targetOf(stretch);
            return std::abs(m_plate.heightAt(m_heights, target) - target.depth);
        });
    }
    /// Cauchy's weights: a target far from the surface counts little. Far is what exceeds `scale`, in samples.
    void weigh(double scale) {
        for (Target& target : m_targets) {
            const double miss = (target.depth - m_plate.heightAt(m_heights, target)) / scale;
            target.weight /= 1.0 + miss * miss;
        }
    }
    void solve() {
        double weights = 0.0;
        for (const Target& target : m_targets) weights += target.weight;
        // If the plate came out too steep, it is fitted again, eight times as stiff.
        const double ofNode = weights / (m_nodes.columns * m_nodes.rows);
        double stiffness = 5.0 * ofNode;
        constexpr int stiffenings = 5;
        for (int i = 0; i < stiffenings; ++i, stiffness *= 8.0) {
            m_heights = m_plate.fitted(m_targets, stiffness, flattening * ofNode, m_flat);
            if (m_plate.steepestStep(m_heights) <= steepest * m_nodes.samplesApart) return;
        }
    }
    [[nodiscard]] double medianMiss() const {
        std::vector<double> misses;
        for (const Target& target : m_targets)
            misses.push_back(std::abs(target.depth - m_plate.heightAt(m_heights, target)));
        const auto middle = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2);
        std::nth_element(misses.begin(), middle, misses.end());
        return *middle;
    }

    const TubeEcho& m_tubes;
    std::span<const FluidStretch> m_stretches;
    Nodes m_nodes;
    Plate m_plate;
    cv::Mat1d m_heights;
    double m_flat;
    std::vector<Target> m_targets;
};

}  // namespace

std::optional<CutSurface> fitCurvedCut(const TubeEcho& tubes, std::span<const FluidStretch> stretches,
                                       double flatSample) {
    Fit fit(tubes, stretches, flatSample);
    if (!fit.run()) return std::nullopt;
    return fit.surface();
}

}  // namespace echolucent
