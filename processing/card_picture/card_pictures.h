// Makes what a graphics card draws, outside the thread that draws.
#pragma once

#include <memory>
#include <optional>

#include "processing/card_picture/card_picture.h"
#include "processing/progress.h"

namespace echolucent {

/// Makes pictures of one volume for a card again and again, and keeps what they share: filled voxels, presence, the
/// intensities of bricks, the light. Only one thread at a time may use it.
class CardPictures {
public:
    explicit CardPictures(std::shared_ptr<const Volume> volume);
    ~CardPictures();
    CardPictures(CardPictures&&) noexcept;
    CardPictures& operator=(CardPictures&&) noexcept;

    [[nodiscard]] const std::shared_ptr<const Volume>& volume() const;
    /// Takes the same scan with another scalpel cut. The scan's voxels stay the object that they are. Throws
    /// std::invalid_argument for another scan (Volume::isSameScanAs()).
    void setCut(std::shared_ptr<const Volume> volume);

    /// Empty only if progress.cancel was raised. Throws std::invalid_argument for the settings for which castRays()
    /// throws. Works in the calling thread's oneTBB arena.
    [[nodiscard]] std::optional<CardPicture> make(const Classification& classification, const RayCastSettings& settings,
                                                  const Progress& progress = {});
    /// Bytes that this keeps beside the volume.
    [[nodiscard]] std::size_t keptBytes() const;

private:
    class Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
