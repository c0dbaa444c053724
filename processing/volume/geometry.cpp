#include "processing/volume/geometry.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echolucent {

namespace {
struct SineCosine {
    double sine;
    double cosine;
};

SineCosine sineCosine(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    if (turn == 0.0) return {0.0, 1.0};
    if (turn == 90.0) return {1.0, 0.0};
    if (turn == -90.0) return {-1.0, 0.0};
    if (std::abs(turn) == 180.0) return {0.0, -1.0};
    const double radians = turn * std::numbers::pi / 180.0;
    return {std::sin(radians), std::cos(radians)};
}
}  // namespace

double length(const Vec3& vector) { return std::sqrt(vector.dot(vector)); }

Vec3 normalized(const Vec3& vector) {
    const double size = length(vector);
    if (!(size > 0.0)) throw std::invalid_argument("normalized: a zero vector has no direction");
    return vector * (1.0 / size);
}

double wrappedDegrees(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    return turn == -180.0 ? 180.0 : turn;
}

Mat3 rotationX(double degrees) {
    const auto [s, c] = sineCosine(degrees);
    return {1, 0, 0, 0, c, -s, 0, s, c};
}

Mat3 rotationY(double degrees) {
    const auto [s, c] = sineCosine(degrees);
    return {c, 0, s, 0, 1, 0, -s, 0, c};
}

Mat3 rotationZ(double degrees) {
    const auto [s, c] = sineCosine(degrees);
    return {c, -s, 0, s, c, 0, 0, 0, 1};
}

}  // namespace echolucent
