#include "app/measuring/measures/rank_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace echolucent {
namespace {

using Values = std::vector<double>;

TEST(RankCorrelation, IsOneInTheSameOrderAndMinusOneInTheReverse) {
    const Values one{0.1, 5.0, 2.0, 9.0};
    EXPECT_DOUBLE_EQ(*rankCorrelation(one, Values{-3, 1e6, 0, 1e9}), 1.0);
    EXPECT_DOUBLE_EQ(*rankCorrelation(one, Values{4, 2, 3, 1}), -1.0);
}

TEST(RankCorrelation, IsTheTextbooksFormulaWithoutTies) {
    // 1 - 6 sum d^2 / (n (n^2 - 1)) with d = -1, 1, 0, -1, 1
    EXPECT_DOUBLE_EQ(*rankCorrelation(Values{1, 2, 3, 4, 5}, Values{2, 1, 3, 6, 3.5}), 1.0 - 6.0 * 4.0 / 120.0);
}

TEST(RankCorrelation, TiesShareTheirMeanRank) {
    // Ranks 0, 1.5, 1.5, 3 against 0, 1, 2, 3.
    EXPECT_NEAR(*rankCorrelation(Values{1, 2, 2, 3}, Values{1, 2, 3, 4}), 4.5 / std::sqrt(4.5 * 5.0), 1e-12);
}

TEST(RankCorrelation, IsUnknownWithoutAnOrder) {
    EXPECT_FALSE(rankCorrelation(Values{1}, Values{1}));
    EXPECT_FALSE(rankCorrelation(Values{2, 2, 2}, Values{1, 2, 3}));
    EXPECT_THROW((void)rankCorrelation(Values{1, 2}, Values{1}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
