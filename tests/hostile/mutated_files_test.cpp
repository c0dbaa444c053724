// Random changes of good files of every format through the real command line: each ends in a picture of what the file
// holds or in a sentence. ECHOLUCENT_MUTATIONS is how many there are (280 where it is not set), ECHOLUCENT_KEEP a
// folder that keeps those that fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include <fmt/format.h>

#include "found_voxels.h"
#include "good_files.h"
#include "hostile_file.h"
#include "opening_by_command.h"
#include "random_mutation.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// How many files ended in which way.
struct MutationEnds {
    std::atomic<int> refused{0}, found{0}, notTold{0};
};

class ChangedFile {
public:
    /// Every `changed` stands for the file of `good` at its place.
    ChangedFile(std::string name, const GoodFile& good, std::vector<std::string> changed, CommandTally& tally)
        : m_name(std::move(name)), m_good(good), m_changed(std::move(changed)), m_tally(tally) {
        m_files = m_folder.file("files");
        m_scratch = m_folder.file("scratch");
        std::filesystem::create_directory(m_files);
        std::filesystem::create_directory(m_scratch);
        for (std::size_t i = 0; i < m_changed.size(); ++i) writeBytes(m_files / good.files[i].first, m_changed[i]);
    }

    /// Opens the file and finds the voxels that were read.
    void run(MutationEnds& ends) {
        const MeasuredRun info = command({"info", "--json=-"});
        if (info.status != 0) {
            ++ends.refused;
        } else {
            const auto places = placesOfVoxels(m_good, m_changed);
            const bool told = !places.empty() && !isComputed(info.output);
            if (told) findVoxels(info.output, places);
            ++(told ? ends.found : ends.notTold);
        }
        if (const char* keep = std::getenv("ECHOLUCENT_KEEP"); keep != nullptr && m_fails)
            std::filesystem::copy(m_files, std::filesystem::path(keep) / m_name,
                                  std::filesystem::copy_options::recursive);
    }

    /// The voxels of a phase that a command writes; no value where it fails.
    std::optional<WrittenVoxels> voxelsOf(int phase) {
        const std::string written = m_folder.file("voxels.mha");
        const MeasuredRun run = command(
            {"quiet", "--reduction", "off", "--black-at-zero", "--phase", std::to_string(phase), "-o", written});
        return run.status == 0 ? writtenVoxels(written) : std::nullopt;
    }

private:
    void fail(const std::string& sentence) {
        m_fails = true;
        ADD_FAILURE() << m_name << ": " << sentence;
    }

    MeasuredRun command(std::vector<std::string> words) {
        words.push_back(m_good.opened == "." ? m_files.string() : (m_files / m_good.opened).string());
        for (const std::string& word : commandLineOf(m_good.options)) words.push_back(word);
        OpeningByCommand opening = openByCommand(m_name, words, m_scratch, bytesBelow(m_files), m_tally);
        for (const std::string& fault : opening.faults) fail(fault);
        return std::move(opening.run);
    }

    /// Whether the file says that its voxels are computed from what is stored, so that they stand nowhere as bytes.
    static bool isComputed(const std::string& json) {
        // The report outlives the loop over its facts.
        const auto report = nlohmann::json::parse(json);
        return std::ranges::any_of(report.at("facts"), [](const nlohmann::json& fact) {
            const std::string name = fact.at("name");
            return name == "rescale" || name == "rescaling" || name == "polar volume" || name == "colours";
        });
    }

    void findVoxels(const std::string& json, const std::vector<std::string>& places) {
        const auto report = nlohmann::json::parse(json);
        const int phases = report.at("volume").at("phases");
        const bool someAreMissing = std::ranges::any_of(report.at("warnings"), [](const nlohmann::json& warning) {
            return warning.get<std::string>().find("no data") != std::string::npos;
        });
        for (const int phase : {0, phases - 1}) {
            const auto voxels = voxelsOf(phase);
            if (!voxels)
                fail(fmt::format("info opens it, and quiet cannot write phase {}", phase));
            else if (!standIn(*voxels, places, someAreMissing))
                fail(fmt::format("phase {} of {} x {} x {} holds voxels that do not stand in the file", phase,
                                 voxels->size[0], voxels->size[1], voxels->size[2]));
            if (phases == 1) break;
        }
    }

    std::string m_name;
    const GoodFile& m_good;
    std::vector<std::string> m_changed;
    CommandTally& m_tally;
    TemporaryFolder m_folder;
    std::filesystem::path m_files, m_scratch;
    bool m_fails = false;
};

std::vector<std::string> goodBytesOf(const GoodFile& good) {
    std::vector<std::string> bytes;
    for (const auto& file : good.files) bytes.push_back(file.second);
    return bytes;
}

TEST(GoodFiles, OpenWithTheVoxelsThatWereWritten) {
    CommandTally tally;
    for (const GoodFile& good : goodFiles()) {
        ChangedFile file(good.name, good, goodBytesOf(good), tally);
        std::optional<WrittenVoxels> first = file.voxelsOf(0);
        ASSERT_TRUE(first) << good.name;
        if (good.voxels.empty()) continue;
        EXPECT_EQ(good.voxels.substr(0, first->bytes.size()), first->bytes) << good.name;
        EXPECT_FALSE(placesOfVoxels(good, goodBytesOf(good)).empty()) << good.name;
        EXPECT_TRUE(standIn(*first, placesOfVoxels(good, goodBytesOf(good)), false)) << good.name;
        // One voxel that was not in the file is noticed.
        first->bytes[first->bytes.size() / 2] = static_cast<char>(first->bytes[first->bytes.size() / 2] ^ 1);
        EXPECT_FALSE(standIn(*first, placesOfVoxels(good, goodBytesOf(good)), false)) << good.name;
    }
}

/// `count` changes, those of each good file in turn.
void endInWhatTheFileHoldsOrInASentence(std::size_t count) {
    const std::vector<GoodFile> all = goodFiles();
    MutationEnds ends;
    CommandTally tally;
    twoAtATime(count, [&](std::size_t i) {
        const GoodFile& good = all[i % all.size()];
        std::vector<std::string> bytes = goodBytesOf(good);
        std::string& changed = bytes[i / all.size() % bytes.size()];
        changed = mutated(changed, i);
        ChangedFile(fmt::format("{}-{}", good.name, i), good, std::move(bytes), tally).run(ends);
    });
    const std::string summary = fmt::format(
        "{} mutations of {} good files: {} refused, {} opened with the voxels of the file, {} opened with voxels that "
        "cannot be told from it; {}",
        count, all.size(), ends.refused.load(), ends.found.load(), ends.notTold.load(), tally.inWords());
    std::cout << summary << "\n";
    testing::Test::RecordProperty("summary", summary);
}

TEST(MutatedFiles, SomeEndInWhatTheFileHoldsOrInASentence) { endInWhatTheFileHoldsOrInASentence(28); }

TEST(LongMutatedFiles, EndInWhatTheFileHoldsOrInASentence) {
    const char* asked = std::getenv("ECHOLUCENT_MUTATIONS");
    endInWhatTheFileHoldsOrInASentence(asked != nullptr ? std::strtoul(asked, nullptr, 10) : 280);
}

}  // namespace
}  // namespace echolucent
