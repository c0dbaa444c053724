// The frames of encapsulated pixel data: found among the fragments, checked, then decoded.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "io/dicom/pixels/dicom_grey.h"

class DcmDataset;
class DcmPixelData;

namespace echolucent {

/// The coding of pixels, as the transfer syntax says.
enum class PixelCoding { native, rle, jpeg, jpegLs, jpeg2000, unknown };

/// The compressed frames of a data set, which must outlive this object. Problems are texts as in Failure::problem,
/// about (7fe0,0010) Pixel Data. An empty text means that nothing is wrong.
class CompressedFrames {
public:
    /// Finds the fragments of each frame. Fails if the pixels are not split into fragments, if the fragments of the
    /// frames cannot be told apart, or if frames are larger than any scanner makes.
    [[nodiscard]] static tl::expected<CompressedFrames, std::string> open(DcmDataset& dataset, DcmPixelData& pixels,
                                                                          const DicomPixelFormat& format,
                                                                          PixelCoding coding);
    CompressedFrames(CompressedFrames&&) noexcept;
    CompressedFrames& operator=(CompressedFrames&&) noexcept;
    ~CompressedFrames();

    /// The bytes of all fragments together.
    [[nodiscard]] std::uint64_t heldBytes() const;
    /// Compares the header of frame `index` (from 0) with the data set, without decoding. Also checks that all of the
    /// frame is there, and that its bytes are enough to hold it. RLE has no such header: of an RLE frame only the
    /// number of bytes is checked.
    [[nodiscard]] std::string check(std::size_t index) const;
    /// Decodes frame `index` (from 0). A JPEG, JPEG-LS or JPEG 2000 frame is wrong if more than a hundredth of its
    /// values do not fit into the declared bits. Fewer are limited and noted.
    [[nodiscard]] std::string decode(std::size_t index, DecodedFrame& frame);
    /// Sentences on errors that were accepted, each once, with the number of decoded frames that it is true of if these
    /// are not all.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct State;
    explicit CompressedFrames(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
