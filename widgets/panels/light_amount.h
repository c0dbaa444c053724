// Light as one number: from none to deep shadows.
#pragma once

#include "processing/picture/look.h"

namespace echolucent {

/// The least amount of a look that has light.
inline constexpr double leastLight = 0.05;

/// How much light does in a look, in [0, 1]. 0: it is flat. Of light that reaches, the amount is the mean of cast
/// shadows and dark hollows, leastLight at least. Light on surfaces alone darkens nothing else and has leastLight.
[[nodiscard]] double lightAmount(const Look& look);

/// The look with another amount of light. 0 makes it flat and keeps all else for the way back. Above 0 light reaches,
/// and both cast shadows and dark hollows are as dark as the amount says. Where the light stands, its softness and its
/// translucency stay. `amount` must lie in [0, 1].
[[nodiscard]] Look withLightAmount(Look look, double amount);

}  // namespace echolucent
