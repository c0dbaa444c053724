// What the slices of one volume share, and the splitting of those that do not.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/series/image_header.h"

namespace echolucent {

using Images = std::vector<ImageHeader>;

/// Slices of one Series Instance UID, listed apart.
struct Apart {
    std::vector<Images> groups;
    std::vector<std::string> distinctions;  ///< how each group differs from the others; an empty text if there is one
    std::vector<std::string> reasons;       ///< "2 patients"
};

/// Splits slices that differ in patient, frame of reference, size, modality, photometric interpretation or pixel
/// spacing. A value that a slice lacks makes a group of its own. Slices of two or three orientations are split too, if
/// these stand at clear angles to each other and one of them has three slices or more.
[[nodiscard]] Apart listApart(Images images);

/// Whether each of several images has a frame of reference of its own.
[[nodiscard]] bool noneShareTheirFrame(const Images& images);

/// Whether two headers contradict each other in what the slices of one volume share.
[[nodiscard]] bool contradict(const ImageHeader& a, const ImageHeader& b);

}  // namespace echolucent
