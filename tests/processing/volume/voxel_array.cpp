// Voxels that never change, whoever keeps them.
#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "processing/volume/voxels.h"

namespace echolucent {
namespace {

TEST(VoxelArray, SharesWhatItHoldsAndKeepsItAlive) {
    auto owner = std::make_shared<std::vector<std::uint16_t>>(std::vector<std::uint16_t>{3, 1, 2});
    const std::weak_ptr<const void> alive = owner;
    auto array = std::make_unique<VoxelArray<std::uint16_t>>(owner, std::span<const std::uint16_t>(*owner));
    owner.reset();
    const VoxelArray<std::uint16_t> copy = *array;
    EXPECT_EQ(copy.data(), array->data());
    array.reset();
    EXPECT_FALSE(alive.expired());
    EXPECT_EQ(copy.toVector(), (std::vector<std::uint16_t>{3, 1, 2}));
}

TEST(VoxelArray, IsEqualWhereTheValuesAre) {
    const VoxelArray<float> one{1.0F, 2.0F}, same(std::vector<float>{1.0F, 2.0F}), other{1.0F, 3.0F}, longer{1, 2, 3};
    EXPECT_TRUE(one == same);
    EXPECT_FALSE(one == other);
    EXPECT_FALSE(one == longer);
    EXPECT_TRUE(VoxelArray<float>() == VoxelArray<float>(std::vector<float>()));
    EXPECT_TRUE(VoxelArray<float>().empty());
}

TEST(VoxelArray, TakesAVectorWithoutACopy) {
    std::vector<float> values{1.0F, 2.0F};
    const float* const place = values.data();
    const VoxelArray<float> array = std::move(values);
    EXPECT_EQ(array.data(), place);
    EXPECT_EQ(array.front() + array.back(), 3.0F);
}

}  // namespace
}  // namespace echolucent
