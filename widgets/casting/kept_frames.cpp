#include "widgets/casting/kept_frames.h"

#include <algorithm>

namespace echolucent {

void KeptFrames::keep(const CastPicture& picture) {
    std::size_t bytes = 0;
    for (const CastPane& pane : picture.panes)
        bytes += pane.screen->rgba.size() + pane.screen->depthMm.size() * sizeof(pane.screen->depthMm[0]);
    if (m_bytes + bytes > byteLimit || find(picture.request)) return;
    auto frame = std::make_shared<CastPicture>(picture);
    for (CastPane& pane : frame->panes) pane.picture.reset();  // its floats are only read from a fresh picture
    frame->followsHand = true;
    m_frames.push_back(std::move(frame));
    m_bytes += bytes;
}

std::shared_ptr<const CastPicture> KeptFrames::find(const PictureRequest& request) const {
    const auto found = std::find_if(m_frames.begin(), m_frames.end(),
                                    [&](const auto& frame) { return samePicture(frame->request, request); });
    return found == m_frames.end() ? nullptr : *found;
}

void KeptFrames::clear() {
    m_frames.clear();
    m_bytes = 0;
}

}  // namespace echolucent
