// What the header of a DICOM file says of its picture and its series. The file may be damaged.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "io/dicom/series/concatenation.h"
#include "io/dicom/series/picture_moments.h"
#include "io/files/input_file.h"
#include "io/study/series_list.h"

namespace echolucent {

/// What the pictures of one volume share. What a file does not say is empty.
struct PictureTraits {
    std::string patientId, patientName, birthDate;  ///< only compared, never shown: small letters, no padding
    std::string frameOfReference;                   ///< UID
    std::string photometric;                        ///< "MONOCHROME2"
    std::optional<std::array<double, 2>> scale;     ///< mm along x and y
};

/// What the header of one image says. Of a Philips volume, columns, rows and frames are the size of the volume.
struct ImageHeader {
    SeriesFile file;
    /// Why the position or the orientation that is stated makes no sense, with its tag; else empty.
    std::string wrongPlace;
    std::string series, object, sopClass;  ///< UIDs of the series, the image and its SOP class
    std::string study;                     ///< UID
    std::string description, modality;
    std::int64_t rows = 0, columns = 0, frames = 1;
    bool volume = false;  ///< whether the file holds a maker's private volume, whatever its frames
    /// Why the frames of the file, or a maker's private volume, are no volume that can be read.
    std::optional<Failure> whyNot;
    PictureTraits traits;
    PictureMoments moments;                 ///< of a single picture
    std::optional<ConcatenationPart> part;  ///< which part of a concatenation the file is
};

/// What lookAt() finds in a file.
struct LookedAt {
    enum class Kind {
        image,       ///< `header` says which
        damaged,     ///< `damage` says what is wrong; `header` holds what could still be read
        otherDicom,  ///< DICOM, but no image: a report, a presentation
        packed,      ///< with gzip
        empty,       ///< 0 bytes
        unopened,    ///< `damage` says why
        unknown      ///< no DICOM, or not looked at after a cancel
    };
    Kind kind = Kind::unknown;
    std::unique_ptr<ImageHeader> header;  ///< null if there is none
    Failure damage;                       ///< of kinds damaged and unopened
    std::string series, sopClass;         ///< of otherDicom: Series Instance UID and SOP class, if it has them
};

/// Looks at the beginning of the file at `path` and, if that is DICOM, at its header. A file counts as damaged if
/// DicomFile::load() fails for it, for example because it ends before its pixels do. So does a file that has the place
/// or the size of a picture but no pixels, or pixels but not their size. `progress` is polled for cancel between
/// elements. Call it in a thread with a large stack.
[[nodiscard]] LookedAt lookAt(const std::string& path, const Progress& progress);

}  // namespace echolucent
