// DICOM files to begin from.
#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/fuzz_target.h"

namespace echolucent {

/// Multi-frame files in every transfer syntax that is read, Enhanced US Volumes, palettes, and manufacturers' volumes.
[[nodiscard]] std::vector<FuzzSample> dicomSamples();
/// Slice `instance` of a small series in the patient's frame.
[[nodiscard]] std::string dicomSlice(int instance);
/// Part `number`, 1 or 2, of an object of four frames that is kept in two files.
[[nodiscard]] std::string dicomPart(int number);
/// Picture `number`, 0 to 3, of a series of two places at two moments.
[[nodiscard]] std::string dicomMoment(int number);
/// A slice that has a series of its own and lies beside those of other numbers.
[[nodiscard]] std::string dicomLoneSlice(int number);

/// The form of a fragment's pixels.
struct FragmentForm {
    std::string transferSyntax;
    int columns, rows, samples, bits;
};
/// The forms that a fragment is wrapped in, by number.
[[nodiscard]] const std::vector<FragmentForm>& fragmentForms();
/// A file of two frames. Both are this fragment. `form` is below fragmentForms().size().
[[nodiscard]] std::string dicomOfFragment(std::size_t form, const std::string& fragment);
/// Good fragments, each after a byte with the number of its form.
[[nodiscard]] std::vector<FuzzSample> fragmentSamples();

}  // namespace echolucent
