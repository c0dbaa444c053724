// Adaptive OTFs that were computed before: a loop that plays over and over computes each of its own once, as many as
// fit.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"

namespace echolucent {

/// What an adaptive OTF is computed from. The same question has the same answer, bit for bit.
struct OtfQuestion {
    std::shared_ptr<const Volume> volume;  ///< the raw voxels that the tube cores read
    std::shared_ptr<const Volume> voxels;  ///< those that the curve is meant for
    Viewpoint view;
    AdaptiveOtfConfig config;
    friend bool operator==(const OtfQuestion&, const OtfQuestion&) = default;
};

/// Finds answers by their questions. It keeps no voxels alive: an answer about voxels that are gone is never found
/// again.
class KeptOtfs {
public:
    /// Keeps an answer while all of them take no more than byteLimit. Where it does not fit, those about voxels that
    /// are gone and those by another method make room; of a loop that is too long, the OTFs computed first stay.
    void keep(const OtfQuestion& question, std::shared_ptr<const AdaptiveOtf> otf);
    /// The answer to the same question; null where it is not kept.
    [[nodiscard]] std::shared_ptr<const AdaptiveOtf> find(const OtfQuestion& question) const;
    void clear();
    [[nodiscard]] std::size_t count() const { return m_answers.size(); }

    /// It holds about 120 OTFs of 15 x 15 tube cores through 256 voxels.
    static constexpr std::size_t byteLimit = std::size_t{64} << 20;

private:
    struct Answer {
        std::weak_ptr<const Volume> volume, voxels;
        Viewpoint view;
        AdaptiveOtfConfig config;
        std::shared_ptr<const AdaptiveOtf> otf;
        std::size_t bytes = 0;
    };
    std::vector<Answer> m_answers;
    std::size_t m_bytes = 0;
};

}  // namespace echolucent
