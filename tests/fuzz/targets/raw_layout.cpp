// Fuzz target: the layout that is kept beside a raw file.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/json_mutation.h"
#include "promises.h"
#include "samples/json_samples.h"

namespace echolucent {

namespace {

struct FolderOfVoxels : FuzzedFolder {
    const std::string raw = write("scan.raw", std::string(rawVoxelBytes, 'v'));
};

void read(std::string_view bytes) {
    static const FolderOfVoxels folder;
    (void)folder.write("scan.raw.echolucent.json", bytes);
    ReadOptions options;
    // A sweep of a few beams may be wide: the grid that it is converted to is kept small here.
    options.conversionMebibytes = 1;
    requireSoundReading(folder.raw, options);
}

}  // namespace

const FuzzTarget rawLayoutTarget{"raw-layout", read, mutatedJson, rawLayoutSamples, 8192, "json"};

}  // namespace echolucent
