// Linked into the command line, this leaves it the kernels for AVX2, also on a processor with wider instruction sets.
#include <hwy/targets.h>

namespace {

/// Before main(), as a kernel is chosen once. Highway gives a wider instruction set a lower bit.
[[maybe_unused]] const bool nothingIsWiderThanAvx2 = [] {
    hwy::DisableTargets(HWY_AVX2 - 1);
    return true;
}();

}  // namespace
