#include "io/dicom/frames/functional_groups.h"

#include <fmt/format.h>

#include "io/dicom/frames/date_times.h"
#include "io/dicom/frames/dicom_geometry.h"
#include "io/dicom/frames/picture_scale.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

constexpr DicomTag orientationVolumeTag{0x0020, 0x9302};
constexpr DicomTag orientationPatientTag{0x0020, 0x0037};

/// Reads one item of functional groups into the groups of a frame. Stops at the first value that makes no sense.
class GroupsReader {
public:
    GroupsReader(FrameGroups& groups, const std::string& path, std::string whose)
        : m_groups(groups), m_path(path), m_whose(std::move(whose)) {}

    Result<void> read(DcmItem& item);

private:
    /// Takes what `parse` finds in an attribute of a group. Fails if the attribute is there but `parse` finds nothing.
    template <typename Value, typename Parse>
    void take(DcmItem& item, DicomTag group, DicomTag attribute, const char* name, const char* must,
              std::optional<Value>& value, const Parse& parse) {
        DcmItem* holder = dicomFirstItem(item, group);
        if (m_failure || holder == nullptr || !dicomHas(*holder, attribute)) return;
        if (auto found = parse(*holder, attribute))
            value = found;
        else
            m_failure = fail(FailureKind::unreadable, m_path, tagText(attribute) + " " + name,
                             fmt::format("of {} {}", m_whose, must), exportAgain)
                            .value();
    }

    FrameGroups& m_groups;
    const std::string& m_path;
    const std::string m_whose;  ///< "frame 3" or "all frames"
    std::optional<Failure> m_failure;
};

/// Takes the times of a frame that no reader needs: one that makes no sense is left out.
void takeTimesOf(DcmItem& item, FrameGroups& groups) {
    constexpr DicomTag contentGroup{0x0020, 0x9111}, cardiacGroup{0x0018, 0x9118}, respiratoryGroup{0x0020, 0x9253};
    if (DcmItem* content = dicomFirstItem(item, contentGroup)) {
        if (const auto time = secondsOfDateTime(dicomText(*content, {0x0018, 0x9151}))) groups.referenceTime = time;
        if (const auto time = secondsOfDateTime(dicomText(*content, {0x0018, 0x9074}))) groups.acquisitionTime = time;
    }
    const auto takeDelay = [&](DicomTag group, DicomTag nominal, DicomTag actual) {
        DcmItem* const synchronized = dicomFirstItem(item, group);
        if (synchronized == nullptr) return;
        for (const DicomTag tag : {actual, nominal}) {
            const auto delay = dicomNumber(*synchronized, tag);
            if (!delay) continue;
            groups.triggerDelay = *delay / 1000;
            groups.delayTag = tag;
        }
    };
    takeDelay(respiratoryGroup, {0x0020, 0x9255}, {0x0020, 0x9257});
    takeDelay(cardiacGroup, {0x0020, 0x9153}, {0x0020, 0x9252});
}

Result<void> GroupsReader::read(DcmItem& item) {
    constexpr DicomTag positionVolumeGroup{0x0020, 0x930e}, orientationVolumeGroup{0x0020, 0x930f};
    constexpr DicomTag positionPatientGroup{0x0020, 0x9113}, orientationPatientGroup{0x0020, 0x9116};
    constexpr DicomTag measuresGroup{0x0028, 0x9110}, temporalGroup{0x0020, 0x9310};
    constexpr DicomTag contentGroup{0x0020, 0x9111}, dataTypeGroup{0x0018, 0x9807};
    const char* const noPoint = "is no position: three numbers that are finite";
    const char* const noDirections = "is no pair of perpendicular directions";
    take(item, positionVolumeGroup, positionVolumeTag, "Image Position (Volume)", noPoint, m_groups.inVolume.position,
         dicomPoint);
    take(item, orientationVolumeGroup, orientationVolumeTag, "Image Orientation (Volume)", noDirections,
         m_groups.inVolume.orientation, dicomOrientation);
    take(item, positionPatientGroup, positionPatientTag, "Image Position (Patient)", noPoint,
         m_groups.inPatient.position, dicomPoint);
    take(item, orientationPatientGroup, orientationPatientTag, "Image Orientation (Patient)", noDirections,
         m_groups.inPatient.orientation, dicomOrientation);
    take(item, measuresGroup, pixelSpacingTag, "Pixel Spacing", "is not two numbers above 0", m_groups.pixelSpacing,
         [](DcmItem& holder, DicomTag) { return dicomPixelSpacing(holder); });
    take(item, measuresGroup, sliceDistanceTag, "Spacing Between Slices", "is no number", m_groups.betweenSlices,
         dicomNumber);
    take(item, temporalGroup, timeOffsetTag, "Temporal Position Time Offset", "is no number of seconds",
         m_groups.timeOffset, dicomNumber);
    take(item, contentGroup, temporalIndexTag, "Temporal Position Index", "is no whole number", m_groups.temporalIndex,
         dicomWholeNumber);
    if (m_failure) return tl::unexpected(*m_failure);
    takeTimesOf(item, m_groups);
    if (DcmItem* holder = dicomFirstItem(item, contentGroup); holder != nullptr && dicomHas(*holder, indexValuesTag))
        m_groups.indexValues = dicomLongWords(*holder, indexValuesTag);
    if (DcmItem* holder = dicomFirstItem(item, dataTypeGroup)) m_groups.dataType = dicomText(*holder, dataTypeTag);
    return {};
}

}  // namespace

Result<std::vector<FrameGroups>> readFunctionalGroups(DcmItem& dataset, const std::string& path, std::size_t frames,
                                                      const Progress& progress) {
    const std::size_t described = dicomSequenceLength(dataset, perFrameGroupsTag);
    if (described == 0) return std::vector<FrameGroups>{};
    if (described != frames)
        return fail(FailureKind::unreadable, path, tagText(perFrameGroupsTag) + " Per-frame Functional Groups",
                    fmt::format("describes {} frames where Number of Frames says {}", described, frames), exportAgain);
    FrameGroups shared;
    if (DcmItem* item = dicomFirstItem(dataset, sharedGroupsTag))
        if (auto read = GroupsReader(shared, path, "all frames").read(*item); !read)
            return tl::unexpected(read.error());
    std::vector<FrameGroups> groups(described, shared);
    Result<void> read;
    std::size_t frame = 0;
    dicomVisitItems(dataset, perFrameGroupsTag, [&](DcmItem& item) {
        if (progress.cancelled()) return false;
        read = GroupsReader(groups[frame], path, fmt::format("frame {}", frame + 1)).read(item);
        ++frame;
        return read.has_value();
    });
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    if (!read) return tl::unexpected(read.error());
    return groups;
}

}  // namespace echolucent
