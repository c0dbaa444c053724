// GE Voluson volumes (Kretz): files of their own (.vol, .v00, ...) and elements of DICOM files.
#pragma once

#include <string_view>

#include "io/kretz/kretz_items.h"
#include "io/study/study.h"

namespace echolucent {

/// Whether the first bytes of a file, or of a DICOM element, are those of a Kretz volume.
[[nodiscard]] bool looksLikeKretz(std::string_view beginning);

/// Reads a Kretz volume, polar (which is converted) or Cartesian, 3D or 4D. Every size is compared with what the source
/// holds before memory is taken. Fails (unreadable) where it is compressed, damaged or contradicts itself, (cancelled)
/// where the person ended it.
[[nodiscard]] Result<Study> readKretz(KretzSource source, const ReadOptions& options, const Progress& progress);

}  // namespace echolucent
