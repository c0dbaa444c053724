// Runs the real echolucent-cli.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {

struct Outcome {
    int status = -1;  ///< exit status; -1 if a signal ended the program
    std::string output;
    std::string errors;
};

/// A folder for one test, removed with it. A slash and a name give the path of a file in it.
class Folder : public TemporaryFolder {
public:
    [[nodiscard]] std::string operator/(const std::string& name) const { return file(name); }
};

inline void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Runs the program with arguments as a shell would take them.
inline Outcome runProgram(const std::string& arguments) {
    const Folder folder;
    const std::string command = std::string("\"" ECHOLUCENT_CLI "\" ") + arguments + " >\"" + folder / "out" +
                                "\" 2>\"" + folder / "err" + "\"";
    const int raw = std::system(command.c_str());
    return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, contentsOf(folder / "out"), contentsOf(folder / "err")};
}

/// A phantom file, made once for all tests of a run. It has 72 voxels an edge, and is anisotropic on request.
inline std::string phantomFile(const std::string& name, const std::string& options) {
    static const Folder folder;
    const std::string path = folder / name;
    if (!std::filesystem::exists(path)) {
        const Outcome made = runProgram("phantom \"" + path + "\" " + options);
        EXPECT_EQ(made.status, 0) << made.errors;
    }
    return path;
}
inline std::string shapesFile() { return phantomFile("shapes.mha", "--scene shapes --size 110x100x120 --seed 5"); }

/// An 8-bit MetaImage of one value.
inline void writeConstantVolume(const std::string& path, int edge, char value) {
    const std::string size = std::to_string(edge);
    write(path, "ObjectType = Image\nNDims = 3\nDimSize = " + size + " " + size + " " + size +
                    "\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                    std::string(static_cast<std::size_t>(edge) * edge * edge, value));
}

}  // namespace echolucent
