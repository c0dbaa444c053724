// Writes, at build time, what a desktop must know of the program's files: the desktop entry, from a form, and the MIME
// types that the system's list lacks. Both come from the list of formats.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "io/file_formats.h"

namespace {

std::string mimeTypes() {
    std::string types;
    for (const echolucent::FileFormat& format : echolucent::fileFormats())
        if (!format.mimeType.empty()) types += std::string(format.mimeType) + ';';
    return types;
}

std::string mimeInfo() {
    std::string info =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<!-- Names for volume files that the system's own list of MIME types does not know. -->\n"
        "<mime-info xmlns=\"http://www.freedesktop.org/standards/shared-mime-info\">\n";
    for (const echolucent::FileFormat& format : echolucent::fileFormats()) {
        if (!format.definesMimeType) continue;
        info +=
            fmt::format("  <mime-type type=\"{}\">\n    <comment>{} volume</comment>\n", format.mimeType, format.name);
        if (!format.mimeMagic.empty())
            info +=
                fmt::format("    <magic priority=\"50\"><match type=\"string\" value=\"{}\" offset=\"0\"/></magic>\n",
                            format.mimeMagic);
        for (const std::string_view ending : format.endings)
            info += fmt::format("    <glob pattern=\"*{}\"/>\n", ending);
        info += "  </mime-type>\n";
    }
    return info + "</mime-info>\n";
}

/// Says on stderr if a file could not be written.
bool write(const char* path, const std::string& text) {
    std::ofstream file(path);
    file << text;
    if (file.flush()) return true;
    std::cerr << path << " could not be written.\n";
    return false;
}

}  // namespace

/// Usage: write_file_types FORM.desktop.in ENTRY.desktop MIME.xml
int main(int count, char** words) {
    if (count != 4) return EXIT_FAILURE;
    std::ifstream form(words[1]);
    std::string entry{std::istreambuf_iterator<char>(form), {}};
    constexpr std::string_view place = "@MIME_TYPES@";
    const auto at = entry.find(place);
    if (at == std::string::npos) {
        std::cerr << words[1] << " has no place for the MIME types.\n";
        return EXIT_FAILURE;
    }
    const bool written = write(words[2], entry.replace(at, place.size(), mimeTypes())) && write(words[3], mimeInfo());
    return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
