// Voxels that lie in shared memory from the beginning reach the workstation without a copy.
#include "io/restricted/shared_voxel_memory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "io/restricted/shared_study.h"
#include "io/voxels/voxel_bytes.h"

namespace echolucent::restricted {
namespace {

class SharedVoxels : public testing::Test {
protected:
    SharedVoxels() { setVoxelMemory(m_memory); }
    ~SharedVoxels() override { setVoxelMemory(m_before); }
    SharedVoxelMemory& memory() { return m_memory; }
    static std::uint8_t* taken(SharedVoxelMemory& memory, std::size_t bytes) {
        return static_cast<std::uint8_t*>(memory.allocate(bytes));
    }

private:
    std::pmr::memory_resource& m_before = voxelMemory();
    SharedVoxelMemory m_memory;
};

TEST_F(SharedVoxels, PiecesBeginAtPagesAndAreZero) {
    for (const std::size_t bytes : {std::size_t{1}, std::size_t{5000}, std::size_t{5} << 20}) {
        std::uint8_t* const piece = taken(memory(), bytes);
        EXPECT_TRUE(std::all_of(piece, piece + bytes, [](std::uint8_t byte) { return byte == 0; })) << bytes;
        const auto offset = memory().offsetOf(piece);
        ASSERT_TRUE(offset);
        EXPECT_EQ(*offset % sharedPageBytes, 0U);
        EXPECT_EQ(memory().offsetOf(piece + bytes - 1), *offset + bytes - 1);
        std::memset(piece, 9, bytes);
    }
    const std::uint8_t elsewhere = 0;
    EXPECT_FALSE(memory().offsetOf(&elsewhere));
}

TEST_F(SharedVoxels, WhatIsGivenBackIsNoLongerThere) {
    std::uint8_t* const first = taken(memory(), 100);
    std::memset(first, 9, 100);
    memory().deallocate(first, 100);
    EXPECT_FALSE(memory().offsetOf(first));
    std::uint8_t* const second = taken(memory(), 100);
    EXPECT_EQ(second[0], 0);
    EXPECT_EQ(memory().offsetOf(second), sharedPageBytes);
}

/// Two phases with one mask, in the memory that voxels are taken from.
Study studyOfTwo() {
    Study study;
    study.name = "two";
    VolumeGeometry geometry;
    geometry.size = {40, 30, 20};
    VoxelBytes marks(24000, 1);
    marks[7] = 0;
    const auto mask = std::make_shared<const DataMask>(voxelsIn<std::uint8_t>(std::move(marks)));
    for (const std::uint8_t phase : {3, 5}) {
        VoxelBytes bytes(48000, phase);
        study.phases.push_back(std::make_shared<const Volume>(
            Volume(geometry, voxelsIn<std::uint16_t>(std::move(bytes)), 2000.0).withDataMask(mask)));
    }
    return study;
}

TEST_F(SharedVoxels, AStudyIsSharedWhereItLies) {
    Study study = studyOfTwo();
    const std::uint64_t before = memory().size();
    const auto shared = shareStudy(std::move(study), memory());
    ASSERT_TRUE(shared);
    EXPECT_EQ(memory().size(), before) << "nothing was copied";
    const auto taken =
        takeStudy({reinterpret_cast<const std::uint8_t*>(shared->bytes.data()), shared->bytes.size()}, shared->voxels);
    ASSERT_TRUE(taken);
    ASSERT_EQ(taken->phases.size(), 2U);
    EXPECT_EQ(taken->phases[0]->storedValue(11), 3 * 257);
    EXPECT_EQ(taken->phases[1]->storedValue(23999), 5 * 257);
    EXPECT_FALSE(taken->phases[1]->hasData(7));
    EXPECT_TRUE(taken->phases[1]->hasData(8));
    EXPECT_EQ(taken->phases[0]->dataMask().data(), taken->phases[1]->dataMask().data()) << "one mask for both";
}

TEST_F(SharedVoxels, WhatLiesElsewhereIsCopied) {
    Study study = studyOfTwo();
    const Volume own(study.phases.front()->geometry(), std::vector<float>(24000, 0.5F), 1.0);
    study.phases = {std::make_shared<const Volume>(own)};
    const auto shared = shareStudy(std::move(study), memory());
    ASSERT_TRUE(shared);
    const auto taken =
        takeStudy({reinterpret_cast<const std::uint8_t*>(shared->bytes.data()), shared->bytes.size()}, shared->voxels);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->phases.front()->storedValue(23999), 0.5);
}

TEST_F(SharedVoxels, WhoeverStillHoldsTheVoxelsMakesThemUntaken) {
    Study study = studyOfTwo();
    const auto held = study.phases.front();  // it could write to them
    const auto shared = shareStudy(std::move(study), memory());
    ASSERT_TRUE(shared);
    EXPECT_FALSE(
        takeStudy({reinterpret_cast<const std::uint8_t*>(shared->bytes.data()), shared->bytes.size()}, shared->voxels));
}

TEST_F(SharedVoxels, PagesThatAReaderLeftOutAreNotMadeForIt) {
    const auto shared = shareStudy(studyOfTwo(), memory());
    ASSERT_TRUE(shared);
    struct stat status {};
    ASSERT_EQ(fstat(shared->voxels.number(), &status), 0);
    // This memory is as large as the voxels and has no page of them; pages behind its end make up for them in the
    // count.
    const Descriptor sparse = sharedMemory(static_cast<std::uint64_t>(status.st_size));
    ASSERT_EQ(fallocate(sparse.number(), FALLOC_FL_KEEP_SIZE, status.st_size, status.st_size), 0);
    const auto pages = [&] {
        EXPECT_EQ(fstat(sparse.number(), &status), 0);
        return status.st_blocks;
    };
    const auto before = pages();
    const auto taken =
        takeStudy({reinterpret_cast<const std::uint8_t*>(shared->bytes.data()), shared->bytes.size()}, sparse);
    ASSERT_TRUE(taken);
    EXPECT_EQ(pages(), before);
    EXPECT_EQ(taken->phases[1]->storedValue(23999), 0.0);
    EXPECT_GT(pages(), before) << "a voxel that is read has its page";
}

TEST_F(SharedVoxels, BytesMoveWithoutACopy) {
    VoxelBytes bytes(1000, 4);
    const std::uint8_t* const place = bytes.data();
    VoxelBytes moved;
    moved = std::move(bytes);
    EXPECT_EQ(moved.data(), place);
    const VoxelArray<float> values = voxelsIn<float>(std::move(moved));
    EXPECT_EQ(reinterpret_cast<const std::uint8_t*>(values.data()), place);
    EXPECT_EQ(values.size(), 250U);
}

}  // namespace
}  // namespace echolucent::restricted
