// What every reader promises of what it gives, whatever the file holds.
#pragma once

#include "io/study/study.h"

namespace echolucent {

/// Throws BrokenPromise unless the study has phases of one size and type, with as many voxels as their size says, a
/// geometry and a white level of finite numbers, and a report of one line each without an empty source.
void requireSoundStudy(const Study& study);
/// Throws BrokenPromise unless the failure says in one line of at most 1,500 bytes what is wrong and what to do.
void requireSoundRefusal(const Failure& failure);

/// How the targets read: voxels along beams become grids of 4 MiB at most, since larger ones would take most of the
/// time.
[[nodiscard]] inline ReadOptions optionsOfTargets() {
    ReadOptions options;
    options.conversionMebibytes = 4;
    return options;
}

/// Reads the file or folder and requires one or the other. What could be opened with frames as slices is opened so too.
void requireSoundReading(const std::string& path, const ReadOptions& options = optionsOfTargets());

}  // namespace echolucent
