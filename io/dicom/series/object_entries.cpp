#include "io/dicom/series/object_entries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/frames/frame_layout.h"
#include "io/dicom/series/slice_groups.h"
#include "io/dicom/volumes/joined_parts.h"
#include "io/files/files_below.h"

namespace echolucent {

namespace {

/// Why the joined parts are no volume, as far as their headers tell.
std::optional<Failure> whyPartsAreNoVolume(const SeriesEntry& entry, const Progress& progress) {
    std::vector<std::string> paths;
    for (const SeriesFile& file : entry.files) paths.push_back(file.path);
    const auto header = joinedHeader(paths, progress);
    if (!header) return header.error();
    if (entry.size[2] < 2) return singlePicture(paths.front()).value();
    const auto layout = layOutFrames(header->dataset(), paths.front(),
                                     {static_cast<std::size_t>(entry.size[2]), entry.size[0], entry.size[1]}, progress);
    return layout ? std::nullopt : std::optional(layout.error());
}

/// The entry of an object that is kept in these files.
SeriesEntry joined(const std::string& folder, Images parts, const Progress& progress) {
    std::vector<PartFile> files;
    for (const ImageHeader& part : parts) files.push_back({part.file.path, *part.part});
    const auto arranged = arrangeParts(folder, files);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < parts.size(); ++i) order.push_back(arranged ? arranged->order[i] : i);
    SeriesEntry entry = entryOf(parts[order.front()]);
    entry.multiframe = true;
    entry.size[2] = 0;
    for (const std::size_t index : order) {
        ImageHeader& part = parts[index];
        entry.size[2] += part.part->frames;
        if (!entry.whyNot && part.whyNot) entry.whyNot = part.whyNot;
        if (!entry.whyNot && contradict(parts[order.front()], part))
            entry.whyNot = fail(FailureKind::unreadable, folder, "(0020,9161) Concatenation UID",
                                fmt::format("is the same in files of different patients, sizes or places, {}",
                                            filesInWords({parts[order.front()].file.path, part.file.path})),
                                "Keep the parts of one object in the folder.")
                               .value();
        entry.files.push_back(part.file);
    }
    if (!arranged) {
        entry.whyNot = arranged.error();
        return entry;
    }
    entry.notes = arranged->notes;
    if (entry.files.size() > 1)
        entry.notes.insert(
            entry.notes.begin(),
            fmt::format("{} files are the parts of one object (a concatenation) and were joined.", entry.files.size()));
    if (!entry.whyNot) entry.whyNot = whyPartsAreNoVolume(entry, progress);
    return entry;
}

}  // namespace

std::vector<SeriesEntry> objectEntries(const std::string& folder, Images images, LeftOutCopies& copies,
                                       const Progress& progress) {
    const FoundCopies found = dropCopies(images, progress);
    copies.add(found.dropped);
    std::ranges::stable_sort(images, {}, [](const ImageHeader& image) { return image.file.path; });
    std::vector<SeriesEntry> entries;
    std::map<std::string, Images> parts;
    for (ImageHeader& image : images) {
        if (image.part) {
            parts[image.part->whole].push_back(std::move(image));
            continue;
        }
        SeriesEntry entry = entryOf(image);
        if (found.contradiction && image.object == found.contradicting) entry.whyNot = found.contradiction;
        entry.files.push_back(std::move(image.file));
        entries.push_back(std::move(entry));
    }
    for (auto& [whole, own] : parts) {
        const bool contradicts = std::ranges::any_of(
            own, [&](const ImageHeader& part) { return found.contradiction && part.object == found.contradicting; });
        SeriesEntry entry = joined(folder, std::move(own), progress);
        if (contradicts) entry.whyNot = found.contradiction;
        entries.push_back(std::move(entry));
    }
    return entries;
}

}  // namespace echolucent
