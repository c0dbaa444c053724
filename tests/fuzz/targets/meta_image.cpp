// Fuzz target: MetaImages, with their voxels or beside files that hold them.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/text_header_mutation.h"
#include "promises.h"
#include "samples/text_header_samples.h"

namespace echolucent {

namespace {

/// A folder with the files that headers may name.
struct FolderOfVoxels : FuzzedFolder {
    FolderOfVoxels() {
        for (const char* name : {"voxels.raw", "a 50% of it.raw", "v%2d 50%.raw"})
            (void)write(name, std::string(64, 'v'));
        for (const char* name : {"v1.raw", "v2.raw", "v3.raw"}) (void)write(name, std::string(12, 'v'));
    }
};

void read(std::string_view bytes) {
    static const FolderOfVoxels folder;
    requireSoundReading(folder.write("scan.mha", bytes));
}

}  // namespace

const FuzzTarget metaImageTarget{"meta-image", read, mutatedMetaImage, metaImageSamples, 8192, "meta-image"};

}  // namespace echolucent
