// The values that DICOM pixels hold where there is no picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

class DcmItem;

namespace echolucent {

/// Stored values that are no picture.
struct PixelPadding {
    int low = 0;        ///< the least of them
    int high = 0;       ///< the largest of them
    std::string words;  ///< the attributes that state them, with their values
    [[nodiscard]] bool holds(int value) const { return value >= low && value <= high; }
};

/// The stored samples of grey pixels.
struct GreySamples {
    bool dark = false;  ///< MONOCHROME1
    bool isSigned = false;
    int bitsAllocated = 8;
    int smallest = 0, largest = 255;  ///< values that the stored bits can hold
};

/// Pixel Padding Value (0028,0120) of grey pixels, with Pixel Padding Range Limit (0028,0121) if that is stated. Both
/// have the sign of the pixels, whatever sign they are stored with. No value if there is none, if no pixel can hold it,
/// or if it would leave no value for the picture; a note is added then. No value either for 0 in unsigned MONOCHROME2:
/// that may be the picture's black as well.
[[nodiscard]] std::optional<PixelPadding> readPadding(DcmItem& dataset, const GreySamples& samples,
                                                      std::vector<std::string>& notes);

}  // namespace echolucent
