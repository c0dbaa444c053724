// Small DICOM files for the readers, written by DCMTK, an independent writer.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

enum class TestSyntax {
    implicitLittle,
    explicitLittle,
    explicitBig,
    deflated,
    rle,
    jpegLossless,
    jpegBaseline,
    jpegLs
};

struct TestPalette {
    std::vector<std::uint16_t> red, green, blue;
    int first = 0;
    int bits = 16;
};

/// One frame's place in functional groups.
struct TestFrame {
    Vec3 position{0, 0, 0};
    std::optional<double> seconds{};
    std::string dataType{};
};

/// What a test may want to say in a DICOM file.
struct TestImage {
    int columns = 4;
    int rows = 3;
    int frames = 0;  ///< 0 if there is no Number of Frames
    int samples = 1;
    int bitsAllocated = 8;
    int bitsStored = 8;
    bool isSigned = false;
    int planar = 0;
    std::string photometric = "MONOCHROME2";
    std::string series = "1.2.3";
    int instance = 1;
    std::vector<std::uint8_t> pixels8;
    std::vector<std::uint16_t> pixels16;
    std::optional<Vec3> position;
    std::optional<std::array<double, 6>> orientation;
    std::optional<std::array<double, 2>> pixelSpacing;  ///< as in the tag: between rows, between columns
    std::string pixelSpacingText;                       ///< Pixel Spacing as in the file, in place of pixelSpacing
    std::optional<double> spacingBetweenSlices;
    std::vector<double> gridOffsets;
    std::vector<TestFrame> functionalGroups;  ///< Enhanced US Volume: positions in the volume frame
    bool patientFrame = false;                ///< whether it is Plane Position (Patient) instead
    std::optional<TestPalette> palette;
    std::string lossyImageCompression;           ///< as text, if not empty
    std::string burnedInAnnotation;              ///< as text, if not empty
    std::string windowCentre, windowWidth;       ///< as text, if not empty
    std::string rescaleSlope, rescaleIntercept;  ///< as text, if not empty
    std::optional<int> padding, paddingLimit;    ///< Pixel Padding Value and Range Limit; unsigned if above 32767
    std::string lutFunction;                     ///< VOI LUT Function, if not empty
    bool windowInGroups = false;                 ///< whether window and rescaling stand in the shared functional groups
    bool frameTime = false;                      ///< whether the file says that frames follow each other in time
};

/// Makes the image a slice of a stack along z: single, at `zMm`, with square pixels of `pixelMm`.
void makeSlice(TestImage& image, double zMm, double pixelMm);

/// Throws std::runtime_error if DCMTK cannot write it.
void writeDicom(const std::string& path, const TestImage& image, TestSyntax syntax = TestSyntax::explicitLittle);

/// The first frame of the image as it stands in a file of this encapsulated syntax. Throws as writeDicom() does.
[[nodiscard]] std::string codedFrame(const TestImage& image, TestSyntax syntax);

/// Baseline JPEG of a frame of red, green and blue, as luma and colour differences of as many samples.
[[nodiscard]] std::string codedFullChroma(const TestImage& image);

/// One frame for codedJpeg2000().
struct TestPlanes {
    int columns = 8, rows = 8;
    int bits = 8;
    bool isSigned = false;
    bool transform = false;  ///< whether the encoder turns red, green and blue into luma and colour differences first
    std::vector<std::vector<int>> planes;  ///< one for each sample
};
/// The lossless JPEG 2000 codestream of a frame. Throws std::runtime_error if it cannot be written.
[[nodiscard]] std::string codedJpeg2000(const TestPlanes& frame);

/// An explicit little-endian file with sequences nested `depth` deep, written by hand. Defined lengths, if asked for,
/// are false (too short), but a parser enters them.
[[nodiscard]] std::string nestedDicom(int depth, bool implicitVr);

/// One grey 8-bit JPEG 2000 frame as a multi-frame file of two equal frames.
void writeJpeg2000Dicom(const std::string& path, int columns, int rows, const std::vector<std::uint8_t>& pixels);

}  // namespace echolucent
