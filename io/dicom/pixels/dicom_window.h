// The display window that a DICOM data set declares, read as what is shown as white.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/study/study_assembly.h"

namespace echolucent {

/// What a data set says of its display window.
struct DicomWindow {
    std::optional<WindowWhite> white;   ///< no value where no window is declared, or none that can be read
    std::vector<std::string> warnings;  ///< sentences: a window that cannot be read, a VOI LUT that is not applied
};

/// Reads Window Center and Width (of several the first) at top level, else in the functional groups that all frames
/// share, else in those of `frame` (counted from 0). White is centre + width / 2, of MONOCHROME1 centre - width / 2,
/// which is inverted as the pixels are. Windows count in rescaled values; `rescale` is that of the frame. Only grey
/// pixels of more than 8 stored bits have a window here; others say nothing.
[[nodiscard]] DicomWindow readWindow(DcmItem& dataset, const DicomPixelFormat& format, std::size_t frame,
                                     const Rescale& rescale);

}  // namespace echolucent
