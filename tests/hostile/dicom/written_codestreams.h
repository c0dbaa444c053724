// Codestreams of compressed frames from independent writers. Hostile files damage them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "hostile_file.h"

namespace echolucent {

/// The edge of the square pictures below, in pixels.
constexpr int pictureEdge = 64;

/// The codestream of a picture of pictureEdge x pictureEdge speckled pixels, of 8 bits or of `bits` in 16. Throws
/// std::runtime_error if it cannot be written.
[[nodiscard]] std::string writtenCodestream(const std::string& syntax, int bits = 8);

/// What a cine says about its pictures.
struct CineShape {
    std::uint16_t columns = pictureEdge;
    std::uint16_t rows = pictureEdge;
    std::uint16_t bitsAllocated = 8;
    std::uint16_t bitsStored = 8;
    std::uint16_t sign = 0;
    int frames = 2;
};

/// A cine with these fragments. It is opened with its frames as slices.
[[nodiscard]] HostileFile hostileCine(const std::string& name, const std::string& syntax,
                                      const std::vector<std::string>& fragments, std::vector<std::string> words,
                                      CineShape shape = {}, HostileOutcome outcome = HostileOutcome::refused,
                                      const std::string& offsetTable = "");

/// A cine with these uncompressed pixels, and with `more` elements before them.
[[nodiscard]] HostileFile hostileNativeCine(const std::string& name, const std::string& pixels,
                                            std::vector<std::string> words, CineShape shape,
                                            HostileOutcome outcome = HostileOutcome::refused);

/// A row that opens these bytes with its frames as slices.
[[nodiscard]] HostileFile asSlices(HostileFile row);

/// Elements that describe grey pixels of this shape.
[[nodiscard]] DicomBytes describedCine(const CineShape& shape);

}  // namespace echolucent
