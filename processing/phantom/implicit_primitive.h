// One primitive of the smooth bodies in simulated scans.
#pragma once

#include <string>

#include "processing/volume/geometry.h"

namespace echolucent {

/// One primitive in grid mm. Its distance function is negative inside. At the surface it is exact to first order, but
/// for a cone's ends and a wavy plane: there it may be too small by the factor `slant`.
struct ImplicitPrimitive {
    enum class Kind { ellipsoid, roundCone, roundBox, cylinder, wavyPlane };
    Kind kind = Kind::ellipsoid;
    std::string name;         ///< anatomy, for people
    Vec3 centre{0, 0, 0};     ///< ellipsoid, box: centre; round cone, cylinder: first end; plane: a point on it
    Vec3 end{0, 0, 0};        ///< round cone, cylinder: second end
    Vec3 radii{1, 1, 1};      ///< ellipsoid: radii; box: half sizes; round cone: end radii; cylinder: radius;
                              ///< plane: depth of the waves and their wavelength
    Mat3 axes = Mat3::eye();  ///< columns: local axes of ellipsoid and box; last column: the plane's outward normal
    double rounding = 0.0;    ///< radius of box and cylinder edges, within the stated size

    /// prepare() derives these for the distance functions.
    Vec3 inverseRadii{1, 1, 1};
    Vec3 along{0, 0, 0};              ///< end - centre
    double inverseLengthSquared = 0;  ///< of `along`
    double slant = 1;  ///< cosine: turns a cone's radial distance, a wavy plane's height, into a distance
    Vec3 boundCentre{0, 0, 0};
    double boundRadius = 0;  ///< of a ball around the primitive
    void prepare();
};

}  // namespace echolucent
