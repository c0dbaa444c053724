// The choices for a picture's look. One table says each choice once.
#pragma once

#include "processing/parameters/parameter.h"
#include "processing/picture/camera.h"
#include "processing/picture/colour_map.h"
#include "processing/picture/light_direction.h"
#include "processing/picture/lighting.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/picture/render_mode.h"
#include "processing/sampling/interpolation.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {

/// How a volume looks, apart from its opacity curve, the viewpoint and what is cut away.
struct Look {
    RenderMode mode = RenderMode::direct;
    double mixing = 0.0;                         ///< [0, 1]: share of the mixed mode in a picture of the direct mode
    RenderMode mixedMode = RenderMode::maximum;  ///< maximum or mean; plays a part if mixing is above 0
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of the voxels in the picture
    Lighting lighting = Lighting::flat;                  ///< plays a part in direct mode only
    LightDirection light;  ///< where the light stands; plays a part unless lighting is flat
    /// Degrees, [0, 45]: half the angle under which the light is seen. Plays a part if the light casts shadows.
    double lightSoftness = 8.0;
    ReachingLight reaching;      ///< plays a part if lighting is depth
    bool depthColoured = false;  ///< colours change with depth; plays a part in direct mode only
    ColourMap colourMap = ColourMap::sepia;
    double brightness = 1.0;  ///< [1/4, 4]: a factor on the picture's colours
    Projection projection = Projection::parallel;
    Interpolation interpolation = Interpolation::trilinear;
    double step = 1.0;  ///< units between the samples on a ray, > 0
    friend bool operator==(const Look&, const Look&) = default;
};

/// A row for every member of Look, in the order in which people are shown them. The command line, the panel, the JSON
/// and docs/cli-render.md are made from these rows. lookAtStart() gives the defaults.
[[nodiscard]] const ParameterTable<Look>& lookParameters();

/// The look at the start of the window and the command line: quiet voxels, and light that tells depth. The light's
/// angles are whole degrees, as on the panel's sliders.
[[nodiscard]] Look lookAtStart();

/// The settings of a look. Size, camera place and cuts stay as in RayCastSettings{}. If mixing is 1, the mode is the
/// mixed mode alone. Modes that use no light or depth colours get none, so that equal pictures have equal settings.
[[nodiscard]] RayCastSettings rayCastSettings(const Look& look);

}  // namespace echolucent
