// The tables that reading DICOM loads from files: the dictionary of tags, and character sets.
#pragma once

namespace echolucent {

/// Loads them all now, so that DICOM can be read even when no file can be opened any more.
void loadDicomTables();

}  // namespace echolucent
