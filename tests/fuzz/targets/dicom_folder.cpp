// Fuzz target: one file among the slices of a folder, listed, shown small and read.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "io/study/series_list.h"
#include "mutations/dicom_mutation.h"
#include "promises.h"
#include "samples/dicom_samples.h"

namespace echolucent {

namespace {

constexpr int longestEdge = 96;

struct FolderOfSlices : FuzzedFolder {
    FolderOfSlices() {
        for (const int slice : {1, 3}) (void)write("IM" + std::to_string(slice), dicomSlice(slice));
    }
};

void requireSoundPicture(const SmallPicture& picture) {
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (picture.width < 1 || picture.height < 1 || picture.width > longestEdge || picture.height > longestEdge ||
        picture.grey.size() != pixels)
        throw BrokenPromise("a small picture has as many pixels as its edges say, and short edges");
}

void read(std::string_view bytes) {
    static const FolderOfSlices folder;
    (void)folder.write("IM2", bytes);
    const auto list = listSeries(folder.path());
    if (!list) return requireSoundRefusal(list.error());
    if (list->series.empty()) throw BrokenPromise("a list that was made holds a series");
    for (const SeriesEntry& entry : list->series) {
        if (entry.files.empty()) throw BrokenPromise("an entry has files");
        if (entry.whyNot) requireSoundRefusal(*entry.whyNot);
        const auto picture = middlePicture(entry, longestEdge);
        picture ? requireSoundPicture(*picture) : requireSoundRefusal(picture.error());
        const auto study = readSeries(*list, entry, optionsOfTargets());
        study ? requireSoundStudy(*study) : requireSoundRefusal(study.error());
    }
}

std::vector<FuzzSample> samples() {
    std::vector<FuzzSample> all = dicomSamples();
    all.push_back({"between", dicomSlice(2)});
    return all;
}

}  // namespace

const FuzzTarget dicomFolderTarget{"dicom-folder", read, mutatedDicom, samples, 32768, "dicom"};

}  // namespace echolucent
