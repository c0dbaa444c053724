#include "io/dicom/pixels/dicom_rle.h"

#include <fmt/format.h>

#include "io/dicom/elements/fragment_coding.h"

namespace echolucent {

namespace {

/// Unpacks one segment into every stride-th byte of `out`. Returns how many bytes it gave (at most `pixels`).
std::size_t unpackSegment(std::span<const std::uint8_t> data, std::size_t pixels, std::size_t stride,
                          std::uint8_t* out) {
    std::size_t done = 0;
    std::size_t position = 0;
    while (done < pixels && position + 1 < data.size()) {
        const int control = static_cast<std::int8_t>(data[position++]);
        if (control == -128) continue;
        const std::size_t count = static_cast<std::size_t>(control >= 0 ? control + 1 : 1 - control);
        for (std::size_t i = 0; i < count && done < pixels && position < data.size(); ++i, ++done)
            out[done * stride] = data[control >= 0 ? position++ : position];
        if (control < 0) ++position;
    }
    return done;
}

}  // namespace

std::string rleTooShort(std::size_t bytes, std::size_t pixels, int samples, int bytesPerSample) {
    if (bytes < 64) return fmt::format("has an RLE frame of {} bytes, shorter than its header", bytes);
    const std::size_t needed = static_cast<std::size_t>(samples * bytesPerSample) * 2 * ((pixels + 127) / 128);
    if (bytes - 64 >= needed) return {};
    return fmt::format("has an RLE frame of {} bytes for {} pixels, which cannot be", bytes, pixels);
}

int rleBytesPerSample(std::span<const std::uint8_t> data, int samples, int bytesPerSample) {
    if (data.size() < 64) return bytesPerSample;
    const std::uint32_t segments = littleEndian32(data);
    for (const int bytes : {1, 2})
        if (segments == static_cast<std::uint32_t>(samples * bytes)) return bytes;
    return bytesPerSample;
}

std::string decodeRle(std::span<const std::uint8_t> data, std::size_t pixels, int samples, int bytesPerSample,
                      std::span<std::uint8_t> out) {
    if (data.size() < 64) return fmt::format("has an RLE frame of {} bytes, shorter than its header", data.size());
    const auto segments = static_cast<std::uint32_t>(samples * bytesPerSample);
    if (littleEndian32(data) != segments)
        return fmt::format("has an RLE frame of {} segments where {} belong to it", littleEndian32(data), segments);
    const std::size_t width = static_cast<std::size_t>(bytesPerSample);
    for (std::uint32_t segment = 0; segment < segments; ++segment) {
        const std::uint32_t start = littleEndian32(data.subspan(4 + 4 * segment));
        const std::uint32_t end = segment + 1 < segments ? littleEndian32(data.subspan(8 + 4 * segment))
                                                         : static_cast<std::uint32_t>(data.size());
        if (start < 64 || end > data.size() || start > end) return "has an RLE frame with wrong segment offsets";
        const std::size_t sample = segment / width;
        const std::size_t byte = width - 1 - segment % width;  // the most significant byte comes first
        std::uint8_t* plane = out.data() + sample * pixels * width + byte;
        const std::size_t unpacked = unpackSegment(data.subspan(start, end - start), pixels, width, plane);
        if (unpacked < pixels) return fmt::format("has an RLE frame that ends after {} of {} pixels", unpacked, pixels);
    }
    return {};
}

}  // namespace echolucent
