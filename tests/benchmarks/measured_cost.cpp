#include "tests/benchmarks/measured_cost.h"

#include <time.h>

#include <chrono>
#include <thread>

#include "processing/median.h"

namespace echolucent::bench {

namespace {
/// The pause is longer than oneTBB's workers look for work before they sleep.
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

Cost medianOf(const std::vector<Cost>& costs) {
    std::vector<double> wall, cpu;
    for (const Cost& cost : costs) {
        wall.push_back(cost.wallMs);
        cpu.push_back(cost.cpuMs);
    }
    return {echolucent::medianOf(wall), echolucent::medianOf(cpu)};
}

}  // namespace echolucent::bench
