// Fuzz target: what a fragment holds, as the frames of a good header. The first byte chooses transfer syntax and form.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/byte_mutation.h"
#include "promises.h"
#include "samples/dicom_samples.h"

namespace echolucent {

namespace {

void read(std::string_view bytes) {
    static const FuzzedFolder folder;
    if (bytes.empty()) return;
    const std::size_t form = static_cast<unsigned char>(bytes.front()) % fragmentForms().size();
    requireSoundReading(folder.write("scan.dcm", dicomOfFragment(form, std::string(bytes.substr(1)))));
}

std::string mutated(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    if (bytes.empty() || dice.oneIn(16)) return mutatedBytes(std::move(bytes), seed);
    return bytes.substr(0, 1) + mutatedBytes(bytes.substr(1), seed);
}

}  // namespace

const FuzzTarget dicomPixelsTarget{"dicom-pixels", read, mutated, fragmentSamples, 4096, ""};

}  // namespace echolucent
