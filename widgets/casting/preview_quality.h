// Chooses how good the picture is while the hand moves.
#pragma once

#include <cstddef>
#include <limits>

#include "widgets/casting/qualities.h"

namespace echolucent {

/// Requests that follow each other within this time belong to one movement.
inline constexpr int streamMilliseconds = 150;
/// After this time the hand counts as at rest. It is longer than the time between two moves of a mouse.
inline constexpr int restMilliseconds = 40;

/// Learns what a ray's sample costs on this machine and this scene, and what bringing a picture to the screen costs.
/// Chooses the finest quality that fits into a frame's time. The caster keeps the samples for an edit (another curve or
/// colour map under the same camera). So edits and new views cost differently and are learnt apart. Pictures with and
/// without light are learnt apart too.
class PreviewQuality {
public:
    /// `frameMilliseconds` is the time from one picture to the next while the hand moves.
    explicit PreviewQuality(double frameMilliseconds = 33.0) : m_frame(frameMilliseconds) {}

    /// Learns the time of a picture whose samples had to be taken, with rays through this share of its pixels.
    void sampled(const RayCastSettings& settings, double milliseconds, double castShare = 1.0);
    /// Learns the time of a picture that was made from kept samples.
    void reclassified(const RayCastSettings& settings, double milliseconds);
    /// Learns that the caster could not keep as many samples as these settings need.
    void couldNotKeep(const RayCastSettings& settings);
    /// Learns how long it took to bring a picture to the screen, without the casting. The first picture does not count:
    /// it prepares OpenGL.
    void drawn(double milliseconds);

    /// Learns the time of the light volume of a picture in motion. This time does not depend on rays and steps.
    void lit(const RayCastSettings& settings, double milliseconds);

    /// The time for casting one picture without a light volume.
    [[nodiscard]] double budgetMilliseconds() const;
    /// The quality for the next picture of a moving view; `asked` as in settingsAt(). The quality does not waver
    /// between two if the cost changes only a little.
    [[nodiscard]] std::size_t qualityInMotion(const RayCastSettings& asked);
    /// The quality for a view that no other follows closely. It is high quality or finer if high quality takes no
    /// longer than aloneFrames frames, else qualityInMotion().
    [[nodiscard]] std::size_t qualityAlone(const RayCastSettings& asked);
    static constexpr double aloneFrames = 1.5;
    /// The quality for the next picture of an edit, at most as coarse as the last qualityInMotion(). With a light
    /// volume it may be one coarser, because another curve also changes how much each place attenuates. The first two
    /// pictures at each quality must be sampled. So within a series of edits the quality stays unless it is far off. A
    /// quality is left out if each of the two would take longer than warmUpFrames frames.
    [[nodiscard]] std::size_t qualityForEdits(const RayCastSettings& asked, bool inSeries);
    static constexpr double warmUpFrames = 5.0;

private:
    /// Milliseconds for one ray at step 1: `sampling` if its samples are taken, `reclassifying` if they were kept. 0
    /// before anything was measured.
    struct Cost {
        double sampling = 0.0;
        double reclassifying = 0.0;
    };
    [[nodiscard]] Cost& costOf(const RayCastSettings& settings) { return settings.shading ? m_shaded : m_unshaded; }
    /// Measured, or guessed from the other kind; 0 if neither was measured.
    [[nodiscard]] double samplingCost(const RayCastSettings& settings) const;
    /// The share of the pixels through which rays are cast; too much rather than too little.
    [[nodiscard]] double castShareOf(const RayCastSettings& settings) const;
    /// The time for the rays of a picture whose samples are taken.
    [[nodiscard]] double samplingTime(std::size_t quality, const RayCastSettings& asked) const;
    /// The time for the rays of a picture, without its light volume.
    [[nodiscard]] double budgetFor(const RayCastSettings& asked) const;
    [[nodiscard]] double editCost(std::size_t quality, const RayCastSettings& asked);

    double m_frame;
    Cost m_unshaded, m_shaded;
    double m_drawing = 0.0, m_light = 0.0;  // ms
    int m_drawn = 0;
    double m_castShare = 1.0, m_castSharePixels = 1.0;  // of the newest picture that may have interpolated pixels
    double m_samplesNotKept = std::numeric_limits<double>::infinity();  // the fewest that could not be kept
    std::size_t m_motionQuality = firstQuality;
    std::size_t m_editQuality = firstQuality;
};

}  // namespace echolucent
