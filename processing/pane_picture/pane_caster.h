// Casts pictures of panes of documents, one after another, through the phases of one study.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/classification.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/document/document.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/progress.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "processing/shared_list.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How the panes of a document are cast at their look's own step. The camera is that of the shown pose, fitted to a
/// data box. Front and box limit the picture.
[[nodiscard]] RayCastSettings castSettingsOf(const Document& document, const VolumeGeometry& geometry,
                                             const DataBox& box, int width, int height);

/// How much a pane's picture spares.
enum class PictureQuality {
    converged,  ///< converged(): what the window shows at rest, and saves
    quick,      ///< the look's own step, and RayCastSettings{}.terminationTransmittance
};

/// What a pane shows.
struct PanePicture {
    Picture picture;
    RayCastSettings cast;                  ///< the settings that it was cast with
    Classification classification;         ///< the classification that it was cast with
    std::shared_ptr<const Volume> voxels;  ///< quiet if speckle is reduced, and cut by the strokes
    std::string message;                   ///< from the computed OTF; empty if there is none
};

struct StudyPhases {
    std::vector<std::shared_ptr<const Volume>> scans;  ///< as they were read, at least one, all on one grid
    /// The quiet voxels by phase, uncut, if somebody has them. If a phase is null or missing, PaneCaster makes them.
    std::vector<std::shared_ptr<const Volume>> quiet{};
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `quiet`; for another reduction quiet voxels are made
    friend bool operator==(const StudyPhases&, const StudyPhases&) = default;
};

/// The OTF that is computed from the voxels for a pane.
struct PaneOtf {
    SampledCurve curve{};                      ///< the adaptive one, if the pane is rendered with it
    std::optional<Classification> designed{};  ///< the designer's, if the pane has a designer
    std::string message{};                     ///< of the adaptive method or the designer
};

/// Whether a pane's picture needs an OTF that is computed: in direct mode, if the pane is rendered with the adaptive
/// OTF or a designer's.
[[nodiscard]] bool needsComputedOtf(const Document& document, std::size_t pane);

/// What a pane is rendered with, adjusted as CurveSet::adjustment says. If the pane has a designer and `otf` holds no
/// OTF of a designer, it is clear everywhere.
[[nodiscard]] Classification classificationOf(const Document& document, std::size_t pane, const PaneOtf& otf);

/// What the designer of a pane is given. The volumes must outlive the result. The viewpoint is otfViewpointOf().
[[nodiscard]] DesignerInput designerInputOf(const Document& document, std::size_t pane, const Volume& raw,
                                            const Volume& shown, SpeckleReduction reduction);

/// The phase whose computed OTF a pane shows. If there are several phases and all frames show one OTF (Pane::motionOtf,
/// else MotionChoice::otf), the phase is MotionChoice::otfPhase, or the last phase if there are fewer. Else it is the
/// phase that the pane shows.
[[nodiscard]] int otfPhaseOf(const Document& document, std::size_t pane, int phases);

/// Keeps what pictures have in common: what the scalpel cut, the voxels asked for last, their ray caster, and the
/// newest OTF. Converged pictures are the same, to the bit, as if each were the only one. Only one thread at a time may
/// use it. Functions throw std::out_of_range if there is no such pane, or no such phase in the study.
class PaneCaster {
public:
    /// Throws std::invalid_argument if there is no scan.
    explicit PaneCaster(StudyPhases phases);

    [[nodiscard]] int phaseCount() const { return static_cast<int>(m_phases.scans.size()); }
    /// The OTF that a pane needs, of the phase otfPhaseOf(). If the pane has a designer, the designer computes it; else
    /// it is the adaptive one, computed from raw voxels along otfViewpointOf() for the voxels that are shown. If
    /// needsComputedOtf() is false, the result is PaneOtf{}. The result is empty only if progress.cancel was raised.
    [[nodiscard]] std::optional<PaneOtf> otf(const Document& document, std::size_t pane, const Progress& progress = {});
    /// Voxels of the phase otfPhaseOf(), cut by the strokes.
    struct OtfVoxels {
        std::shared_ptr<const Volume> raw;    ///< for tube cores
        std::shared_ptr<const Volume> shown;  ///< for the picture
    };
    /// The voxels from which the OTF of a pane is computed. The result is empty only if progress.cancel was raised.
    [[nodiscard]] std::optional<OtfVoxels> otfVoxels(const Document& document, std::size_t pane,
                                                     const Progress& progress = {});
    /// The voxels of a phase, for what is measured of its picture. The result is empty only if progress.cancel was
    /// raised.
    [[nodiscard]] std::optional<OtfVoxels> phaseVoxels(const Document& document, int phase,
                                                       const Progress& progress = {});
    /// What tube cores read for the adaptive OTF of a pane, and the voxels for which the OTF is made.
    struct TubeCoreReading {
        AdaptiveOtf otf;
        std::shared_ptr<const Volume> shown;  ///< of the phase otfPhaseOf()
    };
    /// The adaptive OTF of a pane with its tube cores, whatever the pane is rendered with. The result is empty only if
    /// progress.cancel was raised.
    [[nodiscard]] std::optional<TubeCoreReading> readTubeCores(const Document& document, std::size_t pane,
                                                               const Progress& progress = {});
    /// The picture of the phase that a pane shows, `width` x `height` pixels, with its otf(). The result is empty only
    /// if progress.cancel was raised.
    [[nodiscard]] std::optional<PanePicture> picture(const Document& document, std::size_t pane, int width, int height,
                                                     const Progress& progress = {},
                                                     PictureQuality quality = PictureQuality::converged);
    /// Like picture(), but with `otf` in place of otf().
    [[nodiscard]] std::optional<PanePicture> pictureWith(const PaneOtf& otf, const Document& document, std::size_t pane,
                                                         int width, int height, const Progress& progress = {},
                                                         PictureQuality quality = PictureQuality::converged);

    /// Like picture(), but with a classification that was made before, as classificationOf() gives it.
    [[nodiscard]] std::optional<PanePicture> pictureOf(const Classification& classification, const Document& document,
                                                       std::size_t pane, int width, int height,
                                                       const Progress& progress = {},
                                                       PictureQuality quality = PictureQuality::converged);

private:
    /// All that the voxels of a phase are made from.
    struct AskedVoxels {
        int phase = 0;
        SharedList<ScalpelStroke> strokes{};
        SpeckleReduction reduction = SpeckleReduction::off;
        friend bool operator==(const AskedVoxels&, const AskedVoxels&) = default;
    };
    struct AskedOtf {
        AskedVoxels voxels{};
        std::optional<DesignerConfig> designer{};
        Viewpoint viewpoint{};       ///< set only if the OTF reads tube cores
        AdaptiveOtfConfig method{};  ///< set only if the OTF reads tube cores
        friend bool operator==(const AskedOtf&, const AskedOtf&) = default;
    };
    struct Voxels {
        AskedVoxels asked;
        std::shared_ptr<const Volume> raw{}, shown{};
    };
    [[nodiscard]] static AskedVoxels askedVoxels(const Document& document, int phase);
    [[nodiscard]] const Voxels* voxels(const AskedVoxels& asked, const Progress& progress);
    [[nodiscard]] std::optional<PaneOtf> computedOtf(const Document& document, std::size_t pane,
                                                     const Progress& progress);
    [[nodiscard]] RayCaster& raysThrough(const std::shared_ptr<const Volume>& volume, bool withoutKeptSamples);

    StudyPhases m_phases;
    ScalpelCuts m_cuts;
    std::optional<Voxels> m_voxels;  ///< asked for last
    std::optional<AskedOtf> m_askedOtf;
    PaneOtf m_otf;  ///< the answer to m_askedOtf
    std::optional<RayCaster> m_rays;
    RayCastSettings m_cast;  ///< what m_rays cast with last
};

/// The adaptive OTF of a pane, from voxels that PaneCaster::otfVoxels() gave for a document with the same phase,
/// strokes and speckle reduction. Several threads may call it at once. The result is empty only if progress.cancel was
/// raised.
[[nodiscard]] std::optional<AdaptiveOtf> adaptiveOtfOf(const Document& document, std::size_t pane,
                                                       const PaneCaster::OtfVoxels& voxels,
                                                       const Progress& progress = {});

}  // namespace echolucent
