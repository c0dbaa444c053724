#include "processing/picture/light_direction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echolucent {

namespace {

constexpr double degreesPerHeight = 180.0;
constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

double wrapped(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    return turn == -180.0 ? 180.0 : turn;
}

}  // namespace

Vec3 towardsLight(const LightDirection& light) {
    return rotationY(-light.azimuthDegrees) * rotationX(-light.elevationDegrees) * Vec3{0, 0, -1};
}

LightDirection lightDirectionOf(const Vec3& towardsLight) {
    const Vec3 direction = normalized(towardsLight);
    const double across = std::hypot(direction[0], direction[2]);
    const double azimuth = across > 0.0 ? std::atan2(direction[0], -direction[2]) : 0.0;
    return {azimuth * degreesPerRadian, std::atan2(-direction[1], across) * degreesPerRadian};
}

LightDirection moved(const LightDirection& light, double right, double down) {
    return {wrapped(light.azimuthDegrees + degreesPerHeight * right),
            std::clamp(light.elevationDegrees - degreesPerHeight * down, -90.0, 90.0)};
}

}  // namespace echolucent
