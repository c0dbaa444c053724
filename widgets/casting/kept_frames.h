// Keeps the pictures of a motion that plays over and over, from its first turn on.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "widgets/casting/cast_picture.h"

namespace echolucent {

/// Finished pictures by their requests. Another volume, curve, camera, look or size is another request, so nothing
/// stale is ever shown.
class KeptFrames {
public:
    /// Keeps the screen pictures of `picture`, unless they would exceed byteLimit or the request is kept already. The
    /// frames kept first stay.
    void keep(const CastPicture& picture);
    /// The picture of a request at its full size; null if it is not kept.
    [[nodiscard]] std::shared_ptr<const CastPicture> find(const PictureRequest& request) const;
    void clear();
    [[nodiscard]] int count() const { return static_cast<int>(m_frames.size()); }
    /// The bytes of all frames kept.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

    static constexpr std::size_t byteLimit = std::size_t{512} << 20;

private:
    std::vector<std::shared_ptr<const CastPicture>> m_frames;
    std::size_t m_bytes = 0;
};

}  // namespace echolucent
