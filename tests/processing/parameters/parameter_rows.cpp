// Rows of a table: the way to a value, what is no value, what a table says of itself.
#include "processing/parameters/parameter_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

namespace echolucent {
namespace {

enum class Shape { round, manySided };

struct Disc {
    double radius = 2.0;
};
struct Ring {
    double inner = 1.0;
    int teeth = 7;
};
struct Wheel {
    std::variant<Disc, Ring> part = Ring{};
    Shape shape = Shape::round;
    bool spokes = false;
    double width = 3.0;
};

constexpr std::array shapes{parameter_rows::Choice{Shape::round, "round"},
                            parameter_rows::Choice{Shape::manySided, "many_sided"}};

constexpr ParameterChoice disc{"disc"}, ring{"ring", "Toothed ring"};

bool hasSpokes(const Wheel& wheel) { return wheel.spokes; }
bool isRound(const Wheel& wheel) { return wheel.shape == Shape::round; }

const ParameterTable<Wheel>& wheelTable() {
    using namespace parameter_rows;
    static const ParameterTable<Wheel> table{
        {choice<shapes, &Wheel::shape>({"shape", "Shape", "Outline", "", "here"}),
         flag<&Wheel::spokes>({"spokes", "Spokes", "Whether it has spokes", "", "here"}),
         number<&Wheel::part, &Disc::radius>({"radius", "Radius", "Of a disc", "mm", "here"}, {0, 5}),
         number<&Wheel::part, &Ring::teeth>({"teeth", "Teeth", "Of a ring", "", "here"}, {1, 20}),
         number<&isRound, &Wheel::width>({"width", "Width", "Of a round wheel", "mm", "here"}, {0, 5},
                                         {.scope = {"shape", "round"}})},
        Wheel{.spokes = true},
        [](const Wheel& wheel) { return std::string(wheel.width == 4.0 ? "the width must not be 4" : ""); }};
    return table;
}
const Parameter<Wheel>& rowNamed(std::string_view name) { return *parameterNamed(wheelTable(), name); }

TEST(ParameterRows, AValueOfAnAlternativeThatIsNotChosenIsNone) {
    Wheel wheel;
    EXPECT_FALSE(rowNamed("radius").get(wheel));
    EXPECT_FALSE(rowNamed("radius").set(wheel, 3.0));
    EXPECT_TRUE(std::holds_alternative<Ring>(wheel.part));
    ASSERT_TRUE(rowNamed("teeth").set(wheel, std::int64_t{9}));
    EXPECT_EQ(std::get<Ring>(wheel.part).teeth, 9);
    wheel.part = Disc{};
    ASSERT_TRUE(rowNamed("radius").set(wheel, std::int64_t{4})) << "a whole number is a number";
    EXPECT_EQ(std::get<Disc>(wheel.part).radius, 4.0);
    EXPECT_FALSE(rowNamed("teeth").get(wheel));
}

TEST(ParameterRows, AnAlternativeIsChosenAndKeepsWhatWasSetOfIt) {
    const auto row =
        parameter_rows::alternative<&Wheel::part, Disc, disc, Ring, ring>({"part", "Part", "What it is", "", "here"});
    Wheel wheel{.part = Ring{.teeth = 9}};
    EXPECT_EQ(row.get(wheel), ParameterValue(std::string("ring")));
    ASSERT_TRUE(row.set(wheel, std::string("ring")));
    EXPECT_EQ(std::get<Ring>(wheel.part).teeth, 9);
    EXPECT_FALSE(row.set(wheel, std::string("hub")));
    EXPECT_FALSE(row.set(wheel, 1.0));
    ASSERT_TRUE(row.set(wheel, std::string("disc")));
    EXPECT_TRUE(std::holds_alternative<Disc>(wheel.part));
    EXPECT_EQ(shownValue(row, std::string("ring")), "Toothed ring");
    const auto of = parameter_rows::within({"part", "ring"}, std::vector{rowNamed("teeth")});
    EXPECT_EQ(whenOf(of.front()), "if part is ring");
}

TEST(ParameterRows, AConditionOnTheWayDecidesWhetherThereIsAValue) {
    Wheel wheel;
    ASSERT_TRUE(rowNamed("width").set(wheel, 1.0));
    wheel.shape = Shape::manySided;
    EXPECT_FALSE(rowNamed("width").get(wheel));
    EXPECT_FALSE(rowNamed("width").set(wheel, 2.0));
    EXPECT_EQ(wheel.width, 1.0);
    EXPECT_EQ(defaultOf(wheelTable(), rowNamed("width")), ParameterValue(3.0));
}

TEST(ParameterRows, ValuesOfAnotherKindChangeNothing) {
    Wheel wheel;
    EXPECT_FALSE(rowNamed("teeth").set(wheel, 9.5));
    EXPECT_FALSE(rowNamed("teeth").set(wheel, std::string("9")));
    EXPECT_FALSE(rowNamed("spokes").set(wheel, std::int64_t{1}));
    EXPECT_FALSE(rowNamed("shape").set(wheel, std::string("square")));
    EXPECT_FALSE(rowNamed("shape").set(wheel, true));
    EXPECT_EQ(std::get<Ring>(wheel.part).teeth, 7);
    EXPECT_FALSE(wheel.spokes);
    ASSERT_TRUE(rowNamed("teeth").set(wheel, std::int64_t{1} << 40)) << "the range is asked by problemIn()";
    EXPECT_EQ(problemIn(wheelTable(), wheel), "the teeth must be 1 to 20");
}

TEST(ParameterRows, TheTableSaysWhatIsWrongBetweenRowsLast) {
    Wheel wheel;
    wheel.width = 4.0;
    EXPECT_EQ(problemIn(wheelTable(), wheel), "the width must not be 4");
    std::get<Ring>(wheel.part).teeth = 0;
    EXPECT_EQ(problemIn(wheelTable(), wheel), "the teeth must be 1 to 20");
    wheel = {};
    wheel.width = std::nan("");
    EXPECT_EQ(problemIn(wheelTable(), wheel), "the width must be 0 to 5");
}

TEST(ParameterRows, DefaultsAreThoseOfTheTable) {
    EXPECT_EQ(defaultOf(wheelTable(), rowNamed("spokes")), ParameterValue(true));
    const auto all = defaultsOf(ParameterTable<Wheel>{{rowNamed("shape"), rowNamed("teeth")}});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].standard, ParameterValue(std::string("round")));
    EXPECT_EQ(all[1].standard, ParameterValue(std::int64_t{7}));
}

TEST(ParameterRows, WordsForPersons) {
    EXPECT_EQ(shownValue(rowNamed("shape"), std::string("many_sided")), "Many sided");
    EXPECT_EQ(shownValue(rowNamed("spokes"), true), "yes");
    EXPECT_EQ(shownValue(rowNamed("teeth"), std::int64_t{7}), "7");
    EXPECT_EQ(whenOf(rowNamed("width")), "if shape is round");
    EXPECT_EQ(whenOf(rowNamed("shape")), "always");
    const auto row = parameter_rows::playing(hasSpokes, "with spokes", rowNamed("shape"));
    EXPECT_EQ(whenOf(row), "with spokes");
    EXPECT_FALSE(playsAPart(row, Wheel{}));
    EXPECT_TRUE(playsAPart(row, Wheel{.spokes = true}));
    EXPECT_EQ(optionOf("many_sided"), "--many-sided");
    EXPECT_EQ(camelCase("many_sided"), "manySided");
}

}  // namespace
}  // namespace echolucent
