// Which phases of its study a document asks for.
#pragma once

#include "processing/document/document.h"

namespace echolucent {

/// The last phase, counted from 0, that the document asks for: of the scene, a pane, a measurement or the motion.
[[nodiscard]] int lastPhaseOf(const Document& document);

}  // namespace echolucent
