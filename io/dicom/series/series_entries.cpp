#include "io/dicom/series/series_entries.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/files/files_below.h"
#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

/// Pixel spacings that differ by less are equal, as programs write them with more or fewer digits.
constexpr double sameScale = 1e-3;

using Images = std::vector<ImageHeader>;

/// A property that the slices of one volume share.
struct Trait {
    const char* one;   // "patient"
    const char* many;  // "patients"
    // One for each image; empty if the image does not say it.
    std::function<std::vector<std::string>(const Images&)> values;
};

Trait textTrait(const char* one, const char* many, std::function<std::string(const ImageHeader&)> text) {
    return {one, many, [text = std::move(text)](const Images& images) {
                std::vector<std::string> values;
                for (const ImageHeader& image : images) values.push_back(text(image));
                return values;
            }};
}

/// For each image, the numbers of its groups of nearly equal scales along x and y; empty if it states no scale.
std::vector<std::string> scaleGroups(const Images& images) {
    std::vector<std::string> groups(images.size());
    for (const std::size_t axis : {0, 1}) {
        std::vector<std::pair<double, std::size_t>> scales;
        for (std::size_t i = 0; i < images.size(); ++i)
            if (images[i].traits.scale) scales.emplace_back((*images[i].traits.scale)[axis], i);
        std::sort(scales.begin(), scales.end());
        double begun = 0;
        int group = 0;
        for (const auto& [scale, image] : scales) {
            if (scale > begun * (1 + sameScale)) {
                begun = scale;
                ++group;
            }
            groups[image] += fmt::format("{} ", group);
        }
    }
    return groups;
}

/// The traits in the order in which sentences name them. The first three tell patients apart.
const std::vector<Trait>& allTraits() {
    static const std::vector<Trait> traits{
        textTrait("patient", "patients", [](const ImageHeader& image) { return image.traits.patientId; }),
        textTrait("patient", "patients", [](const ImageHeader& image) { return image.traits.patientName; }),
        textTrait("patient", "patients", [](const ImageHeader& image) { return image.traits.birthDate; }),
        textTrait("frame of reference", "frames of reference",
                  [](const ImageHeader& image) { return image.traits.frameOfReference; }),
        textTrait("size", "sizes",
                  [](const ImageHeader& image) { return fmt::format("{} x {}", image.columns, image.rows); }),
        textTrait("modality", "modalities", [](const ImageHeader& image) { return image.modality; }),
        textTrait("photometric interpretation", "photometric interpretations",
                  [](const ImageHeader& image) { return image.traits.photometric; }),
        {"pixel spacing", "pixel spacings", scaleGroups}};
    return traits;
}

std::size_t countDifferent(const std::vector<std::string>& values) {
    std::set<std::string> different(values.begin(), values.end());
    different.erase("");
    return different.size();
}

bool noneShareTheirFrame(const Images& images) {
    std::set<std::string> frames;
    for (const ImageHeader& image : images)
        if (image.traits.frameOfReference.empty() || !frames.insert(image.traits.frameOfReference).second) return false;
    return images.size() > 1;
}

/// Slices of one Series Instance UID, listed apart.
struct Apart {
    std::vector<Images> groups;
    // How each group differs from the others; an empty text if there is one group.
    std::vector<std::string> distinctions;
    std::vector<std::string> reasons;  // "2 patients"
};

Apart listApart(Images images) {
    std::vector<std::vector<std::string>> told(images.size());   // for each image, its values of the traits that differ
    std::vector<std::vector<std::string>> named(images.size());  // these values in words for a person
    Apart apart;
    std::string last;
    for (const Trait& trait : allTraits()) {
        const std::vector<std::string> values = trait.values(images);
        const std::size_t different = countDifferent(values);
        const bool frame = std::string_view(trait.one) == "frame of reference";
        if (different < 2 || (frame && noneShareTheirFrame(images))) continue;
        std::map<std::string, std::size_t> numbers;
        for (const std::string& value : values) numbers.emplace(value, 0);
        std::size_t number = 0;
        for (auto& [value, own] : numbers) own = ++number;
        for (std::size_t i = 0; i < images.size(); ++i) {
            told[i].push_back(values[i]);
            if (last != trait.one)
                named[i].push_back(fmt::format("{} {} of {}", trait.one, numbers.at(values[i]), numbers.size()));
        }
        // The first three traits all tell patients apart; name them once.
        if (last != trait.one) apart.reasons.push_back(fmt::format("{} {}", different, trait.many));
        last = trait.one;
    }
    std::map<std::vector<std::string>, std::size_t> places;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto place = places.emplace(std::move(told[i]), apart.groups.size());
        if (place.second) {
            apart.groups.emplace_back();
            apart.distinctions.push_back(fmt::format("{}", fmt::join(named[i], ", ")));
        }
        apart.groups[place.first->second].push_back(std::move(images[i]));
    }
    return apart;
}

/// Whether two headers contradict each other in what the slices of one volume share.
bool contradict(const ImageHeader& a, const ImageHeader& b) {
    const auto differ = [](const auto& one, const auto& other) {
        return one != other && one != decltype(one){} && other != decltype(one){};
    };
    const auto far = [](double one, double other) { return std::abs(one - other) > sameScale * std::max(one, other); };
    const auto& s = a.traits;
    const auto& t = b.traits;
    return differ(s.patientId, t.patientId) || differ(s.patientName, t.patientName) ||
           differ(s.birthDate, t.birthDate) || differ(s.frameOfReference, t.frameOfReference) ||
           differ(a.rows, b.rows) || differ(a.columns, b.columns) || differ(a.modality, b.modality) ||
           differ(s.photometric, t.photometric) ||
           (s.scale && t.scale && (far((*s.scale)[0], (*t.scale)[0]) || far((*s.scale)[1], (*t.scale)[1])));
}

struct Group {
    Images images;
    std::vector<DamagedFile> damaged;
    std::string distinction;
};

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
std::optional<Failure> whyNoStack(const std::string& folder, const Group& group, const std::vector<SeriesFile>& files) {
    if (files.size() < 2)
        return fail(FailureKind::unreadable, files.front().path, "", "is a single 2D picture, not a volume",
                    "Open the folder that holds all slices, or a multi-frame file.")
            .value();
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
    return framesWithoutGeometry(folder, which).value();
}

/// Puts the slices of an entry in order, damaged ones among them if they fit, and sets entry.whyNot if they are no
/// volume. Gives back the damaged slices that do not fit.
std::vector<DamagedFile> orderSlices(const std::string& folder, Group& group, SeriesEntry& entry) {
    auto& files = entry.files;
    std::stable_sort(files.begin(), files.end(),
                     [](const SeriesFile& a, const SeriesFile& b) { return a.instance < b.instance; });
    std::vector<SeriesFile> all = files;
    std::vector<std::string> broken;
    for (const DamagedFile& one : group.damaged) {
        all.push_back(one.header->file);
        all.back().damage = one.damage;
        broken.push_back(one.path);
    }
    entry.whyNot = whyNoStack(folder, group, files);
    const bool placed = std::ranges::all_of(files, [](const SeriesFile& file) { return file.plane.has_value(); });
    const bool comparable = placed && !(entry.whyNot && files.size() > 1);
    if (!broken.empty() && comparable) {
        if (const auto stack = stackOf(folder, all)) {
            entry.whyNot = tooFewWhole(folder, broken, all.size(), group.damaged.front().damage);
            files = std::move(all);
            putInOrder(files, *stack);
            return {};
        }
    }
    if (entry.whyNot) return std::move(group.damaged);
    const auto stack = stackOf(folder, files);
    if (stack)
        putInOrder(files, *stack);
    else
        entry.whyNot = stack.error();
    return std::move(group.damaged);
}

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

/// Gives each damaged slice to the one group that it can belong to. Gives back the files that can belong to none or to
/// several groups.
std::vector<DamagedFile> giveToGroups(std::vector<DamagedFile> damaged,
                                      std::map<std::string, std::vector<Group>>& series) {
    constexpr std::size_t mostGroups = 16;  // among more, no slice's group is certain
    std::vector<DamagedFile> others;
    for (DamagedFile& one : damaged) {
        const bool slice = one.header && one.header->file.plane && one.header->frames == 1;
        const auto own = slice ? series.find(one.header->series) : series.end();
        std::vector<Group*> fitting;
        if (own != series.end() && own->second.size() <= mostGroups)
            for (Group& group : own->second)
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

}  // namespace

std::optional<Failure> tooFewWhole(const std::string& folder, const std::vector<std::string>& damaged, std::size_t all,
                                   const Failure& first) {
    const std::size_t whole = all - damaged.size();
    if (whole >= 2 && 2 * whole >= all) return std::nullopt;
    const std::string reason = first.element.empty() ? first.problem : first.element + " " + first.problem;
    return fail(FailureKind::unreadable, folder, "",
                fmt::format("holds a damaged series: {} of {} slices could not be read ({}), the first because it {}",
                            damaged.size(), all, filesInWords(damaged), reason),
                "Copy or export the series again.")
        .value();
}

SortedSeries sortIntoSeries(const std::string& folder, std::vector<ImageHeader> images,
                            std::vector<DamagedFile> damaged) {
    SortedSeries sorted;
    std::map<std::string, Images> slices;
    std::map<std::pair<std::string, std::string>, SeriesEntry> alone;  // multi-frame files by series and path
    for (ImageHeader& image : images) {
        if (image.volume || image.frames > 1) {
            SeriesEntry& entry = alone[{image.series, image.file.path}] = entryOf(image);
            entry.files.push_back(std::move(image.file));
        } else {
            slices[image.series].push_back(std::move(image));
        }
    }
    std::map<std::string, std::vector<Group>> series;
    std::vector<std::vector<std::string>> reasons;
    for (auto& [uid, own] : slices) {
        Apart apart = listApart(std::move(own));
        if (apart.groups.size() > 1) reasons.push_back(std::move(apart.reasons));
        for (std::size_t i = 0; i < apart.groups.size(); ++i)
            series[uid].push_back({std::move(apart.groups[i]), {}, std::move(apart.distinctions[i])});
    }
    sayApart(reasons, sorted.warnings);
    sorted.leftOut = giveToGroups(std::move(damaged), series);
    for (auto& [uid, groups] : series)
        for (Group& group : groups) {
            SeriesEntry entry = entryOf(group.images.front());
            entry.distinction = std::move(group.distinction);
            for (const ImageHeader& image : group.images) entry.files.push_back(image.file);
            for (DamagedFile& one : orderSlices(folder, group, entry)) sorted.leftOut.push_back(std::move(one));
            entry.size[2] = static_cast<std::int64_t>(entry.files.size());
            sorted.entries.push_back(std::move(entry));
        }
    for (auto& [key, entry] : alone) sorted.entries.push_back(std::move(entry));
    std::stable_sort(sorted.entries.begin(), sorted.entries.end(), [](const SeriesEntry& a, const SeriesEntry& b) {
        return std::pair(a.whyNot.has_value(), -a.size[2]) < std::pair(b.whyNot.has_value(), -b.size[2]);
    });
    nameApart(sorted.entries);
    return sorted;
}

}  // namespace echolucent
