// A simulated scan on its way through formats: as Enhanced US Volume, read, as NIfTI, read again.
#include <gtest/gtest.h>

#include "io/writers/enhanced_us_writer.h"
#include "io/writers/nifti_writer.h"
#include "processing/phantom/phantom.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// Two phases of a moving scene on an oblique, anisotropic grid in a patient.
std::vector<std::shared_ptr<const Volume>> phasesOf(int bits) {
    std::vector<std::shared_ptr<const Volume>> phases;
    for (const double phase : {0.0, 0.25}) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {21, 19, 17};
        config.spacing = {0.4, 0.5, 0.9};
        config.bits = bits;
        config.phase = phase;
        const Volume made = *makePhantom(config);
        VolumeGeometry geometry = made.geometry();
        geometry.direction = rotationX(25) * rotationZ(-40);
        geometry.origin = {-31.5, 12.25, 100.125};
        geometry.patientFrameKnown = true;
        phases.push_back(std::make_shared<const Volume>(geometry, made.voxels(), made.whiteLevel()));
    }
    return phases;
}

TEST(FormatChain, KeepsEveryVoxelAndItsPlace) {
    const TemporaryFolder folder;
    for (const int bits : {8, 16}) {
        const auto phases = phasesOf(bits);
        EnhancedUsDetails details;
        details.phaseSeconds = 0.04;
        ASSERT_TRUE(writeEnhancedUs(folder.file("a.dcm"), phases, details));
        const auto dicom = readStudy(folder.file("a.dcm"), withoutGuess());
        ASSERT_TRUE(dicom) << dicom.error().sentence();
        ASSERT_TRUE(writeNifti(folder.file("a.nii.gz"), dicom->phases, dicom->phaseTimes.meanSeconds));
        const auto nifti = readStudy(folder.file("a.nii.gz"), withoutGuess());
        ASSERT_TRUE(nifti) << nifti.error().sentence();
        ASSERT_EQ(nifti->phases.size(), 2U);
        ASSERT_TRUE(nifti->phaseTimes.meanSeconds);
        EXPECT_NEAR(*nifti->phaseTimes.meanSeconds, 0.04, 1e-8);
        for (std::size_t phase = 0; phase < 2; ++phase) {
            const Volume& read = *nifti->phases[phase];
            EXPECT_EQ(read.voxels(), phases[phase]->voxels()) << bits << " bits";
            EXPECT_EQ(read.whiteLevel(), phases[phase]->whiteLevel());
            for (const Vec3& voxel : {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(0, 18, 0), Vec3(0, 0, 16)})
                EXPECT_LT(
                    length(read.geometry().patientFromVoxel(voxel) - phases[phase]->geometry().patientFromVoxel(voxel)),
                    1e-4);  // NIfTI-1 keeps places as float32
        }
    }
}

}  // namespace
}  // namespace echolucent
