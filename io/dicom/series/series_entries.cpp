#include "io/dicom/series/series_entries.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/dicom/series/copies.h"
#include "io/dicom/series/joined_series.h"
#include "io/dicom/series/object_entries.h"
#include "io/files/files_below.h"

namespace echolucent {

namespace {

/// Gives each damaged slice to the one group that it can belong to. Gives back the files that can belong to none or to
/// several groups.
std::vector<DamagedFile> giveToGroups(std::vector<DamagedFile> damaged,
                                      std::map<std::string, std::vector<SliceGroup>>& series) {
    constexpr std::size_t mostGroups = 16;  // among more, no slice's group is certain
    std::vector<DamagedFile> others;
    for (DamagedFile& one : damaged) {
        const bool slice = one.header && one.header->file.plane && one.header->frames == 1;
        const auto own = slice ? series.find(one.header->series) : series.end();
        std::vector<SliceGroup*> fitting;
        if (own != series.end() && own->second.size() <= mostGroups)
            for (SliceGroup& group : own->second)
                if (!contradict(group.images.front(), *one.header)) fitting.push_back(&group);
        (fitting.size() == 1 ? fitting.front()->damaged : others).push_back(std::move(one));
    }
    return others;
}

/// Gives entries that share a Series Instance UID different names.
void nameApart(std::vector<SeriesEntry>& entries) {
    std::set<std::string> taken;
    std::map<std::string, int> times;  // keeps the counts, as counting anew would be quadratic
    for (SeriesEntry& entry : entries) {
        if (entry.uid.empty()) entry.uid = "unnamed";
        if (taken.insert(entry.uid).second) continue;
        if (entry.multiframe && !entry.object.empty())
            entry.uid = entry.object;
        else
            entry.uid += fmt::format(":{}x{}", entry.size[0], entry.size[1]);
        if (taken.insert(entry.uid).second) continue;
        const std::string name = entry.uid;
        int& again = times.emplace(name, 1).first->second;
        do entry.uid = fmt::format("{}:{}", name, ++again);
        while (!taken.insert(entry.uid).second);
    }
}

/// Warns of series whose pictures are listed apart, one sentence for each of the first few.
void sayApart(const std::vector<std::vector<std::string>>& reasons, std::vector<std::string>& warnings) {
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(most, reasons.size()); ++i)
        warnings.push_back(
            fmt::format("Pictures of the same Series Instance UID, or of none, are of {}; they are listed apart.",
                        fmt::join(reasons[i], " and of ")));
    if (reasons.size() > most)
        warnings.push_back(fmt::format("{} more series are listed apart in this way.", reasons.size() - most));
}

/// Slices of each Series Instance UID in groups that may be volumes, without copies.
std::map<std::string, std::vector<SliceGroup>> groupSlices(std::map<std::string, Images> slices, LeftOutCopies& copies,
                                                           std::vector<std::string>& warnings,
                                                           const Progress& progress) {
    std::map<std::string, std::vector<SliceGroup>> series;
    std::vector<std::vector<std::string>> reasons;
    for (auto& [uid, own] : slices) {
        Apart apart = listApart(std::move(own));
        if (apart.groups.size() > 1) reasons.push_back(std::move(apart.reasons));
        for (std::size_t i = 0; i < apart.groups.size(); ++i) {
            SliceGroup group{std::move(apart.groups[i]), {}, std::move(apart.distinctions[i])};
            FoundCopies found = dropCopies(group.images, progress);
            copies.add(found.dropped);
            group.contradiction = std::move(found.contradiction);
            if (found.identityIsShared)
                group.notes.emplace_back(
                    "All pictures have the same (0008,0018) SOP Instance UID, which should tell them apart.");
            if (!found.elsewhere.empty())
                group.notes.push_back(fmt::format(
                    "{} files share the (0008,0018) SOP Instance UID of another, though they lie elsewhere: {}.",
                    found.elsewhere.size(), filesInWords(found.elsewhere)));
            series[uid].push_back(std::move(group));
        }
    }
    sayApart(reasons, warnings);
    return series;
}

/// Warns of copies.
void sayCopies(LeftOutCopies copies, std::vector<std::string>& warnings) {
    std::ranges::sort(copies.same);
    std::ranges::sort(copies.broken);
    if (!copies.same.empty())
        warnings.push_back(
            fmt::format("{} file(s) are copies of others, which show the same at the same place and time, and were "
                        "left out: {}.",
                        copies.same.size(), filesInWords(copies.same)));
    if (!copies.broken.empty())
        warnings.push_back(
            fmt::format("{} file(s) that cannot be decoded were left out, as others stand for the same picture: {}.",
                        copies.broken.size(), filesInWords(copies.broken)));
}

/// Sorts entries, the openable ones first, most slices first, and puts `joined` among them: behind each series that
/// opens by itself, as it is certain that a series was meant.
void takeInOrder(std::vector<SeriesEntry> joined, std::vector<SeriesEntry>& entries) {
    const auto rank = [](const std::pair<bool, SeriesEntry>& one) {
        const bool isRefused = one.second.whyNot.has_value();
        return std::tuple(isRefused, one.first && !isRefused, -one.second.size[2]);
    };
    std::vector<std::pair<bool, SeriesEntry>> all;
    for (SeriesEntry& entry : joined) all.emplace_back(true, std::move(entry));
    for (SeriesEntry& entry : entries) all.emplace_back(false, std::move(entry));
    std::ranges::stable_sort(all, {}, rank);
    entries.clear();
    for (auto& [isJoined, entry] : all) entries.push_back(std::move(entry));
}

}  // namespace

SortedSeries sortIntoSeries(const std::string& folder, std::vector<ImageHeader> images,
                            std::vector<DamagedFile> damaged, const Progress& progress) {
    SortedSeries sorted;
    std::map<std::string, Images> slices, objects;
    std::set<std::pair<std::string, std::string>> framed;  // concatenations with a file of many frames
    for (const ImageHeader& image : images)
        if (image.part && image.frames > 1) framed.emplace(image.series, image.part->whole);
    for (ImageHeader& image : images) {
        // Some programs call plain slices parts; their places tell more.
        const bool slice = image.file.plane && image.part && !framed.contains({image.series, image.part->whole});
        const bool object = image.volume || image.frames > 1 || (image.part && !isWhole(*image.part) && !slice);
        (object ? objects : slices)[image.series].push_back(std::move(image));
    }
    LeftOutCopies copies;
    auto series = groupSlices(std::move(slices), copies, sorted.warnings, progress);
    sorted.leftOut = giveToGroups(std::move(damaged), series);
    std::vector<SeriesEntry> joined = joinSeries(folder, series);
    for (auto& [uid, groups] : series)
        for (SliceGroup& group : groups) {
            SeriesEntry entry = entryOf(group.images.front());
            entry.distinction = std::move(group.distinction);
            entry.notes = std::move(group.notes);
            for (DamagedFile& one : orderSlices(folder, group, entry)) sorted.leftOut.push_back(std::move(one));
            sorted.entries.push_back(std::move(entry));
        }
    for (auto& [uid, own] : objects)
        for (SeriesEntry& entry : objectEntries(folder, std::move(own), copies, progress))
            sorted.entries.push_back(std::move(entry));
    sayCopies(std::move(copies), sorted.warnings);
    takeInOrder(std::move(joined), sorted.entries);
    nameApart(sorted.entries);
    return sorted;
}

}  // namespace echolucent
