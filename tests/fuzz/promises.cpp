#include "promises.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "fuzz_target.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

constexpr std::size_t longestSentence = 1500;

void require(bool kept, const std::string& promise) {
    if (!kept) throw BrokenPromise(promise);
}

bool isOneLine(std::string_view words) {
    return std::ranges::none_of(words, [](char letter) {
        const auto code = static_cast<unsigned char>(letter);
        return code < 0x20 || code == 0x7f;
    });
}

bool isFinite(const Vec3& vector) {
    return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

void requireSoundGeometry(const VolumeGeometry& geometry) {
    for (const std::int64_t size : geometry.size) require(size >= 1, "a size is at least 1");
    for (int axis = 0; axis < 3; ++axis) {
        require(std::isfinite(geometry.spacing[axis]) && geometry.spacing[axis] > 0, "a spacing is finite and above 0");
        const Vec3 direction(geometry.direction(0, axis), geometry.direction(1, axis), geometry.direction(2, axis));
        require(isFinite(direction) && std::abs(length(direction) - 1) < 1e-6, "a direction is a unit vector");
    }
    require(cv::determinant(geometry.direction) > 0, "a grid is right-handed");
    require(isFinite(geometry.origin), "an origin is finite");
}

void requireSoundPhase(const Volume& volume, const Volume& first) {
    const VolumeGeometry& geometry = volume.geometry();
    requireSoundGeometry(geometry);
    const auto count = static_cast<std::size_t>(geometry.voxelCount());
    const std::size_t held = std::visit([](const auto& voxels) { return voxels.size(); }, volume.voxels());
    require(held == count, "a volume holds as many voxels as its size says");
    require(volume.dataMask().empty() || volume.dataMask().size() == count, "a mask has a byte a voxel");
    require(geometry.size == first.geometry().size, "all phases have one size");
    require(volume.voxels().index() == first.voxels().index(), "all phases have one type");
    require(isSensibleWhite(volume.whiteLevel()), "a white level is above 0, and float32 holds it");
    require(std::isfinite(volume.blackValue()) && std::isfinite(volume.whiteValue()), "black and white are finite");
    require(volume.blackValue() < volume.whiteValue(), "black lies below white");
    require(volume.valueScale() == first.valueScale(), "all phases have one scale");
}

}  // namespace

void requireSoundStudy(const Study& study) {
    require(!study.phases.empty(), "a study has a phase");
    for (const auto& phase : study.phases) requireSoundPhase(*phase, *study.phases.front());
    require(!study.files.empty(), "a study names its files");
    require(areTimesOf(study.phaseTimes, study.phases.size()), "times of phases rise and are finite");
    for (const ImportFact& fact : study.facts) {
        require(!fact.name.empty() && !fact.value.empty() && !fact.source.empty(),
                "a fact has a name, a value and a source: " + fact.name);
        require(isOneLine(fact.name) && isOneLine(fact.value) && isOneLine(fact.source),
                "a fact is one line: " + fact.name);
    }
    for (const std::string& warning : study.warnings) {
        require(!warning.empty() && isOneLine(warning), "a warning is one line: " + warning);
        require(warning.size() <= longestSentence, "a warning is short: " + warning);
    }
}

void requireSoundRefusal(const Failure& failure) {
    const std::string sentence = failure.sentence();
    require(!failure.problem.empty(), "a refusal says what is wrong: " + sentence);
    require(!failure.remedy.empty(), "a refusal says what to do: " + sentence);
    require(isOneLine(sentence), "a refusal is one line: " + sentence);
    require(sentence.size() <= longestSentence, "a refusal is short: " + sentence);
}

void requireSoundReading(const std::string& path, const ReadOptions& options) {
    const auto study = readStudy(path, options);
    if (study) return requireSoundStudy(*study);
    requireSoundRefusal(study.error());
    if (!study.error().framesCouldBeSlices || options.framesAsSlices) return;
    ReadOptions asSlices = options;
    asSlices.framesAsSlices = true;
    requireSoundReading(path, asSlices);
}

}  // namespace echolucent
