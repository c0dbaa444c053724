// Fuzz target: GE Voluson volumes.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/kretz_mutation.h"
#include "promises.h"
#include "samples/binary_samples.h"

namespace echolucent {

namespace {

void read(std::string_view bytes) {
    static const FuzzedFolder folder;
    requireSoundReading(folder.write("scan.vol", bytes));
}

}  // namespace

const FuzzTarget kretzTarget{"kretz", read, mutatedKretz, kretzSamples, 8192, "kretz"};

}  // namespace echolucent
