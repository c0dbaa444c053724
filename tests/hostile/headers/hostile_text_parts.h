// MetaImage and NRRD files with one part of the header replaced.
#pragma once

#include <stdexcept>
#include <string>

namespace echolucent {

/// The voxels that these headers declare: 2 x 3 x 4 bytes.
inline const std::string textHeaderVoxels(24, 'v');

/// The text with one part replaced. Throws std::logic_error if it has no such part.
inline std::string withPart(std::string text, const std::string& replaced, const std::string& with) {
    const auto place = text.find(replaced);
    if (place == std::string::npos) throw std::logic_error("the row replaces nothing: " + replaced);
    return text.replace(place, replaced.size(), with);
}

/// A line 100000 times.
inline std::string repeatedLine(const std::string& line) {
    std::string all;
    for (int i = 0; i < 100000; ++i) all += line;
    return all;
}

/// A MetaImage with one part of its header replaced, and its data.
inline std::string mhaWith(const std::string& replaced, const std::string& with,
                           const std::string& data = textHeaderVoxels) {
    const std::string header =
        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
        "ElementDataFile = LOCAL\n";
    return withPart(header, replaced, with) + data;
}

/// The same as an NRRD.
inline std::string nrrdWith(const std::string& replaced, const std::string& with,
                            const std::string& data = textHeaderVoxels) {
    const std::string header = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n";
    return withPart(header, replaced, with) + "\n" + data;
}

}  // namespace echolucent
