#include "tests/fuzz/samples/json_samples.h"

#include "io/document/curve_file.h"
#include "io/document/document_file.h"
#include "io/document/preset_file.h"
#include "io/document/session_file.h"
#include "io/study/study.h"
#include "tests/fuzz/samples/written_file.h"
#include "tests/io/document/unusual_document.h"

namespace echolucent {

namespace {

std::string layoutBytes(const RawLayout& layout) {
    return bytesOfWritten("v.raw.echolucent.json", [&](const std::string& path) {
        return rememberRawLayout(path.substr(0, path.size() - std::string(".echolucent.json").size()), layout)
            .has_value();
    });
}

}  // namespace

std::vector<FuzzSample> curveSamples() {
    const ManualCurve curve{{{0, 0}, {0.25, 0.125}, {0.25, 0.5}, {1, 0.75}}};
    return {{"written",
             bytesOfWritten("c.json", [&](const std::string& path) { return writeCurve(path, curve).has_value(); })}};
}

std::vector<FuzzSample> presetsSamples() {
    std::vector<Preset> presets(standardPresets().begin(), standardPresets().end());
    presets.resize(2);
    return {{"standard", jsonOf(presets)}, {"none", jsonOf(std::vector<Preset>{})}};
}

std::vector<FuzzSample> documentSamples() {
    return {{"unusual", jsonOf(unusualDocument())}, {"empty", jsonOf(Document{})}};
}

std::vector<FuzzSample> sessionSamples() {
    const SavedSession plain{.document = Document{}};
    const SavedSession snapshots{.document = unusualDocument(), .snapshots = {{"before", Document{}}}};
    return {{"plain", jsonOf(plain)}, {"snapshots", jsonOf(snapshots)}};
}

std::vector<FuzzSample> rawLayoutSamples() {
    RawLayout plain{.size = {16, 16, 16}};
    RawLayout words{.size = {8, 8, 8}, .type = "int16", .bigEndian = true, .headerBytes = 8};
    words.spacing = {0.5, 0.25, 2};
    words.spacingKnown = true;
    RawLayout polar{.size = {9, 4, 3}};
    polar.polar = PolarGeometry{.samples = 9,
                                .rangeStartMm = 2,
                                .rangeStepMm = 0.5,
                                .lines = {PolarSpread::angles, {-0.15, -0.05, 0.05, 0.15}, 10},
                                .planes = {PolarSpread::positions, {0, 1, 2}}};
    return {{"plain", layoutBytes(plain)}, {"words", layoutBytes(words)}, {"polar", layoutBytes(polar)}};
}

}  // namespace echolucent
