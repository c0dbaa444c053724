// Files of no format that is known, and layouts that are kept beside raw files and do not describe them.
#include <string>

#include "hostile_file.h"
#include "zlib_bytes.h"

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

constexpr int gzipWindow = 31;  // zlib then writes a gzip file

/// A tar archive of one empty file of an old program, which wrote no signature. The header's sum is wrong by `wrong`.
std::string tarOf(const std::string& name, unsigned wrong = 0) {
    std::string header(512, '\0');
    header.replace(0, name.size(), name);
    header.replace(100, 8, "0000644 ").replace(124, 12, "00000000000 ").replace(136, 12, "14725360000 ");
    header.replace(148, 8, "        ");
    unsigned sum = wrong;
    for (const char each : header) sum += static_cast<unsigned char>(each);
    std::string octal;
    for (; sum > 0; sum /= 8) octal.insert(octal.begin(), static_cast<char>('0' + sum % 8));
    header.replace(148, 6, std::string(6 - octal.size(), '0') + octal);
    header[154] = '\0';
    return header + std::string(1024, '\0');
}

}  // namespace

std::vector<HostileFile> hostileUnknownFiles() {
    const std::string begin = R"({"format": "echolucent-raw-layout", "version": 1, )";
    return {
        hostileFile("unknown/a-word", "file.bin", "whatever",
                    {"is no MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz) file", "--raw-size"}),
        hostileFile("unknown/empty", "file.bin", "", {"is empty"}),
        hostileFile("unknown/a-zip-archive", "file.bin", "PK\x03\x04 and more", {"is a ZIP archive"}),
        hostileFile("unknown/an-empty-zip-archive", "file.nii", "PK\x05\x06" + std::string(18, '\0'),
                    {"is a ZIP archive"}),
        hostileFile("unknown/a-7z-archive", "file.dcm", "7z\xbc\xaf\x27\x1c and more", {"is a 7z archive"}),
        hostileFile("unknown/a-rar-archive", "file.vol", "Rar!\x1a\x07\x01", {"is a RAR archive"}),
        hostileFile("unknown/a-tar-archive", "slices.nrrd", tarOf("slices/1.dcm"), {"is a tar archive. Unpack it"}),
        hostileFile("unknown/a-packed-tar-archive", "slices.tar.gz", deflated(tarOf("1.dcm"), gzipWindow),
                    {"is a tar archive"}),
        hostileFile("unknown/a-tar-archive-with-a-wrong-sum", "file.bin", tarOf("1.dcm", 1), {"is no MetaImage"}),
        hostileFile("unknown/xz", "file.mha.xz",
                    std::string("\xfd"
                                "7zXZ\0 and more",
                                14),
                    {"is compressed with xz"}),
        hostileFile("unknown/bzip2", "file.mha.bz2", "BZh91AY&SY and more", {"is compressed with bzip2"}),
        hostileFile("unknown/a-word-that-begins-like-bzip2", "file.bin", "BZh9 is a word", {"is no MetaImage"}),
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
