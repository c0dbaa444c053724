// GE Voluson (Kretz) volumes in DICOM files.
#pragma once

#include <optional>

#include "io/dicom/elements/dicom_file.h"
#include "io/kretz/kretz_items.h"

namespace echolucent {

/// The Kretz volume in element (7FE1,xx01) of the private creator KRETZ_US; no value if the file holds none. The source
/// reads from `file`, which must outlive it. If the file lacks bytes of the volume, each read fails (unreadable).
[[nodiscard]] std::optional<KretzSource> kretzVolumeIn(const DicomFile& file);

}  // namespace echolucent
