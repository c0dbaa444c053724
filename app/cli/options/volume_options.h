// The options of commands that read a volume, and the check of what a command writes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/polar_options.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "processing/document/study_reference.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// Options of commands that read a volume: VOLUME, --series, --phase, raw layout, --conversion-memory, --study-memory,
/// --frames-as-slices, --all-voxels.
struct VolumeOptions {
    std::string path;
    int phase = 0;
    ReadOptions read;
    std::string series;  ///< UID or number in the list of a folder's series, from 1; empty if it is not given
    std::string rawSize, rawSpacing, rawType, rawByteOrder;
    std::int64_t rawHeaderBytes = 0;
    PolarOptions rawPolar;

    void addTo(CLI::App& command);
    /// Reads the study. Fails if it cannot be read. Fails (wrong usage) if an option is out of range or contradicts
    /// another, or if one of the `outputs` of the command is a file of the study: an input is never overwritten.
    [[nodiscard]] Result<Study> readAll(const std::vector<std::string>& outputs) const;
    /// The series of a folder or DICOMDIR. No value for other files, and --series is wrong usage for them.
    [[nodiscard]] Result<std::optional<SeriesList>> listedSeries() const;
    /// The series of `list` that --series names; if --series is not given, the one that findSeries() picks. Fails
    /// (wrong usage) if there is no such series.
    [[nodiscard]] Result<const SeriesEntry*> chosenSeries(const SeriesList& list) const;
    /// Reads the study as readAll() does. `list` is what listedSeries() returned.
    [[nodiscard]] Result<Study> readListed(const std::optional<SeriesList>& list,
                                           const std::vector<std::string>& outputs) const;
    /// A study, and how a document names it: path, options of reading and the series' UID, but no raw layout and no
    /// checksum.
    struct Named {
        Study study;
        StudyFile reference;
    };
    /// Reads the study as readAll() does.
    [[nodiscard]] Result<Named> readNamed(const std::vector<std::string>& outputs) const;
    /// Reads the study as readAll() does, and gives the volume of the phase that --phase names.
    [[nodiscard]] Result<std::shared_ptr<const Volume>> readPhase(const std::vector<std::string>& outputs) const;
};

/// Checks the outputs of a command before it begins. Fails (wrong usage) if two of the `outputs` name the same file,
/// and as placeOfOutput() does. Empty outputs are left out, and "-" may be named several times. `curveNames` are names
/// as curveFromName() takes them: the files of manual curves are inputs from here on, and no output may be one of them.
/// The files of the volume are checked when it is read (VolumeOptions::readAll()).
[[nodiscard]] Result<void> checkOutputs(const std::vector<std::string>& outputs,
                                        const std::vector<std::string>& curveNames = {});

}  // namespace echolucent::cli
