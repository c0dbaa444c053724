// Writes the frames of a motion into files: a movie, or a series of pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/pane_picture/pane_frames.h"
#include "processing/progress.h"
#include "processing/result.h"
#include "widgets/dialogs/movie_dialog.h"

namespace echolucent {

/// All that a movie or a series is made of, as it was when it was asked for: what changes meanwhile does not matter.
struct FrameOrder {
    Document document{};
    StudyPhases phases{};
    std::optional<double> phaseSeconds{};  ///< as in Study
    FrameOutput output = FrameOutput::movie;
    MovieChoice choice{};
};

/// The files that a choice writes for so many frames: the movie, or NAME-0001.png and those that follow it.
[[nodiscard]] std::vector<std::string> filesOf(FrameOutput output, const MovieChoice& choice, int frames);

/// The pictures that are there of a longer series of that name: numbered on from so many frames, up to the first that
/// is not there. A movie has none.
[[nodiscard]] std::vector<std::string> filesOfLongerSeries(FrameOutput output, const MovieChoice& choice, int frames);

/// Fails where the choice cannot be written: MovieFile::check(), a series whose name does not end in .png or whose
/// folder is not there, or where a file of `study` would be replaced or removed.
[[nodiscard]] Result<void> checkFrameFiles(FrameOutput output, const MovieChoice& choice, int frames,
                                           const std::vector<std::string>& study);

/// Writes every frame of one turn (PaneFrames), over black, with labels and measurements where the choice wants them.
/// Files appear once the last frame is made, and none of them before: where it fails until then, or is cancelled
/// (Failure::cancelled, within a frame), what was there before is as it was. Where a picture of a series cannot take
/// its place then, those before it that are new are removed, and those that replaced others stay. Where the choice
/// replaces, the pictures of a longer series (filesOfLongerSeries()) are removed once all of this one are in their
/// places; it fails where one cannot be. Without labels a picture of a series is that of `render --document`, to the
/// bit. Needs no GUI thread; the movie's encoder is loaded by the thread that calls it.
[[nodiscard]] Result<void> writeFrames(const FrameOrder& order, const Progress& progress = {});

}  // namespace echolucent
