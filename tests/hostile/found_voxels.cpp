#include "found_voxels.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace echolucent {

namespace {

template <typename T>
void appendNumber(std::string& bytes, T number, bool bigEndian) {
    std::string raw(sizeof number, '\0');
    std::memcpy(raw.data(), &number, sizeof number);
    if (bigEndian) std::reverse(raw.begin(), raw.end());
    bytes += raw;
}

/// The numbers as bytes of type T; empty where one of them is none of T.
template <typename T>
std::string asType(const std::vector<double>& numbers, bool bigEndian) {
    std::string bytes;
    for (const double number : numbers) {
        if constexpr (std::numeric_limits<T>::is_integer)
            if (!(number >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                  number <= static_cast<double>(std::numeric_limits<T>::max()) && number == std::floor(number)))
                return {};
        appendNumber(bytes, static_cast<T>(number), bigEndian);
    }
    return bytes;
}

std::vector<double> numbersOf(const WrittenVoxels& voxels) {
    std::vector<double> numbers;
    const auto each = [&](auto zero) {
        for (std::size_t at = 0; at + sizeof zero <= voxels.bytes.size(); at += sizeof zero) {
            auto number = zero;
            std::memcpy(&number, voxels.bytes.data() + at, sizeof number);
            numbers.push_back(static_cast<double>(number));
        }
    };
    if (voxels.type == "MET_UCHAR")
        each(std::uint8_t{});
    else if (voxels.type == "MET_USHORT")
        each(std::uint16_t{});
    else if (voxels.type == "MET_DOUBLE")
        each(double{});
    else
        each(float{});
    return numbers;
}

bool stands(const std::string& bytes, const std::vector<std::string>& places) {
    return std::ranges::any_of(places,
                               [&](const std::string& place) { return place.find(bytes) != std::string::npos; });
}

/// All digits behind the empty line of an NRRD header, two a byte.
std::string fromHexadecimal(const std::string& file) {
    std::string bytes;
    int high = -1;
    for (const char letter : file.substr(std::min(file.find("\n\n"), file.size()))) {
        const int digit = letter >= '0' && letter <= '9'   ? letter - '0'
                          : letter >= 'a' && letter <= 'f' ? letter - 'a' + 10
                          : letter >= 'A' && letter <= 'F' ? letter - 'A' + 10
                                                           : -1;
        if (digit < 0) continue;
        if (high >= 0) bytes.push_back(static_cast<char>(high * 16 + digit));
        high = high >= 0 ? -1 : digit;
    }
    return bytes;
}

/// The numbers behind the empty line of an NRRD header, as bytes.
std::string fromDecimal(const std::string& file) {
    std::string text = file.substr(std::min(file.find("\n\n"), file.size()));
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream stream(text);
    std::string bytes, word;
    while (stream >> word) {
        const double value = std::atof(word.c_str());
        bytes.push_back(std::abs(value) < 1e9 ? static_cast<char>(static_cast<int>(value)) : '\0');
    }
    return bytes;
}

/// What the raw deflate stream behind a DICOM meta header holds, as far as it goes.
std::string inflatedDataSet(const std::string& file) {
    // Group 2 length is the first element behind the preamble.
    if (file.size() < 144) return {};
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + 140, sizeof length);
    if (length > file.size() - 144) return {};
    std::string packed = file.substr(144 + length), out(std::size_t{1} << 20, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -15) != Z_OK) return {};
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    inflate(&stream, Z_FINISH);
    out.resize(out.size() - stream.avail_out);
    inflateEnd(&stream);
    return out;
}

/// Pixel Data and what follows it.
std::string pixelElement(const std::string& file) {
    const auto at = file.rfind(std::string("\xe0\x7f\x10\0OB", 6));
    return at == std::string::npos ? std::string() : file.substr(at);
}

/// The numbers as each type of bytes that holds them.
std::vector<std::string> formsOf(const std::vector<double>& numbers) {
    std::vector<std::string> forms;
    for (const bool bigEndian : {false, true}) {
        forms.push_back(asType<std::uint8_t>(numbers, bigEndian));
        forms.push_back(asType<std::int8_t>(numbers, bigEndian));
        forms.push_back(asType<std::uint16_t>(numbers, bigEndian));
        forms.push_back(asType<std::int16_t>(numbers, bigEndian));
        forms.push_back(asType<std::uint32_t>(numbers, bigEndian));
        forms.push_back(asType<std::int32_t>(numbers, bigEndian));
        forms.push_back(asType<float>(numbers, bigEndian));
        forms.push_back(asType<double>(numbers, bigEndian));
    }
    std::erase(forms, std::string());
    return forms;
}

/// Whether each slice stands somewhere. A slice that holds nothing but 0 need not where some are missing, but one does.
bool eachSliceStands(const std::string& form, std::size_t slices, const std::vector<std::string>& places,
                     bool someAreMissing) {
    const std::size_t length = form.size() / slices;
    std::size_t missing = 0;
    for (std::size_t z = 0; z < slices; ++z) {
        const std::string slice = form.substr(z * length, length);
        const bool isEmpty = someAreMissing && slice.find_first_not_of('\0') == std::string::npos;
        if (!isEmpty && !stands(slice, places)) return false;
        missing += isEmpty ? 1 : 0;
    }
    return missing < slices;
}

}  // namespace

std::optional<WrittenVoxels> writtenVoxels(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    WrittenVoxels voxels;
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::string key, equals;
        words >> key >> equals;
        if (key == "DimSize") words >> voxels.size[0] >> voxels.size[1] >> voxels.size[2];
        if (key == "ElementType") words >> voxels.type;
        if (key != "ElementDataFile") continue;
        voxels.bytes.assign(std::istreambuf_iterator<char>(stream), {});
        return voxels;
    }
    return std::nullopt;
}

bool standIn(const WrittenVoxels& voxels, const std::vector<std::string>& places, bool someAreMissing) {
    const std::vector<double> all = numbersOf(voxels);
    std::vector<double> numbers = all;
    while (someAreMissing && !numbers.empty() && numbers.back() == 0) numbers.pop_back();
    if (numbers.empty()) return true;
    const auto slices = static_cast<std::size_t>(voxels.size[2]);
    return std::ranges::any_of(formsOf(numbers), [&](const std::string& form) { return stands(form, places); }) ||
           std::ranges::any_of(formsOf(all), [&](const std::string& form) {
               return eachSliceStands(form, slices, places, someAreMissing);
           });
}

std::vector<std::string> placesOfVoxels(const GoodFile& good, const std::vector<std::string>& changed) {
    std::vector<std::string> places = changed;
    switch (good.coding) {
        case VoxelCoding::plain: break;
        case VoxelCoding::checked: places.push_back(good.voxels); break;
        case VoxelCoding::hexadecimal: places.push_back(fromHexadecimal(changed.front())); break;
        case VoxelCoding::decimal: places.push_back(fromDecimal(changed.front())); break;
        case VoxelCoding::deflated: places.push_back(inflatedDataSet(changed.front())); break;
        case VoxelCoding::coded: {
            const std::string pixels = pixelElement(good.files.front().second);
            if (good.voxels.empty() || pixels.empty() || !changed.front().ends_with(pixels)) return {};
            places.push_back(good.voxels);
            break;
        }
        case VoxelCoding::converted: return {};
    }
    return places;
}

}  // namespace echolucent
