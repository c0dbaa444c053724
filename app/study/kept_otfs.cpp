#include "app/study/kept_otfs.h"

#include <algorithm>
#include <utility>

namespace echolucent {

namespace {

std::size_t bytesOf(const AdaptiveOtf& otf) {
    std::size_t bytes =
        sizeof otf + sizeof(double) * 2 * AdaptiveOtf::sampleCount + sizeof(TubeCore) * otf.tubes.size();
    for (const TubeCore& tube : otf.tubes)
        bytes += sizeof(float) * (tube.cellMeans.size() + tube.interfaceFunction.size()) +
                 sizeof(int) * tube.trackedCells.size();
    return bytes;
}

}  // namespace

void KeptOtfs::keep(const OtfQuestion& question, std::shared_ptr<const AdaptiveOtf> otf) {
    if (find(question)) return;
    const std::size_t bytes = bytesOf(*otf);
    if (m_bytes + bytes > byteLimit) {
        std::erase_if(m_answers, [&](const Answer& answer) {
            return answer.volume.expired() || answer.voxels.expired() || !(answer.config == question.config);
        });
        m_bytes = 0;
        for (const Answer& answer : m_answers) m_bytes += answer.bytes;
    }
    if (m_bytes + bytes > byteLimit) return;
    m_answers.push_back({question.volume, question.voxels, question.view, question.config, std::move(otf), bytes});
    m_bytes += bytes;
}

std::shared_ptr<const AdaptiveOtf> KeptOtfs::find(const OtfQuestion& question) const {
    if (!question.volume || !question.voxels) return nullptr;  // else they would equal voxels that are gone
    const auto found = std::find_if(m_answers.begin(), m_answers.end(), [&](const Answer& answer) {
        return answer.volume.lock() == question.volume && answer.voxels.lock() == question.voxels &&
               answer.view == question.view && answer.config == question.config;
    });
    return found == m_answers.end() ? nullptr : found->otf;
}

void KeptOtfs::clear() {
    m_answers.clear();
    m_bytes = 0;
}

}  // namespace echolucent
