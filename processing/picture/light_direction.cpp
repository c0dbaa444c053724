#include "processing/picture/light_direction.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

namespace {

constexpr double degreesPerHeight = 180.0;

double wrapped(double degrees) {
    const double turn = std::remainder(degrees, 360.0);
    return turn == -180.0 ? 180.0 : turn;
}

}  // namespace

Vec3 towardsLight(const LightDirection& light) {
    return rotationY(-light.azimuthDegrees) * rotationX(-light.elevationDegrees) * Vec3{0, 0, -1};
}

LightDirection moved(const LightDirection& light, double right, double down) {
    return {wrapped(light.azimuthDegrees + degreesPerHeight * right),
            std::clamp(light.elevationDegrees - degreesPerHeight * down, -90.0, 90.0)};
}

}  // namespace echolucent
