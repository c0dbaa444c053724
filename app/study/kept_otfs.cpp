#include "app/study/kept_otfs.h"

#include <algorithm>
#include <utility>

namespace echolucent {

namespace {

std::size_t bytesOfOtf(const AdaptiveOtf& otf) {
    std::size_t bytes =
        sizeof otf + sizeof(double) * 2 * AdaptiveOtf::sampleCount + sizeof(TubeCore) * otf.tubes.size();
    for (const TubeCore& tube : otf.tubes)
        bytes += sizeof(float) * (tube.cellMeans.size() + tube.interfaceFunction.size()) +
                 sizeof(int) * tube.trackedCells.size();
    return bytes;
}

}  // namespace

void KeptOtfs::keep(const OtfRequest& request, std::shared_ptr<const AdaptiveOtf> otf) {
    if (find(request)) return;
    const std::size_t bytes = bytesOfOtf(*otf);
    if (m_bytes + bytes > byteLimit) {
        std::erase_if(m_kept, [&](const Kept& kept) { return kept.volume.expired() || kept.voxels.expired(); });
        m_bytes = 0;
        for (const Kept& kept : m_kept) m_bytes += kept.bytes;
    }
    if (m_bytes + bytes > byteLimit) return;
    m_kept.push_back({request.volume, request.voxels, request.view, request.config, std::move(otf), bytes});
    m_bytes += bytes;
}

std::shared_ptr<const AdaptiveOtf> KeptOtfs::find(const OtfRequest& request) const {
    if (!request.volume || !request.voxels) return nullptr;  // else they would equal voxels that are gone
    const auto found = std::find_if(m_kept.begin(), m_kept.end(), [&](const Kept& kept) {
        return kept.volume.lock() == request.volume && kept.voxels.lock() == request.voxels &&
               kept.view == request.view && kept.config == request.config;
    });
    return found == m_kept.end() ? nullptr : found->otf;
}

void KeptOtfs::clear() {
    m_kept.clear();
    m_bytes = 0;
}

}  // namespace echolucent
