// A DICOM file as a tree of elements that may be wrong: false parts are kept and written as they are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace echolucent {

struct DicomElementBytes;

/// An item of a sequence.
struct DicomItemBytes {
    std::vector<DicomElementBytes> elements;
    bool delimited = false;                      ///< whether it has no length but a delimiter
    bool closed = true;                          ///< whether a needed delimiter is there
    std::optional<std::uint32_t> falseLength{};  ///< written in place of the true length
};

/// One element. Sequences hold items, encapsulated pixels fragments, all others a value.
struct DicomElementBytes {
    std::uint32_t tag = 0;                       ///< group in the upper half
    std::string vr;                              ///< two letters
    std::string value;                           ///< if it is neither a sequence nor in fragments
    std::vector<DicomItemBytes> items{};         ///< of a sequence
    std::vector<std::string> fragments{};        ///< of encapsulated pixels, the offset table first
    bool sequence = false;                       ///< whether `items` counts
    bool encapsulated = false;                   ///< whether `fragments` counts
    bool delimited = false;                      ///< whether a sequence has no length but a delimiter
    bool closed = true;                          ///< whether a needed delimiter is there
    std::optional<std::uint32_t> falseLength{};  ///< written in place of the true length
};

/// A file. Only little-endian files are taken apart.
struct DicomFileBytes {
    std::string preamble;                     ///< 132 bytes, or none
    std::vector<DicomElementBytes> meta;      ///< explicit VR, group 2
    std::vector<DicomElementBytes> elements;  ///< the data set
    bool implicit = false;                    ///< whether the data set is in implicit VR
    bool deflated = false;                    ///< whether the data set is deflated
    std::string rest;                         ///< what could not be taken apart; never deflated
};

/// Takes a file apart as far as it can be.
[[nodiscard]] DicomFileBytes dicomParts(const std::string& bytes);
/// Puts the file together. Lengths are true unless a false one is set.
[[nodiscard]] std::string dicomBytes(const DicomFileBytes& file);

}  // namespace echolucent
