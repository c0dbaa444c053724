// Fuzz targets: the JSON files of the program, opacity curves, presets, documents and sessions.
#include "fuzz_target.h"
#include "fuzzed_folder.h"
#include "io/document/curve_file.h"
#include "io/document/document_file.h"
#include "io/document/preset_file.h"
#include "io/document/session_file.h"
#include "mutations/json_mutation.h"
#include "promises.h"
#include "samples/json_samples.h"

namespace echolucent {

namespace {

/// What was read is written as a text that is read as the same.
template <typename Value>
void requireRoundTrip(const Result<Value>& value, Result<Value> (*fromJson)(std::string_view, const std::string&)) {
    if (!value) return requireSoundRefusal(value.error());
    const auto again = fromJson(jsonOf(*value), "again");
    if (!again) throw BrokenPromise("what was read can be written and read again: " + again.error().sentence());
    if (!(*again == *value)) throw BrokenPromise("what was read is the same when it was written and read again");
}

void readCurveBytes(std::string_view bytes) {
    static const FuzzedFolder folder;
    const auto curve = readCurve(folder.write("curve.json", bytes));
    if (!curve) return requireSoundRefusal(curve.error());
    for (const CurveNode& node : curve->nodes)
        if (!(node.intensity >= 0 && node.intensity <= 1 && node.opacity >= 0 && node.opacity <= 1))
            throw BrokenPromise("the nodes of a curve lie in [0,1]");
}

void readPresetsBytes(std::string_view bytes) { requireRoundTrip(presetsFromJson(bytes, "file"), presetsFromJson); }
void readDocumentBytes(std::string_view bytes) { requireRoundTrip(documentFromJson(bytes, "file"), documentFromJson); }
void readSessionBytes(std::string_view bytes) { requireRoundTrip(sessionFromJson(bytes, "file"), sessionFromJson); }

}  // namespace

const FuzzTarget curveTarget{"curve", readCurveBytes, mutatedJson, curveSamples, 4096, "json"};
const FuzzTarget presetsTarget{"presets", readPresetsBytes, mutatedJson, presetsSamples, 32768, "json"};
const FuzzTarget documentTarget{"document", readDocumentBytes, mutatedJson, documentSamples, 32768, "json"};
const FuzzTarget sessionTarget{"session", readSessionBytes, mutatedJson, sessionSamples, 65536, "json"};

}  // namespace echolucent
