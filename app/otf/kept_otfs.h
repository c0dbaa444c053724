// Keeps computed OTFs, as many as fit. So a loop computes each of its OTFs once, and an undone step finds its OTF.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// A request to a designer; the adaptive method is one too. Equal requests have the same OTF, bit for bit.
struct OtfRequest {
    DesignerConfig config{};
    std::shared_ptr<const Volume> raw{};                 ///< as read, cut by the scalpel: tube cores read it
    std::shared_ptr<const Volume> shown{};               ///< what the OTF is meant for: quiet if speckle is reduced
    SpeckleReduction reduction = SpeckleReduction::off;  ///< of `shown`
    Viewpoint view{};            ///< tube cores look along it; the default if the designer reads none
    AdaptiveOtfConfig method{};  ///< how tube cores are read; the default if the designer reads none
    friend bool operator==(const OtfRequest&, const OtfRequest&) = default;
};

struct ComputedOtf {
    OtfRequest asked;
    Design design;
    double milliseconds = 0.0;  ///< wall time of the designer
};

/// Finds OTFs by their requests. It keeps no voxels alive: an OTF is never found again once its voxels are gone.
class KeptOtfs {
public:
    /// Keeps an OTF, and forgets those of lost voxels. All kept OTFs together take at most byteLimit; one that takes
    /// more alone is not kept, and the others stay. If `otf` does not fit beside the others, the newest of them make
    /// room. So if a loop is too long, its first OTFs stay.
    void keep(const ComputedOtf& otf);
    /// The OTF of the same request; null if it is not kept.
    [[nodiscard]] std::shared_ptr<const ComputedOtf> find(const OtfRequest& request) const;
    /// Forgets the OTFs that hold tube cores.
    void forgetAdaptive();
    void clear();
    [[nodiscard]] std::size_t count() const { return m_kept.size(); }
    /// The bytes of all kept OTFs.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

    /// Room for about 120 OTFs of 15 x 15 tube cores through 256 voxels.
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
