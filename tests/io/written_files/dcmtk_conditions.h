// Checks DCMTK's results.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/ofstd/ofcond.h>

#include <stdexcept>
#include <string>

namespace echolucent {

/// Throws std::runtime_error, with `what` and DCMTK's own words, unless it was done.
inline void require(const OFCondition& done, const std::string& what) {
    if (done.bad()) throw std::runtime_error(what + ": " + done.text());
}

}  // namespace echolucent
