// Signals without a peak, given as the interface indicating function itself, hold no maximum at any scale.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "processing/adaptive/method_reading.h"
#include "processing/detection/scale_space.h"
#include "processing/detection/variance_surface.h"
#include "tests/processing/tube_core/signals.h"

namespace echolucent {
namespace {

using Signal = std::vector<double>;

Signal constant(std::size_t length, double value) { return Signal(length, value); }

/// The function is `before` up to `at`, and `behind` from there on.
Signal step(std::size_t length, std::size_t at, double before, double behind) {
    Signal signal(length, before);
    std::fill(signal.begin() + static_cast<std::ptrdiff_t>(at), signal.end(), behind);
    return signal;
}

/// There are two plateaus above the ground before them, of which the second is the higher.
Signal twoPlateaus(std::size_t length, std::size_t first, std::size_t second, double low, double middle, double high) {
    Signal signal = step(length, first, low, middle);
    std::fill(signal.begin() + static_cast<std::ptrdiff_t>(second), signal.end(), high);
    return signal;
}

struct Count {
    int signals = 0, falseMaxima = 0;
};

class Tracker {
public:
    explicit Tracker(const VarianceRule& rule) : m_space(rule), m_rule(rule) {}
    void look(const Signal& signal, Count& count) {
        ++count.signals;
        count.falseMaxima += trackSurface(signal, m_smoother, m_rule, m_scratch).empty() ? 0 : 1;
    }

private:
    ScaleSpace m_space;
    ScaleSmoother m_smoother{m_space};
    VarianceRule m_rule;
    DetectionScratch m_scratch;
};

Count falseMaxima(const VarianceRule& rule) {
    Tracker tracker(rule);
    Count count;
    for (const std::size_t length : {1u, 2u, 3u, 7u, 39u, 40u, 100u, 195u, 400u})
        for (const double value : {0.0, 5e-324, 1e-300, 1e-9, 0.1, 1.0 / 3.0, 0.37, 1.0, 6.0221e-7, 1e12}) {
            tracker.look(constant(length, value), count);
            tracker.look(rampOf(length, 0.0, value), count);
            tracker.look(rampOf(length, value, 0.0), count);
            tracker.look(rampOf(length, value, 3.0 * value), count);
            for (std::size_t at = 0; at <= length; at += std::max<std::size_t>(length / 13, 1)) {
                tracker.look(step(length, at, 0.1 * value, value), count);
                tracker.look(step(length, at, value, 0.1 * value), count);
                for (std::size_t second = at; second <= length; second += std::max<std::size_t>(length / 7, 1)) {
                    tracker.look(twoPlateaus(length, at, second, 0.0, 0.4 * value, value), count);
                    tracker.look(twoPlateaus(length, at, second, value, 0.4 * value, 0.1 * value), count);
                }
            }
        }
    return count;
}

TEST(FalseMaxima, NoneInConstantsRampsStepsAndPlateaus) {
    const auto ruleOf = [](MethodReading reading) { return std::get<VarianceRule>(configOf(reading).detection); };
    const VarianceRule variance, cut{.kernelEndsAtZero = false};
    VarianceRule fourier = ruleOf(MethodReading::settled);
    fourier.smoothing = SmoothingRoute::fourier;
    struct Named {
        const char* name;
        VarianceRule rule;
    };
    for (const Named& named : {Named{"published", ruleOf(MethodReading::asPublished)},
                               {"settled", ruleOf(MethodReading::settled)},
                               {"default with the variance", variance},
                               {"kernels cut", cut},
                               {"by FFT", fourier}}) {
        const Count count = falseMaxima(named.rule);
        std::printf("%-26s %d false maxima in %d signals\n", named.name, count.falseMaxima, count.signals);
        EXPECT_GT(count.signals, 5000);
        EXPECT_EQ(count.falseMaxima, 0) << named.name;
    }
}

}  // namespace
}  // namespace echolucent
