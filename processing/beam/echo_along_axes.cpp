#include "processing/beam/echo_along_axes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double brightQuantile = 0.98;  ///< of the cells: echo 1
constexpr float faintest = 0.004F;       ///< fainter echoes count as this share of the bright ones
constexpr float oneTissue = 0.35F;       ///< natural logarithm: one tissue, if echoes differ by less
constexpr int tissueStep = 3;            ///< cells between the two places of a fall within one tissue
constexpr int typicalStep = 6;           ///< cells between the two places of any fall
constexpr std::size_t fewestPairs = 50;  ///< of a slice
constexpr std::size_t fewestSlicesWithPairs = 8;
constexpr int shadowGap = 3;  ///< cells left out before and behind: a place is not its own shadow
constexpr std::array<int, 3> shadowOffsets{2, 3, 4};  ///< cells between neighbours across the axis

/// The logarithm of the echo, and the cells that hold echo.
struct LogEcho {
    std::vector<float> value;      ///< natural logarithm of the share of the bright echo, at least ln `faintest`
    std::vector<float> linear;     ///< that share, [0,1]
    std::vector<std::uint8_t> is;  ///< 1 if the cell holds echo
};

double medianOf(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

LogEcho logEchoOf(const CoarseEcho& coarse) {
    const std::size_t count = coarse.echo.size();
    LogEcho log{std::vector<float>(count), std::vector<float>(count), std::vector<std::uint8_t>(count)};
    std::vector<float> echoes;
    for (std::size_t i = 0; i < count; ++i)
        if (coarse.dataShare[i] >= CoarseEcho::leastDataShare && coarse.echo[i] > 0.0F) {
            log.is[i] = 1;
            echoes.push_back(coarse.echo[i]);
        }
    if (echoes.empty()) return log;
    const auto rank = static_cast<std::ptrdiff_t>(brightQuantile * static_cast<double>(echoes.size() - 1));
    std::nth_element(echoes.begin(), echoes.begin() + rank, echoes.end());
    const float bright = echoes[static_cast<std::size_t>(rank)];
    for (std::size_t i = 0; i < count; ++i) {
        if (log.is[i] == 0) continue;
        log.linear[i] = std::min(1.0F, coarse.echo[i] / bright);
        log.value[i] = std::log(std::max(faintest, coarse.echo[i] / bright));
    }
    return log;
}

/// One axis of the cells, and the two axes across it.
struct Course {
    int cells = 0;
    std::size_t step = 0;
    std::array<int, 2> across{};
    std::array<std::size_t, 2> acrossStep{};

    Course(const CoarseEcho& coarse, int axis)
        : cells(coarse.size[static_cast<std::size_t>(axis)]), step(coarse.stride(axis)) {
        for (int i = 0; i < 2; ++i) {
            const int other = (axis + 1 + i) % 3;
            across[static_cast<std::size_t>(i)] = coarse.size[static_cast<std::size_t>(other)];
            acrossStep[static_cast<std::size_t>(i)] = coarse.stride(other);
        }
    }
    [[nodiscard]] std::size_t place(int along, int u, int v) const {
        return static_cast<std::size_t>(along) * step + static_cast<std::size_t>(u) * acrossStep[0] +
               static_cast<std::size_t>(v) * acrossStep[1];
    }
};

/// Logarithmic steps from the cells of one slice to the cells `apart` slices behind.
std::vector<float> stepsOf(const LogEcho& log, const Course& course, int slice, int apart) {
    std::vector<float> steps;
    steps.reserve(static_cast<std::size_t>(course.across[0]) * static_cast<std::size_t>(course.across[1]));
    const std::size_t behind = static_cast<std::size_t>(apart) * course.step;
    for (int v = 0; v < course.across[1]; ++v)
        for (int u = 0; u < course.across[0]; ++u) {
            const std::size_t place = course.place(slice, u, v);
            if (log.is[place] != 0 && log.is[place + behind] != 0)
                steps.push_back(log.value[place + behind] - log.value[place]);
        }
    return steps;
}

/// The mean step within one tissue of a slice; NaN if the slice has too few such steps.
float tissueStepOf(std::vector<float>& steps) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const float step : steps)
        if (std::abs(step) < oneTissue) {
            sum += step;
            ++count;
        }
    return count >= fewestPairs ? static_cast<float>(sum / static_cast<double>(count)) : std::nanf("");
}

float typicalStepOf(std::vector<float>& steps) {
    return steps.size() >= fewestPairs ? static_cast<float>(medianOf(steps)) : std::nanf("");
}

struct Fall {
    double fall = 0.0, share = 0.5;
};

/// The fall: minus the median over the slices of the step that `ofSlice` computes for each, scaled to the whole extent.
/// 0 if too few slices have a step.
Fall fallOf(const LogEcho& log, const Course& course, int apart,
            const std::function<float(std::vector<float>&)>& ofSlice) {
    std::vector<float> perSlice;
    for (int slice = 0; slice + apart < course.cells; ++slice) {
        std::vector<float> steps = stepsOf(log, course, slice, apart);
        if (const float step = ofSlice(steps); !std::isnan(step)) perSlice.push_back(step);
    }
    if (perSlice.size() < fewestSlicesWithPairs) return {};
    const auto falling = std::count_if(perSlice.begin(), perSlice.end(), [](float step) { return step < 0.0F; });
    const auto rising = std::count_if(perSlice.begin(), perSlice.end(), [](float step) { return step > 0.0F; });
    const double share = 0.5 + 0.5 * static_cast<double>(falling - rising) / static_cast<double>(perSlice.size());
    return {-medianOf(perSlice) * course.cells / apart, share};
}

/// The sum of the echo that sound has passed on its way to each cell, from the first or the last slice on. Cells within
/// shadowGap of the cell do not count.
std::vector<float> passedEcho(const LogEcho& log, const Course& course, bool fromFirst) {
    std::vector<float> passed(log.value.size(), 0.0F);
    for (int v = 0; v < course.across[1]; ++v)
        for (int u = 0; u < course.across[0]; ++u) {
            float sum = 0.0F;
            for (int i = shadowGap; i < course.cells; ++i) {
                const int slice = fromFirst ? i : course.cells - 1 - i;
                const int last = fromFirst ? slice - shadowGap : slice + shadowGap;
                sum += log.linear[course.place(last, u, v)];
                passed[course.place(slice, u, v)] = sum;
            }
        }
    return passed;
}

/// Sums of the products of two differences.
struct Products {
    double echoPassed = 0.0, passedPassed = 0.0, echoEcho = 0.0;
};

/// Adds the pairs of cells that lie `apart` from each other along the axis `side` across the course.
void addPairs(const LogEcho& log, const std::vector<float>& passed, const Course& course, std::size_t side, int apart,
              Products& products) {
    const std::size_t other = static_cast<std::size_t>(apart) * course.acrossStep[side];
    const int lastU = course.across[0] - (side == 0 ? apart : 0), lastV = course.across[1] - (side == 1 ? apart : 0);
    for (int slice = 0; slice < course.cells; ++slice)
        for (int v = 0; v < lastV; ++v) {
            float echoPassed = 0.0F, passedPassed = 0.0F, echoEcho = 0.0F;
            for (int u = 0; u < lastU; ++u) {
                const std::size_t place = course.place(slice, u, v);
                const float step = log.value[place + other] - log.value[place];
                const bool counts = log.is[place] != 0 && log.is[place + other] != 0 && std::abs(step) < oneTissue;
                const float echo = counts ? step : 0.0F;
                const float difference = counts ? passed[place + other] - passed[place] : 0.0F;
                echoPassed += echo * difference;
                passedPassed += difference * difference;
                echoEcho += echo * echo;
            }
            products.echoPassed += echoPassed;
            products.passedPassed += passedPassed;
            products.echoEcho += echoEcho;
        }
}

double correlationWith(const LogEcho& log, const Course& course, bool fromFirst) {
    const std::vector<float> passed = passedEcho(log, course, fromFirst);
    Products products;
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        for (const int apart : shadowOffsets) addPairs(log, passed, course, side, apart, products);
    const double scale = std::sqrt(products.passedPassed * products.echoEcho);
    return scale > 0.0 ? products.echoPassed / scale : 0.0;
}

}  // namespace

std::array<EchoAlongAxis, 3> echoAlongAxes(const CoarseEcho& coarse) {
    const LogEcho log = logEchoOf(coarse);
    std::array<EchoAlongAxis, 3> axes;
    parallelFor(0, 3, [&](int axis) {
        const Course course(coarse, axis);
        EchoAlongAxis& figures = axes[static_cast<std::size_t>(axis)];
        const Fall tissue = fallOf(log, course, tissueStep, tissueStepOf);
        const Fall typical = fallOf(log, course, typicalStep, typicalStepOf);
        figures = {tissue.fall, tissue.share, typical.fall, typical.share};
    });
    return axes;
}

ShadowCorrelation shadowsAlong(const CoarseEcho& coarse, int axis) {
    const LogEcho log = logEchoOf(coarse);
    const Course course(coarse, axis);
    return {correlationWith(log, course, true), correlationWith(log, course, false)};
}

}  // namespace echolucent
