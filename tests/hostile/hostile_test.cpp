// Every hostile file through readStudy(): what it says, and that rows cannot pass by saying nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hostile_file.h"
#include "io/study/study.h"
#include "largest_request.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

bool anyHolds(const std::vector<std::string>& warnings, const std::string& word) {
    return std::ranges::any_of(warnings,
                               [&](const std::string& warning) { return warning.find(word) != std::string::npos; });
}

/// Everything after the file's own name, so that a word in the name does not count.
std::string withoutFolder(const std::string& sentence, const std::string& folder) {
    const auto at = sentence.find(folder);
    return at == std::string::npos ? sentence : sentence.substr(0, at) + sentence.substr(at + folder.size());
}

class HostileFiles : public testing::TestWithParam<HostileFile> {};

TEST_P(HostileFiles, AreRefusedOrOpenAsTheTableSays) {
    const HostileFile& row = GetParam();
    const TemporaryFolder folder;
    row.write(folder.path());
    forgetLargestRequest();
    const auto study = readStudy(row.opened == "." ? folder.path() : folder.file(row.opened), row.options);
    EXPECT_LE(largestRequest(), row.mostBytesAtOnce) << "bytes asked for at once";
    if (row.outcome == HostileOutcome::refused) {
        ASSERT_FALSE(row.words.empty()) << "a refusal has to say something";
        ASSERT_FALSE(study) << "it opens as " << study->facts.front().value;
        const std::string sentence = withoutFolder(study.error().sentence(), folder.path());
        for (const std::string& word : row.words) EXPECT_THAT(sentence, HasSubstr(word));
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        EXPECT_FALSE(study.error().remedy.empty()) << sentence;
        EXPECT_EQ(study.error().kind, FailureKind::unreadable) << sentence;
        EXPECT_THAT(study.error().sentence(), HasSubstr(folder.path())) << "it names the file";
        EXPECT_THAT(sentence, EndsWith("."));
        EXPECT_THAT(sentence, Not(AnyOf(HasSubstr("1.2.840.10008."), HasSubstr("1.2.3.4.5")))) << "codings have names";
        return;
    }
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_FALSE(study->phases.empty());
    if (row.phases != 0) {
        EXPECT_EQ(study->phases.size(), row.phases);
    }
    for (const std::string& word : row.words)
        EXPECT_EQ(anyHolds(study->warnings, word), row.outcome == HostileOutcome::opensWithNote)
            << word << " in " << testing::PrintToString(study->warnings);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(HostileFiles);
INSTANTIATE_TEST_SUITE_P(All, HostileFiles, testing::ValuesIn(hostileFiles()), [](const auto& row) {
    std::string name = row.param.name;
    std::ranges::replace_if(
        name, [](char letter) { return std::isalnum(static_cast<unsigned char>(letter)) == 0; }, '_');
    return name;
});

TEST(HostileTable, NamesEachRowOnce) {
    std::set<std::string> names;
    for (const HostileFile& row : hostileFiles()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace
}  // namespace echolucent
