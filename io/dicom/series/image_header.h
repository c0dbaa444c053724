// What the headers of DICOM files say of the series that their pictures belong to, whole files and damaged ones.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "io/files/input_file.h"
#include "io/study/series_list.h"

namespace echolucent {

/// What pictures share that make up one volume. What a file does not say is empty.
struct PictureTraits {
    std::string patientId, patientName, birthDate;  ///< only compared, never shown: small letters, no padding
    std::string frameOfReference;                   ///< UID
    std::string photometric;                        ///< "MONOCHROME2"
    std::optional<std::array<double, 2>> scale;     ///< mm along x and y
};

/// What the header of one image says.
struct ImageHeader {
    SeriesFile file;
    std::string series, object, sopClass;  ///< UIDs of series, image and kind of object
    std::string description, modality;
    std::int64_t rows = 0, columns = 0, frames = 1;
    bool volume = false;            ///< whether the file alone is one, whatever its frames
    std::optional<Failure> whyNot;  ///< of a multi-frame file
    PictureTraits traits;
};

/// What a file in a folder turned out to be.
struct LookedAt {
    enum class Kind {
        image,       ///< `header` holds what it says
        damaged,     ///< `damage` says what is wrong; `header` what could still be read, where that is anything
        otherDicom,  ///< no image: a report, a presentation
        packed,      ///< with gzip
        empty,       ///< 0 bytes
        unopened,    ///< `damage` says why
        unknown      ///< no DICOM
    };
    Kind kind = Kind::unknown;
    std::unique_ptr<ImageHeader> header;  ///< null where there is none
    Failure damage;                       ///< of kinds that have any
    std::string series, sopClass;         ///< of otherDicom: its Series Instance UID and SOP class, where it has them
};

/// Looks at the file at `path`: at its beginning, and at its header where that is DICOM. A file that ends before its
/// pixels do, or has the place or size of a picture but no pixels, is damaged. `progress` is polled for cancel between
/// elements. To be called in a thread with a large stack.
[[nodiscard]] LookedAt lookAt(const std::string& path, const Progress& progress);

}  // namespace echolucent
