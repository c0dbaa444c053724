// Puts DICOM files together byte by byte, so that a test can write what no library would.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace echolucent {

/// The transfer syntax of data sets that are deflated as a whole.
inline const std::string deflatedSyntax = "1.2.840.10008.1.2.1.99";
inline const std::string rleSyntax = "1.2.840.10008.1.2.5";
inline const std::string jpegSyntax = "1.2.840.10008.1.2.4.50";
inline const std::string jpegLosslessSyntax = "1.2.840.10008.1.2.4.70";
inline const std::string jpegLsSyntax = "1.2.840.10008.1.2.4.80";
inline const std::string jpeg2000Syntax = "1.2.840.10008.1.2.4.90";

/// The SOP classes of ultrasound: many frames, and one picture.
inline const std::string cineClass = "1.2.840.10008.5.1.4.1.1.3.1";
inline const std::string pictureClass = "1.2.840.10008.5.1.4.1.1.6.1";

/// Elements in explicit VR, little endian, in the order in which they are put.
class DicomBytes {
public:
    /// If `length` is given, it is written in place of the value's own.
    DicomBytes& put(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value,
                    std::int64_t length = -1);
    DicomBytes& text(std::uint16_t group, std::uint16_t element, const std::string& vr, std::string value);
    DicomBytes& word(std::uint16_t group, std::uint16_t element, std::uint16_t value);
    DicomBytes& real(std::uint16_t group, std::uint16_t element, double value);
    /// A sequence of items, all of defined length; `length` as in put().
    DicomBytes& sequence(std::uint16_t group, std::uint16_t element, const std::vector<DicomBytes>& items,
                         std::int64_t length = -1);
    /// Encapsulated Pixel Data: the offset table, fragments, and, if `closed`, the delimiter.
    DicomBytes& fragments(const std::string& offsetTable, const std::vector<std::string>& fragments,
                          bool closed = true);
    /// Grey pixels of 8 or 16 bits and their size.
    DicomBytes& picture(std::uint16_t columns, std::uint16_t rows, int frames, std::uint16_t bits = 8);

    [[nodiscard]] const std::string& bytes() const { return m_bytes; }
    /// The file of these elements, with preamble and meta header.
    [[nodiscard]] std::string file(const std::string& sopClass,
                                   const std::string& transferSyntax = "1.2.840.10008.1.2.1") const;

private:
    std::string m_bytes;
};

/// A picture of two frames of 4 x 2 pixels with a geometry, which opens.
[[nodiscard]] DicomBytes twoFrames();

/// A DICOMDIR whose records name these files; each record links to itself.
[[nodiscard]] std::string dicomDirectory(const std::vector<std::string>& names);

/// An item's tag and length in front of these bytes, as fragments are stored.
[[nodiscard]] std::string dicomItem(const std::string& bytes);

}  // namespace echolucent
