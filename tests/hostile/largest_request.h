// The largest piece of memory that was asked for: a request for gigabytes that are never touched shows in no other
// measure.
#pragma once

#include <cstddef>

namespace echolucent {

/// The bytes of the largest piece that any thread has asked `new` for since forgetLargestRequest(), by the project's
/// code and by libraries in C++; what libraries in C ask `malloc` for is not seen. Only a program that is linked with
/// largest_request.cpp, which replaces the global `new`, has it; under the address sanitizer, which replaces it too, it
/// is always 0.
[[nodiscard]] std::size_t largestRequest();
void forgetLargestRequest();

}  // namespace echolucent
