#include "io/dicom/pixels/jpeg2000.h"

#include <openjpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace echolucent {

namespace {

struct Memory {
    std::span<const std::uint8_t> data;
    std::size_t position = 0;
};

OPJ_SIZE_T readMemory(void* buffer, OPJ_SIZE_T count, void* user) {
    auto& memory = *static_cast<Memory*>(user);
    const std::size_t rest = memory.data.size() - memory.position;
    if (rest == 0) return static_cast<OPJ_SIZE_T>(-1);
    const std::size_t taken = std::min<std::size_t>(count, rest);
    std::memcpy(buffer, memory.data.data() + memory.position, taken);
    memory.position += taken;
    return taken;
}

OPJ_OFF_T skipMemory(OPJ_OFF_T count, void* user) {
    auto& memory = *static_cast<Memory*>(user);
    if (count < 0) return -1;
    const std::size_t taken =
        std::min<std::size_t>(static_cast<std::size_t>(count), memory.data.size() - memory.position);
    memory.position += taken;
    return static_cast<OPJ_OFF_T>(taken);
}

OPJ_BOOL seekMemory(OPJ_OFF_T position, void* user) {
    auto& memory = *static_cast<Memory*>(user);
    if (position < 0 || static_cast<std::size_t>(position) > memory.data.size()) return OPJ_FALSE;
    memory.position = static_cast<std::size_t>(position);
    return OPJ_TRUE;
}

using Stream = std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)>;
using Codec = std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)>;
using Image = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;

/// The decoded image, halved in size `halvings` times; null if a part of it is missing or damaged.
Image decoded(std::span<const std::uint8_t> data, bool isJp2, unsigned halvings) {
    Memory memory{data};
    const Stream stream(opj_stream_create(std::size_t{1} << 16, OPJ_TRUE), &opj_stream_destroy);
    const Codec codec(opj_create_decompress(isJp2 ? OPJ_CODEC_JP2 : OPJ_CODEC_J2K), &opj_destroy_codec);
    Image image(nullptr, &opj_image_destroy);
    if (!stream || !codec) return image;
    opj_stream_set_user_data(stream.get(), &memory, nullptr);
    opj_stream_set_user_data_length(stream.get(), data.size());
    opj_stream_set_read_function(stream.get(), &readMemory);
    opj_stream_set_skip_function(stream.get(), &skipMemory);
    opj_stream_set_seek_function(stream.get(), &seekMemory);
    opj_dparameters_t parameters;
    opj_set_default_decoder_parameters(&parameters);
    parameters.cp_reduce = halvings;
    opj_setup_decoder(codec.get(), &parameters);
    opj_image_t* header = nullptr;
    const bool read = opj_read_header(stream.get(), codec.get(), &header) == OPJ_TRUE;
    image.reset(header);
    if (!read || !image || opj_decode(codec.get(), stream.get(), image.get()) != OPJ_TRUE) image.reset();
    return image;
}

}  // namespace

std::string decodeJpeg2000(std::span<const std::uint8_t> data, const Jpeg2000Frame& expected,
                           Jpeg2000Samples& samples) {
    const auto sealed = sealCodestream(data, expected);
    if (!sealed) return sealed.error();
    samples.isSigned = sealed->isSigned;
    samples.bits = sealed->bits;
    // The sealed codestream shows missing packets; only its smallest image is decoded. The codestream as it is shows
    // data missing within a packet.
    const bool allPackets = decoded(sealed->bytes, sealed->isJp2, sealed->levels) != nullptr;
    const Image image = allPackets ? decoded(data, sealed->isJp2, 0) : Image(nullptr, &opj_image_destroy);
    if (!image || image->numcomps != expected.samples)
        return "has a JPEG 2000 frame of which a part is missing or damaged";

    const std::size_t pixels = std::size_t{expected.columns} * expected.rows;
    samples.colours = {};
    if (sealed->transformsColours)
        samples.colours = {StreamColours::Kind::rgb, "its component transform"};
    else if (expected.samples == 3 && image->color_space == OPJ_CLRSPC_SYCC)
        samples.colours = {StreamColours::Kind::lumaFirst, "the colour space of its .jp2"};
    samples.values.clear();
    for (std::uint32_t plane = 0; plane < expected.samples; ++plane) {
        const opj_image_comp_t& component = image->comps[plane];
        if (component.data == nullptr || component.w != expected.columns || component.h != expected.rows)
            return "has a JPEG 2000 frame with subsampled or missing planes";
        samples.values.insert(samples.values.end(), component.data, component.data + pixels);
    }
    return {};
}

}  // namespace echolucent
