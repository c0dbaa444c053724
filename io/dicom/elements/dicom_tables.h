// What reading DICOM opens files for: the dictionary of tags, and tables of characters.
#pragma once

namespace echolucent {

/// Loads them all now, so that DICOM can be read where no file can be opened any more.
void loadDicomTables();

}  // namespace echolucent
