// Series of which some slices cannot be read, or are of something else: what is shown, and where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "dicom_bytes.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

using testing::Each;
using testing::HasSubstr;

/// A slice of 8 x 8 pixels at this depth: 0 in the corners of the picture, which no sector reaches, and `inside`
/// within.
std::string sectorSlice(int depth, char inside, const std::string& patient = "P-1") {
    DicomBytes file;
    file.text(0x0008, 0x0018, "UI", "1.2.3." + std::to_string(depth)).text(0x0008, 0x0060, "CS", "US");
    file.text(0x0010, 0x0010, "PN", "Muster^Anna").text(0x0010, 0x0020, "LO", patient);
    file.text(0x0020, 0x000e, "UI", "1.2.3").text(0x0020, 0x0013, "IS", std::to_string(depth));
    file.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(depth)).text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    std::string grey(64, inside);
    for (const std::size_t corner : {0, 7, 56, 63}) grey[corner] = '\0';
    return file.picture(8, 8, 0).put(0x7fe0, 0x0010, "OW", grey).file(pictureClass);
}

std::string name(int depth) { return "s" + std::to_string(depth); }

/// Which voxels of a slice are data: all, none, or some.
std::string dataIn(const Volume& volume, std::int64_t z) {
    int data = 0;
    for (std::int64_t i = 0; i < 64; ++i) data += volume.hasData(z * 64 + i) ? 1 : 0;
    return data == 64 ? "all" : data == 0 ? "none" : "some";
}

TEST(DamagedSeries, ACutSliceIsNoDataInItsPlaceAndTheOthersStay) {
    const TemporaryFolder folder;
    for (int depth = 0; depth < 7; ++depth) {
        const std::string whole = sectorSlice(depth, static_cast<char>(10 + depth));
        folder.write(name(depth), depth == 3 ? whole.substr(0, whole.size() - 9) : whole);
    }
    for (const bool guess : {false, true}) {
        ReadOptions options;
        options.guessNoData = guess;
        const auto study = readStudy(folder.path(), options);
        ASSERT_TRUE(study) << study.error().sentence();
        const Volume& volume = *study->phases[0];
        ASSERT_EQ(volume.geometry().size[2], 7);
        for (std::int64_t z = 0; z < 7; ++z) {
            EXPECT_EQ(dataIn(volume, z), z == 3 ? "none" : guess ? dataIn(volume, 0) : "all") << z;
            EXPECT_EQ(volume.storedValue(z * 64 + 27), z == 3 ? 0.0 : 10.0 + static_cast<double>(z));
        }
    }
}

TEST(DamagedSeries, TheOutsideIsNotGuessedThroughAMissingSlice) {
    const TemporaryFolder folder;
    // Black fluid in the middle of the slices touches the outside nowhere but through the missing slice.
    for (int depth = 0; depth < 9; ++depth) {
        std::string whole = sectorSlice(depth, 'a');
        for (int y = 2; y < 6; ++y)
            for (int x = 2; x < 6; ++x)
                if (depth > 1 && depth < 7) whole[whole.size() - 64 + static_cast<std::size_t>(8 * y + x)] = '\0';
        folder.write(name(depth), depth == 4 ? whole.substr(0, whole.size() - 9) : whole);
    }
    const auto study = readStudy(folder.path());
    ASSERT_TRUE(study) << study.error().sentence();
    for (const std::int64_t z : {2, 3, 5, 6}) EXPECT_TRUE(study->phases[0]->hasData(z * 64 + 27)) << z;
    EXPECT_EQ(dataIn(*study->phases[0], 4), "none");
}

TEST(DamagedSeries, SlicesOfTwoPatientsAreListedApartAndNeitherIsNamed) {
    const TemporaryFolder folder;
    for (int depth = 0; depth < 7; ++depth)
        folder.write(name(depth), sectorSlice(depth, static_cast<char>(10 + depth), depth < 4 ? "P-1" : "P-2"));
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    ASSERT_EQ(list->series.size(), 2u);
    EXPECT_EQ(list->series[0].distinction, "patient 1 of 2");
    EXPECT_EQ(list->series[1].distinction, "patient 2 of 2");
    EXPECT_NE(list->series[0].uid, list->series[1].uid);
    for (const SeriesEntry& entry : list->series) EXPECT_FALSE(entry.whyNot);
    const auto second = readSeries(*list, list->series[1], withoutGuess());
    ASSERT_TRUE(second) << second.error().sentence();
    EXPECT_EQ(second->phases[0]->storedValue(27), 14.0);
    EXPECT_THAT(second->warnings, Each(testing::Not(HasSubstr("P-"))));
}

/// Runs as another person while it lives, where the tests run as root, whom nothing is forbidden.
class NotRoot {
public:
    NotRoot() : m_wasRoot(geteuid() == 0 && seteuid(65534) == 0) {}
    ~NotRoot() {
        if (m_wasRoot && seteuid(0) != 0) std::abort();
    }
    NotRoot(const NotRoot&) = delete;
    NotRoot& operator=(const NotRoot&) = delete;

private:
    bool m_wasRoot;
};

TEST(DamagedSeries, MissingPermissionIsCalledThat) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms::all);
    for (int depth = 0; depth < 4; ++depth) folder.write(name(depth), sectorSlice(depth, 'a'));
    fs::permissions(folder.file(name(3)), fs::perms::none);
    fs::create_directories(folder.file("closed"));
    fs::permissions(folder.file("closed"), fs::perms::none);
    if (const NotRoot person; geteuid() == 0) GTEST_SKIP() << "nothing is forbidden to this user";
    Result<SeriesList> list = fail(FailureKind::unreadable, "", "", ""), closed = list;
    {
        const NotRoot person;
        list = listSeries(folder.path());
        closed = listSeries(folder.file("closed"));
    }
    fs::permissions(folder.file("closed"), fs::perms::all);
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_THAT(list->warnings, testing::Contains(HasSubstr("1 folder(s) could not be opened: the permission")));
    EXPECT_THAT(list->warnings, testing::Contains(testing::AllOf(HasSubstr("1 file(s) were left out: \"s3\""),
                                                                 HasSubstr("permission to read it"))));
    ASSERT_FALSE(closed);
    EXPECT_THAT(closed.error().sentence(), HasSubstr("could not be looked into: the permission to read it"));
}

TEST(DamagedSeries, ManyFilesThatShareTheirNamesAreListedInTimeThatGrowsWithTheirNumber) {
    const TemporaryFolder folder;
    DicomBytes file;
    file.text(0x0020, 0x000e, "UI", "1.2.5");
    const std::string cine = file.picture(1, 1, 2).put(0x7fe0, 0x0010, "OW", "ab").file(cineClass);
    const auto secondsOf = [&](int from, int to) {
        for (int i = from; i < to; ++i) folder.write(std::to_string(i), cine);
        const auto begun = std::chrono::steady_clock::now();
        const auto list = listSeries(folder.path());
        EXPECT_TRUE(list);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    };
    constexpr int files = takesSomeInputs ? 250 : 1000;
    const double few = secondsOf(0, files);
    const double many = secondsOf(files, 8 * files);
    EXPECT_LT(many, 30 * std::max(few, 0.02)) << "eight times as many files; quadratic is 64 times";
}

}  // namespace
}  // namespace echolucent
