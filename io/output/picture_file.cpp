#include "io/output/picture_file.h"

#include <png.h>

#include <stdexcept>

#include "io/output/atomic_file.h"

namespace echolucent {

std::string pngBytes(int width, int height, std::span<const std::uint8_t> rgb) {
    if (width < 1 || height < 1 || rgb.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)
        throw std::invalid_argument("pngBytes: the picture's bytes do not match its size");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(std::string("a picture could not be made a PNG: ") + image.message);
    bytes.resize(size);
    return bytes;
}

Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
    try {
        return writeFileAtomically(path, pngBytes(width, height, rgb));
    } catch (const std::runtime_error& error) {
        return fail(FailureKind::unwritable, path, "", error.what());
    }
}

}  // namespace echolucent
