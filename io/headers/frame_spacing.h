// The spacing that the frames of a sequence state beside that of their header, as Plus writes it.
#pragma once

#include <map>
#include <string>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Looks for keys like Seq_Frame0012_ElementSpacing among those of a MetaImage or an NRRD. If all of them state one
/// spacing in mm other than that of `stored`, it counts, with a note: Plus writes it beside a header of 1 1 1. If they
/// differ, or if one is no spacing, that of `stored` becomes unknown, with a note.
void takeFrameSpacing(const std::map<std::string, std::string>& keys, StoredVolume& stored);

}  // namespace echolucent
