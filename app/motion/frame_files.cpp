#include "app/motion/frame_files.h"

#include <QFileInfo>
#include <QFontInfo>
#include <QPainter>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <new>
#include <set>
#include <span>

#include "app/picture/labelled_picture.h"
#include "app/picture/picture_caption.h"
#include "io/output/output_place.h"
#include "io/output/overwriting.h"
#include "io/output/unfinished_file.h"
#include "io/writers/looped_pictures.h"
#include "io/writers/movie_file.h"
#include "io/writers/picture_file.h"
#include "processing/picture/picture.h"
#include "widgets/casting/picture_image.h"
#include "widgets/compare/compare_grid.h"
#include "widgets/picture_labels/picture_labels.h"

namespace echolucent {

namespace {

constexpr auto pictureEnding = "png";
constexpr double plainHeight = 720.0;  ///< labels grow with pictures above this height

tl::unexpected<Failure> cancelled(const FrameOrder& order) {
    return fail(FailureKind::cancelled, order.choice.path.toStdString(), "", "was cancelled");
}

/// A document of one pane, which shows what a pane of `document` does.
Document alone(Document document, std::size_t pane) {
    Pane shown = document.panes.at(pane);
    document.motion.otf = shown.motionOtf.value_or(document.motion.otf);
    shown.motionOtf.reset();
    document.panes = {std::move(shown)};
    return document;
}

/// The frames of one pane or of several. All have the same positions.
class ShownFrames {
public:
    explicit ShownFrames(const FrameOrder& order) {
        const std::size_t panes = std::max<std::size_t>(1, order.compared.size());
        for (std::size_t pane = 0; pane < panes; ++pane)
            m_panes.push_back(std::make_unique<PaneFrames>(
                order.compared.empty() ? order.document : alone(order.document, pane), firstPane, order.phases));
    }
    [[nodiscard]] int count() const { return m_panes.front()->count(); }
    [[nodiscard]] const MotionPosition& position(int frame) const { return m_panes.front()->position(frame); }
    [[nodiscard]] PaneFrames& pane(std::size_t place) { return *m_panes.at(place); }
    [[nodiscard]] std::size_t panes() const { return m_panes.size(); }
    /// The first frame that looks like this one in every pane.
    [[nodiscard]] int firstLike(int frame) const {
        const int first = m_panes.front()->firstLike(frame);
        const bool all =
            std::ranges::all_of(m_panes, [&](const auto& each) { return each->firstLike(frame) == first; });
        return all ? first : frame;
    }

private:
    std::vector<std::unique_ptr<PaneFrames>> m_panes;
};

LabelFacts labelsOf(const FrameOrder& order, const PaneFrames& frames, int frame) {
    const Document shown = frames.documentOf(frame);
    const MotionChoice& motion = order.document.motion;
    // If the probe moves, no frame is a view of its own, not even the middle one.
    const bool ofAnotherView =
        !movesProbe(motion.scenario) && curveIsOfAnotherView(shown, otfViewpointOf(shown, firstPane));
    return {.curveOfAnotherView = ofAnotherView,
            .curveIsTold = order.curveIsTold,
            .sides = order.sides.get(),
            .remembered = std::nullopt,
            .frame = frameWords(frames.position(frame), motion.scenario, static_cast<int>(order.phases.scans.size()),
                                order.phaseTimes)};
}

/// A frame of several panes as 8-bit red, green, blue. No value if the work was cancelled.
std::optional<std::vector<std::uint8_t>> comparedPixelsOf(const FrameOrder& order, ShownFrames& frames, int frame,
                                                          const Progress& progress) {
    QImage image(order.choice.size, QImage::Format_RGB888);
    if (image.isNull()) throw std::bad_alloc();
    image.fill(Qt::black);
    QPainter painter(&image);
    const std::vector<QRect> places = placesOfPanes(frames.panes(), image.size());
    QStringList names;
    for (const PaneFace& face : order.compared) names << face.name;
    QFont letters = order.letters;
    letters.setPixelSize(
        std::max(1, qRound(QFontInfo(letters).pixelSize() * std::max(1.0, image.height() / plainHeight))));
    const CaptionLayout caption =
        order.choice.labels ? captionLayout(names, places.front().width(), letters) : CaptionLayout{};
    for (std::size_t pane = 0; pane < frames.panes(); ++pane) {
        const QRect place = pictureIn(places[pane], caption);
        if (place.isEmpty()) continue;
        const Progress ofPane{
            [&](double share) {
                progress.at((static_cast<double>(pane) + share) / static_cast<double>(frames.panes()));
            },
            progress.cancel};
        const auto picture = frames.pane(pane).picture(frame, place.width(), place.height(), ofPane);
        if (!picture) return std::nullopt;
        painter.drawImage(place, imageOf(picture->picture));
        // What was measured, and the OTF in the corner, are of another frame.
        const PaneFace& face = order.compared[pane];
        if (order.choice.labels)
            paintFace(painter, places[pane], {.name = face.name, .frame = face.frame, .frameStyle = face.frameStyle},
                      caption);
    }
    painter.end();
    return rgbBytesOf(image);
}

/// A frame as 8-bit red, green, blue. No value if the work was cancelled.
std::optional<std::vector<std::uint8_t>> pixelsOf(const FrameOrder& order, ShownFrames& all, int frame,
                                                  const Progress& progress) {
    if (!order.compared.empty()) return comparedPixelsOf(order, all, frame, progress);
    PaneFrames& frames = all.pane(firstPane);
    const QSize size = order.choice.size;
    const auto picture = frames.picture(frame, size.width(), size.height(), progress);
    if (!picture) return std::nullopt;
    if (!order.choice.labels) return overBackground(picture->picture, Vec3(0, 0, 0));
    const double scale = std::max(1.0, size.height() / plainHeight);
    return rgbBytesOf(labelledPicture(*picture, frames.documentOf(frame), labelsOf(order, frames, frame), scale));
}

/// Writes pictures beside their places and puts them all in place at the end.
class PictureSeries {
public:
    Result<void> add(const std::string& path, const QSize& size, const std::vector<std::uint8_t>& rgb) {
        auto file = UnfinishedFile::beside(path);
        if (!file) return tl::unexpected<Failure>(file.error());
        const std::string bytes = pngBytes(size.width(), size.height(), rgb);
        std::ofstream stream(file->name(), std::ios::binary);
        if (!stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
            return fail(FailureKind::unwritable, path, "", "could not be written", "The disk may be full.");
        m_files.push_back(std::move(*file));
        std::error_code unknown;
        m_isNew.push_back(!std::filesystem::exists(path, unknown));
        m_paths.push_back(path);
        return {};
    }
    /// Puts the pictures in place. If one cannot take its place, removes those before it that replaced no file, and
    /// returns the failure.
    Result<void> finish() {
        for (std::size_t i = 0; i < m_files.size(); ++i) {
            auto put = m_files[i].putInPlace();
            if (put) continue;
            std::error_code ignored;
            for (std::size_t before = 0; before < i; ++before)
                if (m_isNew[before]) std::filesystem::remove(m_paths[before], ignored);
            return put;
        }
        return {};
    }

private:
    std::vector<UnfinishedFile> m_files;
    std::vector<std::string> m_paths;
    std::vector<bool> m_isNew;
};

/// The file of a frame, counted from 1, in a series of `frames` pictures.
std::string fileOfSeries(const MovieChoice& choice, int frame, int frames) {
    const QFileInfo name(choice.path);
    const auto digits = std::max<qsizetype>(4, QString::number(frames).size());
    // The name may hold a placeholder that QString::arg() would replace.
    const QString file = name.path() + '/' + name.completeBaseName() + '-' +
                         QString::number(frame).rightJustified(digits, u'0') + '.' + pictureEnding;
    return file.toStdString();
}

Result<void> removePictures(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        std::error_code problem;
        std::filesystem::remove(file, problem);
        if (problem)
            return fail(FailureKind::unwritable, file, "", "is of a longer series and could not be removed",
                        "Remove it by hand: all pictures before it are of the new series.");
    }
    return {};
}

std::vector<int> phasesOf(const ShownFrames& frames) {
    std::vector<int> phases;
    for (int frame = 0; frame < frames.count(); ++frame) phases.push_back(frames.position(frame).phase);
    return phases;
}

Result<void> writeSeries(const FrameOrder& order, ShownFrames& frames, const Progress& progress) {
    const std::vector<std::string> paths = filesOf(order.output, order.choice, frames.count());
    PictureSeries series;
    for (int frame = 0; frame < frames.count(); ++frame) {
        const Progress ofFrame{
            [&](double share) { progress.at((frame + share) / static_cast<double>(frames.count())); }, progress.cancel};
        const auto rgb = pixelsOf(order, frames, frame, ofFrame);
        if (!rgb || progress.cancelled()) return cancelled(order);
        if (auto added = series.add(paths[static_cast<std::size_t>(frame)], order.choice.size, *rgb); !added)
            return added;
        ofFrame.at(1.0);
    }
    if (const auto finished = series.finish(); !finished || !order.choice.replace) return finished;
    return removePictures(filesOfLongerSeries(order.output, order.choice, frames.count()));
}

/// The frame that each picture of the movie shows; of frames that look alike, the first.
std::vector<int> framesOfMovie(const FrameOrder& order, const ShownFrames& frames) {
    const std::vector<int> held =
        heldFrames(order.document.motion, order.phaseTimes, phasesOf(frames), 1.0 / MovieDialog::largestRate).pictures;
    std::vector<int> shown = framesOfPictures(held, order.choice.length, order.choice.framesPerSecond);
    for (int& frame : shown) frame = frames.firstLike(frame);
    return shown;
}

Result<void> writeMovie(const FrameOrder& order, ShownFrames& frames, const Progress& progress) {
    const QSize size = order.choice.size;
    auto movie =
        MovieFile::begin(order.choice.path.toStdString(), size.width(), size.height(), order.choice.framesPerSecond);
    if (!movie) return tl::unexpected<Failure>(movie.error());
    const std::vector<int> shown = framesOfMovie(order, frames);
    // Rendering takes most of the time, and packed frames next to none.
    constexpr double shareOfRendering = 0.95;
    const auto toRender = static_cast<double>(std::set<int>(shown.begin(), shown.end()).size());
    int rendered = 0, added = 0;
    const auto tell = [&](double share) {
        progress.at(shareOfRendering * std::min(1.0, (rendered + share) / toRender) +
                    (1.0 - shareOfRendering) * added / static_cast<double>(shown.size()));
    };
    const auto make = [&](int frame) -> Result<MoviePicture> {
        auto rgb = pixelsOf(order, frames, frame, {tell, progress.cancel});
        if (!rgb) return cancelled(order);
        ++rendered;
        return *std::move(rgb);
    };
    const auto add = [&](std::span<const std::uint8_t> rgb) -> Result<void> {
        if (progress.cancelled()) return cancelled(order);
        if (auto done = movie->add(rgb); !done) return done;
        ++added;
        tell(0.0);
        return {};
    };
    const auto all = addLooped(shown, make, add);
    return all ? movie->finish(progress) : all;
}

}  // namespace

std::vector<std::string> filesOf(FrameOutput output, const MovieChoice& choice, int frames) {
    if (output == FrameOutput::movie) return {choice.path.toStdString()};
    std::vector<std::string> files;
    for (int frame = 1; frame <= frames; ++frame) files.push_back(fileOfSeries(choice, frame, frames));
    return files;
}

std::vector<std::string> filesOfLongerSeries(FrameOutput output, const MovieChoice& choice, int frames) {
    std::vector<std::string> files;
    if (output == FrameOutput::movie) return files;
    for (int frame = frames + 1;; ++frame) {
        std::string file = fileOfSeries(choice, frame, frames);
        if (!QFileInfo(QString::fromStdString(file)).isFile()) return files;
        files.push_back(std::move(file));
    }
}

Result<void> checkFrameFiles(FrameOutput output, const MovieChoice& choice, int frames,
                             const std::vector<std::string>& study) {
    const std::string path = choice.path.toStdString();
    if (output == FrameOutput::movie) {
        if (auto possible = MovieFile::check(path, choice.size.width(), choice.size.height()); !possible)
            return possible;
    } else {
        const QFileInfo name(choice.path);
        if (name.suffix().compare(pictureEnding, Qt::CaseInsensitive) != 0 || name.completeBaseName().isEmpty())
            return fail(FailureKind::wrongUsage, path, "", "is no name of pictures, which are written as PNG",
                        "Give it a name that ends in .png.");
        if (const auto place = placeOfOutput(fileOfSeries(choice, 1, frames)); !place)
            return tl::unexpected<Failure>(place.error());
    }
    std::vector<std::string> files = filesOf(output, choice, frames);
    std::ranges::move(filesOfLongerSeries(output, choice, frames), std::back_inserter(files));
    return refuseToOverwrite(study, files);
}

Result<void> writeFrames(const FrameOrder& order, const Progress& progress) {
    ShownFrames frames(order);
    return order.output == FrameOutput::series ? writeSeries(order, frames, progress)
                                               : writeMovie(order, frames, progress);
}

}  // namespace echolucent
