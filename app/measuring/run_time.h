// Measures run times.
#pragma once

#include <chrono>

namespace echolucent::cli {

/// The wall time of `work`, ms.
template <typename Work>
[[nodiscard]] double millisecondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace echolucent::cli
