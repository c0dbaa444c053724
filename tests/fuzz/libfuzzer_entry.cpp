// The program of all fuzz targets for clang's libFuzzer; ECHOLUCENT_FUZZ_TARGET in the environment names one.
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "fuzz_target.h"
#include "mutations/dice.h"

namespace {

const echolucent::FuzzTarget& target() {
    static const echolucent::FuzzTarget& named = []() -> const echolucent::FuzzTarget& {
        const char* name = std::getenv("ECHOLUCENT_FUZZ_TARGET");
        return echolucent::fuzzTargetNamed(name == nullptr ? "" : name);
    }();
    return named;
}

}  // namespace

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

// NOLINTBEGIN(readability-identifier-naming): libFuzzer looks for these names.

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    target().read({reinterpret_cast<const char*>(data), size});
    return 0;
}

/// Every fourth mutation is libFuzzer's own, which knows the dictionary and what the code compared.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest, unsigned seed) {
    echolucent::Dice dice(seed);
    if (dice.oneIn(4)) return LLVMFuzzerMutate(data, size, longest);
    const std::string changed = target().mutated({reinterpret_cast<const char*>(data), size}, dice.number());
    const std::size_t taken = changed.size() < longest ? changed.size() : longest;
    std::memcpy(data, changed.data(), taken);
    return taken;
}

// NOLINTEND(readability-identifier-naming)

}  // extern "C"
