// Paths into a document: what they name, what they set, and what is refused in which words.
#include "io/document/document_paths.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/document/document_file.h"
#include "processing/adaptive/method_reading.h"
#include "tests/inputs.h"
#include "tests/io/document/unusual_document.h"

namespace echolucent {
namespace {

std::string refusalOf(const Result<Document>& result) { return result ? std::string() : result.error().sentence(); }

Document withOwnPanes() {
    Document document;
    document.panes = {{.curve = CurveKind::linear, .linear = LinearCurve{0.1, 2, 0.9}},
                      {.method = configOf(MethodReading::asPublished)},
                      {}};
    return document;
}

TEST(DocumentPaths, EveryPathNamesAValueThatCanBeSetToItself) {
    for (const Document& document : {Document{}, unusualDocument(), withOwnPanes()}) {
        const std::vector<std::string> paths = pathsOf(document);
        EXPECT_GT(paths.size(), 80U);
        for (std::size_t i = 0; i < paths.size(); i += takesSomeInputs ? 5 : 1) {
            const std::string& path = paths[i];
            const auto text = textAt(document, path);
            ASSERT_TRUE(text) << path;
            const auto again = withValueAt(document, path, *text);
            ASSERT_TRUE(again) << path << ": " << again.error().sentence();
            EXPECT_TRUE(*again == document) << path;
        }
    }
}

TEST(DocumentPaths, AValueIsReadByTheKeysOfTheFile) {
    Document document;
    document.scene.front.depthMm = 18.5;
    document.scene.pose.offsetMm = Vec3(1, 2, -3);
    document.panes.push_back({.curve = CurveKind::quartic});
    EXPECT_EQ(*valueAt(document, "scene.front.depth_mm"), DocumentValue(18.5));
    EXPECT_EQ(*valueAt(document, "scene.pose.offset_mm[2]"), DocumentValue(-3.0));
    EXPECT_EQ(*valueAt(document, "panes[1].curve"), DocumentValue(std::string("quartic")));
    EXPECT_EQ(*valueAt(document, "panes"), DocumentValue(2.0)) << "a list stands for the number of its entries";
    EXPECT_EQ(*valueAt(document, "panes[1].designer"), DocumentValue()) << "what a file leaves out is there";
    EXPECT_EQ(*valueAt(document, "panes[1].method"), DocumentValue());
    EXPECT_EQ(*valueAt(document, "panes[0].linear"), DocumentValue());
    EXPECT_EQ(*valueAt(withOwnPanes(), "panes[0].linear.slope"), DocumentValue(2.0));
    EXPECT_EQ(*valueAt(document, "scene.exposure"), DocumentValue(1.0));
    const auto values = valuesAt(document, {"scene.exposure", "scene.nothing", "panes"});
    EXPECT_EQ(values, (std::vector<std::optional<DocumentValue>>{1.0, std::nullopt, 2.0}));
    EXPECT_EQ(*valueAt(document, "scene.box.on"), DocumentValue(false));
}

TEST(DocumentPaths, WhatNamesNothingIsRefusedByName) {
    const Document document;
    for (const char* path : {"", "scene.front.depthMm", "scene..front", ".scene", "scene.", "panes[1]", "panes[01x]",
                             "panes[-1]", "panes[0", "panes.0.curve", "scene[0]", "format", "version", "panes[0] ",
                             "scene.front.depth_mm.x", "scene.front.depth_mm[0]", "scene/front/depth_mm"}) {
        EXPECT_FALSE(valueAt(document, path)) << path;
        EXPECT_FALSE(textAt(document, path)) << path;
        const auto set = withValueAt(document, path, "1");
        ASSERT_FALSE(set) << path;
        EXPECT_EQ(set.error().kind, FailureKind::wrongUsage);
        EXPECT_NE(set.error().sentence().find("names no value of this document"), std::string::npos);
    }
    EXPECT_FALSE(valueAt(document, std::string(longestDocumentPath + 1, 'a')));
}

TEST(DocumentPaths, AValueIsSetByTheRulesOfTheReader) {
    const Document document;
    const auto linear = withValueAt(document, "panes[0].curve", "linear");
    ASSERT_TRUE(linear) << refusalOf(linear);
    EXPECT_TRUE(linear->panes[0].curve == CurveKind::linear);
    const auto deep = withValueAt(document, "scene.front.depth_mm", "18");
    ASSERT_TRUE(deep) << refusalOf(deep);
    EXPECT_EQ(deep->scene.front.depthMm, 18.0);
    Document expected = document;
    expected.scene.front.depthMm = 18.0;
    EXPECT_TRUE(*deep == expected) << "nothing else changes";

    EXPECT_EQ(refusalOf(withValueAt(document, "scene.pose.magnification", "0")),
              "scene.pose.magnification must be above 0, not 0.");
    EXPECT_EQ(refusalOf(withValueAt(document, "panes[0].curve", "cubic")), "panes[0].curve must not be \"cubic\".");
    EXPECT_EQ(refusalOf(withValueAt(document, "scene.box.on", "1")), "scene.box.on must be true or false.");
    EXPECT_EQ(refusalOf(withValueAt(document, "scene.pose", "3")), "scene.pose must be a JSON object.");
    EXPECT_EQ(refusalOf(withValueAt(document, "scene.front.direction.azimuth", "20")),
              "scene.front.direction.azimuth cannot be this as the document is set.")
        << "without a front there is no direction";
    EXPECT_FALSE(withValueAt(document, "scene.front.depth_mm", std::string(70, '[')));
    EXPECT_FALSE(withValueAt(document, "measurements", std::string(longestDocumentPart + 1, ' ')));
    EXPECT_FALSE(withValueAt(document, "panes[0].curve", "\xff\xfe"));
}

TEST(DocumentPaths, AChoiceDropsParametersWithoutAMeaningAndGivesTheOthersTheirDefaults) {
    const Document document;
    ASSERT_TRUE(valueAt(document, "method.parameters.aim"));
    const auto product = withValueAt(document, "method.parameters.form", "\"product\"");
    ASSERT_TRUE(product) << refusalOf(product);
    EXPECT_FALSE(valueAt(*product, "method.parameters.aim"));
    EXPECT_TRUE(valueAt(*product, "method.parameters.strength"));
    const auto back = withValueAt(*product, "method.parameters.form", "\"ramp\"");
    ASSERT_TRUE(back) << refusalOf(back);
    EXPECT_EQ(*valueAt(*back, "method.parameters.aim"), *valueAt(document, "method.parameters.aim"));
    const auto ramp = withValueAt(withOwnPanes(), "panes[1].method.form", "ramp");
    ASSERT_TRUE(ramp) << refusalOf(ramp);
    EXPECT_EQ(*valueAt(*ramp, "panes[1].method.aim"), *valueAt(document, "method.parameters.aim"));
    EXPECT_FALSE(valueAt(*withValueAt(*ramp, "panes[1].method.form", "product"), "panes[1].method.aim"));
    EXPECT_TRUE(*withValueAt(*ramp, "panes[1].method", "null") ==
                *withValueAt(withOwnPanes(), "panes[1].method", "null"));
}

TEST(DocumentPaths, APartIsPutOverTheDocument) {
    const Document document = unusualDocument();
    const auto changed = withPart(document, R"({"scene": {"look": {"brightness": 1.5}}, "panes": [{"curve": "manual"}],
                                               "comparison": {"first": 0, "second": 0}})");
    ASSERT_FALSE(changed) << "the places of a comparison are those of the panes";
    const auto less = withPart(document, R"({"scene": {"look": {"brightness": 1.5}, "exposure": 1}})");
    ASSERT_TRUE(less) << refusalOf(less);
    Document expected = document;
    expected.scene.look.brightness = 1.5;
    expected.scene.exposure = 1.0;
    EXPECT_TRUE(*less == expected);

    const auto says = [&](const char* part) { return refusalOf(withPart(Document{}, part, "lesson.json", "begins")); };
    EXPECT_EQ(says("[]"), "lesson.json: begins must be a part of a document as a JSON object.");
    EXPECT_EQ(says("{"), "lesson.json: begins must be a part of a document as a JSON object.");
    EXPECT_EQ(says(R"({"version": 2})"), "lesson.json: begins.version is no part of a document.");
    EXPECT_EQ(says(R"({"scene": {"colour": 1}})"), "lesson.json: begins.scene.colour names no value of this document.");
    EXPECT_EQ(says(R"({"panes": [{"curve": "linear", "courve": 1}]})"),
              "lesson.json: begins.panes[0].courve names no value of this document.");
    EXPECT_EQ(says(R"({"scene": {"look": {"brightness": "much"}}})"),
              "lesson.json: begins.scene.look.brightness must not be \"much\".");
    EXPECT_EQ(says(R"({"panes": []})"), "lesson.json: begins panes must hold 1 to 4 panes.");
}

TEST(DocumentPaths, ThePartBetweenTwoDocumentsMakesOneOfTheOther) {
    Document designed;
    designed.panes = {{}, {.designer = DesignerConfig{}}};
    designed.scene.front.depthMm = 12;
    Document published;
    published.method.config = configOf(MethodReading::asPublished);
    const std::vector<Document> documents{Document{}, designed, published, withOwnPanes()};
    for (const Document& from : documents)
        for (const Document& to : documents) {
            const auto made = withPart(from, partBetween(from, to));
            ASSERT_TRUE(made) << made.error().sentence() << partBetween(from, to);
            EXPECT_TRUE(*made == to) << partBetween(from, to);
        }
    EXPECT_EQ(partBetween(designed, designed), "{}");
    Document deeper;
    deeper.scene.front.depthMm = 2;
    EXPECT_EQ(partBetween(Document{}, deeper), R"({"scene":{"front":{"depth_mm":2.0}}})");
    Document unusual = unusualDocument();
    Document plain;
    plain.study = unusual.study;
    EXPECT_TRUE(*withPart(plain, partBetween(plain, unusual)) == unusual);
    EXPECT_TRUE(*withPart(unusual, partBetween(unusual, plain)) == plain);
}

}  // namespace
}  // namespace echolucent
