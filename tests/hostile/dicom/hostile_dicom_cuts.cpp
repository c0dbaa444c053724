// Good DICOM files of every way of writing, cut at twenty lengths: each is called incomplete, none "no image".
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <utility>

#include "dicom_bytes.h"
#include "dicom_files.h"
#include "enhanced_us_files.h"
#include "hostile_file.h"
#include "temporary_folder.h"

namespace echolucent {

namespace {

/// A good file, written into `folder`.
using Sample = std::function<void(const std::filesystem::path& path)>;

Sample written(TestSyntax syntax) {
    return [syntax](const std::filesystem::path& path) {
        TestImage image;
        image.frames = 3;
        image.columns = image.rows = 16;
        for (int i = 0; i < 3 * 256; ++i) image.pixels8.push_back(static_cast<std::uint8_t>(i * 37 % 251));
        image.pixelSpacing = {0.5, 0.5};
        image.spacingBetweenSlices = 0.5;
        writeDicom(path, image, syntax);
    };
}

void writeEnhanced(const std::filesystem::path& path) {
    const SharedPhases phases = simulatedPhases(obliqueGeometry(), 8, 2);
    const auto done = writeEnhancedUs(path, phases, {});
    if (!done) throw std::runtime_error(done.error().sentence());
}

void writeQlab(const std::filesystem::path& path) {
    DicomBytes file;
    file.text(0x0018, 0x602c, "DS", "0.05").text(0x0018, 0x602e, "DS", "0.05").picture(8, 8, 2);
    file.word(0x3001, 0x1001, 8).text(0x3001, 0x1003, "DS", "0.05");
    writeBytes(path, file.put(0x7fe0, 0x0010, "OW", std::string(1024, 'a')).file("1.2.840.113543.6.6.1.3.10002"));
}

/// Twenty rows for one good file, cut after n/20 of its bytes.
void addCuts(std::vector<HostileFile>& rows, const std::string& name, const Sample& sample, int mostTwentieths = 19) {
    for (int part = 1; part <= mostTwentieths; ++part) {
        HostileFile row = hostileFile(dicomStructureTopic + name + "-cut-to-" + std::to_string(5 * part) + "-percent",
                                      "a.dcm", "", {"ncomplete"});
        row.write = [sample, part](const std::filesystem::path& folder) {
            const std::filesystem::path whole = folder / "whole";
            sample(whole);
            const std::string bytes = contentsOf(whole);
            std::filesystem::remove(whole);
            const std::size_t kept = std::max<std::size_t>(140, bytes.size() * static_cast<std::size_t>(part) / 20);
            writeBytes(folder / "a.dcm", bytes.substr(0, kept));
        };
        rows.push_back(std::move(row));
    }
}

}  // namespace

std::vector<HostileFile> hostileDicomCuts() {
    std::vector<HostileFile> rows;
    addCuts(rows, "explicit", written(TestSyntax::explicitLittle));
    addCuts(rows, "implicit", written(TestSyntax::implicitLittle));
    addCuts(rows, "big-endian", written(TestSyntax::explicitBig));
    addCuts(rows, "deflated", written(TestSyntax::deflated));
    addCuts(rows, "rle", written(TestSyntax::rle));
    addCuts(rows, "jpeg", written(TestSyntax::jpegLossless));
    addCuts(rows, "enhanced", writeEnhanced);
    // QLAB files of one whole volume or more open, with a note.
    addCuts(rows, "qlab", writeQlab, 10);
    return rows;
}

}  // namespace echolucent
