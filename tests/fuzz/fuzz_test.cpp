// A short run of every fuzz target: its samples, and a fixed number of mutations that the seed decides. Where clang's
// fuzzer is missing, ECHOLUCENT_FUZZ_MUTATIONS and ECHOLUCENT_FUZZ_SEED in the environment make it a longer one.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "fuzz_target.h"
#include "hostile_file.h"
#include "mutations/dice.h"
#include "promises.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

#ifdef ECHOLUCENT_SANITIZED
constexpr std::uint64_t standardMutations = 150;
#else
constexpr std::uint64_t standardMutations = 600;
#endif
constexpr std::uint64_t standardSeed = 15;
// Mutations of mutations reach what one cannot; so many are kept to begin from.
constexpr std::size_t mostKept = 200;

std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise) {
    const char* value = std::getenv(name);
    return value == nullptr ? otherwise : std::stoull(value);
}

class FuzzTargets : public testing::TestWithParam<const FuzzTarget*> {};

/// The reader with these bytes; what it threw, or an empty text.
std::string thrownBy(const FuzzTarget& target, const std::string& bytes) {
    try {
        target.read(bytes);
        return {};
    } catch (const std::exception& thrown) {
        return thrown.what();
    }
}

TEST_P(FuzzTargets, KeepWhatReadersPromiseForSamplesAndTheirMutations) {
    const FuzzTarget& target = *GetParam();
    std::vector<FuzzSample> corpus = target.samples();
    ASSERT_FALSE(corpus.empty());
    for (const FuzzSample& sample : corpus) {
        EXPECT_LE(sample.bytes.size(), target.longest) << sample.name;
        EXPECT_EQ(thrownBy(target, sample.bytes), "") << sample.name;
    }
    Dice dice(fromEnvironment("ECHOLUCENT_FUZZ_SEED", standardSeed));
    const std::uint64_t mutations = fromEnvironment("ECHOLUCENT_FUZZ_MUTATIONS", standardMutations);
    for (std::uint64_t i = 0; i < mutations; ++i) {
        const FuzzSample& parent = dice.oneOf(corpus);
        const std::uint64_t change = dice.number();
        FuzzSample child{parent.name + " " + std::to_string(change), target.mutated(parent.bytes, change)};
        if (child.bytes.size() > target.longest) child.bytes.resize(target.longest);
        const auto begun = std::chrono::steady_clock::now();
        EXPECT_EQ(thrownBy(target, child.bytes), "") << child.name;
        EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5)) << child.name;
        if (corpus.size() < mostKept) corpus.push_back(std::move(child));
    }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTargets, testing::ValuesIn(fuzzTargets().begin(), fuzzTargets().end()),
                         [](const auto& target) {
                             std::string name(target.param->name);
                             for (char& letter : name)
                                 if (letter == '-') letter = '_';
                             return name;
                         });

// What was found once, by fuzzing or otherwise, is kept in the table of hostile files. It is looked at here as findings
// are: the table asks for words only. test_hostile reads all of them: of refusals every eighth suffices.
TEST(HostileFiles, KeepWhatReadersPromise) {
    const std::vector<HostileFile>& rows = hostileFiles();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const HostileFile& row = rows[i];
        if (row.outcome == HostileOutcome::refused && i % 8 != 0) continue;
        const TemporaryFolder folder;
        row.write(folder.path());
        EXPECT_NO_THROW(requireSoundReading(row.opened == "." ? folder.path() : folder.file(row.opened), row.options))
            << row.name;
    }
}

}  // namespace
}  // namespace echolucent
