// The tests read real files beside the source tree; they are skipped where these are not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/beam/beam_guess.h"
#include "shared_data.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

struct VolumeRow {
    const char* name;
    std::array<std::int64_t, 3> size;
    Vec3 spacing;
    const char* type;
    std::size_t phases = 1;
    bool spacingKnown = true;
};

class SharedVolumes : public testing::TestWithParam<VolumeRow> {};

TEST_P(SharedVolumes, LoadWithTheirSizeAndSpacing) {
    SKIP_WITHOUT_SHARED_DATA();
    const VolumeRow& row = GetParam();
    const auto study = readStudy(sharedData + "/volumes/" + row.name, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), row.phases);
    EXPECT_FALSE(study->phaseTimes.meanSeconds);
    for (const auto& phase : study->phases) {
        EXPECT_EQ(phase->geometry().size, row.size);
        EXPECT_LT(length(phase->geometry().spacing - row.spacing), 1e-9);
        EXPECT_EQ(phase->geometry().spacingKnown, row.spacingKnown);
        EXPECT_EQ(phase->typeName(), row.type);
    }
}

struct BeamRow {
    const char* name;
    std::optional<BeamAxis> beam;  ///< empty where it cannot be known
};

/// docs/beam.md says how the truth is known.
TEST(SharedVolumesBeam, IsFoundWhereItCanBeKnown) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const BeamRow& row :
         {BeamRow{"fetal_chest_600x614x66.nrrd", BeamAxis::plusY}, BeamRow{"fetal_chest_iso0.3mm.mha", BeamAxis::plusY},
          BeamRow{"fetal_heart_4d_128x128x128x20.nrrd", BeamAxis::plusZ},
          BeamRow{"adult_heart_256.nrrd", BeamAxis::plusZ},
          BeamRow{"adult_heart_4d_56x52x56x3_float.nrrd", BeamAxis::plusZ},
          BeamRow{"spine_phantom_freehand.mha", BeamAxis::plusZ}, BeamRow{"reconstruction_lnmax.mha", BeamAxis::plusZ},
          BeamRow{"prostate_trus.nrrd", std::nullopt}, BeamRow{"odd_nan.mha", std::nullopt}}) {
        const auto study = readStudy(sharedData + "/volumes/" + row.name);
        ASSERT_TRUE(study) << study.error().sentence();
        const auto guess = guessBeamAxis(*study->phases.front());
        EXPECT_EQ(guess->sure, row.beam.has_value()) << row.name << " " << guess->confidence;
        if (row.beam) {
            EXPECT_EQ(guess->axis, *row.beam) << row.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, SharedVolumes,
    testing::Values(
        VolumeRow{"fetal_chest_600x614x66.nrrd", {600, 614, 66}, {0.076036, 0.076036, 0.5}, "uint8"},
        VolumeRow{"fetal_chest_iso0.3mm.mha", {152, 156, 110}, {0.3, 0.3, 0.3}, "uint8"},
        VolumeRow{"fetal_heart_4d_128x128x128x20.nrrd", {128, 128, 128}, {2, 2, 2}, "uint8", 20},
        VolumeRow{"adult_heart_256.nrrd", {256, 256, 256}, {1, 1, 1}, "uint8"},
        VolumeRow{"adult_heart_4d_56x52x56x3_float.nrrd", {56, 52, 56}, {3.77657, 3.72161, 3.28731}, "float32", 3},
        // Its Kinds call the last axis a list.
        VolumeRow{"spine_phantom_freehand.mha", {147, 106, 104}, {0.5, 0.5, 0.5}, "uint8", 1, false},
        VolumeRow{"reconstruction_lnmax.mha", {147, 106, 105}, {0.5, 0.5, 0.5}, "uint8"},
        VolumeRow{"prostate_trus.nrrd", {44, 59, 41}, {0.4, 0.4, 0.4}, "uint8"},
        VolumeRow{"odd_nan.mha", {78, 110, 64}, {1, 1, 1}, "float32"}),
    [](const auto& row) {
        std::string name = row.param.name;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
        return name;
    });

TEST(SharedVolumesAll, NoFileIsLeftOut) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const auto& entry : std::filesystem::directory_iterator(sharedData + "/volumes"))
        EXPECT_TRUE(readStudy(entry.path().string(), withoutGuess())) << entry.path();
}

TEST(SharedVolumesAll, OutsideTheScanConeIsNoDataUnlessTheGuessIsOff) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto guessed = readStudy(sharedData + "/volumes/adult_heart_256.nrrd");
    ASSERT_TRUE(guessed);
    const Volume& volume = *guessed->phases[0];
    EXPECT_FALSE(volume.hasData(0));
    std::int64_t zerosWithData = 0;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i)
        zerosWithData += volume.hasData(i) && volume.storedValue(i) == 0 ? 1 : 0;
    EXPECT_GT(zerosWithData, 0) << "fluid inside the cone must stay data";
    EXPECT_TRUE(readStudy(sharedData + "/volumes/adult_heart_256.nrrd", withoutGuess())->phases[0]->dataMask().empty());
}

/// Voxels of all phases that hold a finite value other than 0 and are marked as no data.
std::int64_t echoesLost(const Study& study) {
    std::int64_t lost = 0;
    for (const auto& phase : study.phases) {
        const DataMask& mask = phase->dataMask();
        const auto count = [&](const auto& voxels) {
            for (std::size_t i = 0; i < mask.size(); ++i)
                lost += mask[i] == 0 && voxels[i] != 0 && std::isfinite(static_cast<double>(voxels[i])) ? 1 : 0;
        };
        std::visit(count, phase->voxels());
    }
    return lost;
}

TEST(SharedVolumesAll, NoEchoIsLostToTheGuess) {
    SKIP_WITHOUT_SHARED_DATA();
    std::vector<std::string> paths{sharedData + "/dicom/dcm4che_US-PAL-8-10x-echo.dcm",
                                   sharedData + "/dicom/godicom_I_000016.dcm",
                                   sharedData + "/dicom/orthanc_Issue16.dcm"};
    for (const auto& entry : std::filesystem::directory_iterator(sharedData + "/volumes"))
        paths.push_back(entry.path().string());
    ReadOptions options;
    options.framesAsSlices = true;
    for (const std::string& path : paths) {
        const auto study = readStudy(path, options);
        ASSERT_TRUE(study) << path;
        EXPECT_EQ(echoesLost(*study), 0) << path;
    }
}

/// Of these nothing but the outside is dark before tissue along +z: without the guess the outside is their fluid.
TEST(SharedVolumesAll, TheGuessTakesNoSurfacesAway) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name : {"spine_phantom_freehand.mha", "reconstruction_lnmax.mha"}) {
        const auto guessed = readStudy(sharedData + "/volumes/" + name);
        const auto whole = readStudy(sharedData + "/volumes/" + name, withoutGuess());
        ASSERT_TRUE(guessed && whole) << name;
        const auto found = adaptOpacity(*guessed->phases[0], {}, {});
        EXPECT_GT(found->tubesWithWeight, 10) << name;
        EXPECT_EQ(found->tubesWithWeight, adaptOpacity(*whole->phases[0], {}, {})->tubesWithWeight) << name;
    }
}

/// Its chambers are shorter than the default's least fluid.
TEST(SharedVolumesAll, TheCoarseHeartIsReadInHalvedLengths) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto study = readStudy(sharedData + "/volumes/adult_heart_4d_56x52x56x3_float.nrrd");
    ASSERT_TRUE(study);
    const auto found = adaptOpacity(*study->phases[0], {}, {});
    EXPECT_TRUE(found->lengthsHalved);
    EXPECT_FALSE(found->surfacesWhereDataBegin);
    EXPECT_GT(found->tubesWithWeight, 30);
}

TEST(SharedVolumesAll, NaNVoxelsAreNoData) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto study = readStudy(sharedData + "/volumes/odd_nan.mha", withoutGuess());
    ASSERT_TRUE(study);
    const Volume& volume = *study->phases[0];
    std::int64_t notFinite = 0;
    for (std::int64_t i = 0; i < volume.geometry().voxelCount(); ++i) {
        const bool finite = std::isfinite(volume.storedValue(i));
        notFinite += finite ? 0 : 1;
        ASSERT_EQ(volume.hasData(i), finite);
    }
    EXPECT_GT(notFinite, 0);
}

/// Every DICOM file is read, alone and as the only one of a folder, where a copy stands beside it, with frames taken as
/// slices: each gives a study or a sentence.
TEST(SharedDicom, EveryFileEndsInAStudyOrASentence) {
    SKIP_WITHOUT_SHARED_DATA();
    int studies = 0;
    for (const char* folder : {"/dicom", "/bad"})
        for (const auto& entry : std::filesystem::directory_iterator(sharedData + folder)) {
            const TemporaryFolder pair;
            for (const char* name : {"a.dcm", "b.dcm"}) std::filesystem::copy_file(entry.path(), pair.file(name));
            ReadOptions options = withoutGuess();
            options.framesAsSlices = true;
            for (const std::string& path : {entry.path().string(), pair.path()}) {
                const auto study = readStudy(path, options);
                studies += study ? 1 : 0;
                if (study) {
                    EXPECT_FALSE(study->phases.empty()) << path;
                } else {
                    EXPECT_FALSE(study.error().problem.empty()) << path;
                }
            }
        }
    EXPECT_GE(studies, 30);
}

TEST(SharedDicom, PublicCinesAreRefusedAsCines) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name : {"dcm4che_US-PAL-8-10x-echo.dcm", "godicom_I_000016.dcm", "orthanc_Issue16.dcm",
                             "pydicom_examples_ybr_color.dcm", "dicomParser_IM00001.implicit_little_endian.dcm"}) {
        const auto study = readStudy(sharedData + "/dicom/" + name);
        ASSERT_FALSE(study) << name;
        EXPECT_TRUE(study.error().framesCouldBeSlices) << name;
        EXPECT_THAT(study.error().sentence(), testing::HasSubstr("2D cine")) << name;
    }
}

/// The same pictures, stored by different makers' encoders, must give the same grey values.
TEST(SharedDicom, TransferSyntaxesOfTheSamePicturesAgree) {
    SKIP_WITHOUT_SHARED_DATA();
    ReadOptions options = withoutGuess();
    options.framesAsSlices = true;
    for (const auto& [one, other] :
         {std::pair{"dcm4che_US-PAL-8-10x-echo.dcm", "dcm4che_jpeg-ls-Palette.dcm"},
          std::pair{"pydicomdata_OBXXXX1A_expb_2frame.dcm", "pydicomdata_OBXXXX1A_rle_2frame.dcm"}}) {
        const auto a = readStudy(sharedData + "/dicom/" + one, options);
        const auto b = readStudy(sharedData + "/dicom/" + other, options);
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->phases[0]->voxels(), b->phases[0]->voxels()) << one;
    }
}

}  // namespace
}  // namespace echolucent
