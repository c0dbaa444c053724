// Small DICOM images that tests change in one place, and the result of reading them.
#pragma once

#include <cstddef>
#include <string>

#include "dicom_files.h"
#include "temporary_folder.h"

namespace echolucent {

/// A slice of 4 x 3 pixels of 7, upright, at this place of the patient, mm.
inline TestImage sliceAt(const Vec3& position) {
    TestImage image;
    image.pixels8.assign(12, 7);
    image.position = position;
    image.orientation = {1, 0, 0, 0, 1, 0};
    image.pixelSpacing = {0.5, 0.25};
    return image;
}

/// Frames of 4 x 3 pixels of 7.
inline TestImage cineOf(int frames) {
    TestImage image;
    image.frames = frames;
    image.pixels8.assign(12 * static_cast<std::size_t>(frames), 7);
    image.pixelSpacing = {0.5, 0.25};
    return image;
}

/// Writes three upright slices of one series, 1.5 mm apart, as 0.dcm to 2.dcm; gives the last of them.
inline TestImage writeThreeSlices(const TemporaryFolder& folder) {
    TestImage slice;
    slice.orientation = {1, 0, 0, 0, 1, 0};
    slice.pixels8.assign(12, 7);
    for (int i = 0; i < 3; ++i) {
        slice.instance = i + 1;
        slice.position = Vec3{0, 0, 1.5 * i};
        writeDicom(folder.file(std::to_string(i) + ".dcm"), slice);
    }
    return slice;
}

/// Writes the image in a transfer syntax and reads it.
inline Result<Study> writtenAndRead(const TestImage& image, const ReadOptions& options = withoutGuess(),
                                    TestSyntax syntax = TestSyntax::explicitLittle) {
    const TemporaryFolder folder;
    writeDicom(folder.file("a.dcm"), image, syntax);
    return readStudy(folder.file("a.dcm"), options);
}

}  // namespace echolucent
