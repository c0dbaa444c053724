// Fuzz target: one DICOM file, from its bytes to a study.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "mutations/dicom_mutation.h"
#include "promises.h"
#include "samples/dicom_samples.h"

namespace echolucent {

namespace {

void read(std::string_view bytes) {
    static const FuzzedFolder folder;
    requireSoundReading(folder.write("scan.dcm", bytes));
}

}  // namespace

const FuzzTarget dicomTarget{"dicom", read, mutatedDicom, dicomSamples, 32768, "dicom"};

}  // namespace echolucent
