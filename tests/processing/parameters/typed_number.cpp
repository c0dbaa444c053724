// One rule for the numbers that people type: what a point and a comma mean, and what is refused.
#include "processing/parameters/typed_number.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace echolucent {
namespace {

constexpr ParameterRange any;

TEST(TypedNumbers, APointAndACommaAreUnderstoodAlike) {
    for (const auto& [text, value] : std::vector<std::pair<std::string, double>>{{"1.5", 1.5},
                                                                                 {"1,5", 1.5},
                                                                                 {"-0,25", -0.25},
                                                                                 {"+3", 3},
                                                                                 {",5", 0.5},
                                                                                 {"5.", 5},
                                                                                 {" 12,3456 ", 12.3456},
                                                                                 {"1.234", 1.234},
                                                                                 {"0,125", 0.125},
                                                                                 {"1234,567", 1234.567},
                                                                                 {"1e-3", 0.001},
                                                                                 {"2,5E+2", 250}}) {
        ASSERT_TRUE(typedNumber(text)) << text;
        EXPECT_EQ(typedNumber(text)->value, value) << text;
        EXPECT_FALSE(typedNumber(text)->otherwise) << text;
        EXPECT_EQ(numberTyped(text, any), value) << text;
    }
}

TEST(TypedNumbers, GroupsOfThreeSeparateThousands) {
    for (const std::string text : {"1.234,5", "1,234.5", "1 234.5", "1'234,5"}) {
        ASSERT_TRUE(typedNumber(text)) << text;
        EXPECT_EQ(numberTyped(text, any), 1234.5) << text;
    }
    EXPECT_EQ(numberTyped("1,234,567", any), 1234567);
    EXPECT_EQ(numberTyped("1.234.567", any), 1234567);
    EXPECT_EQ(numberTyped("12.345.678,25", any), 12345678.25);
}

TEST(TypedNumbers, ACommaThatMaySeparateThousandsIsDoubtful) {
    const auto typed = typedNumber("1,234");
    ASSERT_TRUE(typed);
    EXPECT_EQ(typed->value, 1.234);
    EXPECT_EQ(typed->otherwise, 1234);
    EXPECT_FALSE(numberTyped("1,234", any));
    EXPECT_TRUE(isDoubtful("1,234", any));
    EXPECT_EQ(remedyOfDoubt("1,234"), "Write 1.234 or 1234.");
    // The range of a field may leave one meaning.
    EXPECT_EQ(numberTyped("1,234", {0, 1000}), 1.234);
    EXPECT_EQ(numberTyped("1,234", {100, 4000}), 1234);
    EXPECT_FALSE(numberTyped("1,234", {5, 1000}));
    EXPECT_FALSE(isDoubtful("1,234", {0, 1000}));
}

TEST(TypedNumbers, WholeNumbersHaveNoPart) {
    EXPECT_EQ(numberTyped("15", any, true), 15);
    EXPECT_EQ(numberTyped("1,024", any, true), 1024);
    EXPECT_FALSE(numberTyped("1,5", any, true)) << "not 15";
    EXPECT_FALSE(numberTyped("1.5", any, true));
    EXPECT_FALSE(numberTyped("1.000", any, true)) << "1 or 1000";
    EXPECT_FALSE(numberTyped("1,000", {1, 400}, true)) << "not 1";
    EXPECT_FALSE(numberTyped("1e-2", any, true));
}

TEST(TypedNumbers, NothingElseIsANumber) {
    for (const std::string text :
         {"",          " ",    "-",   ".",   ",",  "1,,5",  "1.2.3", "1,23,4", "1.234.5", "12345,678.5", "1 2",
          "1,234 567", "0x10", "nan", "inf", "1e", "1e999", "5 mm",  "1,5x",   "--1",     "1'2'3"})
        EXPECT_FALSE(typedNumber(text)) << text;
}

}  // namespace
}  // namespace echolucent
