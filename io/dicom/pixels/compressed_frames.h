// The frames of encapsulated pixel data: found among the fragments, checked before memory is taken, decoded.
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

/// How pixels are coded, as the transfer syntax says.
enum class PixelCoding { native, rle, jpeg, jpegLs, jpeg2000, unknown };

/// The compressed frames of a data set, which must outlive this object. What is wrong is a text as in Failure::problem,
/// about (7fe0,0010) Pixel Data; an empty text means that nothing is.
class CompressedFrames {
public:
    /// Finds the fragments of each frame. Fails with what is wrong where they cannot be told apart, or where frames are
    /// larger than any scanner makes.
    [[nodiscard]] static tl::expected<CompressedFrames, std::string> open(DcmDataset& dataset, DcmPixelData& pixels,
                                                                          const DicomPixelFormat& format,
                                                                          PixelCoding coding);
    CompressedFrames(CompressedFrames&&) noexcept;
    CompressedFrames& operator=(CompressedFrames&&) noexcept;
    ~CompressedFrames();

    /// How many bytes all fragments hold.
    [[nodiscard]] std::uint64_t heldBytes() const;
    /// Compares the header of frame `index` (from 0) with the data set, and whether all of it is there and can hold the
    /// frame; nothing is decoded.
    [[nodiscard]] std::string check(std::size_t index) const;
    /// Decodes frame `index` (from 0). Values that the declared bits cannot hold are wrong where they are not few.
    [[nodiscard]] std::string decode(std::size_t index, DecodedFrame& frame);
    /// Sentences on what was wrong and read all the same, each once.
    [[nodiscard]] const std::vector<std::string>& notes() const;

private:
    struct State;
    explicit CompressedFrames(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
