// write_corpus TARGET FOLDER: writes the samples of a target, from which its fuzzing begins. Without arguments it lists
// the targets, each with the length of its longest inputs and its dictionary.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "fuzz_target.h"

int main(int count, char** arguments) {
    if (count != 3) {
        for (const echolucent::FuzzTarget* target : echolucent::fuzzTargets())
            std::cout << target->name << " " << target->longest << " " << target->dictionary << "\n";
        return count == 1 ? 0 : 2;
    }
    const std::filesystem::path folder = arguments[2];
    std::filesystem::create_directories(folder);
    for (const echolucent::FuzzSample& sample : echolucent::fuzzTargetNamed(arguments[1]).samples()) {
        const std::filesystem::path path = folder / ("sample-" + sample.name);
        std::ofstream stream(path, std::ios::binary);
        stream.write(sample.bytes.data(), static_cast<std::streamsize>(sample.bytes.size()));
        if (!stream.flush()) {
            std::cerr << "write_corpus: " << path.string() << " could not be written.\n";
            return 1;
        }
    }
    return 0;
}
