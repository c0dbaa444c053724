// Volumes of which 0 is the wrong black, or which float32 cannot hold: their window comes from the data, is said, and
// changes nothing but the numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "io/writers/enhanced_us_writer.h"
#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "nifti_files.h"
#include "processing/intensity/histogram.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

constexpr int edge = 12;
constexpr std::size_t voxelCount = std::size_t{edge} * edge * edge;

/// A body of 1 to 200 in the middle of a grid that is 0 elsewhere.
std::vector<double> body() {
    std::vector<double> values;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const bool inside = std::min({x, y, z, edge - 1 - x, edge - 1 - y, edge - 1 - z}) >= 2;
                values.push_back(inside ? 1 + (37 * x + 11 * y + 5 * z) % 200 : 0);
            }
    return values;
}

template <typename T>
std::string metaImage(const std::string& type, const std::vector<double>& values, const std::string& more = "",
                      double plus = 0.0, double times = 1.0) {
    std::vector<T> stored;
    for (const double value : values) stored.push_back(static_cast<T>(value * times + plus));
    const auto slices = std::to_string(edge);
    const std::string size = values.size() > voxelCount ? slices + " " + slices + " " + slices + " " +
                                                              std::to_string(values.size() / voxelCount)
                                                        : slices + " " + slices + " " + slices;
    const std::string dimensions = values.size() > voxelCount ? "4" : "3";
    const std::string spacing = values.size() > voxelCount ? "1 1 1 0.1" : "1 1 1";
    return "ObjectType = Image\nNDims = " + dimensions + "\nDimSize = " + size + "\nElementSpacing = " + spacing +
           "\nElementType = " + type + "\n" + more + "ElementDataFile = LOCAL\n" + bytesFrom(stored);
}

Study readBytes(const std::string& bytes, const ReadOptions& options = {}, const std::string& name = "v.mha") {
    const TemporaryFolder folder;
    auto study = readStudy(folder.write(name, bytes), options);
    EXPECT_TRUE(study) << study.error().sentence();
    if (study) return *std::move(study);
    Study none;
    none.phases.push_back(std::make_shared<const Volume>(VolumeGeometry{}, std::vector<std::uint8_t>{0}));
    return none;
}

std::vector<double> intensities(const Volume& volume) {
    std::vector<double> all;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) all.push_back(volume.normalisedIntensity(i));
    return all;
}

/// Whether two studies look the same: intensities, masks and boxes.
void expectSamePicture(const Study& one, const Study& other, double tolerance, const std::string& name) {
    const Volume &a = *one.phases[0], &b = *other.phases[0];
    EXPECT_THAT(intensities(a), testing::Pointwise(testing::DoubleNear(tolerance), intensities(b))) << name;
    EXPECT_TRUE(a.dataMask() == b.dataMask()) << name;
    EXPECT_EQ(a.dataBox(), b.dataBox()) << name;
}

TEST(ValueWindow, AShiftOfAllValuesChangesNothingButTheNumbers) {
    const Study plain = readBytes(metaImage<std::uint16_t>("MET_USHORT", body()));
    ASSERT_FALSE(plain.phases[0]->dataMask().empty()) << "the outside of the body is guessed";
    EXPECT_EQ(plain.phases[0]->valueWindow(), (ValueWindow{0.0, 200.0}));
    EXPECT_EQ(factOf(plain, "black level"), "none") << "black at 0 is a matter of course";
    EXPECT_TRUE(plain.warnings.empty() || !warnsOf(plain, "black"));
    for (const double shift : {-1000.0, -200.0, -32768.0}) {
        const Study shifted = readBytes(metaImage<std::int16_t>("MET_SHORT", body(), "", shift));
        const Volume& volume = *shifted.phases[0];
        EXPECT_EQ(volume.typeName(), "uint16") << "whole numbers stay whole";
        EXPECT_TRUE(volume.voxels() == plain.phases[0]->voxels());
        expectSamePicture(shifted, plain, 0.0, std::to_string(shift));
        EXPECT_TRUE(intensityHistogram(volume) == intensityHistogram(*plain.phases[0]));
        EXPECT_EQ(volume.valueWindow(), (ValueWindow{shift, shift + 200.0}));
        EXPECT_EQ(volume.fileValue(0), shift);
    }
    for (const double shift : {-1000.0, -1e6, 1e6, 1e9}) {
        const Study shifted = readBytes(metaImage<double>("MET_DOUBLE", body(), "", shift));
        expectSamePicture(shifted, plain, 1e-7, std::to_string(shift));
        EXPECT_NEAR(shifted.phases[0]->fileValue(500), body()[500] + shift, 1e-6);
    }
}

TEST(ValueWindow, AFactorOfAllValuesChangesNothingButTheNumbers) {
    const Study plain = readBytes(metaImage<float>("MET_FLOAT", body()));
    for (const double factor : {1e-39, 1e-300, 1e38, 5e305, 1e30, 1e-30}) {
        const Study scaled = readBytes(metaImage<double>("MET_DOUBLE", body(), "", 0.0, factor));
        expectSamePicture(scaled, plain, 1e-6, std::to_string(factor));
        const Volume& volume = *scaled.phases[0];
        EXPECT_NEAR(volume.whiteValue() / factor, 200.0, 1e-3);
        EXPECT_EQ(volume.blackValue(), 0.0);
        for (const std::int64_t at : {0, 400, 777})
            EXPECT_NEAR(volume.fileValue(at) / factor, body()[static_cast<std::size_t>(at)], 1e-3) << factor;
    }
    const Study scaled = readBytes(metaImage<float>("MET_FLOAT", body(), "", 0.0, 1e-40));
    expectSamePicture(scaled, plain, 1e-4, "denormal floats");
    const Study tiniest = readBytes(metaImage<double>("MET_DOUBLE", body(), "", 0.0, 5e-324));
    expectSamePicture(tiniest, plain, 1e-6, "denormal doubles");
    EXPECT_TRUE(warnsOf(tiniest, "black is 0, white 9.88131e-322"));
}

TEST(ValueWindow, TheWholeRangeOfDoublesIsNotTooMuch) {
    std::vector<double> values = body();
    for (double& value : values) value = (value - 100.0) * 1.7e306;
    const Study study = readBytes(metaImage<double>("MET_DOUBLE", values), withoutGuess());
    const Volume& volume = *study.phases[0];
    EXPECT_NEAR(volume.blackValue() / 1.7e308, -1.0, 1e-6);
    EXPECT_NEAR(volume.whiteValue() / 1.7e308, 1.0, 1e-6);
    EXPECT_NEAR(volume.normalisedIntensity(500), body()[500] / 200.0, 1e-6);
    EXPECT_NEAR(volume.fileValue(500) / 1.7e306, body()[500] - 100.0, 1e-3);
}

TEST(ValueWindow, TheEndsOfDoublesStayFinite) {
    constexpr double most = std::numeric_limits<double>::max();
    for (const auto& [low, high] : {std::pair{-most, most}, {0.0, most}, {-most, 0.0}, {-1e300, most}}) {
        std::vector<double> values;
        for (std::size_t i = 0; i < voxelCount; ++i) values.push_back(i % 2 == 0 ? low : high);
        const Study study = readBytes(metaImage<double>("MET_DOUBLE", values), withoutGuess());
        const Volume& volume = *study.phases[0];
        EXPECT_TRUE(std::isfinite(volume.blackValue()) && std::isfinite(volume.whiteValue())) << low << " " << high;
        EXPECT_LT(volume.blackValue(), volume.whiteValue());
        EXPECT_NEAR(volume.fileValue(1) / most, high / most, 1e-6) << low << " " << high;
        EXPECT_TRUE(std::isfinite(volume.fileValue(0)) && std::isfinite(volume.fileValue(1)));
    }
}

TEST(ValueWindow, DecibelsShowTheBody) {
    std::vector<double> values;
    for (const double value : body()) values.push_back(value > 0 ? 0.25 * value - 50.0 : -60.0);
    for (const bool padded : {false, true}) {
        std::vector<double> all = values;
        if (padded)
            for (double& value : all) value = value == -60.0 ? -999.0 : value;
        const Study study = readBytes(metaImage<float>("MET_FLOAT", all));
        const Volume& volume = *study.phases[0];
        EXPECT_NEAR(volume.blackValue(), padded ? -49.75 : -60.0, 1e-5);
        EXPECT_EQ(volume.whiteValue(), 0.0);
        EXPECT_FALSE(volume.dataMask().empty()) << "the outside holds one value";
        EXPECT_FALSE(volume.hasData(0));
        EXPECT_TRUE(volume.hasData(volume.geometry().offset(5, 5, 5)));
        EXPECT_TRUE(warnsOf(study, padded ? "-999, far below all others: that is taken for padding"
                                          : "The voxels hold -60 to 0: black is -60, white 0."));
        EXPECT_EQ(factOf(study, "values"), padded ? "-999 to 0" : "-60 to 0");
        EXPECT_EQ(factOf(study, "white level"), "0");
    }
}

TEST(ValueWindow, WhatReachesFarBelowZeroIsNotCutInHalf) {
    std::vector<double> values = body();
    for (double& value : values) value = value > 0 ? value - 100.0 : 0.0;
    const Study study = readBytes(metaImage<float>("MET_FLOAT", values));
    const Volume& volume = *study.phases[0];
    EXPECT_EQ(volume.valueWindow(), (ValueWindow{-99.0, 100.0}));
    EXPECT_FALSE(volume.hasData(0)) << "the file's 0 is the outside, though it is no black";
    EXPECT_EQ(sourceOf(study, "black level"), "smallest value in the data");
}

TEST(ValueWindow, BlackStaysAtZeroWhereZeroHidesLittle) {
    std::vector<double> few = body();
    for (std::size_t i = 0; i < few.size(); i += 40) few[i] = -40.0;  // 44 beside 500 of the body
    std::vector<double> shallow = body();
    for (double& value : shallow)
        if (value == 0) value = -1.0;  // less than 1 % of 200
    std::vector<double> marked = body();
    for (double& value : marked)
        if (value == 0) value = -1000.0;  // outside
    for (const auto& values : {few, shallow, marked}) {
        const Study study = readBytes(metaImage<float>("MET_FLOAT", values), withoutGuess());
        EXPECT_TRUE(study.phases[0]->valueScale().isIdentity());
        EXPECT_EQ(study.phases[0]->storedValue(0), values[0]) << "not a bit changes";
        EXPECT_TRUE(warnsOf(study, "these count as intensity 0"));
        EXPECT_EQ(factOf(study, "values"), "none");
    }
}

TEST(ValueWindow, IsKeptAtZeroForOldDocuments) {
    ReadOptions old = withoutGuess();
    old.blackAtZero = true;
    const Study study = readBytes(metaImage<std::int16_t>("MET_SHORT", body(), "", -1000.0), old);
    EXPECT_TRUE(study.phases[0]->valueScale().isIdentity());
    EXPECT_EQ(study.phases[0]->storedValue(0), -1000.0);
    EXPECT_TRUE(warnsOf(study, "Black is kept at 0"));
    const Study ordinary = readBytes(metaImage<std::uint16_t>("MET_USHORT", body()), old);
    EXPECT_FALSE(warnsOf(ordinary, "Black is kept at 0"));
}

TEST(ValueWindow, OfExtremesIsOneAllTheSame) {
    const double nan = std::nan("");
    const std::vector<double> equal(voxelCount, -5.0);
    std::vector<double> oneAbove = equal, withNan = equal, nothing(voxelCount, nan);
    oneAbove[700] = 3.0;
    for (std::size_t i = 0; i < voxelCount; ++i) withNan[i] = i % 3 == 0 ? nan : -static_cast<double>(i % 7);
    const Study same = readBytes(metaImage<float>("MET_FLOAT", equal));
    EXPECT_EQ(same.phases[0]->valueWindow(), (ValueWindow{-5.0, 0.0}));
    EXPECT_EQ(readBytes(metaImage<float>("MET_FLOAT", oneAbove)).phases[0]->valueWindow(), (ValueWindow{-5.0, 3.0}));
    const Study partly = readBytes(metaImage<float>("MET_FLOAT", withNan), withoutGuess());
    EXPECT_EQ(partly.phases[0]->valueWindow(), (ValueWindow{-6.0, 0.0}));
    EXPECT_FALSE(partly.phases[0]->hasData(0)) << "no number, no data";
    EXPECT_TRUE(partly.phases[0]->hasData(1));
    EXPECT_TRUE(readBytes(metaImage<float>("MET_FLOAT", nothing)).phases[0]->valueScale().isIdentity());
    const Study huge = readBytes(metaImage<double>("MET_DOUBLE", std::vector<double>(voxelCount, -1.7e308)));
    EXPECT_EQ(huge.phases[0]->valueWindow(), (ValueWindow{-1.7e308, 0.0}));
    const Study bytes = readBytes(metaImage<std::int8_t>("MET_CHAR", body(), "", -128.0), withoutGuess());
    EXPECT_EQ(bytes.phases[0]->typeName(), "uint8");
    EXPECT_EQ(bytes.phases[0]->valueWindow(), (ValueWindow{-128.0, 72.0}));
}

TEST(ValueWindow, ColdAndHotVoxelsMoveNothing) {
    std::vector<double> values = body();
    for (double& value : values) value -= 1000.0;
    values[0] = -1e300;
    values[1] = 1e300;
    const Study study = readBytes(metaImage<double>("MET_DOUBLE", values), withoutGuess());
    const Volume& volume = *study.phases[0];
    EXPECT_EQ(volume.valueWindow(), (ValueWindow{-1000.0, -800.0}));
    EXPECT_TRUE(volume.dataMask().empty()) << "what float32 cannot hold is a number all the same";
    EXPECT_EQ(volume.normalisedIntensity(0), 0.0);
    EXPECT_EQ(volume.normalisedIntensity(1), 1.0);
    EXPECT_TRUE(warnsOf(study, "1 voxels hold values down to -1e+300"));
}

TEST(ValueWindow, IsOneForAllPhases) {
    std::vector<double> phases = body();
    for (const double value : body()) phases.push_back(value / 2 - 50.0);
    for (double& value : phases) value -= 300.0;
    const Study study = readBytes(metaImage<float>("MET_FLOAT", phases), withoutGuess());
    ASSERT_EQ(study.phases.size(), 2U);
    for (const auto& phase : study.phases) EXPECT_EQ(phase->valueWindow(), (ValueWindow{-350.0, -100.0}));
    EXPECT_NEAR(study.phases[1]->fileValue(700), body()[700] / 2 - 350.0, 1e-4);
}

TEST(ValueWindow, TheFileMayStateIt) {
    const std::string both = "BlackLevel = -500\nWhiteLevel = -100\n";
    const Study stated = readBytes(metaImage<float>("MET_FLOAT", body(), both, -400.0), withoutGuess());
    EXPECT_EQ(stated.phases[0]->valueWindow(), (ValueWindow{-500.0, -100.0}));
    EXPECT_EQ(sourceOf(stated, "black level"), "BlackLevel");
    const Study whiteAlone = readBytes(metaImage<float>("MET_FLOAT", body(), "WhiteLevel = 50\n", -150.0));
    EXPECT_EQ(whiteAlone.phases[0]->valueWindow(), (ValueWindow{0.0, 50.0})) << "files of older programs";
    NiftiFields fields;
    fields.datatype = 16;
    fields.bitpix = 32;
    fields.calMin = -20;
    fields.calMax = -2;
    std::vector<float> counted;
    for (int i = 0; i < 24; ++i) counted.push_back(static_cast<float>(-i - 1));
    const auto nifti = readFields(fields, bytesFrom(counted));
    ASSERT_TRUE(nifti) << nifti.error().sentence();
    EXPECT_EQ(nifti->phases[0]->valueWindow(), (ValueWindow{-20.0, -2.0}));
    EXPECT_EQ(sourceOf(*nifti, "black level"), "cal_min, cal_max: from -20 to -2");
    fields.calMin = -1e6;
    const auto wide = readFields(fields, bytesFrom(counted));
    EXPECT_EQ(wide->phases[0]->blackValue(), -24.0) << "the picture would be white";
    NiftiFields line;
    line.slope = 0.5;
    line.inter = -200;
    const auto bytes = readFields(line);
    EXPECT_EQ(bytes->phases[0]->valueWindow(), (ValueWindow{-200.0, -72.5})) << "the line of 8 bits";
}

/// Writes a study, reads it again, and expects the same values and window.
void expectRoundTrip(const Study& study, const std::string& name) {
    const TemporaryFolder folder;
    const bool isNifti = name.find(".nii") != std::string::npos;
    const auto written =
        isNifti ? writeNifti(folder.file(name), study.phases) : writeMetaImage(folder.file(name), study.phases);
    ASSERT_TRUE(written) << written.error().sentence();
    const auto again = readStudy(folder.file(name), withoutGuess());
    ASSERT_TRUE(again) << again.error().sentence();
    const Volume &one = *study.phases[0], &other = *again->phases[0];
    const double white = one.whiteValue(), width = white / 2 - one.blackValue() / 2;
    EXPECT_NEAR(other.whiteValue() / width, white / width, 1e-5) << name;
    EXPECT_NEAR(other.blackValue() / width, one.blackValue() / width, 1e-5) << name;
    for (std::int64_t i = 0; i < one.geometry().voxelCount(); i += 7)
        ASSERT_NEAR(other.fileValue(i) / width, one.fileValue(i) / width, 1e-6) << name << " " << i;
}

TEST(ValueWindow, WritersWriteTheFilesOwnValues) {
    std::vector<Study> studies{readBytes(metaImage<std::int16_t>("MET_SHORT", body(), "", -1018.0), withoutGuess()),
                               readBytes(metaImage<std::int8_t>("MET_CHAR", body(), "", -128.0), withoutGuess()),
                               readBytes(metaImage<float>("MET_FLOAT", body(), "", -60.0, 0.3), withoutGuess()),
                               readBytes(metaImage<double>("MET_DOUBLE", body(), "", 1e6, 1.0 / 256), withoutGuess()),
                               readBytes(metaImage<double>("MET_DOUBLE", body(), "", 0.0, 1e300), withoutGuess()),
                               readBytes(metaImage<double>("MET_DOUBLE", body(), "", 0.0, 1e-300), withoutGuess()),
                               readBytes(metaImage<double>("MET_DOUBLE", body(), "", -1e306, 1e304), withoutGuess())};
    for (const Study& study : studies)
        for (const char* name : {"v.mha", "v.nii", "v.nii.gz"}) expectRoundTrip(study, name);
    const TemporaryFolder folder;
    ASSERT_TRUE(writeMetaImage(folder.file("v.mha"), studies[0].phases, MetaImageVoxels::plain));
    const std::string bytes = contentsOf(folder.file("v.mha"));
    EXPECT_THAT(bytes, testing::HasSubstr("BlackLevel = -1018\nWhiteLevel = -818\nElementType = MET_INT\n"));
    const Study far = readBytes(metaImage<std::int32_t>("MET_INT", body(), "", 1e6), withoutGuess());
    for (const auto& [study, where] :
         {std::pair<const Study*, const char*>{&studies[0], "below 0"}, {&far, "far above 0"}}) {
        const auto refused = writeEnhancedUs(folder.file("v.dcm"), study->phases, EnhancedUsDetails{});
        ASSERT_FALSE(refused);
        EXPECT_THAT(refused.error().sentence(), testing::HasSubstr(std::string("values that begin ") + where));
    }
}

}  // namespace
}  // namespace echolucent
