#include "io/dicom/series/picture_moments.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/date_times.h"

namespace echolucent {

namespace {

std::optional<double> timeOn(DcmItem& dataset, DicomTag dateTag, DicomTag timeTag) {
    const auto time = secondsOfDay(dicomText(dataset, timeTag));
    if (!time) return std::nullopt;
    return *time + secondsOfADay * daysOfDate(dicomText(dataset, dateTag)).value_or(0.0);
}

}  // namespace

PictureMoments momentsOf(DcmItem& dataset) {
    PictureMoments moments;
    moments.values = {dicomNumber(dataset, {0x0020, 0x0100}),
                      dicomNumber(dataset, {0x0020, 0x9128}),
                      dicomNumber(dataset, {0x0018, 0x1060}),
                      dicomNumber(dataset, {0x0020, 0x9153}),
                      dicomNumber(dataset, {0x0020, 0x9241}),
                      dicomNumber(dataset, {0x0020, 0x9245}),
                      dicomNumber(dataset, {0x0054, 0x1300}),
                      secondsOfDateTime(dicomText(dataset, {0x0008, 0x002a})),
                      timeOn(dataset, {0x0008, 0x0022}, {0x0008, 0x0032}),
                      timeOn(dataset, {0x0008, 0x0023}, {0x0008, 0x0033}),
                      dicomNumber(dataset, {0x0020, 0x0012}),
                      dicomNumber(dataset, {0x0054, 0x1330})};
    if (const auto milliseconds = dicomNumber(dataset, {0x0020, 0x0110}); milliseconds && *milliseconds > 0)
        moments.resolution = *milliseconds / 1000;
    constexpr std::array kinds{
        DicomTag{0x0008, 0x0008},  // Image Type
        DicomTag{0x0018, 0x0081},  // Echo Time
        DicomTag{0x0018, 0x0086},  // Echo Numbers
        DicomTag{0x0018, 0x0082},  // Inversion Time
        DicomTag{0x0018, 0x0080},  // Repetition Time
        DicomTag{0x0018, 0x1314},  // Flip Angle
        DicomTag{0x0018, 0x1210},  // Convolution Kernel
        DicomTag{0x0018, 0x0060},  // KVP
        DicomTag{0x0018, 0x9087},  // Diffusion b-value
        DicomTag{0x0018, 0x9089},  // Diffusion Gradient Orientation
    };
    constexpr std::size_t longestPart = 200;
    for (const DicomTag tag : kinds) moments.kind += dicomText(dataset, tag).substr(0, longestPart) + "|";
    return moments;
}

}  // namespace echolucent
