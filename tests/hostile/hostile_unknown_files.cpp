// Files of no format that is known, and layouts that are kept beside raw files and do not describe them.
#include "hostile_file.h"

namespace echolucent {

namespace {

/// Four bytes with a layout beside them.
HostileFile layout(const std::string& name, const std::string& json, std::vector<std::string> words) {
    HostileFile row = hostileFile("raw-layout/" + name, "v.raw", "abcd", std::move(words));
    row.write = [json](const std::filesystem::path& folder) {
        writeBytes(folder / "v.raw", "abcd");
        writeBytes(folder / "v.raw.echolucent.json", json);
    };
    return row;
}

}  // namespace

std::vector<HostileFile> hostileUnknownFiles() {
    const std::string begin = R"({"format": "echolucent-raw-layout", "version": 1, )";
    return {
        hostileFile("unknown/a-word", "file.bin", "whatever",
                    {"is no MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz) file", "--raw-size"}),
        hostileFile("unknown/empty", "file.bin", "", {"is empty"}),
        hostileFile("unknown/a-zip-archive", "file.bin", "PK\x03\x04 and more", {"is a ZIP archive"}),
        layout("words", "nonsense", {"v.raw.echolucent.json: is not JSON: it breaks in line 1"}),
        layout("a-list", "[]", {"must be a JSON object"}),
        layout("version-2", R"({"format": "echolucent-raw-layout", "version": 2, "size": [2, 2, 1]})",
               {"version must be 1, not 2"}),
        layout("a-size-of-two-numbers", begin + R"("size": [2, 2]})", {"size must be a list of three"}),
        layout("a-size-of-text", begin + R"("size": "2x2"})", {"size must be a list of three"}),
        layout("a-size-that-is-no-whole-number", begin + R"("size": [2, 2, 1.5]})",
               {"size must be three whole numbers"}),
        layout("header-bytes-that-are-no-whole-number", begin + R"("size": [2, 2, 1], "header_bytes": 1.7})",
               {"header_bytes must be a whole number"}),
        layout("a-type-that-is-a-number", begin + R"("size": [2, 2, 1], "type": 8})", {"type must be a text"}),
        layout("a-byte-order-that-is-none", begin + R"("size": [2, 2, 1], "byte_order": "middle"})", {"byte_order"}),
        layout("a-spacing-of-two-numbers", begin + R"("size": [2, 2, 1], "spacing_mm": [1, 2]})", {"spacing_mm"}),
    };
}

}  // namespace echolucent
