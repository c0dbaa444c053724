// `study theory` through the real program: section 4's numbers beside the ray caster's.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "processing/theory/contrast_course.h"
#include "program.h"
#include "tables.h"

namespace echolucent {
namespace {

TEST(StudyTheory, EveryPixelWithoutSpeckleIsWithinHalfAPercentOfTheory) {
    const Folder folder;
    const Outcome outcome = runProgram("study theory --edge 16 -o \"" + folder / "t" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto rows = namedRowsOf(contentsOf(folder / "t/theory-pictures.csv"));
    std::size_t plain = 0;
    std::set<std::string> curves, units, ratios;
    for (const NamedRow& row : rows) {
        if (row.at("speckle") != "0") continue;
        ++plain;
        curves.insert(row.at("curve"));
        units.insert(row.at("fluid_units"));
        ratios.insert(row.at("fluid"));
        EXPECT_LE(std::stod(row.at("largest_error")), 0.005) << row.at("curve");
        EXPECT_NEAR(std::stod(row.at("difference")),
                    std::stod(row.at("theory_tissue")) - std::stod(row.at("theory_fluid")), 0.005);
    }
    EXPECT_EQ(plain, 2 * curves.size() * units.size() * ratios.size());
    EXPECT_EQ(curves.size(), 5U);
    EXPECT_EQ(units.size(), 4U);
    EXPECT_NE(outcome.output.find("By difference, the tissue is shown best by adaptive: 0.333 of white."),
              std::string::npos)
        << outcome.output;
    const std::string page = contentsOf(folder / "t/theory.html");
    EXPECT_NE(page.find("Where the parabola beats the line"), std::string::npos);
    EXPECT_LT(page.size(), 200'000U);
}

TEST(StudyTheory, ItsCoursesAreTheCoresNumbers) {
    const Folder folder;
    ASSERT_EQ(runProgram("study theory --edge 8 --tissue 120 --fluid 24 --tissue-units 12 --scale 0.5 -o \"" +
                         folder / "t" + "\"")
                  .status,
              0);
    TheorySetting setting;
    setting.model.tissue = 120.0 / 255.0;
    setting.model.fluid = 24.0 / 255.0;
    setting.model.tissueUnits = 12;
    setting.scale = 0.5;
    const ContrastCourse course = courseOf(setting, CourseAxis::depth);
    const auto rows = namedRowsOf(contentsOf(folder / "t/theory-courses.csv"));
    ASSERT_EQ(rows.size(), 2U * 2U * 101U * 5U);
    for (const std::size_t place : {std::size_t{0}, std::size_t{30}, std::size_t{100}})
        for (std::size_t curve = 0; curve < 5; ++curve) {
            const NamedRow& row = rows[place * 5 + curve];
            const CurveContrast& one = course.contrasts[place][curve];
            EXPECT_EQ(row.at("curve"), one.name);
            EXPECT_EQ(std::stod(row.at("tissue_pixel")), one.pixels.tissue);
            EXPECT_EQ(std::stod(row.at("difference")), *one.contrast);
        }
}

TEST(StudyTheory, RefusesWhatIsOutOfRange) {
    const Folder folder;
    const std::string output = " -o \"" + folder / "t" + "\"";
    for (const char* wrong : {"--tissue 300", "--tissue 0", "--fluid nan"}) {
        const Outcome outcome = runProgram("study theory " + std::string(wrong) + output);
        EXPECT_EQ(outcome.status, 2) << wrong << ": " << outcome.errors;
    }
    EXPECT_EQ(runProgram("study theory").status, 2) << "a folder is needed";
}

}  // namespace
}  // namespace echolucent
