// From the samples of a decoded DICOM frame to grey values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/pixels/dicom_palette.h"
#include "io/voxels/voxel_types.h"

class DcmItem;

namespace echolucent {

enum class ColourModel { monochrome1, monochrome2, palette, rgb, lumaFirst };

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
    bool planar = false;  ///< samples plane by plane instead of pixel by pixel
    bool halved = false;  ///< uncompressed 4:2:2, where Y Y Cb Cr stand for two pixels
    ColourModel model = ColourModel::monochrome2;
    std::string photometric;
    DicomPalette palette;            ///< of PALETTE COLOR
    std::vector<std::string> notes;  ///< on oddities of the description that were accepted

    [[nodiscard]] std::int64_t pixels() const { return rows * columns; }
    [[nodiscard]] int bytesPerSample() const { return bitsAllocated / 8; }
    /// Bytes of one frame as DCMTK or the file holds it uncompressed; in 4:2:2 there are two samples a pixel.
    [[nodiscard]] std::int64_t storedFrameBytes() const { return pixels() * bytesPerSample() * (halved ? 2 : samples); }
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

/// What is wrong if `held` bytes of uncompressed pixels are too few for `format`, or too many; else no value. Left over
/// may be up to a 32nd of a frame, at least one byte. If more than one byte is left over, a note is added to `format`.
[[nodiscard]] std::optional<PixelFormatProblem> wrongPixelBytes(DicomPixelFormat& format, std::uint64_t held);

struct DecodedFrame {
    std::vector<std::uint8_t> bytes;  ///< samples in this machine's byte order
    bool planar = false;
    bool halved = false;
    bool rightAligned = false;  ///< the decoder removed unused low bits
    bool lumaFirst = false;     ///< the first sample is luma, whatever the data set says
};

/// Writes the grey values of `frame`, of type format.greyType(), into `out`, which holds format.pixels() of them.
void toGrey(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out);

}  // namespace echolucent
