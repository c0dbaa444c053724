// DICOM's linear rescaling: from stored values to the values they stand for.
#pragma once

#include <cstdint>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"

namespace echolucent {

/// The rescaling of every frame of a data set.
struct FrameRescales {
    Rescale all;                  ///< of the frames without their own
    std::vector<Rescale> single;  ///< of the first frames; empty if the groups of single frames hold none
    [[nodiscard]] const Rescale& of(std::size_t frame) const { return frame < single.size() ? single[frame] : all; }
};

/// Rescale Slope and Intercept of a data set. There is one pair for all frames (at top level or in the shared
/// functional groups), or one a frame in the groups of frames. A missing or empty slope is 1, a missing or empty
/// intercept 0. Pixels in colour are not rescaled. Fails if a value is no finite number or if the slope is 0. It also
/// fails if the values of `format` would not fit into floats or could not be told apart there.
[[nodiscard]] tl::expected<FrameRescales, PixelFormatProblem> readRescales(DcmItem& dataset,
                                                                           const DicomPixelFormat& format);

/// Writes the rescaled values of the grey values of `type` (as toGrey() gives them) into `out`, as float32.
void applyRescale(const Rescale& rescale, std::span<const std::uint8_t> grey, StoredType type,
                  std::span<std::uint8_t> out);

}  // namespace echolucent
