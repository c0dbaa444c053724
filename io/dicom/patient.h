// The patient of a DICOM study. The list of series reads names too, but only to keep patients apart (PictureTraits) and
// to leave names out (seriesDescription()).
#pragma once

#include <string>
#include <vector>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What DICOM files say of their patient: in UTF-8 if the character set is known, else as stored. A missing attribute
/// is empty.
struct Patient {
    std::string name;       ///< (0010,0010), with "^" between its parts as stored
    std::string id;         ///< (0010,0020)
    std::string birthDate;  ///< (0010,0030), "1980-05-17"; as stored if it is no date
    std::string sex;        ///< (0010,0040) as stored; the standard knows "F", "M" and "O"
    std::string studyDate;  ///< (0008,0020), written like the date of birth
    /// Weeks and days from the Last Menstrual Date (0010,21D0) to the date of the study, "22+4"; empty if one of them
    /// is missing or no date, or if they are more than 45 weeks apart.
    std::string gestationalAge{};
    friend bool operator==(const Patient&, const Patient&) = default;
};

/// What a person typed, and what the files say of the rest. The files' gestational age is that of their own exam date,
/// so that it is left out beside another date.
[[nodiscard]] Patient withTyped(Patient ofFiles, const Patient& typed);

/// Whether readPatient() may find a patient in these files: the first or the last of them looks like DICOM. False if
/// there are none.
[[nodiscard]] bool areDicomFiles(const std::vector<std::string>& files);

/// Reads the patient from the headers of DICOM files and passes over other files. If one of the files has the Series
/// Instance UID `series`, only the files of that series count. What these files do not agree on is empty. Fails
/// (unreadable) if no file is readable DICOM, or if two files differ in the patient's name or ID; (cancelled) if
/// progress.cancel was raised.
[[nodiscard]] Result<Patient> readPatient(const std::vector<std::string>& files, const std::string& series = {},
                                          const Progress& progress = {});

}  // namespace echolucent
