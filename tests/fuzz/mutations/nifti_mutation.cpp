#include "tests/fuzz/mutations/nifti_mutation.h"

#include <array>
#include <cstring>
#include <span>

#include "tests/fuzz/mutations/byte_mutation.h"

namespace echolucent {

namespace {

/// Where a field stands, and what its numbers are.
struct Field {
    std::size_t offset, count, width;
    bool real;
};

constexpr std::array<Field, 21> firstVersion{
    {{0, 1, 4, false},   {40, 8, 2, false},  {56, 3, 4, true},  {68, 1, 2, false},  {70, 1, 2, false},
     {72, 1, 2, false},  {74, 1, 2, false},  {76, 8, 4, true},  {108, 1, 4, true},  {112, 2, 4, true},
     {120, 1, 2, false}, {122, 2, 1, false}, {124, 2, 4, true}, {132, 2, 4, true},  {148, 80, 1, false},
     {252, 1, 2, false}, {254, 1, 2, false}, {256, 6, 4, true}, {280, 12, 4, true}, {344, 4, 1, false},
     {348, 4, 1, false}}};
constexpr std::array<Field, 20> secondVersion{
    {{0, 1, 4, false},  {4, 8, 1, false},   {12, 1, 2, false},   {14, 1, 2, false},  {16, 8, 8, false},
     {80, 3, 8, true},  {104, 8, 8, true},  {168, 1, 8, false},  {176, 2, 8, true},  {192, 2, 8, true},
     {208, 2, 8, true}, {224, 2, 8, false}, {240, 80, 1, false}, {344, 1, 4, false}, {348, 1, 4, false},
     {352, 6, 8, true}, {400, 12, 8, true}, {500, 1, 4, false},  {504, 1, 4, false}, {540, 4, 1, false}}};

// The types that NIfTI knows, some that readers take and some that they refuse.
constexpr std::array<std::int16_t, 17> types{0,   1,   2,   4,   8,    16,   32,   64,  128,
                                             255, 256, 512, 768, 1024, 1280, 1536, 2304};
constexpr std::array<std::int16_t, 8> bits{1, 8, 16, 24, 32, 64, 128, 96};

std::int32_t headerBytes(const std::string& bytes, bool reversed) {
    std::int32_t value = 0;
    if (bytes.size() < sizeof value) return 0;
    std::string field = bytes.substr(0, sizeof value);
    if (reversed) field = std::string(field.rbegin(), field.rend());
    std::memcpy(&value, field.data(), sizeof value);
    return value;
}

void write(std::string& bytes, std::size_t offset, const std::string& value) {
    if (offset + value.size() <= bytes.size()) bytes.replace(offset, value.size(), value);
}

}  // namespace

std::string mutatedNifti(std::string bytes, std::uint64_t seed) {
    Dice dice(seed);
    const bool reversed = headerBytes(bytes, true) == 348 || headerBytes(bytes, true) == 540;
    const std::int32_t length = headerBytes(bytes, reversed);
    if (length != 348 && length != 540) return mutatedBytes(std::move(bytes), seed);
    const bool two = length == 540;
    const std::span<const Field> fields =
        two ? std::span<const Field>(secondVersion) : std::span<const Field>(firstVersion);
    const std::size_t changes = 1 + dice.below(4);
    for (std::size_t i = 0; i < changes; ++i) {
        const Field& field = fields[dice.below(fields.size())];
        const std::size_t place = field.offset + field.width * dice.below(field.count);
        switch (dice.below(10)) {
            case 0: bytes = withBytesChanged(std::move(bytes), dice); break;
            case 1: write(bytes, two ? 12 : 70, bytesOfValue(dice.oneOf(types), reversed)); break;
            case 2: write(bytes, two ? 14 : 72, bytesOfValue(dice.oneOf(bits), reversed)); break;
            case 3: {  // A small size is one that the file may hold.
                const auto size = static_cast<std::int16_t>(dice.below(6));
                const std::size_t axis = dice.below(8);
                two ? write(bytes, 16 + 8 * axis, bytesOfValue(std::int64_t{size}, reversed))
                    : write(bytes, 40 + 2 * axis, bytesOfValue(size, reversed));
                break;
            }
            default: write(bytes, place, extremeField(dice, field.width, field.real, reversed));
        }
    }
    return bytes;
}

}  // namespace echolucent
