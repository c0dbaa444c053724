#include "widgets/document/kept_bytes.h"

namespace echolucent {

namespace {

template <typename T>
void share(SharedList<T>& list, const SharedList<T>& other) {
    if (list == other) list = other;
}

template <typename T>
std::size_t bytesOf(const SharedList<T>& list) {
    return list.size() * sizeof(T);
}

/// A stroke needs no bytes for its places if it shares them with the stroke that is as far from the beginning, or from
/// the end, of `others`: one stroke was added or taken back.
std::size_t bytesBeside(const SharedList<ScalpelStroke>& strokes, const SharedList<ScalpelStroke>& others) {
    if (strokes.sharesWith(others)) return 0;
    std::size_t bytes = bytesOf(strokes);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto isShared = [&](std::size_t other) {
            return other < others.size() && strokes[i].places.sharesWith(others[other].places);
        };
        if (!isShared(i) && !isShared(i + others.size() - strokes.size())) bytes += bytesOf(strokes[i].places);
    }
    return bytes;
}

std::size_t bytesBeside(const SharedList<Measurement>& measurements, const SharedList<Measurement>& others) {
    if (measurements.sharesWith(others)) return 0;
    std::size_t bytes = bytesOf(measurements);
    for (const Measurement& each : measurements)
        bytes += each.placesMm.size() * sizeof(Vec3) + each.name.size() + each.comment.size();
    return bytes;
}

std::size_t bytesBeside(const std::optional<CutSurface>& surface, const std::optional<CutSurface>& other) {
    const bool isShared = !surface || (other && surface->depthMm.sharesWith(other->depthMm));
    return isShared ? 0 : bytesOf(surface->depthMm);
}

}  // namespace

Document sharing(Document document, const Document& other) {
    share(document.scene.strokes, other.scene.strokes);
    share(document.measurements, other.measurements);
    std::optional<CutSurface>& surface = document.scene.front.surface;
    if (surface && other.scene.front.surface) share(surface->depthMm, other.scene.front.surface->depthMm);
    return document;
}

std::size_t bytesBeside(const Document& document, const Document* other) {
    static const Document none;
    const Document& kept = other != nullptr ? *other : none;
    std::size_t bytes = sizeof(Document);
    bytes += bytesBeside(document.scene.strokes, kept.scene.strokes);
    bytes += bytesBeside(document.measurements, kept.measurements);
    bytes += bytesBeside(document.scene.front.surface, kept.scene.front.surface);
    bytes += document.curves.manual.nodes.size() * sizeof(CurveNode);
    for (const Pane& pane : document.panes) bytes += sizeof(Pane) + pane.withoutTubes.size() * sizeof(int);
    bytes += document.method.config.grid.withoutTubes.size() * sizeof(int);
    if (const auto* file = std::get_if<StudyFile>(&document.study))
        bytes += file->path.size() + file->options.series.size() + file->checksum.size();
    return bytes;
}

}  // namespace echolucent
