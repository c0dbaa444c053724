#include "io/dicom/dicom_reader.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "io/dicom/frames/dicom_study.h"
#include "io/dicom/series/concatenation.h"
#include "io/dicom/series/dicom_directory.h"
#include "io/dicom/series/large_stack.h"
#include "io/dicom/volumes/philips_volume.h"
#include "io/study/series_list.h"

namespace echolucent {

namespace {

Result<Study> readLoaded(const InputFile& input, const DicomFile& file, const ReadOptions& options,
                         const Progress& progress) {
    const auto philips = philipsVolumeOf(file);
    const bool asSlices = !philips && philips.error().framesCouldBeSlices && options.framesAsSlices;
    if (!philips && !asSlices) return tl::unexpected(philips.error());
    if (philips && *philips) return readPhilipsVolume(input, file, **philips, options, progress);
    return readMultiframe(file, options, progress);
}

/// Reads a file that was opened by itself, which must be no part of a larger object.
Result<Study> readAlone(const InputFile& input, const ReadOptions& options, const Progress& progress) {
    const auto file = DicomFile::load(input, false, progress);
    if (!file) return tl::unexpected(file.error());
    const auto part = concatenationPartOf(file->dataset());
    if (part && !mayBeWhole(*part)) return onlyAPart(input.path(), *part);
    auto study = readLoaded(input, *file, options, progress);
    if (study && part && !isWhole(*part)) study->warnings.push_back(moreMayBeMissing(1));
    return study;
}

}  // namespace

Result<Study> readDicomFile(const InputFile& input, const ReadOptions& options, const Progress& progress) {
    const auto file = DicomFile::load(input, false, progress);
    if (!file) return tl::unexpected(file.error());
    return readLoaded(input, *file, options, progress);
}

Result<Study> readDicom(const InputFile& file, const ReadOptions& options, const Progress& progress) {
    if (isDirectoryFile(file, progress)) return readDicomFolder(file.path(), options, progress);
    Result<Study> study = fail(FailureKind::unreadable, file.path(), "", "was not read");
    runWithLargeStack([&] { study = readAlone(file, options, progress); });
    return study;
}

Result<Study> readDicomFolder(const std::string& path, const ReadOptions& options, const Progress& progress) {
    const auto list = listSeries(path, progress);
    if (!list) return tl::unexpected(list.error());
    const auto entry = findSeries(*list, options.series);
    if (!entry) return tl::unexpected(entry.error());
    return readSeries(*list, **entry, options, progress);
}

}  // namespace echolucent
