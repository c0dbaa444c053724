#include "processing/picture/light_direction.h"

#include <algorithm>

#include "processing/picture/camera_pose.h"

namespace echolucent {

Vec3 towardsLight(const LightDirection& light) {
    return rotationY(-light.azimuthDegrees) * rotationX(-light.elevationDegrees) * Vec3{0, 0, -1};
}

LightDirection moved(const LightDirection& light, double right, double down) {
    return {wrappedDegrees(light.azimuthDegrees + degreesPerHeight * right),
            std::clamp(light.elevationDegrees - degreesPerHeight * down, -90.0, 90.0)};
}

}  // namespace echolucent
