// Numbers that tell pictures apart.
#pragma once

#include <cmath>
#include <cstddef>

#include "processing/picture/picture.h"

namespace echolucent {

/// The root mean square difference of two pictures in 8-bit levels.
inline double difference(const Picture& left, const Picture& right) {
    if (left.rgba.size() != right.rgba.size() || left.rgba.empty()) return 255.0;
    double sum = 0;
    for (std::size_t i = 0; i < left.rgba.size(); ++i) {
        const double d = 255.0 * (static_cast<double>(left.rgba[i]) - static_cast<double>(right.rgba[i]));
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(left.rgba.size()));
}

/// Share of the picture that is not background.
inline double coverage(const Picture& picture) {
    std::size_t covered = 0;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) covered += picture.rgba[i] > 0.1F ? 1 : 0;
    return static_cast<double>(covered) / (static_cast<double>(picture.rgba.size()) / 4.0);
}

}  // namespace echolucent
