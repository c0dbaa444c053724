// The display window that a DICOM data set declares, and the stored value that it shows as white.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/study/study_assembly.h"

namespace echolucent {

struct DicomWindow {
    std::optional<DisplayWindow> white;  ///< no value if no readable window is declared
    std::vector<std::string> warnings;   ///< on a window that cannot be read, or a VOI LUT that is not applied
};

/// Reads the first Window Center and Width at top level. If there is no center, it reads them in the functional groups
/// that all frames share; if these have no window or LUT, in the groups of `frame` (counted from 0). White is centre +
/// width / 2; of MONOCHROME1 it is centre - width / 2, inverted like the pixels. Windows count in rescaled values;
/// `rescale` is that of the frame. Only grey pixels of more than 8 stored bits have a window here.
[[nodiscard]] DicomWindow readWindow(DcmItem& dataset, const DicomPixelFormat& format, std::size_t frame,
                                     const Rescale& rescale);

}  // namespace echolucent
