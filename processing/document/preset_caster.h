// Small pictures of what presets make of a volume.
#pragma once

#include <memory>
#include <optional>

#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/progress.h"
#include "processing/ray_caster.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Casts one picture after the other and keeps what they have in common: the ray caster of a volume and the newest
/// adaptive curve. Only one thread at a time may use it.
class PresetCaster {
public:
    /// The voxels of a phase with what the scalpel cut of them, as they were read and as the view shows them; both may
    /// be one object.
    struct Voxels {
        std::shared_ptr<const Volume> raw, shown;
        SpeckleReduction reduction = SpeckleReduction::off;  ///< of those shown
        friend bool operator==(const Voxels&, const Voxels&) = default;
    };

    /// A view's picture in pixels, each the mean of four rays. Unlike viewPicture() it is made of the voxels shown,
    /// whatever reduction the look names: at this size nobody sees the difference, and none has to be waited for. The
    /// result is empty only where progress.cancel was raised.
    [[nodiscard]] std::optional<Picture> cast(const Document& document, std::size_t pane, const Voxels& voxels,
                                              int width, int height, const Progress& progress = {});

private:
    [[nodiscard]] const SampledCurve* adaptiveCurve(const Document& document, std::size_t pane, const Voxels& voxels,
                                                    const Progress& progress);

    struct AskedOtf {
        Viewpoint viewpoint;
        AdaptiveOtfConfig config;
        Voxels voxels;
        friend bool operator==(const AskedOtf&, const AskedOtf&) = default;
    };
    std::optional<RayCaster> m_rays;
    std::optional<AskedOtf> m_asked;  ///< what m_adaptive is the answer to
    SampledCurve m_adaptive;
};

}  // namespace echolucent
