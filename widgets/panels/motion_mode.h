// The choices of the transducer motion mode, shared by its panel and its player.
#pragma once

namespace echolucent {

/// The axis of the view's frame about which the view turns: x changes the elevation, y the azimuth, z the roll.
enum class MotionAxis { x, y, z };

/// Which OTF the frames of a motion show.
enum class MotionOtf {
    oneOtf,    ///< the one that was computed before the motion, for every view
    eachView,  ///< computed anew for each view
};

/// The range of the motion, whole degrees from the view in which it was started.
inline constexpr int firstMotionAngle = -45;
inline constexpr int lastMotionAngle = 45;

}  // namespace echolucent
