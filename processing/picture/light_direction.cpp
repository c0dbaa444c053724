#include "processing/picture/light_direction.h"

#include <algorithm>

namespace echolucent {

namespace {

constexpr double degreesPerHeight = 180.0;

}  // namespace

Vec3 towardsLight(const LightDirection& light) {
    return rotationY(-light.azimuthDegrees) * rotationX(-light.elevationDegrees) * Vec3{0, 0, -1};
}

LightDirection moved(const LightDirection& light, double right, double down) {
    return {wrappedDegrees(light.azimuthDegrees + degreesPerHeight * right),
            std::clamp(light.elevationDegrees - degreesPerHeight * down, -90.0, 90.0)};
}

}  // namespace echolucent
