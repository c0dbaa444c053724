#include "tests/benchmarks/opencv_otf.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "app/measuring/bench/command_bench.h"
#include "processing/detection/variance_surface.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent::bench {

namespace {

constexpr int curveSamples = AdaptiveOtf::sampleCount;

/// What a surface that was found says.
struct Surface {
    double low = 0.0, high = 0.0, lowMax = 0.0, slope = 0.0, d = 0.0;
};

}  // namespace

struct OpenCvOtf::Stages {
    const Volume& volume;
    AdaptiveOtfConfig config;
    std::vector<TubeSamples> tubes;
    bool onSlices;
    int longest = 0;
    cv::Mat means, deviations;         ///< of the slabs: a row a tube
    cv::Mat cellMeans, cellVariances;  ///< a cell's edge less one are without meaning
    std::vector<Surface> surfaces;

    Stages(const Volume& v, const Viewpoint& view, const AdaptiveOtfConfig& c)
        : volume(v), config(c), tubes(cli::samplesOfTubes(v, view, c)) {
        const TubeSamples& any = tubes.front();
        onSlices = any.onVoxels && any.along[2] != 0.0 && any.right[0] != 0.0;
        for (const TubeSamples& tube : tubes) longest = std::max(longest, tube.slabs);
    }

    [[nodiscard]] int type() const {
        const int types[] = {CV_8U, CV_16U, CV_32F};
        return types[volume.voxels().index()];
    }
    [[nodiscard]] cv::Mat slice(int z) const {
        const auto& size = volume.geometry().size;
        const std::size_t offset = static_cast<std::size_t>(volume.geometry().offset(0, 0, z));
        return std::visit(
            [&](const auto& voxels) {
                return cv::Mat(static_cast<int>(size[1]), static_cast<int>(size[0]), type(),
                               const_cast<void*>(static_cast<const void*>(voxels.data() + offset)));
            },
            volume.voxels());
    }

    void sampleSlices();
    void sampleBetweenVoxels();
    void cells();
    void detectByVariance();
    void detectByRatio();
    void readSurface(int tube, int cell);
    void weigh();
    [[nodiscard]] cv::Mat curve() const;
};

void OpenCvOtf::Stages::sampleSlices() {
    const cv::Size box(config.cells.size, config.cells.size);
    const double white = volume.whiteLevel();
    cv::Mat boxMeans, boxSquares;
    const TubeSamples& any = tubes.front();
    for (int k = 0; k < longest; ++k) {
        const cv::Mat plane = slice(static_cast<int>(any.first[2] + k * any.along[2]));
        cv::boxFilter(plane, boxMeans, CV_32F, box, cv::Point(-1, -1), true, cv::BORDER_REPLICATE);
        cv::sqrBoxFilter(plane, boxSquares, CV_32F, box, cv::Point(-1, -1), true, cv::BORDER_REPLICATE);
        for (std::size_t t = 0; t < tubes.size(); ++t) {
            const int x = static_cast<int>(tubes[t].first[0]), y = static_cast<int>(tubes[t].first[1]);
            const float mean = boxMeans.at<float>(y, x);
            means.at<float>(static_cast<int>(t), k) = mean / static_cast<float>(white);
            deviations.at<float>(static_cast<int>(t), k) =
                std::max(0.0f, boxSquares.at<float>(y, x) - mean * mean) / static_cast<float>(white * white);
        }
    }
}

void OpenCvOtf::Stages::sampleBetweenVoxels() {
    const auto& size = volume.geometry().size;
    const std::int64_t row = size[0], plane = size[0] * size[1];
    const int edge = config.cells.size;
    const float half = static_cast<float>(edge - 1) / 2.0f, white = static_cast<float>(volume.whiteLevel());
    std::visit(
        [&](const auto& voxels) {
            cv::Mat values(longest, edge * edge, CV_32F), mean, square;
            for (std::size_t t = 0; t < tubes.size(); ++t) {
                const TubeSamples& tube = tubes[t];
                for (int k = 0; k < tube.slabs; ++k) {
                    float* value = values.ptr<float>(k);
                    const Vec3 axis = tube.onAxis(k);
                    for (int b = 0; b < edge; ++b)
                        for (int a = 0; a < edge; ++a) {
                            std::int64_t low[3];
                            float share[3];
                            for (int c = 0; c < 3; ++c) {
                                const float at = static_cast<float>(axis[c]) +
                                                 static_cast<float>(tube.right[c]) * (static_cast<float>(a) - half) +
                                                 static_cast<float>(tube.down[c]) * (static_cast<float>(b) - half);
                                const float last = static_cast<float>(size[static_cast<std::size_t>(c)] - 1);
                                const float inside = std::clamp(at, 0.0f, last);
                                low[c] = std::max(
                                    0L, std::min(static_cast<long>(inside), size[static_cast<std::size_t>(c)] - 2));
                                share[c] = inside - static_cast<float>(low[c]);
                            }
                            const auto* v = voxels.data() + low[0] + row * low[1] + plane * low[2];
                            const auto along = [&](std::int64_t at) {
                                const float left = static_cast<float>(v[at]);
                                return left + share[0] * (static_cast<float>(v[at + 1]) - left);
                            };
                            const float front = along(0) + share[1] * (along(row) - along(0));
                            const float back = along(plane) + share[1] * (along(plane + row) - along(plane));
                            *value++ = front + share[2] * (back - front);
                        }
                }
                if (tube.slabs == 0) continue;
                const cv::Mat used = values.rowRange(0, tube.slabs);
                cv::reduce(used, mean, 1, cv::REDUCE_AVG);
                cv::reduce(used.mul(used), square, 1, cv::REDUCE_AVG);
                for (int k = 0; k < tube.slabs; ++k) {
                    const float m = mean.at<float>(k);
                    means.at<float>(static_cast<int>(t), k) = m / white;
                    deviations.at<float>(static_cast<int>(t), k) =
                        std::max(0.0f, square.at<float>(k) - m * m) / (white * white);
                }
            }
        },
        volume.voxels());
}

void OpenCvOtf::Stages::cells() {
    const cv::Size box(config.cells.size, 1);
    const cv::Point first(0, 0);
    cv::boxFilter(means, cellMeans, CV_32F, box, first, true, cv::BORDER_REPLICATE);
    if (std::holds_alternative<RatioRule>(config.detection)) return;
    cv::Mat squares, all = deviations + means.mul(means);
    cv::boxFilter(all, squares, CV_32F, box, first, true, cv::BORDER_REPLICATE);
    cellVariances = cv::max(squares - cellMeans.mul(cellMeans), 0.0);
}

void OpenCvOtf::Stages::readSurface(int tube, int cell) {
    const int prior = cell - config.cells.size + 1;
    if (prior < 1 || cell > tubes[static_cast<std::size_t>(tube)].slabs - config.cells.size) return;
    const cv::Mat row = cellMeans.row(tube);
    const cv::Mat before = row.colRange(0, prior);
    const int last = tubes[static_cast<std::size_t>(tube)].slabs - config.cells.size;
    const int from = std::max(0, cell - config.surface.slopeHalfStep),
              to = std::min(last, cell + config.surface.slopeHalfStep);
    Surface surface;
    surface.low = cv::mean(before)[0];
    cv::minMaxLoc(before, nullptr, &surface.lowMax);
    cv::minMaxLoc(row.colRange(cell, std::min(last, cell + config.surface.highReach) + 1), nullptr, &surface.high);
    surface.slope = to > from ? (row.at<float>(to) - row.at<float>(from)) / (to - from) : 0.0;
    if (surface.high > surface.low) surfaces.push_back(surface);
}

void OpenCvOtf::Stages::detectByVariance() {
    const auto& rule = std::get<VarianceRule>(config.detection);
    std::vector<cv::Mat> scales;
    cv::Mat sorted;
    cv::sort(cellVariances, sorted, cv::SORT_EVERY_ROW | cv::SORT_ASCENDING);
    cv::Mat aboveFloor = cellVariances.clone();
    for (int t = 0; t < aboveFloor.rows; ++t) {
        const float floor = sorted.at<float>(t, static_cast<int>(rule.floorQuantile * (sorted.cols - 1)));
        aboveFloor.row(t) = cv::max(aboveFloor.row(t) - floor, 0.0);
    }
    for (int n = rule.coarsestScale; n >= rule.finestScale; --n) {
        const double sigma = rule.sigmaPerKernelSize * std::ldexp(1.0, n);
        const cv::Mat kernel = cv::getGaussianKernel(2 * static_cast<int>(rule.kernelCut * sigma) + 1, sigma, CV_32F);
        scales.emplace_back();
        cv::sepFilter2D(aboveFloor, scales.back(), CV_32F, kernel, cv::Mat::ones(1, 1, CV_32F), cv::Point(-1, -1), 0,
                        cv::BORDER_REFLECT);
    }
    scales.push_back(aboveFloor);
    std::vector<double> function;
    for (int t = 0; t < aboveFloor.rows; ++t) {
        IndexRange range{0, tubes[static_cast<std::size_t>(t)].slabs - config.cells.size};
        std::optional<int> tracked;
        for (const cv::Mat& scale : scales) {
            const float* row = scale.ptr<float>(t);
            function.assign(row, row + std::max(range.last + 1, 0));
            const auto maximum = firstSignificantMaximum(function, range, rule.significance);
            if (!maximum) continue;
            tracked = maximum;
            function.assign(row, row + scale.cols);
            range = valleyToValley(function, *maximum);
        }
        if (tracked) readSurface(t, *tracked);
    }
}

void OpenCvOtf::Stages::detectByRatio() {
    // Lengths and least contrast are those of RatioRule; the logarithm makes a ratio a difference.
    const auto& rule = std::get<RatioRule>(config.detection);
    const int beforeLength = rule.slabsBefore, behindLength = rule.slabsBehind;
    constexpr float darkest = 1.0f / 255.0f;
    cv::Mat scaled, before, behind, contrast, magnitude, sorted;
    cv::log(means + darkest, scaled);
    cv::boxFilter(scaled, before, CV_32F, cv::Size(beforeLength, 1), cv::Point(beforeLength - 1, 0), true,
                  cv::BORDER_REPLICATE);
    cv::boxFilter(scaled, behind, CV_32F, cv::Size(behindLength, 1), cv::Point(0, 0), true, cv::BORDER_REPLICATE);
    contrast = behind.colRange(1, behind.cols) - before.colRange(0, before.cols - 1);
    magnitude = cv::abs(contrast);
    magnitude = magnitude.reshape(1, 1);
    cv::sort(magnitude, sorted, cv::SORT_EVERY_ROW | cv::SORT_ASCENDING);
    const double threshold = rule.falseAlarm * sorted.at<float>(sorted.cols / 4) / 0.318639;
    for (int t = 0; t < contrast.rows; ++t) {
        const float* row = contrast.ptr<float>(t);
        const int end = tubes[static_cast<std::size_t>(t)].slabs - config.cells.size;
        int k = beforeLength;
        while (k < end && row[k] <= threshold) ++k;
        int best = k;
        for (; k < end && row[k] > threshold; ++k)
            if (row[k] > row[best]) best = k;
        if (best < end) readSurface(t, best);
    }
}

void OpenCvOtf::Stages::weigh() {
    std::vector<double> lowMaxima, slopes;
    for (const Surface& surface : surfaces) {
        lowMaxima.push_back(surface.lowMax);
        slopes.push_back(surface.slope);
    }
    std::sort(lowMaxima.begin(), lowMaxima.end());
    std::sort(slopes.begin(), slopes.end());
    const double tubeCount = static_cast<double>(tubes.size());
    const auto rank = [&](const std::vector<double>& ascending, double value) {
        return static_cast<double>(std::upper_bound(ascending.begin(), ascending.end(), value) - ascending.begin()) /
               tubeCount;
    };
    for (Surface& surface : surfaces)
        surface.d = surface.slope > 0.0 ? strengthOf(config.curve) / tubeCount *
                                              (1.0 - rank(lowMaxima, surface.lowMax)) * rank(slopes, surface.slope)
                                        : 0.0;
}

cv::Mat OpenCvOtf::Stages::curve() const {
    const auto* ramp = std::get_if<RampRule>(&config.curve);
    cv::Mat x(1, curveSamples, CV_64F), sum(1, curveSamples, CV_64F, cv::Scalar(0)), term, result;
    for (int i = 0; i < curveSamples; ++i) x.at<double>(i) = static_cast<double>(i) / (curveSamples - 1);
    double weight = 0.0;
    for (const Surface& surface : surfaces) {
        const double rise = surface.high - surface.low;
        if (ramp != nullptr) {
            const double from = surface.low + ramp->begin * rise;
            term = (x - from) / ((ramp->end - ramp->begin) * rise);
            sum += surface.d * cv::min(cv::max(term, 0.0), 1.0);
            weight += surface.d;
        } else {
            const cv::Mat u = (x - surface.low + (x - surface.high)) / rise;
            cv::exp((1.0 - u.mul(u)) / 2.0, term);
            sum += std::log1p(surface.d) * u.mul(term);
        }
    }
    if (ramp != nullptr) return weight > 0.0 ? cv::Mat(ramp->opacity / weight * sum) : sum;
    cv::exp(sum, result);
    return cv::min(result.mul(x).mul(x), 1.0);
}

OpenCvOtf::OpenCvOtf(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config)
    : m_stages(std::make_shared<Stages>(volume, view, config)) {}

double OpenCvOtf::run() {
    Stages& stages = *m_stages;
    stages.surfaces.clear();
    stages.means = cv::Mat::zeros(static_cast<int>(stages.tubes.size()), stages.longest, CV_32F);
    stages.deviations = stages.means.clone();
    stages.onSlices ? stages.sampleSlices() : stages.sampleBetweenVoxels();
    stages.cells();
    std::holds_alternative<RatioRule>(stages.config.detection) ? stages.detectByRatio() : stages.detectByVariance();
    stages.weigh();
    return cv::sum(stages.curve())[0];
}

double OpenCvOtf::differenceTo(const AdaptiveOtf& otf) const {
    double largest = 0.0;
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        const std::vector<float>& cellMeans = otf.tubes[t].cellMeans;
        // The borders' samples count differently.
        for (std::size_t k = 8; k + 8 < cellMeans.size(); ++k)
            largest = std::max<double>(largest, std::abs(cellMeans[k] - m_stages->cellMeans.at<float>(
                                                                            static_cast<int>(t), static_cast<int>(k))));
    }
    return largest;
}

}  // namespace echolucent::bench
