#include "io/dicom/series/joined_series.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

constexpr std::size_t fewestSeries = 3;  // two pictures always lie at an even distance

/// Whether all pictures of a group show one place, which may belong to a volume.
bool isOfOnePlace(const SliceGroup& group) {
    const auto& first = group.images.front().file.plane;
    return first && group.damaged.empty() && !group.contradiction &&
           std::ranges::all_of(group.images, [&](const ImageHeader& image) {
               const auto& plane = image.file.plane;
               return plane && length(plane->position - first->position) <= samePositionMm &&
                      image.moments.kind.find("LOCALIZER") == std::string::npos;
           });
}

/// Parallel images of each orientation.
std::vector<Images> byOrientation(Images images) {
    constexpr std::size_t mostOrientations = 64;  // more are no stacks
    std::vector<Images> groups;
    for (ImageHeader& image : images) {
        const auto own = std::ranges::find_if(
            groups, [&](const Images& group) { return areParallel(*group.front().file.plane, *image.file.plane); });
        if (own != groups.end())
            own->push_back(std::move(image));
        else if (groups.size() < mostOrientations)
            groups.push_back({std::move(image)});
    }
    return groups;
}

std::size_t countSeries(const Images& images) {
    std::set<std::string> uids;
    for (const ImageHeader& image : images) uids.insert(image.series);
    return uids.size();
}

/// Whether single pictures were surely meant as one volume, even if they do not lie evenly.
bool areMeantTogether(const Images& images) {
    const ImageHeader& first = images.front();
    return countSeries(images) == images.size() && !first.traits.frameOfReference.empty() &&
           std::ranges::all_of(images, [&](const ImageHeader& image) {
               return image.description == first.description &&
                      image.traits.frameOfReference == first.traits.frameOfReference;
           });
}

/// The kinds of a group's pictures, as text: of several contrasts, none is a volume with another's.
std::string kindsOf(const SliceGroup& group) {
    std::set<std::string> kinds;
    for (const ImageHeader& image : group.images) kinds.insert(image.moments.kind);
    std::string text;
    for (const std::string& kind : kinds) text += kind + "\n";
    return text;
}

/// The entry of images of several series; no value if they do not belong together.
std::optional<SeriesEntry> join(const std::string& folder, Images images) {
    const std::size_t count = countSeries(images);
    if (count < fewestSeries || noneShareTheirFrame(images)) return std::nullopt;
    const bool meant = areMeantTogether(images);
    std::map<std::string, std::string> seriesOf;
    for (const ImageHeader& image : images) seriesOf[image.file.path] = image.series;
    SliceGroup group{std::move(images)};
    SeriesEntry entry = entryOf(group.images.front());
    (void)orderSlices(folder, group, entry);
    if (entry.whyNot && !meant) return std::nullopt;
    entry.uid = seriesOf[entry.files.front().path];
    entry.notes.insert(
        entry.notes.begin(),
        fmt::format("{} series of one place each lie side by side and were joined to one volume.", count));
    return entry;
}

}  // namespace

std::vector<SeriesEntry> joinSeries(const std::string& folder, std::map<std::string, std::vector<SliceGroup>>& series) {
    std::map<std::pair<std::string, std::string>, Images> studies;  // by study and kinds
    for (const auto& [uid, groups] : series)
        for (const SliceGroup& group : groups)
            if (isOfOnePlace(group)) {
                const std::string kinds = kindsOf(group);
                for (const ImageHeader& image : group.images) studies[{image.study, kinds}].push_back(image);
            }
    std::vector<SeriesEntry> entries;
    std::set<std::string> joined;  // paths
    for (auto& [study, images] : studies) {
        if (countSeries(images) < fewestSeries) continue;
        for (Images& alike : listApart(std::move(images)).groups)
            for (Images& parallel : byOrientation(std::move(alike))) {
                auto entry = join(folder, std::move(parallel));
                if (!entry) continue;
                for (const SeriesFile& file : entry->files) joined.insert(file.path);
                entries.push_back(std::move(*entry));
            }
    }
    for (auto own = series.begin(); own != series.end();) {
        std::erase_if(own->second, [&](const SliceGroup& group) {
            return isOfOnePlace(group) && std::ranges::any_of(group.images, [&](const ImageHeader& image) {
                       return joined.contains(image.file.path);
                   });
        });
        own = own->second.empty() ? series.erase(own) : std::next(own);
    }
    return entries;
}

}  // namespace echolucent
