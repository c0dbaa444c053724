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

/// How the pixels of a data set are described.
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
    std::vector<std::string> notes;  ///< on what is odd in the description and was read all the same

    [[nodiscard]] std::int64_t pixels() const { return rows * columns; }
    [[nodiscard]] int bytesPerSample() const { return bitsAllocated / 8; }
    /// Bytes of one frame as DCMTK or the file hold it; 4:2:2 is taken into account.
    [[nodiscard]] std::int64_t storedFrameBytes() const { return pixels() * bytesPerSample() * (halved ? 2 : samples); }
    /// The type that grey values of these pixels have.
    [[nodiscard]] StoredType greyType() const;
    /// The smallest and the largest grey value that the stored bits can hold.
    [[nodiscard]] double smallestValue() const;
    [[nodiscard]] double largestValue() const;
};

/// What is wrong with a description of pixels.
struct PixelFormatProblem {
    std::string element;  ///< tag and name of the attribute
    std::string text;     ///< what is wrong with it, as in Failure::problem
};
/// Reads the description of the pixels in a data set into `format`; gives what is wrong, or no value.
[[nodiscard]] std::optional<PixelFormatProblem> readPixelFormat(DcmItem& item, DicomPixelFormat& format);

/// What is wrong where `held` bytes of uncompressed pixels are too few for that description, or too many by
/// more than a 32nd of a frame; else no value. Where fewer are left over, but for one, a note is added to `format`.
[[nodiscard]] std::optional<PixelFormatProblem> wrongPixelBytes(DicomPixelFormat& format, std::uint64_t held);

/// One decoded frame.
struct DecodedFrame {
    std::vector<std::uint8_t> bytes;  ///< samples in this machine's byte order
    bool planar = false;
    bool halved = false;
    bool rightAligned = false;  ///< decoders have removed unused low bits already
    bool lumaFirst = false;     ///< the first sample is luma, whatever the data set says
};

/// Writes the grey values of `frame`, of type format.greyType(), into `out`, which holds format.pixels() of them.
void toGrey(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out);

}  // namespace echolucent
