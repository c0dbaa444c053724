// The small pictures in the list of series.
#include <algorithm>
#include <cmath>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/frame_layout.h"
#include "io/dicom/pixels/dicom_pixels.h"
#include "io/dicom/series/large_stack.h"
#include "io/dicom/volumes/philips_volume.h"
#include "io/files/input_file.h"
#include "io/study/series_list.h"
#include "io/voxels/typed_bytes.h"

namespace echolucent {

namespace {

/// Larger pictures are not reduced. No scanner makes them, and each of their pixels would take up to 12 bytes on the
/// way.
constexpr std::int64_t mostPixels = std::int64_t{1} << 24;

double valueAt(const GreySlice& slice, std::size_t index) {
    return withStoredType(slice.type,
                          [&]<typename T>(T) { return static_cast<double>(storedAt<T>(slice.bytes, index)); });
}

/// Each pixel of the small picture is the mean of the data that fall into it, or black. The largest mean becomes white.
SmallPicture reduced(const GreySlice& slice, int longestEdge) {
    SmallPicture small;
    const std::int64_t columns = slice.columns, rows = slice.rows;
    const double factor = std::min(1.0, longestEdge / static_cast<double>(std::max(columns, rows)));
    small.width = std::max(1, static_cast<int>(std::lround(factor * static_cast<double>(columns))));
    small.height = std::max(1, static_cast<int>(std::lround(factor * static_cast<double>(rows))));
    std::vector<double> sums(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    std::vector<double> counts(sums.size());
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column) {
            const auto place =
                static_cast<std::size_t>(row * small.height / rows * small.width + column * small.width / columns);
            const double value = valueAt(slice, static_cast<std::size_t>(row * columns + column));
            if (!std::isfinite(value)) continue;
            sums[place] += value;
            counts[place] += 1.0;
        }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= std::max(1.0, counts[i]);
    const double white = *std::max_element(sums.begin(), sums.end());
    small.grey.resize(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        small.grey[i] = white > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::max(0.0, sums[i]) / white)) : 0;
    return small;
}

Result<void> requireSmall(const std::string& path, std::int64_t columns, std::int64_t rows) {
    const auto pixels = checkedProduct(columns, rows);
    if (pixels && *pixels <= mostPixels) return {};
    return fail(FailureKind::unreadable, path, "",
                fmt::format("has slices of {} x {} pixels, which are not shown small", columns, rows), "Open it.");
}

/// The frame in the middle of the volume; if the frames are no volume, the one in the middle of the file.
std::int64_t middleFrame(const DicomFile& file, const DicomFrames& frames, const Progress& progress) {
    if (frames.frames() < 2) return 0;
    const auto layout =
        layOutFrames(file.dataset(), file.path(),
                     {static_cast<std::size_t>(frames.frames()), frames.columns(), frames.rows()}, progress);
    if (!layout) return frames.frames() / 2;
    const std::vector<std::size_t>& slices = layout->phases.front();
    return static_cast<std::int64_t>(slices[slices.size() / 2]);
}

/// The file in the middle if it is readable, else the next readable one behind it, else the first readable one. If none
/// is readable, the file in the middle.
const SeriesFile& middleFile(const SeriesEntry& entry) {
    const auto isWhole = [](const SeriesFile& file) { return !file.damage; };
    const auto middle = entry.files.begin() + static_cast<std::ptrdiff_t>(entry.files.size() / 2);
    const auto behind = std::find_if(middle, entry.files.end(), isWhole);
    if (behind != entry.files.end()) return *behind;
    const auto before = std::find_if(entry.files.begin(), middle, isWhole);
    return before != middle ? *before : *middle;
}

Result<GreySlice> readMiddle(const SeriesEntry& entry, const Progress& progress) {
    const SeriesFile& middle = middleFile(entry);
    const auto input = InputFile::open(middle.path);
    if (!input) return tl::unexpected(input.error());
    const auto file = DicomFile::load(*input, false, progress);
    if (!file) return tl::unexpected(file.error());
    const auto philips = philipsVolumeOf(*file);
    if (!philips && !philips.error().framesCouldBeSlices) return tl::unexpected(philips.error());
    if (philips && *philips) {
        const auto& size = (*philips)->size;
        if (auto small = requireSmall(middle.path, size[0], size[1]); !small) return tl::unexpected(small.error());
        return readPhilipsSlice(*input, *file, **philips, size[2] / 2, progress);
    }
    auto frames = DicomFrames::open(file->dataset(), file->path(), file->scan());
    if (!frames) return tl::unexpected(frames.error());
    if (auto small = requireSmall(middle.path, frames->columns(), frames->rows()); !small)
        return tl::unexpected(small.error());
    GreySlice slice{frames->columns(), frames->rows(), frames->type(), {}};
    slice.bytes.resize(static_cast<std::size_t>(frames->frameBytes()));
    if (const auto read = frames->readGrey(middleFrame(*file, *frames, progress), slice.bytes); !read)
        return tl::unexpected(read.error());
    return slice;
}

}  // namespace

Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge, const Progress& progress) {
    Result<GreySlice> slice = fail(FailureKind::unreadable, entry.files.front().path, "", "was not read");
    runWithLargeStack([&] { slice = readMiddle(entry, progress); });
    if (!slice) return tl::unexpected(slice.error());
    return reduced(*slice, longestEdge);
}

}  // namespace echolucent
