// How far two colours differ.
#pragma once

#include <QColor>
#include <algorithm>
#include <cmath>

namespace echolucent {

/// Relative luminance of an sRGB colour, 0 to 1 (WCAG 2.1).
inline double luminance(QRgb colour) {
    const auto linear = [](int channel) {
        const double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
}

/// Contrast ratio, 1 to 21 (WCAG 2.1).
inline double contrast(QRgb one, QRgb other) {
    const double a = luminance(one) + 0.05, b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
}

inline double contrast(const QColor& one, const QColor& other) { return contrast(one.rgb(), other.rgb()); }

}  // namespace echolucent
