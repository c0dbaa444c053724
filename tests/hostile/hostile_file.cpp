#include "hostile_file.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "tests/inputs.h"

namespace echolucent {

void writeBytes(const std::filesystem::path& path, std::string_view bytes) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream stream(path, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream.flush()) throw std::runtime_error("a hostile file could not be written: " + path.string());
}

HostileFile hostileFile(std::string name, std::string file, std::string bytes, std::vector<std::string> words,
                        HostileOutcome outcome) {
    HostileFile row;
    row.name = std::move(name);
    row.opened = file;
    row.write = [file = std::move(file), bytes = std::move(bytes)](const std::filesystem::path& folder) {
        writeBytes(folder / file, bytes);
    };
    row.outcome = outcome;
    row.words = std::move(words);
    return row;
}

namespace {

std::vector<HostileFile> allRows() {
    std::vector<HostileFile> all;
    for (const auto rows : {hostileTextHeaders,
                            hostileNifti,
                            hostileKretz,
                            hostileCompression,
                            hostileDicomStructure,
                            hostileDicomValues,
                            hostileDicomContradictions,
                            hostileDicomCuts,
                            hostileDicomPixels,
                            hostileDicomCodecs,
                            hostileDicomSeries,
                            hostileDicomFolders,
                            hostileDicomParts,
                            hostileMalformedMetaImage,
                            hostileMalformedNrrd,
                            hostileMalformedNifti,
                            hostileMalformedKretz,
                            hostileMalformedDicom,
                            hostileDataFiles,
                            hostileUnknownFiles,
                            hostileEnhancedUs,
                            hostileFoundByFuzzing}) {
        std::vector<HostileFile> topic = rows();
        all.insert(all.end(), std::make_move_iterator(topic.begin()), std::make_move_iterator(topic.end()));
    }
    return all;
}

}  // namespace

const std::vector<HostileFile>& hostileFiles() {
    static const std::vector<HostileFile> rows = allRows();
    return rows;
}

std::vector<HostileFile> sampleOf(const std::vector<HostileFile>& rows) {
    std::vector<HostileFile> sample;
    for (std::size_t i = 0; i < rows.size(); i += takesSomeInputs ? 64 : 16) sample.push_back(rows[i]);
    return sample;
}

}  // namespace echolucent
