// How far a card's picture is from the processor's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/picture/picture.h"
#include "tests/benchmarks/card/card_case.h"
#include "tests/benchmarks/card/card_window.h"

namespace echolucent::bench {

/// Levels of 8 bits over the pixels that either picture shows.
struct CardDifference {
    double rmse = 0.0, largest = 0.0;
};
[[nodiscard]] CardDifference cardDifference(const Picture& card, const Picture& processor);

struct ComparisonPlan {
    int views = 2;
    bool plainly = false;  ///< the processor casts by the slow, obvious route (castRaysPlainly())
    std::string pictures;  ///< a folder for the picture of each case that is farthest off; empty for none
};
/// Draws all cases and prints a table, the largest values of a row over its views. False if the card fails.
[[nodiscard]] bool compareCases(CardWindow& window, const std::vector<CardCase>& cases, const ComparisonPlan& plan);

}  // namespace echolucent::bench
