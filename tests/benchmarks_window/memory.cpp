#include "tests/benchmarks_window/memory.h"

#include <fstream>
#include <sstream>
#include <string>

namespace echolucent::bench {

Memory memoryNow() {
    constexpr double kibInMib = 1024.0;
    Memory memory;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream words(line);
        std::string key;
        double kib = 0.0;
        words >> key >> kib;
        if (key == "VmRSS:") memory.residentMiB = kib / kibInMib;
        if (key == "VmHWM:") memory.peakMiB = kib / kibInMib;
    }
    return memory;
}

void forgetPeak() {
    std::ofstream("/proc/self/clear_refs") << "5";  // as proc(5) says
}

}  // namespace echolucent::bench
