// From the samples of a decoded DICOM frame to grey values.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/voxel_types.h"

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
    bool halved = false;  ///< uncompressed 4:2:2: Y Y Cb Cr for two pixels
    ColourModel model = ColourModel::monochrome2;
    std::string photometric;
    std::vector<std::uint8_t> paletteLuma;  ///< luma of each entry
    std::int64_t paletteFirst = 0;          ///< pixel value of the first entry

    [[nodiscard]] std::int64_t pixels() const { return rows * columns; }
    [[nodiscard]] int bytesPerSample() const { return bitsAllocated / 8; }
    /// Bytes of one frame as DCMTK or the file hold it (4:2:2 included).
    [[nodiscard]] std::int64_t storedFrameBytes() const { return pixels() * bytesPerSample() * (halved ? 2 : samples); }
    [[nodiscard]] StoredType greyType() const;
    [[nodiscard]] double whiteLevel() const;
};

/// Reads the description; `problem` holds a failure's element and text.
struct PixelFormatProblem {
    std::string element;
    std::string text;
};
[[nodiscard]] std::optional<PixelFormatProblem> readPixelFormat(DcmItem& item, DicomPixelFormat& format);

/// One decoded frame.
struct DecodedFrame {
    std::vector<std::uint8_t> bytes;  ///< samples in this machine's byte order
    bool planar = false;
    bool halved = false;
    bool rightAligned = false;  ///< decoders have removed unused low bits already
    bool lumaFirst = false;     ///< the first sample is luma, whatever the data set says
};

/// Grey values of the frame into `out`.
void toGrey(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out);

}  // namespace echolucent
