// What a graphics card draws, made in the casting thread.
#pragma once

#include "widgets/casting/ray_casters.h"

namespace echolucent {

/// Makes what a card draws of the first pane of a request (CastPane::card), in place of casting it. What pictures of a
/// volume share is kept for the newest volumes, as long as it takes up to keptBytesForCard: the phases of a heart that
/// plays are prepared once.
[[nodiscard]] Cast makeForCard();
inline constexpr std::size_t keptBytesForCard = std::size_t{512} << 20;

}  // namespace echolucent
