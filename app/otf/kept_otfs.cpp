#include "app/otf/kept_otfs.h"

#include <algorithm>
#include <utility>

#include "processing/adaptive/adaptive_otf_result.h"

namespace echolucent {

namespace {

std::size_t bytesOfTubeCores(const AdaptiveOtf& otf) {
    std::size_t bytes = sizeof otf + sizeof(double) * AdaptiveOtf::sampleCount + sizeof(TubeCore) * otf.tubes.size();
    for (const TubeCore& tube : otf.tubes)
        bytes += sizeof(float) * (tube.cellMeans.size() + tube.interfaceFunction.size()) +
                 sizeof(int) * tube.trackedCells.size();
    return bytes;
}

std::size_t bytesOf(const ComputedOtf& otf) {
    const Design& design = otf.design;
    std::size_t bytes = sizeof otf + sizeof(double) * AdaptiveOtf::sampleCount;
    if (const auto& table = design.classification.twoDimensional()) bytes += sizeof(float) * table->opacities.size();
    for (const DesignPlot& plot : design.plots)
        bytes += sizeof(double) * (plot.intensities.size() + plot.values.size());
    if (design.tubeCores) bytes += bytesOfTubeCores(*design.tubeCores);
    return bytes;
}

}  // namespace

void KeptOtfs::countBytes() {
    m_bytes = 0;
    for (const Kept& kept : m_kept) m_bytes += kept.bytes;
}

void KeptOtfs::forgetAdaptive() {
    std::erase_if(m_kept, [](const Kept& kept) { return kept.otf.design.tubeCores != nullptr; });
    countBytes();
}

void KeptOtfs::keep(const ComputedOtf& otf) {
    if (find(otf.asked)) return;
    const std::size_t bytes = bytesOf(otf);
    std::erase_if(m_kept, [](const Kept& kept) { return kept.raw.expired() || kept.shown.expired(); });
    countBytes();
    if (bytes > byteLimit) return;
    while (m_bytes + bytes > byteLimit && !m_kept.empty()) {
        m_kept.pop_back();
        countBytes();
    }
    Kept kept{otf, otf.asked.raw, otf.asked.shown, bytes};
    kept.otf.asked.raw = kept.otf.asked.shown = nullptr;
    m_kept.push_back(std::move(kept));
    m_bytes += bytes;
}

std::shared_ptr<const ComputedOtf> KeptOtfs::find(const OtfRequest& request) const {
    if (!request.raw || !request.shown) return nullptr;  // null would equal voxels that are gone
    OtfRequest voxelless = request;
    voxelless.raw = voxelless.shown = nullptr;
    const auto found = std::ranges::find_if(m_kept, [&](const Kept& kept) {
        return kept.raw.lock() == request.raw && kept.shown.lock() == request.shown && kept.otf.asked == voxelless;
    });
    if (found == m_kept.end()) return nullptr;
    ComputedOtf otf = found->otf;
    otf.asked = request;
    return std::make_shared<const ComputedOtf>(std::move(otf));
}

void KeptOtfs::clear() {
    m_kept.clear();
    m_bytes = 0;
}

}  // namespace echolucent
