// The view that every document begins with.
#pragma once

namespace echolucent {

inline constexpr int firstView = 1;

}  // namespace echolucent
