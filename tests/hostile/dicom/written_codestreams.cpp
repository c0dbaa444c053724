#include "written_codestreams.h"

#include <utility>

#include "temporary_folder.h"

namespace echolucent {

std::string writtenCodestream(const std::string& syntax, int bits) {
    std::vector<std::uint8_t> pixels;
    std::uint32_t noise = 1;
    for (int i = 0; i < pictureEdge * pictureEdge; ++i) {
        noise = noise * 1664525U + 1013904223U;
        pixels.push_back(static_cast<std::uint8_t>(i < 256 ? i : noise >> 25U));
    }
    if (syntax == jpeg2000Syntax)
        return codedJpeg2000(
            {.columns = pictureEdge, .rows = pictureEdge, .planes = {std::vector<int>(pixels.begin(), pixels.end())}});
    TestImage image;
    image.columns = image.rows = pictureEdge;
    image.bitsAllocated = bits > 8 ? 16 : 8;
    image.bitsStored = bits;
    if (bits > 8)
        for (const std::uint8_t pixel : pixels)
            image.pixels16.push_back(static_cast<std::uint16_t>(pixel << (bits - 8)));
    else
        image.pixels8 = pixels;
    return codedFrame(image, syntax == jpegLsSyntax ? TestSyntax::jpegLs
                             : syntax == rleSyntax  ? TestSyntax::rle
                             : syntax == jpegSyntax ? TestSyntax::jpegBaseline
                                                    : TestSyntax::jpegLossless);
}

DicomBytes describedCine(const CineShape& shape) {
    DicomBytes file;
    file.word(0x0028, 0x0002, 1).text(0x0028, 0x0004, "CS", "MONOCHROME2");
    file.text(0x0028, 0x0008, "IS", std::to_string(shape.frames));
    file.word(0x0028, 0x0010, shape.rows).word(0x0028, 0x0011, shape.columns);
    file.word(0x0028, 0x0100, shape.bitsAllocated).word(0x0028, 0x0101, shape.bitsStored);
    file.word(0x0028, 0x0102, static_cast<std::uint16_t>(shape.bitsStored - 1)).word(0x0028, 0x0103, shape.sign);
    return file;
}

HostileFile asSlices(HostileFile row) {
    row.options.framesAsSlices = true;
    row.options.guessNoData = false;
    return row;
}

HostileFile hostileCine(const std::string& name, const std::string& syntax, const std::vector<std::string>& fragments,
                        std::vector<std::string> words, CineShape shape, HostileOutcome outcome,
                        const std::string& offsetTable) {
    DicomBytes file = describedCine(shape);
    file.fragments(offsetTable, fragments);
    return asSlices(
        hostileFile("dicom-pixels/" + name, "a.dcm", file.file(cineClass, syntax), std::move(words), outcome));
}

HostileFile hostileNativeCine(const std::string& name, const std::string& pixels, std::vector<std::string> words,
                              CineShape shape, HostileOutcome outcome) {
    DicomBytes file = describedCine(shape);
    file.put(0x7fe0, 0x0010, shape.bitsAllocated > 8 ? "OW" : "OB", pixels);
    return asSlices(hostileFile("dicom-pixels/" + name, "a.dcm", file.file(cineClass), std::move(words), outcome));
}

}  // namespace echolucent
