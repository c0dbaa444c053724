// From the samples of a decoded DICOM frame to grey values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/pixels/dicom_palette.h"
#include "io/dicom/pixels/pixel_padding.h"
#include "io/voxels/voxel_types.h"

class DcmItem;

namespace echolucent {

enum class ColourModel { monochrome1, monochrome2, palette, rgb, lumaFirst };

/// How uncompressed samples of a frame follow each other.
enum class NativeLayout {
    full,        ///< all samples of each pixel, or planes
    halved,      ///< 4:2:2: Y Y Cb Cr stand for two pixels, and the next two follow, also across the end of a row
    halvedRows,  ///< 4:2:2, where each row of an odd number of pixels ends with a pair of which one is not shown
};

/// The description of a data set's pixels.
struct DicomPixelFormat {
    std::int64_t rows = 0;
    std::int64_t columns = 0;
    std::int64_t frames = 1;
    int samples = 1;
    int bitsAllocated = 8;
    int bitsStored = 8;
    int highBit = 7;
    bool isSigned = false;
    bool planar = false;                       ///< samples plane by plane instead of pixel by pixel
    NativeLayout layout = NativeLayout::full;  ///< of uncompressed pixels
    bool narrowRange = false;                  ///< whether uncompressed luma runs from 16 to 235 (YBR_PARTIAL_...)
    ColourModel model = ColourModel::monochrome2;
    std::string photometric;
    DicomPalette palette;                   ///< of PALETTE COLOR
    std::optional<PixelPadding> padding{};  ///< of grey pixels, before they are inverted
    std::vector<std::string> notes;         ///< on oddities of the description that were accepted

    [[nodiscard]] std::int64_t pixels() const { return rows * columns; }
    [[nodiscard]] int bytesPerSample() const { return bitsAllocated / 8; }
    /// Bytes of one frame as the file holds it uncompressed in `layout`; in 4:2:2 there are two samples a pixel.
    [[nodiscard]] std::int64_t storedFrameBytes() const;
    [[nodiscard]] StoredType greyType() const;
    /// The smallest and the largest grey value that the stored bits can hold; 0 and 255 with a palette.
    [[nodiscard]] double smallestValue() const;
    [[nodiscard]] double largestValue() const;
};

struct PixelFormatProblem {
    std::string element;  ///< tag and name of the attribute
    std::string text;     ///< what is wrong with it, as in Failure::problem
};
/// Reads the description of the pixels in a data set into `format`. Gives what is wrong, or no value.
[[nodiscard]] std::optional<PixelFormatProblem> readPixelFormat(DcmItem& item, DicomPixelFormat& format);

struct DecodedFrame {
    std::vector<std::uint8_t> bytes;  ///< samples in this machine's byte order
    bool planar = false;
    NativeLayout layout = NativeLayout::full;
    bool rightAligned = false;           ///< the decoder removed unused low bits
    bool narrowRange = false;            ///< as in DicomPixelFormat
    std::optional<ColourModel> model{};  ///< as the codestream says; else that of the data set
};

/// Writes the grey values of `frame`, of type format.greyType(), into `out`, which holds format.pixels() of them.
void toGrey(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out);

/// Makes the pixels of `frame` that hold format.padding NaN in `out`, which holds a float32 for each. Whether any does.
bool blankPadding(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out);

}  // namespace echolucent
