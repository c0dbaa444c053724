#include "processing/median.h"

#include <algorithm>
#include <stdexcept>

namespace echolucent {

double medianOf(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("medianOf: needs a value");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace echolucent
