// Slices that lie at the same places again and again: the attribute that tells their phases apart, and their times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "dicom_bytes.h"
#include "io/dicom/frames/date_times.h"
#include "io/study/series_list.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

constexpr int momentPlaces = 3;
constexpr int momentPhases = 4;

/// A picture of 4 x 2 pixels of 10 * phase + place + 1, all counted from 0.
struct MomentSlice {
    int phase = 0, place = 0;
    int instance = 1;
    std::string identifier{}, trigger{}, resolution{}, acquired{}, acquiredOn{}, acquiredAt{}, content{}, imageType{},
        number{}, decimals{};  ///< `decimals` stand behind the place in mm: ".01"

    [[nodiscard]] std::string bytes() const {
        DicomBytes file;
        const auto text = [&](std::uint16_t group, std::uint16_t element, const char* vr, const std::string& value) {
            if (!value.empty()) file.text(group, element, vr, value);
        };
        text(0x0008, 0x0008, "CS", imageType);
        text(0x0008, 0x0018, "UI", "1.2.3." + std::to_string(instance));
        text(0x0008, 0x0022, "DA", acquiredOn);
        text(0x0008, 0x002a, "DT", acquiredAt);
        text(0x0008, 0x0032, "TM", acquired);
        text(0x0008, 0x0033, "TM", content);
        text(0x0018, 0x1060, "DS", trigger);
        text(0x0020, 0x000e, "UI", "1.2.3");
        text(0x0020, 0x0012, "IS", number);
        text(0x0020, 0x0013, "IS", std::to_string(instance));
        text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(2 * place) + decimals);
        text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
        text(0x0020, 0x0100, "IS", identifier);
        text(0x0020, 0x0110, "DS", resolution);
        text(0x0028, 0x0030, "DS", "0.5\\0.5");
        DicomBytes pixels;
        pixels.picture(4, 2, 0).put(0x7fe0, 0x0010, "OW", std::string(8, static_cast<char>(10 * phase + place + 1)));
        return file.file(pictureClass) + pixels.bytes();
    }
};

/// Writes all pictures, whose instance numbers count through the places of a phase, after `set` has changed each.
void writePhases(const TemporaryFolder& folder, const std::function<void(MomentSlice&)>& set) {
    for (int phase = 0; phase < momentPhases; ++phase)
        for (int place = 0; place < momentPlaces; ++place) {
            MomentSlice slice{phase, place, 1 + momentPlaces * phase + place};
            set(slice);
            folder.write("i" + std::to_string(slice.instance), slice.bytes());
        }
}

/// Requires the voxels of `count` phases, the first of which is `first`.
void expectPhases(const Study& study, int count = momentPhases, int first = 0) {
    ASSERT_EQ(study.phases.size(), static_cast<std::size_t>(count));
    for (int phase = 0; phase < count; ++phase) {
        const Volume& volume = *study.phases[static_cast<std::size_t>(phase)];
        ASSERT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{4, 2, momentPlaces}));
        EXPECT_EQ(volume.geometry().spacing, Vec3(0.5, 0.5, 2));
        for (std::int64_t place = 0; place < momentPlaces; ++place)
            EXPECT_EQ(volume.storedValue(8 * place), static_cast<double>(10 * (first + phase) + place + 1));
    }
}

TEST(SlicesOverTime, TemporalPositionIdentifierAndResolutionGivePhases) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.identifier = std::to_string(slice.phase + 1);
        slice.resolution = "40.0";
        slice.content = "12000" + std::to_string(slice.phase) + ".0";
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    ASSERT_TRUE(study->phaseTimes.meanSeconds);
    EXPECT_NEAR(*study->phaseTimes.meanSeconds, 0.04, 1e-9);
    EXPECT_TRUE(warnsOf(*study, "(0020,0100) Temporal Position Identifier tells 4 phases apart"));
    EXPECT_EQ(factOf(*study, "format"), "DICOM, 4 phases of 3 slices");
}

TEST(SlicesOverTime, TriggerTimesOfEachSliceGivePhasesByTheirOrder) {
    const TemporaryFolder folder;
    // Each place is taken through a whole heart cycle, whose length is never quite the same.
    writePhases(folder, [](MomentSlice& slice) {
        slice.instance = 1 + momentPhases * slice.place + slice.phase;
        slice.trigger = std::to_string(7 + slice.place + 50 * slice.phase);
        slice.identifier = "1";
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    ASSERT_TRUE(study->phaseTimes.meanSeconds);
    EXPECT_NEAR(*study->phaseTimes.meanSeconds, 0.05, 1e-9);
    EXPECT_TRUE(warnsOf(*study, "(0018,1060) Trigger Time tells 4 phases apart"));
}

TEST(SlicesOverTime, TimesOfAcquisitionPassMidnight) {
    const TemporaryFolder folder;
    const std::array<std::string, momentPhases> times{"235958.5", "235959.5", "000000.5", "000001.5"};
    for (const bool dated : {false, true}) {
        writePhases(folder, [&](MomentSlice& slice) {
            slice.acquired = times[static_cast<std::size_t>(slice.phase)];
            if (dated) slice.acquiredOn = slice.phase < 2 ? "20191231" : "20200101";
            slice.instance = 100 - slice.instance;
        });
        const auto study = readStudy(folder.path(), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        expectPhases(*study);
        ASSERT_TRUE(study->phaseTimes.meanSeconds);
        EXPECT_NEAR(*study->phaseTimes.meanSeconds, 1.0, 1e-5);
        EXPECT_TRUE(warnsOf(*study, "(0008,0032) Acquisition Time tells 4 phases apart"));
    }
}

TEST(SlicesOverTime, TimesWithDatesPassNoMidnightTwice) {
    const TemporaryFolder folder;
    const std::array<std::string, momentPhases> times{"080000", "080001", "060000", "060001"};
    writePhases(folder, [&](MomentSlice& slice) {
        slice.acquired = times[static_cast<std::size_t>(slice.phase)];
        slice.acquiredOn = slice.phase < 2 ? "20191231" : "20200101";
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    ASSERT_EQ(study->phaseTimes.starts.size(), 4u);
    EXPECT_NEAR(study->phaseTimes.starts[3], 22 * 3600 + 1, 1e-3);
}

TEST(SlicesOverTime, RoundedPlacesAreTheSame) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.identifier = std::to_string(slice.phase + 1);
        if (slice.phase % 2 == 1) slice.decimals = ".01";
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
}

TEST(SlicesOverTime, TimesOfContentCountIfNothingElseTells) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.acquired = "120000";
        slice.content = "1200" + std::string(1, static_cast<char>('0' + 2 * slice.phase)) + "0";
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    EXPECT_NEAR(study->phaseTimes.meanSeconds.value_or(0), 20.0, 1e-6);
    EXPECT_TRUE(warnsOf(*study, "(0008,0033) Content Time tells 4 phases apart"));
}

TEST(SlicesOverTime, PhasesByIdentifierHaveTheTimesThatAreThere) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.identifier = std::to_string(10 - slice.phase);  // falls
        slice.trigger = "12";                                 // says nothing
    });
    auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->storedValue(0), 31) << "phases are in the order of the identifier";
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
    EXPECT_TRUE(warnsOf(*study, "the time between phases is unknown"));
    // A resolution that is far from the times of acquisition is of another unit.
    writePhases(folder, [](MomentSlice& slice) {
        slice.identifier = std::to_string(slice.phase + 1);
        slice.resolution = "5000000";
        slice.acquired = "1200" + std::to_string(10 + 5 * slice.phase);
    });
    study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_NEAR(study->phaseTimes.meanSeconds.value_or(0), 5.0, 1e-6);
    EXPECT_EQ(sourceOf(*study, "time between phases"), "(0008,0032) Acquisition Time");
}

TEST(SlicesOverTime, UnevenTimesStayAsTheyAre) {
    const TemporaryFolder folder;
    constexpr std::array times{100, 130, 190, 300};
    writePhases(folder, [&](MomentSlice& slice) {
        slice.identifier = std::to_string(slice.phase + 1);
        slice.resolution = "40";
        slice.trigger = std::to_string(times[static_cast<std::size_t>(slice.phase)]);
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    EXPECT_THAT(study->phaseTimes.starts,
                testing::ElementsAre(0, testing::DoubleNear(0.03, 1e-9), testing::DoubleNear(0.09, 1e-9),
                                     testing::DoubleNear(0.2, 1e-9)));
    EXPECT_EQ(sourceOf(*study, "time between phases"), "(0018,1060) Trigger Time");
}

TEST(SlicesOverTime, InstanceNumbersCountIfNothingSaysTheTime) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice&) {});
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study);
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
    EXPECT_TRUE(warnsOf(*study, "4 phases were taken in the order of (0020,0013) Instance Number"));
}

TEST(SlicesOverTime, PicturesOfSeveralKindsAreNoPhases) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.imageType = slice.phase % 2 == 0 ? "ORIGINAL\\PRIMARY\\M" : "ORIGINAL\\PRIMARY\\P";
        slice.content = "12000" + std::to_string(slice.phase);
    });
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("Image Position is the same for two slices"));
}

TEST(SlicesOverTime, APhaseThatLacksASliceIsNamedAndLeftOut) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) { slice.identifier = std::to_string(slice.phase + 1); });
    std::filesystem::remove(folder.file("i5"));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 3u);
    EXPECT_EQ(study->phases[1]->storedValue(8), 22);
    EXPECT_TRUE(warnsOf(*study, "phase 2 of 4 lacks 1 of 3 slices"));
    for (const char* name : {"i1", "i12"}) std::filesystem::remove(folder.file(name));
    EXPECT_THAT(
        readStudy(folder.path()).error().sentence(),
        HasSubstr("(0020,0100) Temporal Position Identifier shows that slices are missing: phase 1 of 4 lacks 1 "
                  "of 3 slices, phase 2 of 4 lacks 1 of 3 slices, phase 4 of 4 lacks 1 of 3 slices"));
}

TEST(SlicesOverTime, ASliceThatIsMissingAmongTimesOfTheirOwnIsFoundByTheRepetition) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) { slice.acquired = "1200" + std::to_string(10 + slice.instance); });
    std::filesystem::remove(folder.file("i12"));
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectPhases(*study, 3);
    EXPECT_NEAR(study->phaseTimes.meanSeconds.value_or(0), 3.0, 1e-6);
    EXPECT_TRUE(warnsOf(*study, "phase 4 of 4 lacks 1 of 3 slices"));
}

TEST(SlicesOverTime, TwoVolumesSideBySideStayOne) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) {
        slice.place += momentPlaces * slice.phase;
        slice.identifier = std::to_string(slice.phase + 1);
    });
    const auto study = readStudy(folder.path(), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 1u);
    EXPECT_EQ(study->phases[0]->geometry().size[2], momentPlaces * momentPhases);
}

TEST(SlicesOverTime, AnUnreadableSliceIsNoDataInAllPhases) {
    const TemporaryFolder folder;
    writePhases(folder, [](MomentSlice& slice) { slice.identifier = std::to_string(slice.phase + 1); });
    const auto list = listSeries(folder.path());
    ASSERT_TRUE(list) << list.error().sentence();
    EXPECT_EQ(list->series[0].size, (std::array<std::int64_t, 3>{4, 2, momentPlaces}));
    EXPECT_EQ(sizeInWords(list->series[0]), "4 x 2, 3 slices, 4 phases");
    folder.write("i1", "no DICOM any more");
    folder.write("i5", "no DICOM any more");
    const auto study = readSeries(*list, list->series[0], withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_TRUE(warnsOf(*study, "2 of 12 slices could not be read and are shown as no data in all phases"));
    for (const auto& phase : study->phases) {
        EXPECT_FALSE(phase->hasData(0));
        EXPECT_FALSE(phase->hasData(8));
        EXPECT_TRUE(phase->hasData(16));
    }
    EXPECT_EQ(study->phases[1]->storedValue(0), 11) << "voxels keep their places";
    EXPECT_EQ(study->phases[3]->storedValue(16), 33);
}

TEST(DateTimes, AreReadFromTimesOfDayDatesAndBoth) {
    EXPECT_EQ(secondsOfDay("235959.5"), 86399.5);
    EXPECT_EQ(secondsOfDay("0102"), 3720);
    EXPECT_EQ(secondsOfDay("01"), 3600);
    EXPECT_EQ(secondsOfDay("01:02:03"), 3723);
    for (const char* wrong : {"", "1", "2561", "0160", "010270", "010203,5", "010203.5x", "noon", "-10203"})
        EXPECT_FALSE(secondsOfDay(wrong)) << wrong;
    EXPECT_EQ(daysOfDate("20200301").value_or(0) - daysOfDate("2020.02.28").value_or(0), 2);
    for (const char* wrong : {"", "2020", "20201301", "20190229", "202001011"})
        EXPECT_FALSE(daysOfDate(wrong)) << wrong;
    EXPECT_EQ(secondsOfDateTime("20200101000000.25+0100"), secondsOfDateTime("20191231230000.25"));
    EXPECT_EQ(secondsOfDateTime("20191231190000-0500"), secondsOfDateTime("20200101000000"));
    for (const char* wrong : {"", "20200101", "20200101x", "20200101120000+9", "20200101120000+0100x"})
        EXPECT_FALSE(secondsOfDateTime(wrong)) << wrong;
}

}  // namespace
}  // namespace echolucent
