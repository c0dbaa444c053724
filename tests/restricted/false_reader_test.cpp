// A reader process that lies, dies or says nothing: the workstation says one sentence and goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "io/restricted/reader_process.h"
#include "io/restricted/restricted_reader.h"
#include "io/restricted/taken_words.h"
#include "processing/volume/coarse_grid.h"
#include "temporary_folder.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int time = 0; time < times; ++time) all += text;
    return all;
}

std::string besideThisProgram(const std::string& name) {
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

/// Lets the false reader read, in one of its ways.
class FalseReader : public testing::Test {
protected:
    void SetUp() override {
        restricted::dismissReader();
        m_file = m_folder.write("a.mha", "ObjectType = Image\nNDims = 3\n");
    }
    void TearDown() override {
        restricted::useReaderProgram("");
        unsetenv("ECHOLUCENT_FALSE_READER");
    }
    static void useMode(const std::string& mode, unsigned seed) {
        restricted::useReaderProgram(besideThisProgram("false-reader"));
        setenv("ECHOLUCENT_FALSE_READER", mode.c_str(), 1);
        setenv("ECHOLUCENT_FALSE_SEED", std::to_string(seed).c_str(), 1);
    }
    Result<Study> readBy(const std::string& mode, unsigned seed = 1, const Progress& progress = {}) {
        useMode(mode, seed);
        return restricted::readStudy(m_file, {}, progress);
    }
    std::string sentenceBy(const std::string& mode) {
        const auto study = readBy(mode);
        return study ? "it opens" : study.error().sentence();
    }
    const std::string& file() const { return m_file; }
    void expectSenseOfCoarse(unsigned messages);
    void expectSenseOfStudies(unsigned messages);

private:
    TemporaryFolder m_folder;
    std::string m_file;
};

TEST_F(FalseReader, TellsTheTruthAsWell) {
    const auto study = readBy("honest");
    ASSERT_TRUE(study) << study.error().sentence() << ": the lies below would prove nothing";
    EXPECT_EQ(study->phases.front()->storedValue(63), 7.0);
}

TEST_F(FalseReader, IsNotBelieved) {
    for (const char* mode :
         {"rubbish", "short-memory", "no-memory", "a-file-for-memory", "names-another-file", "left-handed"})
        EXPECT_THAT(sentenceBy(mode),
                    HasSubstr("a.mha: was not read: the process that reads files answered what makes no "
                              "sense"))
            << mode;
    EXPECT_THAT(sentenceBy("unconfined"), HasSubstr("said what makes no sense"));
    EXPECT_THAT(sentenceBy("raw-bytes"), HasSubstr("ended"));
}

/// Asks for a coarse volume too.
struct WithCoarse {
    int told = 0;
    double intensity = -1;
    Progress progress;
    WithCoarse() {
        progress.coarse = [this](const CoarseVolume& coarse) {
            ++told;
            intensity = coarse.voxels->storedValue(63);
        };
    }
};

TEST_F(FalseReader, ShowsItsCoarseVolumeBeforeTheStudy) {
    WithCoarse asked;
    const auto study = readBy("coarse", 1, asked.progress);
    ASSERT_TRUE(study) << study.error().sentence() << ": the lies below would prove nothing";
    EXPECT_EQ(asked.told, 1);
    EXPECT_EQ(asked.intensity, 7.0);

    WithCoarse failing;
    const auto failed = readBy("coarse-fails", 1, failing.progress);
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().sentence(), HasSubstr("ends within its voxels"));
    EXPECT_EQ(failing.told, 1);

    WithCoarse late;
    EXPECT_TRUE(readBy("coarse-after-result", 1, late.progress)) << "nobody listens any more";
    EXPECT_EQ(late.told, 1);
}

TEST_F(FalseReader, IsNotBelievedCoarsely) {
    for (const char* mode :
         {"coarse-rubbish", "coarse-without-memory", "coarse-too-large", "coarse-too-long", "coarse-still-written"}) {
        WithCoarse asked;
        const auto study = readBy(mode, 1000, asked.progress);
        ASSERT_FALSE(study) << mode;
        EXPECT_THAT(study.error().sentence(), HasSubstr("said what makes no sense")) << mode;
        EXPECT_EQ(asked.told, 0) << mode;
    }
    WithCoarse asked;
    const auto twice = readBy("coarse-twice", 1, asked.progress);
    ASSERT_FALSE(twice);
    EXPECT_THAT(twice.error().sentence(), HasSubstr("said what makes no sense"));
    EXPECT_EQ(asked.told, 1);
    EXPECT_THAT(sentenceBy("coarse"), HasSubstr("said what makes no sense")) << "nobody asked for it";
}

class LongFalseReader : public FalseReader {};

/// How many messages are changed at random, each for a process of its own: in an ordinary run, and in a long one.
constexpr unsigned someMessages = takesSomeInputs ? 40 : 60, manyMessages = 300;

/// Whatever changes in the message of a coarse volume, what is shown is one whose numbers make sense.
void FalseReader::expectSenseOfCoarse(unsigned messages) {
    unsigned shown = 0, refused = 0;
    for (unsigned seed = 0; seed < messages; ++seed) {
        Progress progress;
        bool told = false;
        progress.coarse = [&](const CoarseVolume& coarse) {
            told = true;
            EXPECT_EQ(coarse.voxels->geometry().voxelCount(), 64) << seed;
            EXPECT_TRUE(coarse.units >= 1.0 && coarse.units <= 1e5) << seed;
        };
        const auto study = readBy("coarse-mutated", seed, progress);
        EXPECT_EQ(study.has_value(), told) << seed;
        ++(told ? shown : refused);
    }
    EXPECT_GT(refused, messages / 3);
    EXPECT_GT(shown, messages / 30) << "where none was shown, nothing was checked";
}

TEST_F(FalseReader, CannotHandOverACoarseVolumeThatMakesNoSense) { expectSenseOfCoarse(someMessages); }
TEST_F(LongFalseReader, CannotHandOverACoarseVolumeThatMakesNoSense) { expectSenseOfCoarse(manyMessages); }

TEST_F(FalseReader, IsEndedOnCancelAfterItsCoarseVolume) {
    std::atomic<bool> cancel = false;
    Progress progress{{}, &cancel};
    progress.coarse = [&](const CoarseVolume&) { cancel = true; };
    const auto study = readBy("coarse-stays", 1, progress);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
}

/// What a list names is opened for later readers.
TEST_F(FalseReader, ListsOnlyFilesThatItAskedForAndMaySee) {
    const std::string folder = std::filesystem::path(file()).parent_path().string();
    setenv("ECHOLUCENT_FALSE_FOLDER", folder.c_str(), 1);
    const auto listBy = [&](const char* mode) {
        useMode(mode, 1);
        return restricted::listSeries(folder);
    };
    const auto honest = listBy("lists-its-own-file");
    ASSERT_TRUE(honest) << honest.error().sentence() << ": the lies below would prove nothing";
    EXPECT_EQ(honest->series.front().files.front().path, file());
    for (const char* mode : {"lists-a-file-beside", "lists-what-it-did-not-ask-for"}) {
        const auto list = listBy(mode);
        ASSERT_FALSE(list) << mode;
        EXPECT_THAT(list.error().sentence(), HasSubstr("answered what makes no sense")) << mode;
    }
}

TEST_F(FalseReader, OpensNothingOutsideOfTheFolder) { EXPECT_THAT(sentenceBy("outside"), HasSubstr("was refused")); }

TEST_F(FalseReader, SaysNothingThatATerminalOrALabelObeys) {
    const std::string harmless = "a [2J 2J b  c  d" + repeated("\ufffd", 6);
    const auto study = readBy("bad-words");
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->name, harmless);
    EXPECT_EQ(study->facts.front().name, harmless);
    EXPECT_EQ(study->facts.front().value, harmless);
    EXPECT_EQ(study->facts.front().source, harmless);
    ASSERT_EQ(study->warnings.size(), restricted::mostTakenLines);
    EXPECT_EQ(study->warnings.front().size(), restricted::longestTakenLine + 3);
    EXPECT_THAT(study->warnings.front(), AllOf(StartsWith(harmless + "xx"), EndsWith("xx...")));
    EXPECT_EQ(study->warnings.back(), "4801 more notes are not shown.");
    EXPECT_THAT(sentenceBy("refuses-with-bad-words"),
                AllOf(StartsWith(harmless + ": " + harmless + " " + harmless + "xx"), EndsWith("xx... " + harmless)));
}

/// What a list of series says is seen in tables and in JSON.
TEST(TakenWords, OfSeriesAndPatientsAreLines) {
    SeriesEntry entry;
    entry.uid = entry.object = entry.description = entry.modality = entry.distinction = "\x1b]0;a\x07";
    entry.whyNot = fail(FailureKind::unreadable, "/a\nb", "\t", "\x7f", "\u202e").value();
    entry.files.emplace_back().path = "/a\nb";
    entry.files.back().damage = entry.whyNot;
    SeriesList list{"/a\nb", {entry}, {"/a\nb"}, {"\x1b"}};
    restricted::makeHarmless(list);
    const SeriesEntry& taken = list.series.front();
    for (const std::string& word : {taken.uid, taken.object, taken.description, taken.modality, taken.distinction})
        EXPECT_EQ(word, " ]0;a ");
    for (const Failure& failure : {*taken.whyNot, *taken.files.front().damage}) {
        EXPECT_EQ(failure.element + failure.problem + failure.remedy, "   ");
        EXPECT_EQ(failure.file, "/a\nb") << "paths name files";
    }
    EXPECT_EQ(list.path + list.files.front() + taken.files.front().path, "/a\nb/a\nb/a\nb");
    EXPECT_EQ(list.warnings.front(), " ");
    Patient patient{"Anna\nMuster", "\x01", "\x02", "\x03", "\x04", "\x05"};
    restricted::makeHarmless(patient);
    EXPECT_EQ(patient.name + patient.id + patient.birthDate + patient.sex + patient.studyDate + patient.gestationalAge,
              "Anna Muster     ");
}

TEST_F(FalseReader, DiesWithASentence) {
    EXPECT_THAT(sentenceBy("ends-at-once"), HasSubstr("ended without a word (status 0)"));
    EXPECT_THAT(sentenceBy("crashes"), HasSubstr("made the process that reads files end (signal 11)"));
    EXPECT_THAT(sentenceBy("too-long"), HasSubstr("takes longer to read than any file of its size may"));
}

TEST_F(FalseReader, IsEndedOnCancel) {
    for (const char* mode : {"silent", "endless-progress"}) {
        std::atomic<bool> cancel = false;
        int reports = 0;
        // A silent one reports nothing: cancel is raised before it is asked then.
        if (std::string(mode) == "silent") cancel = true;
        const auto study = readBy(mode, 1, {[&](double) { cancel = ++reports > 3; }, &cancel});
        ASSERT_FALSE(study);
        EXPECT_EQ(study.error().kind, FailureKind::cancelled) << mode;
    }
}

/// Whatever changes in the message of a study, what opens is a study whose numbers make sense.
void FalseReader::expectSenseOfStudies(unsigned messages) {
    unsigned opened = 0, refused = 0;
    for (unsigned seed = 0; seed < messages; ++seed) {
        const auto study = readBy("mutated", seed);
        ++(study ? opened : refused);
        if (!study) continue;
        const Volume& volume = *study->phases.front();
        EXPECT_EQ(volume.geometry().voxelCount(), 64) << seed;
        const auto& reduction = volume.geometry().reduction;
        EXPECT_TRUE(!reduction || canHaveMade(*reduction, volume.geometry().size)) << seed;
        EXPECT_TRUE(std::isfinite(volume.whiteLevel()) && volume.whiteLevel() > 0) << seed;
        for (const double mm : volume.geometry().spacing.val) EXPECT_TRUE(mm >= 1e-4 && mm <= 1e4) << seed;
    }
    EXPECT_GT(refused, messages / 3);
    EXPECT_GT(opened, messages / 30) << "where nothing opened, nothing was checked";
}

TEST_F(FalseReader, CannotHandOverAStudyThatMakesNoSense) { expectSenseOfStudies(someMessages); }
TEST_F(LongFalseReader, CannotHandOverAStudyThatMakesNoSense) { expectSenseOfStudies(manyMessages); }

TEST_F(FalseReader, IsMissed) {
    restricted::useReaderProgram("/nowhere/echolucent-reader");
    const auto study = restricted::readStudy(file());
    ASSERT_FALSE(study);
    EXPECT_EQ(
        study.error().sentence(),
        "/nowhere/echolucent-reader: cannot be started to read files: it is not there. Install Echolucent again.");
    restricted::useReaderProgram(besideThisProgram("..") + "/CMakeCache.txt");
    const auto noProgram = restricted::readStudy(file());
    ASSERT_FALSE(noProgram);
    EXPECT_THAT(noProgram.error().sentence(), HasSubstr("cannot be started to read files: "));
}

}  // namespace
}  // namespace echolucent
