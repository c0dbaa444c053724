#include "io/dicom/series/copies.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_file.h"
#include "io/dicom/frames/functional_groups.h"
#include "io/dicom/pixels/dicom_pixels.h"
#include "io/files/files_below.h"
#include "io/files/input_file.h"

namespace echolucent {

namespace {

enum class Comparison { same, different, firstBroken, secondBroken };

/// Where the data set begins, as far as the length of the meta header tells; no value if there is none.
std::optional<std::uint64_t> dataSetStart(const InputFile& file) {
    constexpr std::size_t metaStart = 144;  // behind preamble, "DICM" and the element of the length
    const auto beginning = file.beginning(metaStart);
    if (!beginning || beginning->size() < metaStart || beginning->substr(128, 4) != "DICM" ||
        beginning->substr(132, 8) != std::string("\2\0\0\0UL\4\0", 8))
        return std::nullopt;
    std::uint64_t length = 0;
    for (const std::size_t byte : {143, 142, 141, 140})
        length = 256 * length + static_cast<unsigned char>((*beginning)[byte]);
    return metaStart + length <= file.size() ? std::optional(metaStart + length) : std::nullopt;
}

/// Whether the bytes from these places to the ends of both files are the same.
bool sameBytes(const InputFile& a, std::uint64_t fromA, const InputFile& b, std::uint64_t fromB,
               const Progress& progress) {
    if (a.size() - fromA != b.size() - fromB) return false;
    constexpr std::uint64_t blockBytes = std::uint64_t{1} << 16;
    std::vector<std::uint8_t> one(blockBytes), other(blockBytes);
    for (std::uint64_t done = 0; done < a.size() - fromA; done += blockBytes) {
        const auto bytes = static_cast<std::size_t>(std::min(blockBytes, a.size() - fromA - done));
        const std::span first(one.data(), bytes), second(other.data(), bytes);
        if (progress.cancelled() || !a.readAt(fromA + done, first) || !b.readAt(fromB + done, second) ||
            !std::ranges::equal(first, second))
            return false;
    }
    return true;
}

/// Values as numbers, where they are such: programs write one number in several ways.
std::string withPlainNumbers(const std::string& values) {
    std::string plain;
    for (std::size_t start = 0; start <= values.size();) {
        const std::size_t end = std::min(values.find('\\', start), values.size());
        const std::string value = values.substr(start, end - start);
        const auto number = decimalNumber(value);
        plain += number ? fmt::format("{}\\", *number + 0.0) : value + "\\";  // -0 becomes 0
        start = end + 1;
    }
    return plain;
}

/// What a file says of the places and times of its frames, as text.
std::string statedPlaces(DcmItem& dataset) {
    constexpr std::array tags{
        DicomTag{0x0020, 0x0032}, DicomTag{0x0020, 0x0037}, DicomTag{0x0028, 0x0030}, DicomTag{0x0018, 0x0088},
        DicomTag{0x3004, 0x000c}, DicomTag{0x0018, 0x1063}, DicomTag{0x0018, 0x1065}, DicomTag{0x0028, 0x0009},
    };
    std::string text;
    for (const DicomTag tag : tags) text += withPlainNumbers(dicomText(dataset, tag)) + "|";
    return text;
}

bool sameGroups(const DicomFile& a, const DicomFile& b, std::size_t frames, const Progress& progress) {
    const auto one = readFunctionalGroups(a.dataset(), a.path(), frames, progress);
    const auto other = readFunctionalGroups(b.dataset(), b.path(), frames, progress);
    return one.has_value() == other.has_value() && (!one || *one == *other);
}

/// Compares what two files show.
Comparison compareDecoded(const InputFile& inputA, const InputFile& inputB, const Progress& progress) {
    const auto a = DicomFile::load(inputA, false, progress);
    if (!a) return Comparison::firstBroken;
    const auto b = DicomFile::load(inputB, false, progress);
    if (!b) return Comparison::secondBroken;
    auto framesA = DicomFrames::open(a->dataset(), a->path(), a->scan());
    if (!framesA) return Comparison::firstBroken;
    auto framesB = DicomFrames::open(b->dataset(), b->path(), b->scan());
    if (!framesB) return Comparison::secondBroken;
    if (framesA->frames() != framesB->frames() || framesA->columns() != framesB->columns() ||
        framesA->rows() != framesB->rows() || framesA->type() != framesB->type() ||
        statedPlaces(a->dataset()) != statedPlaces(b->dataset()) ||
        !sameGroups(*a, *b, static_cast<std::size_t>(framesA->frames()), progress))
        return Comparison::different;
    std::vector<std::uint8_t> greyA(static_cast<std::size_t>(framesA->frameBytes())), greyB(greyA.size());
    for (std::int64_t frame = 0; frame < framesA->frames(); ++frame) {
        if (progress.cancelled()) return Comparison::different;
        if (!framesA->readGrey(frame, greyA)) return Comparison::firstBroken;
        if (!framesB->readGrey(frame, greyB)) return Comparison::secondBroken;
        if (greyA != greyB) return Comparison::different;
    }
    return Comparison::same;
}

Comparison compareFiles(const ImageHeader& a, const ImageHeader& b, const Progress& progress) {
    const auto inputA = InputFile::open(a.file.path), inputB = InputFile::open(b.file.path);
    if (!inputA) return Comparison::firstBroken;
    if (!inputB) return Comparison::secondBroken;
    if (sameBytes(*inputA, 0, *inputB, 0, progress)) return Comparison::same;
    const auto startA = dataSetStart(*inputA), startB = dataSetStart(*inputB);
    if (startA && startB && sameBytes(*inputA, *startA, *inputB, *startB, progress)) return Comparison::same;
    // A maker's private volume may stand anywhere in the data set.
    if (a.volume || b.volume) return Comparison::different;
    return compareDecoded(*inputA, *inputB, progress);
}

/// The place, the moment and the size of a picture, as text.
std::string placeOf(const ImageHeader& image) {
    std::string text = fmt::format("{} {} {} {} ", image.file.instance, image.rows, image.columns, image.frames);
    if (const auto& plane = image.file.plane)
        for (const Vec3& vector : {plane->position, plane->alongRow, plane->alongColumn})
            text += fmt::format("{} {} {} ", vector[0], vector[1], vector[2]);
    for (const auto& value : image.moments.values) text += value ? fmt::format("{} ", *value) : "- ";
    return text;
}

/// Files with one identity.
class Alike {
public:
    Alike(Images& images, std::vector<std::size_t> indices, const Progress& progress)
        : m_images(images), m_indices(std::move(indices)), m_progress(progress) {
        std::ranges::stable_sort(m_indices, {}, [&](std::size_t index) { return m_images[index].file.path.size(); });
    }

    /// Splits the files by what they show.
    void compare() {
        std::map<std::string, std::size_t> shown;
        for (const std::size_t index : m_indices) {
            const auto [there, isNew] = shown.emplace(placeOf(m_images[index]), index);
            if (isNew) {
                if (shown.size() > 1 && !m_other) m_other = {shown.begin()->second, index};
                continue;
            }
            switch (compareFiles(m_images[there->second], m_images[index], m_progress)) {
                case Comparison::same: m_same.insert(index); break;
                case Comparison::secondBroken: m_broken.insert(index); break;
                case Comparison::firstBroken:
                    m_broken.insert(there->second);
                    there->second = index;
                    break;
                case Comparison::different:
                    ++m_differing;
                    if (!m_different) m_different = {there->second, index};
            }
        }
        m_places = shown.size();
    }

    [[nodiscard]] const std::set<std::size_t>& same() const { return m_same; }
    [[nodiscard]] const std::set<std::size_t>& broken() const { return m_broken; }
    /// The paths of the files that are no copies.
    [[nodiscard]] std::vector<std::string> kept() const {
        std::vector<std::string> paths;
        for (const std::size_t index : m_indices)
            if (!m_same.contains(index) && !m_broken.contains(index)) paths.push_back(m_images[index].file.path);
        return paths;
    }
    /// Whether the places of all files are known and each holds one picture.
    [[nodiscard]] bool arePlaced() const {
        return std::ranges::all_of(m_indices, [&](std::size_t index) {
            const ImageHeader& image = m_images[index];
            return image.file.plane && image.frames == 1 && !image.volume;
        });
    }
    /// How many different pictures the files hold, at least.
    [[nodiscard]] std::size_t pictures() const { return m_places + m_differing; }
    /// Two files that show something else at the same place and moment.
    [[nodiscard]] const auto& different() const { return m_different; }
    /// Two files of different places or moments.
    [[nodiscard]] const auto& elsewhere() const { return m_other; }

private:
    Images& m_images;
    std::vector<std::size_t> m_indices;
    const Progress& m_progress;
    std::set<std::size_t> m_same, m_broken;
    std::size_t m_places = 0, m_differing = 0;
    std::optional<std::pair<std::size_t, std::size_t>> m_different, m_other;
};

/// Indices of copies.
struct Dropped {
    std::set<std::size_t> same, broken;

    void add(const Alike& alike) {
        same.insert(alike.same().begin(), alike.same().end());
        broken.insert(alike.broken().begin(), alike.broken().end());
    }
    [[nodiscard]] bool contains(std::size_t index) const { return same.contains(index) || broken.contains(index); }
};

/// Finds pictures that some program has given another identity: the same place, moment, number and content.
void findRenamed(Images& images, Dropped& dropped, const Progress& progress) {
    std::map<std::string, std::vector<std::size_t>> places;
    for (std::size_t i = 0; i < images.size(); ++i)
        if (images[i].file.plane && !dropped.contains(i)) places[placeOf(images[i])].push_back(i);
    for (auto& [place, indices] : places) {
        if (indices.size() < 2 || progress.cancelled()) continue;
        Alike alike(images, std::move(indices), progress);
        alike.compare();
        dropped.add(alike);
    }
}

}  // namespace

FoundCopies dropCopies(Images& images, const Progress& progress) {
    FoundCopies found;
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> identities;
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (images[i].object.empty()) continue;
        const std::string part = images[i].part ? partInWords(*images[i].part) : "";
        identities[{images[i].object, part}].push_back(i);
    }
    Dropped dropped;
    for (auto& [identity, indices] : identities) {
        if (indices.size() < 2 || progress.cancelled()) continue;
        const std::size_t count = indices.size();
        Alike alike(images, std::move(indices), progress);
        alike.compare();
        dropped.add(alike);
        // Some programs give all pictures one UID.
        constexpr std::size_t fewest = 3;
        found.identityIsShared = count == images.size() && alike.pictures() >= fewest;
        if (found.identityIsShared) continue;
        const bool placed = alike.arePlaced();
        if (placed && alike.elsewhere())
            for (std::string& path : alike.kept()) found.elsewhere.push_back(std::move(path));
        const auto& pair = alike.different() || placed ? alike.different() : alike.elsewhere();
        if (!pair || found.contradiction) continue;
        found.contradicting = identity.first;
        found.contradiction =
            fail(FailureKind::unreadable, images[pair->second].file.path, "(0008,0018) SOP Instance UID",
                 fmt::format("is the same in two files that differ, {}",
                             filesInWords({images[pair->first].file.path, images[pair->second].file.path})),
                 "Take away the one that does not belong here.")
                .value();
    }
    findRenamed(images, dropped, progress);
    for (const std::size_t index : dropped.same) found.dropped.same.push_back(images[index].file.path);
    for (const std::size_t index : dropped.broken) found.dropped.broken.push_back(images[index].file.path);
    Images kept;
    for (std::size_t i = 0; i < images.size(); ++i)
        if (!dropped.contains(i)) kept.push_back(std::move(images[i]));
    images = std::move(kept);
    return found;
}

}  // namespace echolucent
