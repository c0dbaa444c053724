#include "io/dicom/series/slice_phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/dicom/frames/date_times.h"
#include "io/dicom/frames/dicom_study.h"
#include "io/study/slice_stack.h"

namespace echolucent {

namespace {

constexpr const char* instanceName = "(0020,0013) Instance Number";
constexpr const char* resolutionName = "(0020,0110) Temporal Resolution";
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

using Values = std::vector<double>;                   // one for each image
using Table = std::vector<std::vector<std::size_t>>;  // for each phase and place, an image or `none`

/// The places of images along their normal.
struct Places {
    std::vector<std::size_t> of;  // the place of each image
    std::size_t count = 0;
    std::vector<std::size_t> images;  // how many lie at each place
};

/// No value if the images are not parallel or not all at the places of a stack.
std::optional<Places> placesOf(const Images& images) {
    // Of the distance of slices: stackSlices() warns of distances and of shifts sideways that differ by more.
    constexpr double sameShare = 0.01, sidewaysShare = 0.1;
    const SlicePlane& first = *images.front().file.plane;
    const Vec3 normal = first.alongRow.cross(first.alongColumn);
    std::vector<std::pair<double, std::size_t>> depths;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const SlicePlane& plane = *images[i].file.plane;
        const double depth = plane.position.dot(normal);
        if (!std::isfinite(depth) || !areParallel(plane, first)) return std::nullopt;
        depths.emplace_back(depth, i);
    }
    std::ranges::sort(depths);
    // Programs round positions, so that most gaps may be small ones; the largest is one between two places.
    double spacing = 0.0;
    for (std::size_t i = 1; i < depths.size(); ++i) spacing = std::max(spacing, depths[i].first - depths[i - 1].first);
    if (!(spacing > samePositionMm)) return std::nullopt;
    const double tolerance = std::max(samePositionMm, sameShare * spacing);
    Places places{std::vector<std::size_t>(images.size()), 0, {}};
    const Vec3* start = nullptr;
    double begun = 0.0;
    for (const auto& [depth, image] : depths) {
        const Vec3& position = images[image].file.plane->position;
        if (start == nullptr || depth - begun > tolerance) {
            start = &position;
            begun = depth;
            places.images.push_back(0);
        }
        if (!(length(position - *start) <= std::max(samePositionMm, sidewaysShare * spacing))) return std::nullopt;
        ++places.images.back();
        places.of[image] = places.images.size() - 1;
    }
    places.count = places.images.size();
    return places;
}

/// Times of day that go over midnight without saying so. Values with a date, which are larger, stay as they are.
void passMidnight(Values& seconds) {
    constexpr double day = secondsOfADay;
    constexpr double longestPause = 4 * 3600;  // around midnight the earliest and the latest seem nearly a day apart
    const auto [least, most] = std::ranges::minmax(seconds);
    if (most > day + 1 || most - least < day - longestPause) return;  // a day may end with a leap second
    for (double& one : seconds)
        if (one - least < day / 2) one += day;
}

/// The place of the attribute with this tag in momentAttributes.
constexpr std::size_t momentAt(std::string_view tag) {
    std::size_t place = 0;
    while (!std::string_view(momentAttributes[place].name).starts_with(tag)) ++place;
    return place;
}

class PhaseFinder {
public:
    PhaseFinder(const std::string& folder, const Images& images, Places places)
        : m_folder(folder),
          m_images(images),
          m_places(std::move(places)),
          m_most(*std::ranges::max_element(m_places.images)) {}

    Result<std::optional<SlicePhases>> find() {
        if (!tell()) return std::optional<SlicePhases>();
        if (auto whole = leaveOutBroken(); !whole) return tl::unexpected(whole.error());
        if (auto stacked = stack(); !stacked) return tl::unexpected(stacked.error());
        m_found.phases.count = static_cast<std::int64_t>(m_table.size());
        if (m_table.size() > 1)
            time();
        else
            m_found.phases.source.clear();
        m_found.slices = std::move(m_table);
        return std::optional(std::move(m_found));
    }

private:
    /// The values of an attribute; empty if an image lacks it.
    [[nodiscard]] Values valuesOf(std::size_t attribute) const {
        Values values;
        for (const ImageHeader& image : m_images) {
            const auto& value = image.moments.values[attribute];
            if (!value) return {};
            values.push_back(*value);
        }
        if (momentAttributes[attribute].secondsOfOne == 1) passMidnight(values);
        return values;
    }

    [[nodiscard]] Values instances() const {
        Values values;
        for (const ImageHeader& image : m_images) values.push_back(static_cast<double>(image.file.instance));
        return values;
    }

    [[nodiscard]] bool areOfOneKind() const {
        return std::ranges::all_of(
            m_images, [&](const ImageHeader& image) { return image.moments.kind == m_images.front().moments.kind; });
    }

    [[nodiscard]] bool areEvenlyMany() const {
        return std::ranges::all_of(m_places.images, [&](std::size_t images) { return images == m_most; });
    }

    /// Finds the attribute that tells the phases apart. False if there is none.
    bool tell() {
        const bool oneKind = areOfOneKind();
        for (std::size_t i = 0; i < momentAttributes.size(); ++i) {
            if (!oneKind && !momentAttributes[i].countsTime) continue;
            const Values values = valuesOf(i);
            if (values.empty()) continue;
            m_table = tableBy(values);
            if (m_table.empty()) continue;
            m_told = i;
            m_found.phases.source = momentAttributes[i].name;
            m_found.notes.push_back(
                fmt::format("Pictures lie at each of {} places up to {} times: {} tells {} phases apart.",
                            m_places.count, m_most, m_found.phases.source, m_table.size()));
            return true;
        }
        if (!oneKind || !areEvenlyMany()) return false;
        m_table = tableBy(instances());
        if (m_table.empty()) return false;
        m_found.phases.source = instanceName;
        m_found.notes.push_back(
            fmt::format("Pictures lie at each of {} places {} times, and nothing says when they were taken: {} phases "
                        "were taken in the order of {}.",
                        m_places.count, m_most, m_table.size(), instanceName));
        return true;
    }

    /// Images by phase and place; empty if the values do not tell those at one place apart.
    [[nodiscard]] Table tableBy(const Values& values) const {
        std::vector<std::size_t> order(values.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t image) { return values[image]; });
        std::vector<const double*> before(m_places.count, nullptr);
        std::set<double> different;
        for (const std::size_t image : order) {
            const double*& last = before[m_places.of[image]];
            if (last != nullptr && *last == values[image]) return {};
            last = &values[image];
            different.insert(values[image]);
        }
        // Values that most places share (three quarters) belong to a phase each, even if slices are missing. If not,
        // each slice has a time of its own.
        if (4 * m_images.size() >= 3 * different.size() * m_places.count) return tableByValue(values, order);
        if (areEvenlyMany()) return tableByRank(order);
        if (m_most > 2 * m_images.size() / m_places.count) return {};  // most slices of most phases would be missing
        Table table = tableByRepetition(order);
        return table.size() == m_most ? table : Table();
    }

    /// Each value is a phase.
    [[nodiscard]] Table tableByValue(const Values& values, const std::vector<std::size_t>& order) const {
        Table table;
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || values[order[i]] != values[order[i - 1]]) table.emplace_back(m_places.count, none);
            table.back()[m_places.of[order[i]]] = order[i];
        }
        return table;
    }

    /// The first image of each place is of the first phase, and so on.
    [[nodiscard]] Table tableByRank(const std::vector<std::size_t>& order) const {
        Table table(m_most, std::vector<std::size_t>(m_places.count, none));
        std::vector<std::size_t> ranks(m_places.count, 0);
        for (const std::size_t image : order) {
            const std::size_t place = m_places.of[image];
            table[ranks[place]++][place] = image;
        }
        return table;
    }

    /// A phase begins with the first place that comes again. Ends early if there would be too many phases.
    [[nodiscard]] Table tableByRepetition(const std::vector<std::size_t>& order) const {
        Table table;
        for (const std::size_t image : order) {
            const std::size_t place = m_places.of[image];
            if (table.empty() || table.back()[place] != none) {
                if (table.size() > m_most) return {};
                table.emplace_back(m_places.count, none);
            }
            table.back()[place] = image;
        }
        return table;
    }

    /// Leaves phases out that lack slices. Fails if they are more than half of all.
    Result<void> leaveOutBroken() {
        constexpr std::size_t mostNamed = 3;
        const std::size_t all = m_table.size();
        std::vector<std::string> named;
        std::size_t broken = 0;
        Table whole;
        for (std::size_t phase = 0; phase < all; ++phase) {
            const auto missing = std::ranges::count(m_table[phase], none);
            if (missing == 0) {
                whole.push_back(std::move(m_table[phase]));
                continue;
            }
            if (++broken <= mostNamed)
                named.push_back(
                    fmt::format("phase {} of {} lacks {} of {} slices", phase + 1, all, missing, m_places.count));
        }
        if (broken == 0) {
            m_table = std::move(whole);
            return {};
        }
        const std::string words = fmt::format("{}{}", fmt::join(named, ", "), broken > mostNamed ? " and more do" : "");
        if (2 * whole.size() < all)
            return fail(FailureKind::unreadable, m_folder, m_found.phases.source,
                        fmt::format("shows that slices are missing: {}", words), "Export the whole series again.");
        m_found.notes.push_back(
            fmt::format("Phases with missing slices were left out ({}): {}.", m_found.phases.source, words));
        m_table = std::move(whole);
        return {};
    }

    /// Whether the places are those of a volume.
    [[nodiscard]] Result<void> stack() const {
        std::vector<SlicePlane> planes;
        for (const std::size_t image : m_table.front()) planes.push_back(*m_images[image].file.plane);
        const auto stacked = stackSlices(m_folder, imagePositionName, planes);
        return stacked ? Result<void>() : tl::unexpected(stacked.error());
    }

    /// The mean times of the phases since the first; empty if they do not rise.
    [[nodiscard]] Values meanTimes(const Values& values, double secondsOfOne) const {
        Values times;
        if (values.empty()) return times;
        for (const auto& phase : m_table) {
            double sum = 0.0;
            for (std::size_t place = 0; place < phase.size(); ++place)
                sum += values[phase[place]] - values[m_table.front()[place]];
            times.push_back(secondsOfOne * sum / static_cast<double>(phase.size()));
            if (times.size() > 1 && !(times.back() > times[times.size() - 2])) return {};
        }
        return times;
    }

    bool takeTimes(std::size_t attribute) {
        const MomentAttribute& one = momentAttributes[attribute];
        if (one.secondsOfOne == 0) return false;
        m_found.phases.seconds = meanTimes(valuesOf(attribute), one.secondsOfOne);
        if (!m_found.phases.seconds.empty()) m_found.phases.timeSource = one.name;
        return !m_found.phases.seconds.empty();
    }

    /// Times by Temporal Resolution, if all images state the same; else empty.
    [[nodiscard]] Values resolutionTimes() const {
        const auto& resolution = m_images.front().moments.resolution;
        if (!resolution) return {};
        for (const ImageHeader& image : m_images)
            if (image.moments.resolution != resolution) return {};
        const Values identifiers = m_told <= lastIdentifier ? valuesOf(m_told) : Values();
        if (!identifiers.empty()) return meanTimes(identifiers, *resolution);
        Values times;
        for (std::size_t phase = 0; phase < m_table.size(); ++phase)
            times.push_back(*resolution * static_cast<double>(phase));
        return times;
    }

    void time() {
        if (m_told < momentAttributes.size() && takeTimes(m_told)) return;
        if (takeTimes(triggerTime) || takeTimes(triggerDelay) || takeTimes(referenceTime)) return;
        const Values stated = resolutionTimes();
        const bool acquired = takeTimes(acquisitionDateTime) || takeTimes(acquisitionTime);
        // Times of day are often whole seconds. A resolution that is far from them is of another unit.
        constexpr double wholeSecond = 1.0, closeShare = 0.1;
        const bool fits = !acquired || std::abs(stated.empty() ? 0.0 : stated.back() - m_found.phases.seconds.back()) <=
                                           wholeSecond + closeShare * m_found.phases.seconds.back();
        if (!stated.empty() && fits) {
            m_found.phases.seconds = stated;
            m_found.phases.timeSource = resolutionName;
        } else if (!acquired && !takeTimes(contentTime)) {
            m_found.notes.push_back(
                "No time was found that rises from phase to phase: the time between phases is unknown.");
        }
    }

    // Places in momentAttributes.
    static constexpr std::size_t lastIdentifier = momentAt("(0020,9128)"), triggerTime = momentAt("(0018,1060)"),
                                 triggerDelay = momentAt("(0020,9153)"), referenceTime = momentAt("(0054,1300)"),
                                 acquisitionDateTime = momentAt("(0008,002a)"),
                                 acquisitionTime = momentAt("(0008,0032)"), contentTime = momentAt("(0008,0033)");

    const std::string& m_folder;
    const Images& m_images;
    const Places m_places;
    const std::size_t m_most;                      // images at the place with most
    std::size_t m_told = momentAttributes.size();  // the attribute that tells phases apart
    Table m_table;
    SlicePhases m_found;
};

}  // namespace

Result<std::optional<SlicePhases>> slicePhasesOf(const std::string& folder, const Images& images) {
    auto places = placesOf(images);
    if (!places || places->count < 2 || places->count == images.size()) return std::optional<SlicePhases>();
    return PhaseFinder(folder, images, std::move(*places)).find();
}

}  // namespace echolucent
