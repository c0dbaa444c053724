// Fuzz target: NIfTI, with the voxels in the same file or in one beside it.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/nifti_mutation.h"
#include "promises.h"
#include "samples/binary_samples.h"

namespace echolucent {

namespace {

struct FolderOfVoxels : FuzzedFolder {
    FolderOfVoxels() { (void)write("scan.img", std::string(24, 'v')); }
};

void read(std::string_view bytes) {
    static const FolderOfVoxels folder;
    requireSoundReading(folder.write("scan.nii", bytes));
}

}  // namespace

const FuzzTarget niftiTarget{"nifti", read, mutatedNifti, niftiSamples, 8192, ""};

}  // namespace echolucent
