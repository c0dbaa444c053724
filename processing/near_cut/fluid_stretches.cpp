#include "processing/near_cut/fluid_stretches.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

constexpr int leastLength = 3;       // samples: shorter gaps are speckle, or the slits between layers of tissue
constexpr int leastFrontLength = 6;  // the border of the data is dim in many scans
constexpr int wallReach = 5;         // samples before and behind a stretch among which its wall is looked for
constexpr double leastWall = 1.6;    // a wall is at least so many times as bright as the fluid's mean
constexpr float darkest = 1e-3F;     // of the white level: a darker mean counts as this one, so contrast is finite

/// A run of samples with data.
struct Run {
    const float* echo;
    int begin, end;
    [[nodiscard]] float brightest(int from, int to) const {
        from = std::max(from, begin);
        to = std::min(to, end);
        return from < to ? *std::max_element(echo + from, echo + to) : 0.0F;
    }
};

/// Judges the dark samples [begin, end) of a run.
void addStretch(const Run& run, int tube, int begin, int end, bool atFront, std::vector<FluidStretch>& found) {
    if (end - begin < (atFront ? leastFrontLength : leastLength)) return;
    double mean = 0.0;
    for (int sample = begin; sample < end; ++sample) mean += static_cast<double>(run.echo[sample]);
    mean = std::max(mean / (end - begin), static_cast<double>(darkest));
    const auto behind = static_cast<double>(run.brightest(end, end + wallReach));
    const auto before = atFront ? behind : static_cast<double>(run.brightest(begin - wallReach, begin));
    const double wall = std::min(before, behind);
    if (wall >= leastWall * mean) found.push_back({tube, begin, end, atFront, std::log(wall / mean)});
}

void addRun(const Run& run, int tube, bool first, float level, std::vector<FluidStretch>& found) {
    for (int sample = run.begin; sample < run.end;) {
        if (run.echo[sample] >= level) {
            ++sample;
            continue;
        }
        const int begin = sample;
        while (sample < run.end && run.echo[sample] < level) ++sample;
        // A stretch that begins at a gap in the data has no visible wall before it. One that ends with the data has
        // none behind.
        const bool atEdge = begin < run.begin + 2;
        if (sample < run.end && (first || !atEdge)) addStretch(run, tube, begin, sample, atEdge, found);
    }
}

void addTube(const TubeEcho& tubes, int tube, float level, std::vector<FluidStretch>& found) {
    const float* echo = tubes.tube(static_cast<std::size_t>(tube));
    bool first = true;
    for (int sample = 0; sample < tubes.samples;) {
        if (echo[sample] < 0.0F) {
            ++sample;
            continue;
        }
        Run run{echo, sample, sample};
        while (run.end < tubes.samples && echo[run.end] >= 0.0F) ++run.end;
        addRun(run, tube, first, level, found);
        first = false;
        sample = run.end;
    }
}

/// Joins stretches of neighbouring tube cores that lie side by side for at least two samples.
class Cavities {
public:
    Cavities(const TubeEcho& tubes, const std::vector<FluidStretch>& stretches)
        : m_tubes(tubes), m_stretches(stretches), m_firstOf(tubes.tubes() + 1), m_parent(stretches.size()) {
        std::size_t next = 0;
        for (std::size_t tube = 0; tube <= tubes.tubes(); ++tube) {
            while (next < stretches.size() && static_cast<std::size_t>(stretches[next].tube) < tube) ++next;
            m_firstOf[tube] = next;
        }
        for (std::size_t i = 0; i < m_parent.size(); ++i) m_parent[i] = i;
        join();
    }
    /// The stretches of cavities that hold at least `samples` samples.
    [[nodiscard]] std::vector<FluidStretch> atLeast(double samples) {
        std::vector<double> sum(m_parent.size());
        for (std::size_t i = 0; i < m_parent.size(); ++i) sum[root(i)] += m_stretches[i].length();
        std::vector<FluidStretch> kept;
        for (std::size_t i = 0; i < m_parent.size(); ++i)
            if (sum[root(i)] >= samples) kept.push_back(m_stretches[i]);
        return kept;
    }

private:
    std::size_t root(std::size_t i) {
        while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    void joinTubes(std::size_t one, std::size_t other) {
        for (std::size_t a = m_firstOf[one]; a < m_firstOf[one + 1]; ++a)
            for (std::size_t b = m_firstOf[other]; b < m_firstOf[other + 1]; ++b)
                if (std::min(m_stretches[a].end, m_stretches[b].end) -
                        std::max(m_stretches[a].begin, m_stretches[b].begin) >=
                    2)
                    m_parent[root(a)] = root(b);
    }
    void join() {
        const auto columns = static_cast<std::size_t>(m_tubes.columns);
        for (std::size_t tube = 0; tube < m_tubes.tubes(); ++tube) {
            if (tube % columns + 1 < columns) joinTubes(tube, tube + 1);
            if (tube + columns < m_tubes.tubes()) joinTubes(tube, tube + columns);
        }
    }

    const TubeEcho& m_tubes;
    const std::vector<FluidStretch>& m_stretches;
    std::vector<std::size_t> m_firstOf;  ///< of each tube core: place of its first stretch, or of the next tube core's
    std::vector<std::size_t> m_parent;
};

}  // namespace

std::vector<FluidStretch> fluidStretches(const TubeEcho& tubes, float level, double leastEdge) {
    std::vector<FluidStretch> found;
    for (int tube = 0; tube < static_cast<int>(tubes.tubes()); ++tube) addTube(tubes, tube, level, found);
    return Cavities(tubes, found).atLeast(leastEdge * leastEdge * leastEdge);
}

}  // namespace echolucent
