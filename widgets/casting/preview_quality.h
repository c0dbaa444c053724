// How good the picture is while the hand moves.
#pragma once

#include <cstddef>
#include <limits>

#include "widgets/casting/qualities.h"

namespace echolucent {

/// Requests that follow each other within this belong to one movement.
inline constexpr int streamMilliseconds = 150;
/// When the hand counts as at rest: longer than between two moves of a mouse.
inline constexpr int restMilliseconds = 40;

/// Learns what a ray's sample costs on this machine and this scene, and what bringing a picture to the screen costs,
/// and chooses the finest of the qualities within a frame's time. Pictures of a new view and edits (another curve
/// or colour map under the same camera, whose samples the ray caster keeps) cost differently and are learnt apart, and
/// so are pictures with and without light.
class PreviewQuality {
public:
    /// `frameMilliseconds` is the time from one picture to the next while the hand moves.
    explicit PreviewQuality(double frameMilliseconds = 33.0) : m_frame(frameMilliseconds) {}

    /// Learns what a picture took whose samples had to be taken.
    void sampled(const RayCastSettings& settings, double milliseconds);
    /// Learns what a picture took that was made from kept samples.
    void reclassified(const RayCastSettings& settings, double milliseconds);
    /// Learns that samples of as many rays and steps as these could not be kept.
    void couldNotKeep(const RayCastSettings& settings);
    /// Learns what bringing a picture to the screen took, beside the casting. The first prepares OpenGL and does not
    /// count.
    void drawn(double milliseconds);

    /// Learns what the light volume of a picture in motion took, which is no matter of its rays and steps.
    void lit(const RayCastSettings& settings, double milliseconds);

    /// What casting one picture without a light volume may take.
    [[nodiscard]] double budgetMilliseconds() const;
    /// The quality for the next picture of a moving view; `asked` as in settingsAt(). Does not waver between two
    /// qualities on small changes of cost.
    [[nodiscard]] std::size_t qualityInMotion(const RayCastSettings& asked);
    /// The quality for a view that no other follows closely: the one shown at rest, where that takes no longer than
    /// aloneFrames frames, else qualityInMotion().
    [[nodiscard]] std::size_t qualityAlone(const RayCastSettings& asked);
    static constexpr double aloneFrames = 1.5;
    /// The quality for the next picture of an edit. At each quality the first two pictures must be sampled: within a
    /// series of edits the quality stays unless it is far off, and a quality at which each of the two would take longer
    /// than warmUpFrames frames is left out. Never coarser than qualityInMotion().
    [[nodiscard]] std::size_t qualityForEdits(const RayCastSettings& asked, bool inSeries);
    static constexpr double warmUpFrames = 5.0;

private:
    /// Milliseconds a ray, and a sample per unit of depth; 0 before anything was measured.
    struct Cost {
        double sampling = 0.0;
        double reclassifying = 0.0;
    };
    [[nodiscard]] Cost& costOf(const RayCastSettings& settings) { return settings.shading ? m_shaded : m_unshaded; }
    /// Measured, or guessed from the other kind; 0 where neither was.
    [[nodiscard]] double samplingCost(const RayCastSettings& settings) const;
    /// What the rays of a picture may take, beside its light volume.
    [[nodiscard]] double budgetFor(const RayCastSettings& asked) const;
    [[nodiscard]] double editCost(std::size_t quality, const RayCastSettings& asked);

    double m_frame;
    Cost m_unshaded, m_shaded;
    double m_drawing = 0.0, m_light = 0.0;  // ms
    int m_drawn = 0;
    double m_samplesNotKept = std::numeric_limits<double>::infinity();  // the fewest that could not be kept
    std::size_t m_motionQuality = firstQuality;
    std::size_t m_editQuality = firstQuality;
};

}  // namespace echolucent
