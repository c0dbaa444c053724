// Fuzz target: files that are packed with gzip.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/gzip_mutation.h"
#include "promises.h"
#include "samples/binary_samples.h"

namespace echolucent {

namespace {

void read(std::string_view bytes) {
    static const FuzzedFolder folder;
    requireSoundReading(folder.write("scan.gz", bytes));
}

}  // namespace

const FuzzTarget gzipTarget{"gzip", read, mutatedGzip, gzipSamples, 16384, ""};

}  // namespace echolucent
