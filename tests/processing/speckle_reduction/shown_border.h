// Where a picture ends, and how rough its end is.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "processing/picture/picture.h"

namespace echolucent {

/// The border of what a picture shows, row by row: the last place, in pixels from the left, at which the opacity falls
/// through one half. Empty for rows without one.
inline std::vector<std::optional<double>> rightBorder(const Picture& picture) {
    std::vector<std::optional<double>> border(static_cast<std::size_t>(picture.height));
    for (int row = 0; row < picture.height; ++row) {
        const auto alpha = [&](int column) {
            return static_cast<double>(
                picture.rgba[(static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(column)) *
                                 4 +
                             3]);
        };
        for (int column = picture.width - 2; column >= 0; --column)
            if (alpha(column) >= 0.5 && alpha(column + 1) < 0.5) {
                border[static_cast<std::size_t>(row)] =
                    column + 0.5 + (alpha(column) - 0.5) / (alpha(column) - alpha(column + 1));
                break;
            }
    }
    return border;
}

/// The root mean square of a border's distances from a line that is fitted to the rows within `reach` of each row. A
/// smooth border, straight over that many rows, has none. Rows near the ends and gaps do not count.
inline double roughnessOf(const std::vector<std::optional<double>>& border, int reach) {
    double squares = 0.0;
    int count = 0;
    for (std::size_t row = static_cast<std::size_t>(reach); row + static_cast<std::size_t>(reach) < border.size();
         ++row) {
        double sum = 0.0;
        bool whole = true;
        for (int i = -reach; i <= reach && whole; ++i) {
            const auto& at = border[static_cast<std::size_t>(static_cast<int>(row) + i)];
            whole = at.has_value();
            if (!whole) break;
            sum += *at;
        }
        if (!whole) continue;
        const double apart = *border[row] - sum / (2 * reach + 1);
        squares += apart * apart;
        ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : 0.0;
}

}  // namespace echolucent
