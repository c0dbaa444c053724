// OTFs that were computed before, as many as fit: a loop that plays over and over computes each of its own once, and
// what is undone is there at once.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a designer, the adaptive method among them, is asked for. The same request has the same OTF, bit for bit.
struct OtfRequest {
    DesignerConfig config{};
    std::shared_ptr<const Volume> raw{};                 ///< as it was read, cut by the scalpel: tube cores read it
    std::shared_ptr<const Volume> shown{};               ///< that the OTF is meant for: quiet if speckle is reduced
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `shown`
    Viewpoint view{};            ///< along which tube cores look; the default if the designer reads none
    AdaptiveOtfConfig method{};  ///< how they are read; the default likewise
    friend bool operator==(const OtfRequest&, const OtfRequest&) = default;
};

/// An OTF that was computed, and for which request.
struct ComputedOtf {
    OtfRequest asked;
    Design design;
    double milliseconds = 0.0;  ///< that the designer took
};

/// Finds OTFs by their requests. It keeps no voxels alive: an OTF of voxels that are gone is never found again.
class KeptOtfs {
public:
    /// Keeps an OTF. All of them take at most byteLimit. If one does not fit, those of voxels that are gone make room,
    /// then the newest ones: of a loop that is too long, the OTFs computed first stay.
    void keep(const ComputedOtf& otf);
    /// The OTF of the same request; null if it is not kept.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> find(const OtfRequest& request) const;
    void forgetAdaptive();
    void clear();
    [[nodiscard]] std::size_t count() const { return m_kept.size(); }
    /// That all of them take.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

    /// It holds about 120 OTFs of 15 x 15 tube cores through 256 voxels.
    static constexpr std::size_t byteLimit = std::size_t{64} << 20;

private:
    struct Kept {
        ComputedOtf otf;  ///< its request has no volumes
        std::weak_ptr<const Volume> raw, shown;
        std::size_t bytes = 0;
    };
    void countBytes();

    std::vector<Kept> m_kept;
    std::size_t m_bytes = 0;
};

}  // namespace echolucent
