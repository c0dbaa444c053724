#include "io/dicom/pixels/stored_limits.h"

#include <algorithm>
#include <cstring>

namespace echolucent {

namespace {

template <typename T>
std::size_t limit(const DicomPixelFormat& format, std::span<std::uint8_t> samples, int codedBits) {
    const int bits = format.bitsStored;
    const unsigned largest = (1U << bits) - 1;
    const unsigned sign = format.isSigned ? 1U << (bits - 1) : 0;
    const unsigned above = (1U << format.bitsAllocated) - 1 - largest;
    const unsigned codedSign = 1U << (std::clamp(codedBits, bits, format.bitsAllocated) - 1);
    const unsigned codedAbove = above & (2 * codedSign - 1);
    std::size_t limited = 0;
    for (std::size_t at = 0; at + sizeof(T) <= samples.size(); at += sizeof(T)) {
        T sample{};
        std::memcpy(&sample, samples.data() + at, sizeof(T));
        const bool repeatsSign = (sample & sign) != 0 && (sample & codedAbove) == codedAbove;
        if ((sample & above) == 0 || repeatsSign) continue;
        const bool negative = (sample & codedSign) != 0;
        sample = static_cast<T>(sign == 0 ? largest : negative ? sign : sign - 1);
        std::memcpy(samples.data() + at, &sample, sizeof(T));
        ++limited;
    }
    return limited;
}

template <typename T>
std::size_t store(const Jpeg2000Samples& samples, std::int32_t low, std::int32_t high, std::vector<std::uint8_t>& out) {
    std::size_t limited = 0;
    out.resize(samples.values.size() * sizeof(T));
    for (std::size_t i = 0; i < samples.values.size(); ++i) {
        const std::int32_t value = std::clamp(samples.values[i], low, high);
        limited += value != samples.values[i] ? 1 : 0;
        const auto stored = static_cast<T>(value);
        std::memcpy(out.data() + i * sizeof(T), &stored, sizeof(T));
    }
    return limited;
}

}  // namespace

std::size_t limitToStoredBits(const DicomPixelFormat& format, std::span<std::uint8_t> samples, int codedBits) {
    if (format.bitsStored == format.bitsAllocated) return 0;
    return format.bytesPerSample() == 2 ? limit<std::uint16_t>(format, samples, codedBits)
                                        : limit<std::uint8_t>(format, samples, codedBits);
}

std::size_t storeLimited(const DicomPixelFormat& format, const Jpeg2000Samples& samples,
                         std::vector<std::uint8_t>& out) {
    const bool negative = format.isSigned && samples.isSigned;
    const std::int32_t low = negative ? -(1 << (format.bitsStored - 1)) : 0;
    const std::int32_t high = (1 << (negative ? format.bitsStored - 1 : format.bitsStored)) - 1;
    return format.bytesPerSample() == 2 ? store<std::uint16_t>(samples, low, high, out)
                                        : store<std::uint8_t>(samples, low, high, out);
}

}  // namespace echolucent
