// Reads GE Voluson volumes (Kretz): files of their own (.vol, .v00, ...) and elements of DICOM files.
#pragma once

#include <string_view>

#include "io/kretz/kretz_items.h"
#include "io/study/study.h"

namespace echolucent {

/// Whether a file or a DICOM element begins like a Kretz volume.
[[nodiscard]] bool looksLikeKretz(std::string_view beginning);

/// Reads a Kretz volume, 3D or 4D, Cartesian or polar. A polar volume is converted to a Cartesian grid. Before memory
/// is taken, every size is compared with the source. Fails (unreadable) if the volume is compressed, damaged or
/// contradicts itself; (cancelled) if the person ended it.
[[nodiscard]] Result<Study> readKretz(KretzSource source, const ReadOptions& options, const Progress& progress);

}  // namespace echolucent
