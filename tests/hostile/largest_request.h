// Measures the largest piece of memory that was asked for. No other measure shows a request for gigabytes that are
// never touched.
#pragma once

#include <cstddef>

namespace echolucent {

/// The bytes of the largest piece that any thread has asked `new` for since forgetLargestRequest(), by the project's
/// code and C++ libraries. It does not see C libraries' `malloc`. Only programs that link largest_request.cpp, which
/// replaces the global `new`, have it. The address sanitizer replaces `new` too; under it the result is always 0.
[[nodiscard]] std::size_t largestRequest();
void forgetLargestRequest();

}  // namespace echolucent
