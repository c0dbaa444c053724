// The open study: its voxels as read, quiet and cut, and what was found of it. Knows no OTF and no widget.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/study/cut_phases.h"
#include "app/study/quiet_phases.h"
#include "app/study/saved_study.h"
#include "app/study/study_loading.h"
#include "io/output/overwriting.h"
#include "io/study/series_list.h"
#include "io/study/study.h"
#include "processing/document/opening_finds.h"
#include "processing/document/study_reference.h"
#include "processing/intensity/histogram.h"
#include "processing/volume/coarse_grid.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Loads studies, makes their voxels quiet and cuts them, each in a QThread of its own. Call it in the thread it lives
/// in; it sends its signals there too.
class OpenStudy : public QObject {
    Q_OBJECT

public:
    explicit OpenStudy(Works& works, QObject* parent = nullptr);

    /// Loads a file or a DICOM folder. The open study stays until the new one is there. A newer call replaces an older
    /// one. If the options name no series, and a folder holds several of which not exactly one is a volume, or the only
    /// one cannot be read, emits seriesFound() instead. A file that says it is a document is opened as a session: its
    /// study is read, and saved() gives the rest.
    void open(const QString& path, const ReadOptions& options = {});
    /// Loads a folder of DICOM slices. `slices` are those of it that were named. Fails (unreadable) if one is a folder.
    void openSlices(const QString& folder, const QStringList& slices);
    /// Opens a session file with a person's answer to savedStudyAsked(). `askedFor` is the path that asked() gives
    /// meanwhile, if a person knows the session by another file than this one.
    void openSaved(const QString& file, const SavedStudyAnswer& answer,
                   const std::optional<QString>& askedFor = std::nullopt);
    /// Sets where to look for a session's study if it is not in its place. `search` is called whenever a session is
    /// opened.
    void setStudySearch(std::function<StudySearch()> search) { m_studySearch = std::move(search); }
    /// Sets what says the sides that a person took last (lookThrough()). It is called whenever a study is asked for.
    void setSidesTaken(std::function<SidesByKind()> taken) { m_sidesTaken = std::move(taken); }
    /// The session whose study is open; no value if the study was opened by itself.
    [[nodiscard]] const std::optional<OpenedSession>& saved() const { return m_saved; }
    /// Loads the series at the index `entry` of a list.
    void openSeries(std::shared_ptr<const SeriesList> list, std::size_t entry, ReadOptions options = {});
    /// The series beside the open study; null if it is not from a folder of several.
    [[nodiscard]] std::shared_ptr<const SeriesList> seriesBeside() const { return m_seriesBeside; }
    /// Makes and opens a simulated scan; without a name, the one that a newcomer sees first.
    void openSimulatedScan(const SimulatedScan& scan = {});
    /// Makes and opens the simulated scan of a document, and begins with that document as a session does. Throws
    /// std::bad_variant_access if its study is no simulated scan.
    void openSimulatedScan(const Document& document);
    /// The document that the open study was opened with by openSimulatedScan(); no value for all other studies.
    [[nodiscard]] const std::optional<Document>& given() const { return m_given; }
    /// The open study, to come back to it. It keeps the voxels. Null before the first study.
    struct Kept;
    [[nodiscard]] std::shared_ptr<const Kept> keep() const;
    /// Opens a study that keep() gave once more, at once and without reading it. What is being loaded is dropped.
    void comeBack(const Kept& kept);
    void cancelLoading();
    /// Sets the words for the status line while loading.
    void setLoadingWords(const QString& words) { m_loader.setWords(words); }
    [[nodiscard]] bool loading() const { return m_loader.busy(); }
    /// The path of the file or folder that was asked for last; empty for a simulated scan.
    [[nodiscard]] const QString& asked() const { return m_asked; }
    /// True while the checksum of the study is taken. Afterwards reference() holds it, unless a file could not be read.
    [[nodiscard]] bool takingChecksum() const { return m_checksumThread.busy(); }

    /// The time from asking for the open study until it was read and looked through; no value before the first.
    [[nodiscard]] std::optional<double> loadingMilliseconds() const { return m_loadingMilliseconds; }
    /// The time that the last making of quiet voxels took, for all phases made then; no value before the first.
    [[nodiscard]] std::optional<double> quieteningMilliseconds() const { return m_quieteningMilliseconds; }

    /// The open study; null before the first.
    [[nodiscard]] const Study* study() const { return m_study.get(); }
    /// True while another study's document begins: study and document do not belong together yet.
    [[nodiscard]] bool beginning() const { return m_beginning; }
    /// The path of the file or folder; empty if the scan is simulated.
    [[nodiscard]] QString path() const;
    [[nodiscard]] bool isSimulatedScan() const { return std::holds_alternative<SimulatedScan>(m_reference); }
    /// How a document names the study.
    [[nodiscard]] const StudyReference& reference() const { return m_reference; }
    /// The raw voxels of the phase shown, with what the scalpel cut of them.
    [[nodiscard]] std::shared_ptr<const Volume> volume() const { return m_volume; }
    /// The voxels for the next picture of the phase shown: its quiet ones if they are made, else its raw ones, with
    /// what the scalpel cut of them.
    [[nodiscard]] std::shared_ptr<const Volume> newestVoxels();
    /// newestVoxels() for any phase (counted from 0) of the open study, and the phase's raw voxels, cut too. Both
    /// return the same objects until voxels or cut of the phase change; phaseVoxelsChanged() tells of that.
    [[nodiscard]] std::shared_ptr<const Volume> newestVoxelsOf(int phase);
    [[nodiscard]] std::shared_ptr<const Volume> rawVoxelsOf(int phase) { return volumeOf(phase); }
    /// Cuts all phases by strokes, in the background; the newest list wins.
    void setStrokes(const std::vector<ScalpelStroke>& strokes);
    [[nodiscard]] const std::vector<ScalpelStroke>& strokes() const { return m_cut.strokes(); }
    /// What was found of the study on opening; no value for simulated scans, whose beam is known.
    [[nodiscard]] const std::optional<OpeningFinds>& finds() const { return m_finds; }
    /// Whether strokes are being cut that the phase does not show yet.
    [[nodiscard]] bool isCutting(int phase) const { return m_cut.busy() && !m_cut.isCurrent(phase); }
    [[nodiscard]] bool cutting() const { return m_cut.busy(); }
    /// Sets how much speckle is taken away. The voxels are made quiet in the background, the phase shown first.
    void setReduction(SpeckleReduction reduction);
    [[nodiscard]] const QuietPhases& quietPhases() const { return m_quiet; }
    /// For tests, which set another filter (QuietPhases::setReduce()).
    [[nodiscard]] QuietPhases& quietPhases() { return m_quiet; }
    /// The histogram of the raw voxels of the phase shown, before the scalpel cut them.
    [[nodiscard]] const IntensityHistogram& histogram() const {
        return m_histograms[static_cast<std::size_t>(m_phase)];
    }
    /// The histogram of the quiet voxels of the phase shown if `voxels` are these, cut or not; else histogram().
    [[nodiscard]] const IntensityHistogram& histogramOf(const Volume& voxels) const;
    [[nodiscard]] int phase() const { return m_phase; }
    /// The phase whose raw voxels a volume holds, cut or not; no value if it is not of this study.
    [[nodiscard]] std::optional<int> phaseOfVoxels(const Volume& volume) const;
    /// Shows another phase of a 4D study; out of range is a broken contract (std::out_of_range).
    void setPhase(int phase);

    /// Wants the quiet voxels of a phase beside those of the phase shown. Beyond the last phase, the last one is taken.
    void alsoWant(int phase);

    /// Takes the checksum of a study's files. Tests put in a function that ends on command.
    using Checksum = std::function<Result<StudyChecksum>(const std::vector<std::string>& files, const Progress&)>;
    void setChecksum(Checksum checksum) { m_checksum = std::move(checksum); }

signals:
    void loadingChanged(bool loading);
    /// A study was asked for (asked()), perhaps instead of one that is being loaded. Nothing of it was read yet.
    void loadingBegun();
    /// The study that is being loaded is large. `coarse` is its first phase on a coarse grid
    /// (processing/volume/coarse_grid.h). Loading may still fail. Sent at most once for a study, and never for
    /// sessions.
    void coarseVolumeRead(const echolucent::CoarseVolume& coarse);
    void studyOpened();
    /// The study of a session file is missing or changed; what was open before is unchanged.
    void savedStudyAsked(const echolucent::SavedStudyProblem& problem);
    /// reference() holds the checksum of the study that is open.
    void studyNamed();
    void takingChecksumChanged(bool taking);
    /// A folder holds several series; what was open before is unchanged.
    void seriesFound(std::shared_ptr<const echolucent::SeriesList> list, const echolucent::ReadOptions& options);
    /// The study could not be read with these options; what was open before is unchanged.
    void openFailed(const QString& path, const echolucent::Failure& failure, const echolucent::ReadOptions& options);
    /// Another study is about to replace the present one.
    void aboutToReplace();
    /// The study is replaced: its document begins here. Only volumeChanged() lets others follow the new study.
    void studyReplaced();
    /// Another volume is shown: a new study, or another phase.
    void volumeChanged();
    /// The cut of the volume shown has changed, or that of the phase wanted beside it.
    void volumeCut();
    void cuttingChanged(bool cutting);
    void cuttingFailed(const QString& sentence);
    /// The quiet voxels of any phase are made, or the phase's cut has changed. For the phase shown, this comes after
    /// quietVoxelsMade() or volumeCut().
    void phaseVoxelsChanged(int phase);
    /// The quiet voxels of the phase shown are made, or those of the phase wanted beside it.
    void quietVoxelsMade();
    /// Whether quiet voxels of any phase are being made: false once those of all phases that are kept are made.
    void quieteningChanged(bool quietening);
    void quieteningFailed(const QString& sentence);

private:
    [[nodiscard]] StudyReader readerOfSaved(const QString& file, const SavedStudyAnswer& answer) const;
    void takeChecksum();
    void load(const StudyReference& reference, StudyReader reader, const std::optional<QString>& asked = std::nullopt,
              const std::optional<Document>& given = std::nullopt);
    void replaceBy(const Kept& next);
    void show(int phase);
    /// Raw voxels of a phase, with what the scalpel cut of them.
    [[nodiscard]] std::shared_ptr<const Volume> volumeOf(int phase);
    void wantQuietVoxels() { m_quiet.want(m_phase, m_reduction, m_alsoWanted.value_or(m_phase)); }
    [[nodiscard]] bool isWanted(int phase) const { return phase == m_phase || phase == m_alsoWanted; }
    void takeQuietVoxels(int phase);
    void takeCut(int phase);

    Checksum m_checksum;
    QString m_asked;
    StudyReference m_reference;
    std::shared_ptr<const Study> m_study;
    bool m_beginning = false;
    std::vector<KeptFiles> m_filesRead;  ///< of m_study and m_saved
    std::shared_ptr<const SeriesList> m_seriesBeside;
    std::shared_ptr<const Volume> m_volume;  ///< cut by the strokes
    std::optional<OpeningFinds> m_finds;
    std::optional<OpenedSession> m_saved;
    std::optional<Document> m_given;
    std::function<StudySearch()> m_studySearch;
    std::function<SidesByKind()> m_sidesTaken;
    std::vector<IntensityHistogram> m_histograms = std::vector<IntensityHistogram>(1);  // by phase
    int m_phase = 0;
    std::optional<int> m_alsoWanted;  ///< see alsoWant()
    QElapsedTimer m_loadingClock, m_quieteningClock;
    std::optional<double> m_loadingMilliseconds, m_quieteningMilliseconds;
    SpeckleReduction m_reduction = SpeckleReduction::off;
    QuietPhases m_quiet;
    CutPhases m_cut;
    // Last, so that both threads have ended before anything above is destroyed.
    NewestWinsThread m_loader;
    NewestWinsThread m_checksumThread;
};

struct OpenStudy::Kept {
    StudyReference reference;
    std::shared_ptr<const Study> study;
    std::shared_ptr<const SeriesList> series;
    std::optional<OpenedSession> saved;
    std::optional<Document> given;
    std::optional<OpeningFinds> finds;
    std::vector<IntensityHistogram> histograms;
    int phase = 0;  ///< that is shown first
};

}  // namespace echolucent

Q_DECLARE_METATYPE(echolucent::Failure)
