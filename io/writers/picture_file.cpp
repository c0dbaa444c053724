#include "io/writers/picture_file.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

/// The palette may be null if the format has none.
std::string encoded(png_image& image, const void* pixels, const void* palette) {
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, palette) == 0)
        throw std::runtime_error(std::string("a picture could not be made a PNG: ") + image.message);
    bytes.resize(size);
    return bytes;
}

png_image imageOf(int width, int height, png_uint_32 format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = format;
    return image;
}

}  // namespace

std::string pngBytes(int width, int height, std::span<const std::uint8_t> rgb) {
    if (width < 1 || height < 1 || rgb.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)
        throw std::invalid_argument("pngBytes: the picture's bytes do not match its size");
    png_image image = imageOf(width, height, PNG_FORMAT_RGB);
    return encoded(image, rgb.data(), nullptr);
}

std::string palettePngBytes(int width, int height, std::span<const std::uint8_t> indices,
                            std::span<const std::uint8_t> palette) {
    constexpr std::size_t mostColours = 256;
    const std::size_t colours = palette.size() / 3;
    if (width < 1 || height < 1 ||
        indices.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) ||
        palette.size() % 3 != 0 || colours > mostColours ||
        *std::max_element(indices.begin(), indices.end()) >= colours)
        throw std::invalid_argument("palettePngBytes: the picture's bytes match neither its size nor its palette");
    png_image image = imageOf(width, height, PNG_FORMAT_RGB_COLORMAP);
    image.colormap_entries = static_cast<png_uint_32>(colours);
    return encoded(image, indices.data(), palette.data());
}

Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
    try {
        return writeFileAtomically(path, pngBytes(width, height, rgb));
    } catch (const std::runtime_error& error) {
        return fail(FailureKind::unwritable, path, "", error.what());
    }
}

}  // namespace echolucent
