// What is open and what was computed for it: the model behind the main window. Knows no widget.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "io/study.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/document/study_reference.h"
#include "processing/near_cut.h"
#include "processing/volume/histogram.h"
#include "widgets/newest_wins_thread.h"

namespace echolucent {

/// Loads studies and runs the adaptive pipeline, each in a QThread of its own. Everything below is to be called, and
/// every signal is sent, in the thread the session lives in.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);

    /// Loads a file or a DICOM folder; what is open stays until the new study is there. A newer call replaces an older.
    void open(const QString& path, const ReadOptions& options = {});
    /// Makes and opens the simulated scan a newcomer sees first.
    void openSimulatedScan();
    void cancelLoading();
    [[nodiscard]] bool loading() const { return m_loader.busy(); }

    /// The study that is open; null before the first.
    [[nodiscard]] const Study* study() const { return m_study.get(); }
    /// The path of the file or folder; empty where the scan is simulated.
    [[nodiscard]] QString path() const;
    [[nodiscard]] bool isSimulatedScan() const { return std::holds_alternative<SimulatedScan>(m_reference); }
    /// What a document names the study by.
    [[nodiscard]] const StudyReference& reference() const { return m_reference; }
    [[nodiscard]] std::shared_ptr<const Volume> volume() const { return m_volume; }
    /// Of the volume shown.
    [[nodiscard]] const IntensityHistogram& histogram() const {
        return m_histograms[static_cast<std::size_t>(m_phase)];
    }
    [[nodiscard]] int phase() const { return m_phase; }
    /// Shows another phase of a 4D study; out of range is a broken contract (std::out_of_range).
    void setPhase(int phase);

    /// Computes the adaptive OTF of the volume shown for a view; the newest request wins, older ones are cancelled.
    /// What is being computed already goes on.
    void requestOtf(const Viewpoint& view, const AdaptiveOtfConfig& config);
    [[nodiscard]] bool computingOtf() const { return m_otfThread.busy(); }
    /// The newest result for the volume shown; null where there is none yet.
    [[nodiscard]] std::shared_ptr<const AdaptiveOtf> otf() const { return m_otf; }

    /// Looks for the near cut of the volume shown, in the same thread: takes the place of an OTF that is being
    /// computed, and a newer request takes its place.
    void requestNearCut(const Viewpoint& view, const AdaptiveOtfConfig& config);
    /// Ends what requestOtf or requestNearCut began; nothing of it is delivered.
    void cancelComputing();

    /// The pipeline run by requestOtf; tests put one in its place that ends on command.
    using Pipeline = std::function<std::optional<AdaptiveOtf>(const Volume&, const Viewpoint&, const AdaptiveOtfConfig&,
                                                              const Progress&)>;
    void setPipeline(Pipeline pipeline) { m_pipeline = std::move(pipeline); }
    /// The search run by requestNearCut; tests put one in its place that ends on command.
    using NearCutSearch = std::function<std::optional<NearCutSuggestion>(const Volume&, const Viewpoint&,
                                                                         const AdaptiveOtfConfig&, const Progress&)>;
    void setNearCutSearch(NearCutSearch search) { m_nearCutSearch = std::move(search); }

signals:
    void loadingChanged(bool loading);
    void loadingProgressed(double share);
    void studyOpened();
    /// The study could not be read; what was open before is unchanged.
    void openFailed(const QString& path, const echolucent::Failure& failure);
    /// Another volume is shown: a new study, or another phase. otf() is null from here until otfComputed().
    void volumeChanged();
    void computingOtfChanged(bool computing);
    void otfComputed();
    /// The adaptive OTF or the near cut could not be computed; otf() is as it was.
    void otfFailed(const QString& sentence);
    void nearCutSuggested(const echolucent::NearCutSuggestion& suggestion);

private:
    void load(const StudyReference& reference, std::function<Result<Study>(const Progress&)> read);
    void show(int phase);

    Pipeline m_pipeline;
    NearCutSearch m_nearCutSearch;
    StudyReference m_reference;
    std::shared_ptr<const Study> m_study;
    std::shared_ptr<const Volume> m_volume;
    std::vector<IntensityHistogram> m_histograms = std::vector<IntensityHistogram>(1);  // by phase
    int m_phase = 0;
    std::shared_ptr<const AdaptiveOtf> m_otf;
    struct OtfRequest {
        Viewpoint view;
        AdaptiveOtfConfig config;
        friend bool operator==(const OtfRequest&, const OtfRequest&) = default;
    };
    std::optional<OtfRequest> m_asked;  ///< of the volume shown; none where no OTF is under way
    // Last, so that both threads have ended before anything above is destroyed.
    NewestWinsThread m_loader;
    NewestWinsThread m_otfThread;
};

}  // namespace echolucent

Q_DECLARE_METATYPE(echolucent::Failure)
