#include "io/dicom/series/concatenation.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/files/files_below.h"

namespace echolucent {

namespace {

constexpr DicomTag numberTag{0x0020, 0x9162};
constexpr DicomTag totalTag{0x0020, 0x9163};
constexpr DicomTag offsetTag{0x0020, 0x9228};
const std::string numberName = tagText(numberTag) + " In-concatenation Number";
const std::string offsetName = tagText(offsetTag) + " Concatenation Frame Offset Number";
constexpr const char* openAllParts = "Copy all parts into one folder and open that.";

/// Puts the parts of one object in order. Each function looks at one kind of statement.
class PartOrder {
public:
    PartOrder(const std::string& folder, const std::vector<PartFile>& files) : m_folder(folder), m_files(files) {
        m_arranged.order.resize(files.size());
        std::iota(m_arranged.order.begin(), m_arranged.order.end(), std::size_t{0});
    }

    Result<ArrangedParts> arrange() {
        const bool numbered = allState(&ConcatenationPart::number);
        const bool placed = allState(&ConcatenationPart::offset);
        if (!numbered && !placed)
            return refuse(numberName, fmt::format("is missing in parts of one object, as is {}", offsetName),
                          "Export the object again.");
        sortBy(numbered ? &ConcatenationPart::number : &ConcatenationPart::offset);
        if (const auto twice = refuseTwice(numbered ? &ConcatenationPart::number : &ConcatenationPart::offset,
                                           numbered ? numberName : offsetName);
            !twice)
            return tl::unexpected(twice.error());
        takeTotal();
        if (numbered) {
            if (const auto whole = checkNumbers(); !whole) return tl::unexpected(whole.error());
        } else if (m_total > static_cast<std::int64_t>(m_files.size())) {
            return refuse(
                numberName,
                fmt::format("is missing, and only {} of {} parts of one object are here", m_files.size(), m_total),
                openAllParts);
        }
        if (const auto whole = checkOffsets(placed); !whole) return tl::unexpected(whole.error());
        if (m_total == 0) m_arranged.notes.push_back(moreMayBeMissing(m_files.size()));
        return std::move(m_arranged);
    }

private:
    using Statement = std::optional<std::int64_t> ConcatenationPart::*;

    [[nodiscard]] tl::unexpected<Failure> refuse(const std::string& element, const std::string& problem,
                                                 const std::string& remedy) const {
        return fail(FailureKind::unreadable, m_folder, element, problem, remedy);
    }
    [[nodiscard]] const ConcatenationPart& partAt(std::size_t place) const {
        return m_files[m_arranged.order[place]].part;
    }
    [[nodiscard]] bool allState(Statement statement) const {
        return std::ranges::all_of(m_files, [&](const PartFile& file) { return (file.part.*statement).has_value(); });
    }
    void sortBy(Statement statement) {
        std::ranges::stable_sort(m_arranged.order, {},
                                 [&](std::size_t index) { return *(m_files[index].part.*statement); });
    }

    [[nodiscard]] Result<void> refuseTwice(Statement statement, const std::string& name) const {
        for (std::size_t place = 1; place < m_files.size(); ++place)
            if (*(partAt(place).*statement) == *(partAt(place - 1).*statement))
                return refuse(name,
                              fmt::format("is {} in two different files: {}", *(partAt(place).*statement),
                                          filesInWords({m_files[m_arranged.order[place - 1]].path,
                                                        m_files[m_arranged.order[place]].path})),
                              "Keep the parts of one object in the folder.");
        return {};
    }

    void takeTotal() {
        std::int64_t least = 0;
        for (const PartFile& file : m_files) {
            const std::int64_t total = file.part.total.value_or(0);
            if (total < 1) continue;
            least = least == 0 ? total : std::min(least, total);
            m_total = std::max(m_total, total);
        }
        if (least != m_total)
            m_arranged.notes.push_back(
                fmt::format("The files disagree on how many parts their object has, {} or {}; the larger number was "
                            "taken.",
                            least, m_total));
    }

    /// Refuses an object of which a number is missing.
    Result<void> checkNumbers() {
        const auto parts = static_cast<std::int64_t>(m_files.size());
        const std::int64_t first = *partAt(0).number, last = *partAt(m_files.size() - 1).number;
        // Some programs count from 0.
        const std::int64_t begin = first == 0 ? 0 : 1;
        const std::int64_t total = std::max(m_total, last - begin + 1);
        if (first < 0 || total > parts) {
            std::vector<std::string> missing;
            constexpr std::size_t mostNamed = 8;
            std::size_t place = 0;
            for (std::int64_t number = begin; number < begin + total && missing.size() < mostNamed; ++number) {
                while (place < m_files.size() && *partAt(place).number < number) ++place;
                if (place == m_files.size() || *partAt(place).number != number)
                    missing.push_back(std::to_string(number));
            }
            const std::string more =
                total - parts > static_cast<std::int64_t>(missing.size()) && first >= 0 ? " and more" : "";
            return refuse(numberName,
                          fmt::format("shows that part {}{} of {}{} of one object is missing; here {} {}",
                                      fmt::join(missing, ", "), more, total, begin == 0 ? ", counted from 0," : "",
                                      parts == 1 ? "is only" : "are only", filesInWords(pathsInOrder())),
                          openAllParts);
        }
        if (begin == 0) m_arranged.notes.emplace_back("The parts of the object are counted from 0 instead of 1.");
        return {};
    }

    /// Refuses an object whose offsets leave out frames or count them twice. Offsets that are all the same say nothing.
    Result<void> checkOffsets(bool placed) {
        const auto ignore = [&](const char* why) {
            m_arranged.notes.push_back(fmt::format("{} {}; the parts were joined by their numbers.", offsetName, why));
        };
        if (m_files.size() == 1 && !placed) return {};
        if (!placed) {
            ignore("is missing in some files");
            return {};
        }
        const bool same = std::ranges::all_of(
            m_files, [&](const PartFile& file) { return *file.part.offset == *m_files.front().part.offset; });
        if (same && m_files.size() > 1) {
            ignore("is the same in all files");
            return {};
        }
        std::int64_t frames = 0;
        const std::int64_t begin = *partAt(0).offset == 1 ? 1 : 0;  // some programs count from 1
        for (std::size_t place = 0; place < m_files.size(); ++place) {
            const std::int64_t offset = *partAt(place).offset - begin;
            if (offset > frames)
                return refuse(offsetName,
                              fmt::format("shows that frames {} to {} of one object are missing: {} begins behind them",
                                          frames + 1, offset, filesInWords({m_files[m_arranged.order[place]].path})),
                              openAllParts);
            if (offset < frames)
                return refuse(offsetName,
                              fmt::format("puts {} over frames of the part before it",
                                          filesInWords({m_files[m_arranged.order[place]].path})),
                              "Export the object again.");
            frames += partAt(place).frames;
        }
        return {};
    }

    [[nodiscard]] std::vector<std::string> pathsInOrder() const {
        std::vector<std::string> paths;
        for (const std::size_t index : m_arranged.order) paths.push_back(m_files[index].path);
        return paths;
    }

    const std::string& m_folder;
    const std::vector<PartFile>& m_files;
    std::int64_t m_total = 0;  // parts as the files say; 0 if none does
    ArrangedParts m_arranged;
};

}  // namespace

std::optional<ConcatenationPart> concatenationPartOf(DcmItem& dataset) {
    constexpr DicomTag wholeTag{0x0020, 0x9161}, sourceTag{0x0020, 0x0242};
    ConcatenationPart part;
    part.whole = dicomText(dataset, wholeTag);
    if (part.whole.empty()) part.whole = dicomText(dataset, sourceTag);
    part.number = dicomWholeNumber(dataset, numberTag);
    part.total = dicomWholeNumber(dataset, totalTag);
    part.offset = dicomWholeNumber(dataset, offsetTag);
    part.frames = dicomFrameCount(dataset);
    const bool named = !dicomText(dataset, wholeTag).empty();
    const bool counted = part.number.has_value() && part.total.value_or(0) > 1;
    // Some programs give whole files a Concatenation UID.
    const bool placed = part.number || part.offset || part.total.value_or(0) > 1;
    if (!counted && !(named && placed)) return std::nullopt;
    return part;
}

bool isWhole(const ConcatenationPart& part) {
    return part.total == 1 && part.number.value_or(1) <= 1 && part.offset.value_or(0) == 0;
}

bool mayBeWhole(const ConcatenationPart& part) {
    const std::int64_t number = part.number.value_or(1);
    return part.total.value_or(1) <= 1 && (number == 0 || number == 1) && part.offset.value_or(0) == 0;
}

std::string partInWords(const ConcatenationPart& part) {
    const std::string which = part.number ? fmt::format("part {}", *part.number) : "a part";
    return part.total && *part.total > 0 ? fmt::format("{} of {}", which, *part.total) : which;
}

tl::unexpected<Failure> onlyAPart(const std::string& path, const ConcatenationPart& part) {
    return fail(FailureKind::unreadable, path, numberName,
                fmt::format("says that the file is {} of one object, which is kept in several files (a concatenation)",
                            partInWords(part)),
                "Open the folder that holds all parts.");
}

std::string moreMayBeMissing(std::size_t parts) {
    return fmt::format(
        "The files do not say of how many parts their object is: {} part(s) are here, and more may be missing at the "
        "end.",
        parts);
}

bool isAboutParts(const Failure& failure) { return failure.element == numberName || failure.element == offsetName; }

Result<ArrangedParts> arrangeParts(const std::string& folder, const std::vector<PartFile>& files) {
    return PartOrder(folder, files).arrange();
}

}  // namespace echolucent
