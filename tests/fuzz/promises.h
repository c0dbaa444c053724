// The promises of every reader, whatever the file holds.
#pragma once

#include "io/study/study.h"

namespace echolucent {

/// Throws BrokenPromise unless the study is sound. Its phases have one size and type, and as many voxels as their size
/// says. Geometry and white level are finite. Each entry of the report is one line and has a source.
void requireSoundStudy(const Study& study);
/// Throws BrokenPromise unless the failure says in one line, at most 1,500 bytes, what is wrong and what to do.
void requireSoundRefusal(const Failure& failure);

/// Options of all targets. Voxels along beams become grids of 4 MiB at most, because larger ones would take most of the
/// time.
[[nodiscard]] inline ReadOptions optionsOfTargets() {
    ReadOptions options;
    options.conversionMebibytes = 4;
    return options;
}

/// Reads the file or folder and requires a sound study or a sound refusal. A file that can be opened with frames as
/// slices is also opened so.
void requireSoundReading(const std::string& path, const ReadOptions& options = optionsOfTargets());

}  // namespace echolucent
