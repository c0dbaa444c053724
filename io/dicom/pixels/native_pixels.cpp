#include "io/dicom/pixels/native_pixels.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "io/files/input_file.h"

namespace echolucent {

namespace {

constexpr const char* pixelDataElement = "(7fe0,0010) Pixel Data";
// DICOM counts in 32 bits, so no file holds more.
constexpr std::int64_t mostNativeBytes = 0xfffffffe;

/// The bytes of all frames; no value if they are more than can be counted.
std::optional<std::int64_t> neededBytes(const DicomPixelFormat& format) {
    return checkedProduct(format.storedFrameBytes(), format.frames);
}

/// Whether `held` bytes are just those that `format` needs in this layout, with the byte that makes them even.
bool fitsExactly(DicomPixelFormat format, NativeLayout layout, std::uint64_t held) {
    format.layout = layout;
    const auto needed = neededBytes(format);
    return needed && (held == static_cast<std::uint64_t>(*needed) ||
                      (*needed % 2 != 0 && held == static_cast<std::uint64_t>(*needed) + 1));
}

const char* layoutInWords(NativeLayout layout) {
    switch (layout) {
        case NativeLayout::full: return "4:4:4";
        case NativeLayout::halved: return "4:2:2";
        case NativeLayout::halvedRows: break;
    }
    return "4:2:2 with rows that end in half a pair";
}

/// Takes the layout that the length of YBR pixels says.
void takeLayout(DicomPixelFormat& format, std::uint64_t held) {
    if (format.model != ColourModel::lumaFirst || fitsExactly(format, format.layout, held)) return;
    for (const NativeLayout other : {NativeLayout::halvedRows, NativeLayout::halved, NativeLayout::full}) {
        if (other == format.layout || !fitsExactly(format, other, held)) continue;
        if (other == NativeLayout::halvedRows && format.columns % 2 == 0) continue;
        // Two thirds of the bytes are also what remains if the last of three frames is lost.
        if (format.layout == NativeLayout::full && format.frames % 3 == 0) continue;
        format.notes.push_back(fmt::format(
            "(0028,0004) Photometric Interpretation is {}, but Pixel Data has the length of {}: it was read "
            "as that.",
            format.photometric, layoutInWords(other)));
        format.layout = other;
        return;
    }
}

/// Whether all bytes from `from` on are 0, or all are 255.
bool areBlank(std::uint64_t from, std::uint64_t count, const ReadPixelBytes& read) {
    constexpr std::uint64_t mostAtOnce = 1 << 16;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min(count, mostAtOnce)));
    std::optional<std::uint8_t> first;
    for (std::uint64_t done = 0; done < count; done += bytes.size()) {
        bytes.resize(static_cast<std::size_t>(std::min(count - done, mostAtOnce)));
        if (!read(from + done, bytes)) return false;
        if (!first) first = bytes.front();
        if (*first != 0 && *first != 255) return false;
        if (std::ranges::any_of(bytes, [&](std::uint8_t byte) { return byte != *first; })) return false;
    }
    return true;
}

/// Whether the last `left` bytes of `held` fill up the pixels, so that the size of the picture is not in doubt.
bool isFilling(const DicomPixelFormat& format, std::uint64_t held, std::uint64_t left, const ReadPixelBytes& read) {
    const auto frame = static_cast<std::uint64_t>(format.storedFrameBytes());
    if (left <= std::max<std::uint64_t>(1, frame / 32)) return true;
    if (left >= frame) return false;
    const auto frames = static_cast<std::uint64_t>(format.frames);
    const std::uint64_t row = frame / static_cast<std::uint64_t>(format.rows);
    const std::uint64_t column = frame / static_cast<std::uint64_t>(format.columns);
    // A row that each frame lacks shifts all frames, and the end of the last one may be black all the same.
    if (frames > 1 && (left % (frames * row) == 0 || left % (frames * column) == 0)) return false;
    return areBlank(held - left, left, read);
}

}  // namespace

std::optional<PixelFormatProblem> wrongPixelBytes(DicomPixelFormat& format, std::uint64_t held,
                                                  const ReadPixelBytes& read) {
    if (held == 0) return PixelFormatProblem{pixelDataElement, "is there but empty"};
    takeLayout(format, held);
    const auto needed = neededBytes(format);
    const auto holds = [&] {
        return fmt::format("holds {} bytes where {} x {} pixels in {} frame(s) need {}", held, format.columns,
                           format.rows, format.frames, needed ? std::to_string(*needed) : "more than can be counted");
    };
    if (!needed || static_cast<std::uint64_t>(*needed) > held || *needed > mostNativeBytes)
        return PixelFormatProblem{pixelDataElement, holds()};
    const std::uint64_t left = held - static_cast<std::uint64_t>(*needed);
    // Some writers pad the end. Other bytes mean that the number of rows, columns or frames is false.
    if (!isFilling(format, held, left, read))
        return PixelFormatProblem{pixelDataElement, holds() + ", so that it cannot be told what the picture's size is"};
    if (left > 1)
        format.notes.push_back(
            fmt::format("The last {} bytes of (7fe0,0010) Pixel Data belong to no pixel; they were left out.", left));
    if (format.layout != NativeLayout::full && format.planar) {
        format.planar = false;
        format.notes.emplace_back(
            "(0028,0006) Planar Configuration is 1, which 4:2:2 cannot have: the samples were read as pairs of "
            "pixels.");
    }
    if (format.narrowRange && format.bitsStored == 8)
        format.notes.push_back(format.photometric + " has luma from 16 to 235; it was stretched to 0 to 255.");
    return std::nullopt;
}

}  // namespace echolucent
