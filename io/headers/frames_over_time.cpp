#include "io/headers/frames_over_time.h"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "io/files/header_text.h"

namespace echolucent {

namespace {

/// The frames that keys such as Seq_Frame0012_ProbeToTrackerTransform tell of.
struct SequenceKeys {
    std::set<std::string> frames, tracked;  ///< numbers of the frames with any key, and with a transform
    std::string frameKey, transformKey;     ///< the first key of each, fit for a message
};

SequenceKeys sequenceKeys(const std::vector<std::string>& keys) {
    constexpr std::string_view beginning = "Seq_Frame";
    SequenceKeys found;
    for (const std::string& key : keys) {
        if (!key.starts_with(beginning)) continue;
        const auto end = key.find('_', beginning.size());
        const std::string number = key.substr(beginning.size(), end - beginning.size());
        if (end == std::string::npos || !wholeNumber(number)) continue;
        if (found.frames.insert(number).second && found.frameKey.empty()) found.frameKey = quotedText(key);
        if (!key.ends_with("Transform")) continue;
        if (found.tracked.insert(number).second && found.transformKey.empty()) found.transformKey = quotedText(key);
    }
    return found;
}

tl::unexpected<Failure> refuseSweep(const StoredVolume& stored, const SequenceKeys& keys) {
    const std::int64_t frames = stored.phases > 1 ? stored.phases : stored.geometry.size[2];
    auto refused =
        fail(FailureKind::unreadable, stored.path, keys.transformKey,
             fmt::format("tells where the probe was: this is a tracked 2D sweep of {} frames, not a volume", frames),
             "Reconstruct a volume from it with Plus (VolumeReconstructor) or 3D Slicer (SlicerIGT). Or add "
             "--frames-as-slices to take its frames as slices of unknown spacing.");
    refused.value().framesCouldBeSlices = true;
    return refused;
}

tl::unexpected<Failure> refuseCine(const std::string& path, const std::string& key, const std::string& says) {
    auto refused = fail(FailureKind::unreadable, path, key, says + ": these are 2D frames over time, not a volume",
                        "Add --frames-as-slices to take the frames as slices of unknown spacing.");
    refused.value().framesCouldBeSlices = true;
    return refused;
}

/// Turns the phases of a single slice into slices: along x if the phase is the fastest axis, else along z.
std::size_t turnPhasesIntoSlices(StoredVolume& stored) {
    VolumeGeometry& geometry = stored.geometry;
    const std::size_t axis = stored.phasesFastest ? 0 : 2;
    if (axis == 0) {
        geometry.size = {stored.phases, geometry.size[0], geometry.size[1]};
        geometry.spacing = {1.0, geometry.spacing[0], geometry.spacing[1]};
    } else {
        geometry.size[2] = stored.phases;
    }
    stored.phases = 1;
    stored.phasesFastest = false;
    stored.phaseTimes = {};
    return axis;
}

/// Takes the frames along `axis` as slices. The scale within the frames stays.
void takeAsSlices(StoredVolume& stored, std::size_t axis, const std::string& story) {
    VolumeGeometry& geometry = stored.geometry;
    const bool scaled = geometry.spacingKnown && !stored.spacingSource.empty();
    const auto across = static_cast<int>(axis == 0 ? 1 : 0), down = static_cast<int>(axis == 2 ? 1 : 2);
    geometry.spacing[static_cast<int>(axis)] = std::min(geometry.spacing[across], geometry.spacing[down]);
    geometry.spacingKnown = false;
    geometry.direction = Mat3::eye();
    geometry.origin = {0, 0, 0};
    geometry.patientFrameKnown = false;
    stored.inPlaneSpacingKnown = scaled;
    stored.sliceAxis = static_cast<int>(axis);
    stored.warnings.push_back(story);
}

}  // namespace

bool mayBeAxisOfVolume(std::string_view kind) {
    constexpr std::array<std::string_view, 7> kinds{"", "domain", "space", "???", "none", "time", "list"};
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

Result<void> settleFrames(StoredVolume& stored, const FrameWords& words, bool framesAsSlices) {
    const SequenceKeys keys = sequenceKeys(words.keys);
    const bool flat = stored.phases > 1 && stored.geometry.size[2] == 1;
    const bool framesAlongZ = flat || (stored.phases == 1 && keys.frames.size() > 1);
    if (framesAlongZ && keys.tracked.size() > 1) {
        if (!framesAsSlices) return refuseSweep(stored, keys);
        takeAsSlices(stored, flat ? turnPhasesIntoSlices(stored) : 2,
                     "A tracked 2D sweep is taken as slices: where its frames lay (" + keys.transformKey +
                         " and the others) is left out.");
        return {};
    }
    const auto time = std::find(words.kinds.begin(), words.kinds.end(), "time");
    const bool overTime = time != words.kinds.end();
    if (overTime || framesAlongZ) {
        const auto axis = overTime ? static_cast<std::size_t>(time - words.kinds.begin()) : 2;
        if (!framesAsSlices && flat)
            return refuseCine(stored.path, stored.sizeKey,
                              fmt::format("has one slice and {} time points", stored.phases));
        if (!framesAsSlices)
            return overTime ? refuseCine(stored.path, words.kindsKey, fmt::format("says that {} is time", "xyz"[axis]))
                            : refuseCine(stored.path, keys.frameKey, "tells of one frame among others");
        takeAsSlices(stored, flat ? turnPhasesIntoSlices(stored) : axis, "2D frames over time are taken as slices.");
        return {};
    }
    const auto list = std::find(words.kinds.begin(), words.kinds.end(), "list");
    if (list != words.kinds.end()) {
        stored.geometry.spacingKnown = false;
        stored.warnings.push_back(fmt::format(
            "{} calls the axis {} a list, which 2D frames carry as well as volumes: nothing says for sure that it is "
            "space.",
            words.kindsKey, "xyz"[list - words.kinds.begin()]));
    }
    if (stored.phases > 1 && keys.tracked.size() > 1)
        stored.warnings.push_back("The probe was tracked over the phases (" + keys.transformKey +
                                  " and the others); its movement is left out.");
    return {};
}

}  // namespace echolucent
