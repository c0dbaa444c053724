// Fuzz target: one file beside a part of an object, slices over time, series of one slice each, and a copy.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "io/study/series_list.h"
#include "mutations/dicom_mutation.h"
#include "promises.h"
#include "samples/dicom_samples.h"

namespace echolucent {

namespace {

constexpr int longestEdge = 96;

struct FolderOfSeries : FuzzedFolder {
    FolderOfSeries() {
        (void)write("part", dicomPart(1));
        for (const int moment : {0, 1, 2}) (void)write("moment" + std::to_string(moment), dicomMoment(moment));
        for (const int lone : {0, 1}) (void)write("lone" + std::to_string(lone), dicomLoneSlice(lone));
        (void)write("copied", dicomSlice(7));
    }
};

void read(std::string_view bytes) {
    static const FolderOfSeries folder;
    (void)folder.write("changed", bytes);
    const auto list = listSeries(folder.path());
    if (!list) return requireSoundRefusal(list.error());
    for (const SeriesEntry& entry : list->series) {
        const auto files = static_cast<std::int64_t>(entry.files.size());
        if (files == 0 || entry.phases.count < 1 || files % entry.phases.count != 0)
            throw BrokenPromise("an entry has as many files for each phase");
        if (entry.whyNot) requireSoundRefusal(*entry.whyNot);
        if (const auto picture = middlePicture(entry, longestEdge); !picture) requireSoundRefusal(picture.error());
        const auto study = readSeries(*list, entry, optionsOfTargets());
        study ? requireSoundStudy(*study) : requireSoundRefusal(study.error());
    }
}

std::vector<FuzzSample> samples() {
    return {{"part", dicomPart(2)},
            {"part-again", dicomPart(1)},
            {"moment", dicomMoment(3)},
            {"lone", dicomLoneSlice(2)},
            {"copy", dicomSlice(7)}};
}

}  // namespace

const FuzzTarget dicomSeriesTarget{"dicom-series", read, mutatedDicom, samples, 32768, "dicom"};

}  // namespace echolucent
