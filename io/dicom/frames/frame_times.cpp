#include "io/dicom/frames/frame_times.h"

#include <utility>

namespace echolucent {

namespace {

constexpr DicomTag frameTimeTag{0x0018, 0x1063};
constexpr DicomTag frameTimeVectorTag{0x0018, 0x1065};
constexpr DicomTag cineRateTag{0x0018, 0x0040};
constexpr DicomTag displayRateTag{0x0008, 0x2144};

/// The only number of an attribute if it is above 0.
std::optional<double> aboveZero(DcmItem& item, DicomTag tag) {
    const auto value = dicomNumber(item, tag);
    return value && *value > 0 ? value : std::nullopt;
}

/// The vector holds the milliseconds from each frame to the next; its first number is 0, as there is no frame before.
std::optional<DicomTimes> timesOfVector(DcmItem& item, std::size_t count) {
    const auto steps = dicomNumbers(item, frameTimeVectorTag, count);
    if (steps.empty()) return std::nullopt;
    DicomTimes times{{0.0}, tagText(frameTimeVectorTag) + " Frame Time Vector"};
    for (std::size_t i = 1; i < count; ++i) {
        if (!(steps[i] > 0)) return std::nullopt;
        times.seconds.push_back(times.seconds.back() + steps[i] / 1000);
    }
    return times;
}

}  // namespace

bool framesFollowInTime(DcmItem& dataset) {
    return namesAsIncrement(dataset, frameTimeTag) || namesAsIncrement(dataset, frameTimeVectorTag);
}

bool statesFrameTime(DcmItem& dataset) {
    return aboveZero(dataset, frameTimeTag) || aboveZero(dataset, cineRateTag) ||
           !dicomText(dataset, frameTimeVectorTag).empty();
}

bool namesAsIncrement(DcmItem& dataset, DicomTag tag) {
    return dicomText(dataset, incrementPointerTag).find(tagText(tag)) != std::string::npos;
}

DicomTimes evenTimes(double step, std::size_t count, std::string source) {
    DicomTimes times{{}, std::move(source)};
    for (std::size_t i = 0; i < count; ++i) times.seconds.push_back(step * static_cast<double>(i));
    return times;
}

std::optional<DicomTimes> statedFrameTimes(DcmItem& item, std::size_t count) {
    const auto step = aboveZero(item, frameTimeTag);
    if (!step || !namesAsIncrement(item, frameTimeTag))
        if (auto times = timesOfVector(item, count)) return times;
    if (!step) return std::nullopt;
    return evenTimes(*step / 1000, count, tagText(frameTimeTag) + " Frame Time");
}

std::optional<DicomTimes> statedFrameRate(DcmItem& item, std::size_t count) {
    if (const auto rate = aboveZero(item, cineRateTag))
        return evenTimes(1 / *rate, count, tagText(cineRateTag) + " Cine Rate");
    if (const auto rate = aboveZero(item, displayRateTag))
        return evenTimes(1 / *rate, count, tagText(displayRateTag) + " Recommended Display Frame Rate");
    return std::nullopt;
}

}  // namespace echolucent
