// Slices of a scan, for commands that read a series.
#pragma once

#include <cstdint>

#include "tests/io/written_files/dicom_files.h"

namespace echolucent {

/// The slice of this number (from 0): 20 x 20 pixels of one value, 1 mm from the slice before.
inline TestImage scanSlice(int number) {
    TestImage image;
    image.columns = image.rows = 20;
    image.pixels8.assign(400, static_cast<std::uint8_t>(100 + number));
    makeSlice(image, number, 1);
    return image;
}

}  // namespace echolucent
