// Writes the frames of a motion into files: a movie, or a series of pictures.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/pane_picture/pane_frames.h"
#include "processing/progress.h"
#include "processing/result.h"
#include "processing/sides/side_search.h"
#include "widgets/compare/pane_face.h"
#include "widgets/dialogs/movie_dialog.h"

namespace echolucent {

/// All that a movie or a series is made from, as it was on request. Later changes do not matter.
struct FrameOrder {
    Document document{};
    StudyPhases phases{};
    PhaseTimes phaseTimes{};  ///< as in Study
    FrameOutput output = FrameOutput::movie;
    MovieChoice choice{};
    std::shared_ptr<const SidesFinding> sides{};  ///< of the document's beam, for labels; null until they are found
    bool curveIsTold = true;                      ///< as in CaptionFacts
    /// What stands below the pane of each place, if all panes of the document are in each frame; else empty, and the
    /// frames are the first pane's.
    std::vector<PaneFace> compared{};
    QFont letters{};  ///< of these texts, in pixels of a plain screen
};

/// The files for a choice and a number of frames: the movie, or NAME-0001.png and those that follow it.
[[nodiscard]] std::vector<std::string> filesOf(FrameOutput output, const MovieChoice& choice, int frames);

/// Existing pictures of a longer series of the choice's name: those with the numbers after `frames`, up to the first
/// number without a picture. Empty for a movie.
[[nodiscard]] std::vector<std::string> filesOfLongerSeries(FrameOutput output, const MovieChoice& choice, int frames);

/// Fails if the choice cannot be written: MovieFile::check(), a series whose name does not end in .png, or a series
/// whose folder does not exist. Also fails if a file of `study` would be replaced or removed.
[[nodiscard]] Result<void> checkFrameFiles(FrameOutput output, const MovieChoice& choice, int frames,
                                           const std::vector<std::string>& study);

/// Writes every frame of one turn (PaneFrames), over black: each as one picture of a series; in a movie as often as
/// MovieChoice::length says (framesOfPictures()), though it is rendered once (addLooped()). Adds labels and
/// measurements if the choice wants them. Files appear only once the last frame is made. If the writing fails or is
/// cancelled before that (FailureKind::cancelled, within a frame), the old files stay as they were. After the last
/// frame, a picture of a series may still fail to take its place. If so, the pictures before it that replaced no file
/// are removed, and those that replaced one stay. If the choice replaces, the pictures of a longer series
/// (filesOfLongerSeries()) are removed once all of this series are in place. The writing fails if one of them cannot be
/// removed. Without labels a picture of a series equals that of `render --document`, to the bit. Frames of several
/// panes stand side by side as in the window; their labels are what stands below the panes. Any thread may call this.
/// It loads the movie's encoder.
[[nodiscard]] Result<void> writeFrames(const FrameOrder& order, const Progress& progress = {});

}  // namespace echolucent
