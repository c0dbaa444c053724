#include "io/dicom/volumes/joined_parts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/frames/dicom_geometry.h"
#include "io/dicom/frames/frame_vectors.h"
#include "io/dicom/frames/functional_groups.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/files/files_below.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

/// No object of scanners needs as many groups; copies of them take memory.
constexpr std::size_t mostCopiedGroups = mostElements;
constexpr unsigned long mostGroupsOfAFrame = 1000;

struct SharedAttribute {
    DicomTag tag;
    const char* name;
};
/// What must be the same in all parts.
constexpr std::array sharedAttributes{
    SharedAttribute{{0x0028, 0x0010}, "Rows"},
    SharedAttribute{{0x0028, 0x0011}, "Columns"},
    SharedAttribute{{0x0028, 0x0002}, "Samples per Pixel"},
    SharedAttribute{{0x0028, 0x0100}, "Bits Allocated"},
    SharedAttribute{{0x0028, 0x0101}, "Bits Stored"},
    SharedAttribute{{0x0028, 0x0103}, "Pixel Representation"},
    SharedAttribute{{0x0008, 0x0016}, "SOP Class UID"},
    SharedAttribute{{0x0020, 0x0052}, "Frame of Reference UID"},
};

constexpr DicomTag frameTimesTag{0x0018, 0x1065};
constexpr DicomTag frameOffsetsTag{0x3004, 0x000c};

class PartJoiner {
public:
    explicit PartJoiner(std::vector<DicomFile> parts) : m_parts(std::move(parts)) {}

    Result<DicomFile> join() {
        for (const DicomFile& part : m_parts)
            if (auto alike = checkAlike(part); !alike) return tl::unexpected(alike.error());
        const bool groupsDiffer = std::ranges::any_of(
            m_parts, [&](const DicomFile& part) { return !sameGroups(part.dataset(), m_parts.front().dataset()); });
        std::int64_t frames = 0;
        for (const DicomFile& part : m_parts) {
            const std::int64_t own = dicomFrameCount(part.dataset());
            const std::size_t described = dicomSequenceLength(part.dataset(), perFrameGroupsTag);
            if (described != 0 && static_cast<std::int64_t>(described) != own)
                return fail(
                    FailureKind::unreadable, part.path(), tagText(perFrameGroupsTag) + " Per-frame Functional Groups",
                    fmt::format("describes {} frames where Number of Frames says {}", described, own), exportAgain);
            frames += own;
            if (groupsDiffer)
                if (auto kept = keepGroups(part); !kept) return tl::unexpected(kept.error());
        }
        joinValues();
        DicomFile& first = m_parts.front();
        if (groupsDiffer) delete first.dataset().remove(DCM_SharedFunctionalGroupsSequence);
        for (std::size_t part = 1; part < m_parts.size(); ++part) moveFrames(m_parts[part].dataset(), first.dataset());
        first.dataset().putAndInsertString(DCM_NumberOfFrames, std::to_string(frames).c_str());
        return std::move(first);
    }

private:
    [[nodiscard]] Result<void> checkAlike(const DicomFile& part) const {
        const DicomFile& first = m_parts.front();
        for (const SharedAttribute& one : sharedAttributes) {
            const std::string own = dicomText(part.dataset(), one.tag), wanted = dicomText(first.dataset(), one.tag);
            if (own != wanted)
                return fail(
                    FailureKind::unreadable, part.path(), tagText(one.tag) + " " + one.name,
                    fmt::format("differs between parts of one object, {}", filesInWords({first.path(), part.path()})),
                    "Export the object again.");
        }
        return {};
    }

    static DcmItem* sharedGroups(DcmItem& dataset) { return dicomFirstItem(dataset, sharedGroupsTag); }

    static bool sameGroups(DcmItem& one, DcmItem& other) {
        DcmItem* const a = sharedGroups(one);
        DcmItem* const b = sharedGroups(other);
        return a == nullptr || b == nullptr || a == b ? a == b : sameObjects(*a, *b);
    }

    /// Compares two objects in time in proportion to their size; DCMTK's own comparison is quadratic. The objects must
    /// not be the same one.
    static bool sameObjects(DcmObject& a, DcmObject& b) {
        if (a.getTag() != b.getTag() || a.isLeaf() != b.isLeaf()) return false;
        if (a.isLeaf()) return sameValues(static_cast<DcmElement&>(a), static_cast<DcmElement&>(b));
        DcmObject *one = a.nextInContainer(nullptr), *other = b.nextInContainer(nullptr);
        while (one != nullptr && other != nullptr && sameObjects(*one, *other)) {
            one = a.nextInContainer(one);
            other = b.nextInContainer(other);
        }
        return one == nullptr && other == nullptr;
    }

    static bool sameValues(DcmElement& a, DcmElement& b) {
        const Uint32 bytes = a.getLengthField();
        if (bytes != b.getLengthField()) return false;
        std::vector<std::uint8_t> one(bytes), other(bytes);
        return bytes == 0 || (a.getPartialValue(one.data(), 0, bytes).good() &&
                              b.getPartialValue(other.data(), 0, bytes).good() && one == other);
    }

    static std::size_t elementsIn(DcmObject& object) {
        std::size_t count = 1;
        for (DcmObject* one = object.nextInContainer(nullptr); one != nullptr && count < mostCopiedGroups;
             one = object.nextInContainer(one))
            count += elementsIn(*one);
        return count;
    }

    /// Copies the groups of all frames of a part into each of its frames that lacks them.
    Result<void> keepGroups(const DicomFile& part) {
        DcmItem* shared = sharedGroups(part.dataset());
        if (shared == nullptr) return {};
        const std::size_t frames = dicomSequenceLength(part.dataset(), perFrameGroupsTag);
        const std::size_t each = elementsIn(*shared);
        if (frames == 0) return {};
        if (shared->card() > mostGroupsOfAFrame) m_copied = mostCopiedGroups;  // each is looked for in a list
        m_copied += each > mostCopiedGroups / frames ? mostCopiedGroups : each * frames;
        if (m_copied >= mostCopiedGroups)
            return fail(FailureKind::unreadable, part.path(), tagText(sharedGroupsTag) + " Shared Functional Groups",
                        "differ from part to part and are too many to be kept for each frame", exportAgain);
        dicomVisitItems(part.dataset(), perFrameGroupsTag, [&](DcmItem& frame) {
            for (DcmObject* one = shared->nextInContainer(nullptr); one != nullptr;
                 one = shared->nextInContainer(one)) {
                if (frame.tagExists(one->getTag())) continue;
                auto copy = std::unique_ptr<DcmElement>(static_cast<DcmElement*>(one->clone()));
                if (copy && frame.insert(copy.get()).good()) (void)copy.release();
            }
            return true;
        });
        return {};
    }

    /// Joins the attributes of the old kind that hold a value a frame, if every part has them.
    void joinValues() {
        DcmItem& first = m_parts.front().dataset();
        std::string times;
        const bool timed = std::ranges::all_of(m_parts, [&](const DicomFile& part) {
            const std::string own = dicomText(part.dataset(), frameTimesTag);
            times += (times.empty() ? "" : "\\") + own;
            return !own.empty();
        });
        if (timed) first.putAndInsertString(DcmTag(frameTimesTag.group, frameTimesTag.element), times.c_str());
        for (const DicomTag tag : frameVectorTags()) {
            std::vector<std::uint16_t> joined;
            const bool all = std::ranges::all_of(m_parts, [&](const DicomFile& part) {
                const std::vector<std::uint16_t> own = dicomWords(part.dataset(), tag);
                joined.insert(joined.end(), own.begin(), own.end());
                return !own.empty();
            });
            if (all)
                first.putAndInsertUint16Array(DcmTag(tag.group, tag.element), joined.data(),
                                              static_cast<unsigned long>(joined.size()));
        }
        joinOffsets();
    }

    /// Joins the distances of frames along the normal, which count from the position of each part. Parts with a
    /// position of their own and one distance between all frames get such distances too.
    void joinOffsets() {
        DcmItem& first = m_parts.front().dataset();
        const auto start = dicomPoint(first, positionPatientTag);
        const auto axes = dicomOrientation(first, DicomTag{0x0020, 0x0037});
        const Vec3 normal = axes ? (*axes)[0].cross((*axes)[1]) : Vec3(0, 0, 1);
        const bool byOffsets = std::ranges::all_of(
            m_parts, [](const DicomFile& part) { return dicomHas(part.dataset(), frameOffsetsTag); });
        bool moved = false;
        std::string joined;
        for (const DicomFile& part : m_parts) {
            const auto frames = static_cast<std::size_t>(dicomFrameCount(part.dataset()));
            const auto position = dicomPoint(part.dataset(), positionPatientTag);
            const double shift = start && position ? (*position - *start).dot(normal) : 0.0;
            moved = moved || shift != 0.0;
            const auto between = dicomNumber(part.dataset(), sliceDistanceTag);
            const std::vector<double> offsets =
                byOffsets ? dicomNumbers(part.dataset(), frameOffsetsTag, frames) : std::vector<double>();
            if (byOffsets ? offsets.empty() : !between || frames > mostCopiedGroups) return;
            for (std::size_t frame = 0; frame < frames; ++frame)
                joined += fmt::format("{}{:.9g}", joined.empty() ? "" : "\\",
                                      shift + (byOffsets ? offsets[frame] : *between * static_cast<double>(frame)));
        }
        if (byOffsets || moved)
            first.putAndInsertString(DcmTag(frameOffsetsTag.group, frameOffsetsTag.element), joined.c_str());
    }

    /// Moves the groups of single frames of `from` behind those of `to`.
    static void moveFrames(DcmItem& from, DcmItem& to) {
        DcmSequenceOfItems *source = nullptr, *target = nullptr;
        if (from.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, source).bad() || source == nullptr) return;
        if (to.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, target).bad() || target == nullptr) return;
        while (source->card() > 0) {
            DcmItem* frame = source->remove(0UL);
            if (frame == nullptr) return;
            if (target->append(frame).bad()) {
                delete frame;
                return;
            }
        }
    }

    std::vector<DicomFile> m_parts;
    std::size_t m_copied = 0;
};

}  // namespace

Result<DicomFile> joinedHeader(const std::vector<std::string>& paths, const Progress& progress) {
    std::vector<DicomFile> parts;
    for (const std::string& path : paths) {
        auto part = DicomFile::load(path, true, progress);
        if (!part) return tl::unexpected(part.error());
        parts.push_back(std::move(*part));
    }
    return PartJoiner(std::move(parts)).join();
}

}  // namespace echolucent
