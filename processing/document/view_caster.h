// Casts pictures of the views of documents, one after the other, through the phases of one study.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/classification.h"
#include "processing/designers/design.h"
#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/ray_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How a view is cast at its look's own step. The camera is that of the shown pose, fitted to a data box; the limits
/// are the view's cut and box.
[[nodiscard]] RayCastSettings castSettingsOf(const Document& document, const VolumeGeometry& geometry,
                                             const DataBox& box, int width, int height);

/// How much a view's picture spares.
enum class PictureQuality {
    converged,  ///< converged(): what a window shows at rest, and saves
    quick,      ///< the look's own step and the ray caster's own end of rays
};

/// What a view shows.
struct ViewPicture {
    Picture picture;
    RayCastSettings cast;                  ///< what it was cast with
    Classification classification;         ///< that it is rendered with
    std::shared_ptr<const Volume> voxels;  ///< quiet where speckle is reduced, and cut by the strokes
    std::string message;                   ///< what the OTF that was computed has to say; else empty
};

/// The phases of a study.
struct StudyPhases {
    std::vector<std::shared_ptr<const Volume>> scans;  ///< as they were read, at least one, all on one grid
    /// Their quiet voxels, of which nothing is cut, where somebody has them: by phase, null or shorter than `scans`
    /// where they are not made.
    std::vector<std::shared_ptr<const Volume>> quiet{};
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `quiet`; a view of another one makes its own
};

/// What is computed of the voxels to render a view with.
struct ViewOtf {
    SampledCurve curve{};                      ///< the adaptive one, where the view is rendered with it
    std::optional<Classification> designed{};  ///< what its designer made, where it has a design
    std::string message{};                     ///< what either has to say
};

/// Whether an OTF that is computed plays a part in a view's picture: in direct mode, where the view is rendered with
/// the adaptive one or with a design.
[[nodiscard]] bool needsComputedOtf(const Document& document, std::size_t pane);

/// What a view is rendered with, adjusted. A design that is not computed yet is clear everywhere.
[[nodiscard]] Classification classificationOf(const Document& document, std::size_t pane, const ViewOtf& otf);

/// What the designer of a view is given, where it has one; the volumes outlive it. The view is otfViewpointOf().
[[nodiscard]] DesignerInput designerInputOf(const Document& document, std::size_t pane, const Volume& raw,
                                            const Volume& shown, SpeckleReduction reduction);

/// The phase whose computed OTF a view shows: where one OTF is chosen for all frames of a study of several phases,
/// MotionChoice::otfPhase, or the last phase where there are not so many; else the phase that the view shows.
[[nodiscard]] int otfPhaseOf(const Document& document, std::size_t pane, int phases);

/// Keeps what pictures have in common: what the scalpel cut, the voxels of the newest phase, and their ray caster.
/// Every picture is the same, to the bit, as if it were the only one. Only one thread at a time may use it.
class ViewCaster {
public:
    explicit ViewCaster(StudyPhases phases);

    [[nodiscard]] int phaseCount() const { return static_cast<int>(m_phases.scans.size()); }
    /// The adaptive OTF of a view, computed from raw voxels of the phase otfPhaseOf() along otfViewpointOf(), for the
    /// voxels that are shown of that phase; or what the designer of its design makes of that phase. The result is empty
    /// only where progress.cancel was raised.
    [[nodiscard]] std::optional<ViewOtf> otf(const Document& document, std::size_t pane, const Progress& progress = {});
    /// What tube cores read for the adaptive OTF of a view, and what it is meant for.
    struct TubeCoreReading {
        AdaptiveOtf otf;
        std::shared_ptr<const Volume> shown;  ///< of the phase otfPhaseOf()
    };
    /// The adaptive OTF of a view with its tube cores, whatever the view is rendered with. The result is empty only
    /// where progress.cancel was raised.
    [[nodiscard]] std::optional<TubeCoreReading> readTubeCores(const Document& document, std::size_t pane,
                                                               const Progress& progress = {});
    /// The picture of the phase that a view shows; `otf` is what is computed to render it with, where that plays a
    /// part. The result is empty only where progress.cancel was raised. Throws std::out_of_range where there is no such
    /// phase.
    [[nodiscard]] std::optional<ViewPicture> picture(const Document& document, std::size_t pane, int width, int height,
                                                     const ViewOtf& otf, const Progress& progress = {},
                                                     PictureQuality quality = PictureQuality::converged);

private:
    /// Voxels of a phase with what the scalpel cut of them.
    struct Voxels {
        int phase = 0;
        std::vector<ScalpelStroke> strokes{};
        SpeckleReduction reduction = SpeckleReduction::off;
        std::shared_ptr<const Volume> raw{}, shown{};
    };
    [[nodiscard]] const Voxels* voxels(const Document& document, int phase, const Progress& progress);

    StudyPhases m_phases;
    ScalpelCuts m_cuts;
    std::optional<Voxels> m_voxels;  ///< asked for last
    std::optional<RayCaster> m_rays;
    RayCastSettings m_cast;  ///< what m_rays cast with last
};

}  // namespace echolucent
