// Adaptive OTFs that were computed before: a loop that plays over and over computes each of its own once, as many as
// fit.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"

namespace echolucent {

/// What an adaptive OTF is computed from. The same request has the same OTF, bit for bit.
struct OtfRequest {
    std::shared_ptr<const Volume> volume;  ///< the raw voxels that the tube cores read
    std::shared_ptr<const Volume> voxels;  ///< those that the curve is meant for
    Viewpoint view;
    AdaptiveOtfConfig config;
    friend bool operator==(const OtfRequest&, const OtfRequest&) = default;
};

/// Finds OTFs by their requests. It keeps no voxels alive: an OTF of voxels that are gone is never found again.
class KeptOtfs {
public:
    /// Keeps an OTF while all of them take no more than byteLimit. Where it does not fit, those of voxels that are
    /// gone make room; of a loop that is too long, the OTFs computed first stay.
    void keep(const OtfRequest& request, std::shared_ptr<const AdaptiveOtf> otf);
    /// The OTF of the same request; null where it is not kept.
    [[nodiscard]] std::shared_ptr<const AdaptiveOtf> find(const OtfRequest& request) const;
    void clear();
    [[nodiscard]] std::size_t count() const { return m_kept.size(); }
    /// That all of them take.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

    /// It holds about 120 OTFs of 15 x 15 tube cores through 256 voxels.
    static constexpr std::size_t byteLimit = std::size_t{64} << 20;

private:
    struct Kept {
        std::weak_ptr<const Volume> volume, voxels;
        Viewpoint view;
        AdaptiveOtfConfig config;
        std::shared_ptr<const AdaptiveOtf> otf;
        std::size_t bytes = 0;
    };
    std::vector<Kept> m_kept;
    std::size_t m_bytes = 0;
};

}  // namespace echolucent
