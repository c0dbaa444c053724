#include "io/voxels/large_volumes.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/input_file.h"

namespace echolucent {

std::uint64_t mostStudyBytes(const ReadOptions& options) {
    if (options.studyMebibytes) return static_cast<std::uint64_t>(*options.studyMebibytes) << 20;
    return machineMemoryBytes() / memoryPerVoxels;
}

std::int64_t mostVoxelsOfPhase(std::uint64_t machineBytes) {
    return std::min(mostPhaseVoxels, static_cast<std::int64_t>(machineBytes / workingBytesPerVoxel));
}

std::int64_t mostKeptBytes(StoredType type, bool rescaled) {
    if (rescaled) return bytesOf(StoredType::float32);
    if (type == StoredType::uint8 || type == StoredType::uint16) return bytesOf(type);
    return bytesOf(StoredType::float32);
}

Result<std::optional<ChosenReduction>> chooseReduction(const std::string& file, const std::string& element,
                                                       const DeclaredVoxels& declared, const ReadOptions& options) {
    std::optional<std::int64_t> voxels = 1;
    for (const std::int64_t size : declared.size) voxels = voxels ? checkedProduct(*voxels, size) : std::nullopt;
    const std::uint64_t bytes = mostStudyBytes(options);
    const auto keptBytes = static_cast<std::uint64_t>(mostKeptBytes(declared.type, declared.rescaled));
    const auto inMemory = static_cast<std::int64_t>(bytes / (keptBytes * static_cast<std::uint64_t>(declared.phases)));
    // A person who names a limit knows the machine.
    const std::int64_t ofPhase = options.studyMebibytes ? mostPhaseVoxels : mostVoxelsOfPhase(machineMemoryBytes());
    const std::int64_t most = std::min(inMemory, ofPhase);
    if (voxels && *voxels <= most) return std::optional<ChosenReduction>();
    const auto reduction = reductionTo(declared.size, most);
    if (!reduction)
        return fail(FailureKind::unreadable, file, element,
                    fmt::format("declares {} phase(s) of {} voxels, which cannot be reduced to the {} MiB that they "
                                "may take here",
                                declared.phases, fmt::join(declared.size, " x "), bytes >> 20),
                    "Open it on a larger machine, or a smaller part of it.");
    std::string reason = most == ofPhase ? fmt::format("at most {} voxels are kept of a phase{}", ofPhase,
                                                       ofPhase < mostPhaseVoxels ? " on this machine" : "")
                                         : fmt::format("the voxels of a study may take {} MiB {}", bytes >> 20,
                                                       options.studyMebibytes ? "as asked for" : "on this machine");
    return std::optional(ChosenReduction{*reduction, std::move(reason)});
}

std::string reductionWarning(const ChosenReduction& chosen) {
    const Reduction& reduction = chosen.reduction;
    return fmt::format(
        "The file holds {} voxels, and {}: one voxel shows the mean of {}. Lengths stay true, but fine detail is "
        "averaged away. Open a smaller part of the volume to see it.",
        fmt::join(reduction.storedSize, " x "), chosen.reason, factorsText(reduction));
}

}  // namespace echolucent
