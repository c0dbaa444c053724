// Fuzz target: a DICOMDIR beside the slices that it may name.
#include "dicom_bytes.h"
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "io/study/series_list.h"
#include "mutations/dicom_mutation.h"
#include "promises.h"
#include "samples/dicom_samples.h"

namespace echolucent {

namespace {

struct FolderOfSlices : FuzzedFolder {
    FolderOfSlices() {
        for (int slice = 1; slice <= 3; ++slice) (void)write("IM" + std::to_string(slice), dicomSlice(slice));
    }
};

void read(std::string_view bytes) {
    static const FolderOfSlices folder;
    const std::string path = folder.write("DICOMDIR", bytes);
    (void)holdsSeries(path);
    requireSoundReading(path);
}

std::vector<FuzzSample> samples() {
    return {{"all", dicomDirectory({"IM1", "IM2", "IM3"})},
            {"gone", dicomDirectory({"IM1", "GONE", "..\\IM2", "IM3"})}};
}

}  // namespace

const FuzzTarget dicomDirectoryTarget{"dicom-directory", read, mutatedDicom, samples, 8192, "dicom"};

}  // namespace echolucent
