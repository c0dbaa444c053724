#include "tests/benchmarks/measured_cost.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace echolucent::bench {

namespace {
/// Longer than oneTBB's workers look for work before they sleep.
constexpr std::chrono::milliseconds untilWorkersSleep{4};
}  // namespace

double processCpuMs() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

double wallClockMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Cost costOf(const std::function<void()>& work) {
    const double wall = wallClockMs(), cpu = processCpuMs();
    work();
    Cost cost;
    cost.wallMs = wallClockMs() - wall;
    std::this_thread::sleep_for(untilWorkersSleep);
    cost.cpuMs = processCpuMs() - cpu;
    return cost;
}

double medianOf(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Cost medianOf(const std::vector<Cost>& costs) {
    std::vector<double> wall, cpu;
    for (const Cost& cost : costs) {
        wall.push_back(cost.wallMs);
        cpu.push_back(cost.cpuMs);
    }
    return {medianOf(wall), medianOf(cpu)};
}

}  // namespace echolucent::bench
