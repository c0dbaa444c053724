// Who a DICOM study is of. Nothing else in the program reads this, and nobody keeps it.
#pragma once

#include <string>
#include <vector>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What DICOM files say of their patient, in UTF-8. An attribute that is missing is empty.
struct Patient {
    std::string name;       ///< (0010,0010), with "^" between its parts as stored
    std::string id;         ///< (0010,0020)
    std::string birthDate;  ///< (0010,0030), "1980-05-17"; as stored where it is no date
    std::string sex;        ///< (0010,0040), "F", "M" or "O"
    std::string studyDate;  ///< (0008,0020), written as the date of birth
    friend bool operator==(const Patient&, const Patient&) = default;
};

/// Whether a study of these files is one of DICOM, so that readPatient() may find a patient: its first or its last file
/// looks like DICOM.
[[nodiscard]] bool areDicomFiles(const std::vector<std::string>& files);

/// Reads the patient from the headers of DICOM files; of those of a series where `series` is a Series Instance UID that
/// one of the files has, else of all. Files that are not DICOM are passed over. Fails (unreadable) where no file is
/// DICOM, or where two files are of different patients, so that it cannot be told whose study it is; (cancelled) where
/// progress.cancel was raised.
[[nodiscard]] Result<Patient> readPatient(const std::vector<std::string>& files, const std::string& series = {},
                                          const Progress& progress = {});

}  // namespace echolucent
