#include "io/dicom/series/series_traits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

/// Pixel spacings that differ by less are equal, as programs write them with more or fewer digits.
constexpr double sameScale = 1e-3;

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

/// For each image, the number of its group of parallel planes; empty unless the places are those of a few stacks that
/// stand at clear angles to each other, as scouts do among the slices of a volume. Those of a sweep turn little by
/// little.
std::vector<std::string> orientationGroups(const Images& images) {
    constexpr std::size_t mostGroups = 3, leastOfOne = 3;
    constexpr double apart = 0.2;  // about 11 degrees, more than two slices of a sweep are turned by
    std::vector<std::string> groups(images.size());
    std::vector<std::pair<SlicePlane, std::size_t>> found;  // the first plane of each group, and its pictures
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto& plane = images[i].file.plane;
        if (!plane) continue;
        std::size_t group = 0;
        while (group < found.size() && !areParallel(found[group].first, *plane)) ++group;
        if (group == mostGroups) return std::vector<std::string>(images.size());
        if (group == found.size()) found.emplace_back(*plane, 0);
        ++found[group].second;
        groups[i] = std::to_string(group + 1);
    }
    bool clear = std::ranges::any_of(found, [](const auto& group) { return group.second >= leastOfOne; });
    for (std::size_t a = 0; a < found.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) clear = clear && turnBetween(found[a].first, found[b].first) > apart;
    return clear ? groups : std::vector<std::string>(images.size());
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
        {"pixel spacing", "pixel spacings", scaleGroups},
        {"orientation", "orientations", orientationGroups}};
    return traits;
}

std::size_t countDifferent(const std::vector<std::string>& values) {
    std::set<std::string> different(values.begin(), values.end());
    different.erase("");
    return different.size();
}

}  // namespace

bool noneShareTheirFrame(const Images& images) {
    std::set<std::string> frames;
    for (const ImageHeader& image : images)
        if (image.traits.frameOfReference.empty() || !frames.insert(image.traits.frameOfReference).second) return false;
    return images.size() > 1;
}

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

}  // namespace echolucent
