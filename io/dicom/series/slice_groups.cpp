#include "io/dicom/series/slice_groups.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/series/slice_phases.h"
#include "io/files/files_below.h"
#include "io/files/input_problems.h"
#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

Result<SliceStack> stackOf(const std::string& folder, const std::vector<SeriesFile>& files) {
    std::vector<SlicePlane> planes;
    planes.reserve(files.size());
    for (const SeriesFile& file : files) planes.push_back(*file.plane);
    return stackSlices(folder, imagePositionName, planes);
}

void putInOrder(std::vector<SeriesFile>& files, const SliceStack& stack) {
    std::vector<SeriesFile> ordered;
    for (const std::size_t index : stack.order) ordered.push_back(std::move(files[index]));
    files = std::move(ordered);
}

/// Why the readable pictures `files` cannot be stacked; no value if each has a place and the places can be compared.
std::optional<Failure> whyNoStack(const std::string& folder, const SliceGroup& group,
                                  const std::vector<SeriesFile>& files) {
    if (files.size() < 2) return singlePicture(files.front().path).value();
    if (noneShareTheirFrame(group.images))
        return fail(FailureKind::unreadable, folder, "(0020,0052) Frame of Reference UID",
                    fmt::format("is another one in each of {} pictures, so that their places cannot be compared",
                                files.size()),
                    "Export the series again as one volume.")
            .value();
    std::vector<std::string> placeless;
    for (const SeriesFile& file : files)
        if (!file.plane) placeless.push_back(file.path);
    if (placeless.empty()) return std::nullopt;
    const std::string which =
        placeless.size() == files.size()
            ? fmt::format("holds {} 2D pictures without position and orientation, no volume", files.size())
            : fmt::format("holds {} 2D pictures, {} of them without position and orientation that make sense ({})",
                          files.size(), placeless.size(), filesInWords(placeless));
    const auto stated = std::ranges::find_if(group.images, [](const auto& image) { return !image.wrongPlace.empty(); });
    return framesWithoutGeometry(folder, stated == group.images.end() ? which : which + ": " + stated->wrongPlace)
        .value();
}

/// Takes the phases of slices that lie at the same places again and again. False if there are none.
bool takePhases(const std::string& folder, const SliceGroup& group, SeriesEntry& entry) {
    auto phases = slicePhasesOf(folder, group.images);
    if (!phases) {
        entry.whyNot = phases.error();
        return true;
    }
    if (!*phases) return false;
    entry.files.clear();
    for (const auto& slices : (*phases)->slices)
        for (const std::size_t image : slices) entry.files.push_back(group.images[image].file);
    entry.size[2] = static_cast<std::int64_t>((*phases)->slices.front().size());
    entry.phases = std::move((*phases)->phases);
    for (std::string& note : (*phases)->notes) entry.notes.push_back(std::move(note));
    return true;
}

}  // namespace

SeriesEntry entryOf(const ImageHeader& first) {
    SeriesEntry entry;
    entry.uid = first.series;
    entry.object = first.object;
    entry.multiframe = first.volume || first.frames > 1;
    entry.description = first.description;
    entry.modality = first.modality;
    entry.size = {first.columns, first.rows, first.frames};
    entry.whyNot = first.whyNot;
    return entry;
}

std::vector<DamagedFile> orderSlices(const std::string& folder, SliceGroup& group, SeriesEntry& entry) {
    auto& files = entry.files;
    files.clear();
    for (const ImageHeader& image : group.images) files.push_back(image.file);
    entry.size[2] = static_cast<std::int64_t>(files.size());
    std::stable_sort(files.begin(), files.end(),
                     [](const SeriesFile& a, const SeriesFile& b) { return a.instance < b.instance; });
    std::vector<SeriesFile> all = files;
    std::vector<std::string> broken;
    for (const DamagedFile& one : group.damaged) {
        all.push_back(one.header->file);
        all.back().damage = one.damage;
        broken.push_back(one.path);
    }
    if (group.contradiction) {
        entry.whyNot = group.contradiction;
        return std::move(group.damaged);
    }
    entry.whyNot = whyNoStack(folder, group, files);
    const bool placed = std::ranges::all_of(files, [](const SeriesFile& file) { return file.plane.has_value(); });
    const bool comparable = placed && !(entry.whyNot && files.size() > 1);
    if (!broken.empty() && comparable) {
        if (const auto stack = stackOf(folder, all)) {
            entry.whyNot = tooFewWhole(folder, broken, all.size(), group.damaged.front().damage);
            files = std::move(all);
            putInOrder(files, *stack);
            entry.size[2] = static_cast<std::int64_t>(files.size());
            return {};
        }
    }
    if (entry.whyNot || takePhases(folder, group, entry)) return std::move(group.damaged);
    const auto stack = stackOf(folder, files);
    if (stack)
        putInOrder(files, *stack);
    else
        entry.whyNot = stack.error();
    return std::move(group.damaged);
}

bool isDamage(const Failure& failure) {
    return failure.remedy == copyAgain || failure.remedy == incompleteFile || failure.remedy == damagedFile ||
           failure.remedy == doNotOpen;
}

std::optional<Failure> tooFewWhole(const std::string& folder, const std::vector<std::string>& damaged, std::size_t all,
                                   const Failure& first) {
    const std::size_t whole = all - damaged.size();
    if (whole >= 2 && 2 * whole >= all) return std::nullopt;
    const std::string reason = first.element.empty() ? "it " + first.problem : first.element + " " + first.problem;
    const bool harmed = isDamage(first);
    return fail(FailureKind::unreadable, folder, "",
                fmt::format("{} {} of {} slices could not be read ({}), the first because {}",
                            harmed ? "holds a damaged series:" : "holds a series of which", damaged.size(), all,
                            filesInWords(damaged), reason),
                harmed ? "Copy or export the series again." : first.remedy)
        .value();
}

}  // namespace echolucent
