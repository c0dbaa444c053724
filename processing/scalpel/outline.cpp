#include "processing/scalpel/outline.h"

#include <algorithm>

namespace echolucent::scalpel {

namespace {

double squaredDistance(const PicturePlace& a, const PicturePlace& b, const PicturePlace& at) {
    const double alongX = b[0] - a[0], alongY = b[1] - a[1];
    const double squared = alongX * alongX + alongY * alongY;
    const double share =
        squared > 0.0 ? std::clamp(((at[0] - a[0]) * alongX + (at[1] - a[1]) * alongY) / squared, 0.0, 1.0) : 0.0;
    const double x = at[0] - a[0] - share * alongX, y = at[1] - a[1] - share * alongY;
    return x * x + y * y;
}

}  // namespace

bool crosses(const PicturePlace& a, const PicturePlace& b, const PicturePlace& at) {
    if ((a[1] > at[1]) == (b[1] > at[1])) return false;
    return at[0] < a[0] + (b[0] - a[0]) * (at[1] - a[1]) / (b[1] - a[1]);
}

bool liesWithin(double distance, const PicturePlace& a, const PicturePlace& b, const PicturePlace& at) {
    return squaredDistance(a, b, at) <= distance * distance;
}

}  // namespace echolucent::scalpel
