// The status bar's line: renderer, notes on the data, the value under the pointer, and what runs.
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "processing/volume/value_scale.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace echolucent {

/// Objects: status.renderer, status.otf, status.notes, status.pointed, status.activity, status.progress, status.cancel.
/// The progress and its cancel button appear if something runs for longer than the delay (setProgressDelay()).
class RunStatus : public QWidget {
    Q_OBJECT

public:
    explicit RunStatus(QWidget* parent = nullptr);

    /// The name of the renderer. What its last picture took stands in the tool tip, before `toolTip`, which is plain
    /// text; in a detailed line it also stands behind the name: "software renderer · 24 ms".
    void setRenderer(const QString& name, std::optional<double> milliseconds = std::nullopt,
                     const QString& toolTip = {});
    /// In the tool tip, and in a detailed line beside the renderer: "OTF 1.6 ms, 176 of 225 tube cores".
    void setOtf(double milliseconds, int tubesWithWeight, int tubesMeetingVolume);
    /// "Levoy 12 ms": a designer made the OTF.
    void setDesign(const QString& designer, double milliseconds);
    void clearOtf();
    /// Whether times and tube cores stand in the line, and not in its tool tip alone [false].
    void setDetailed(bool detailed);
    /// Short statements about the data, for example "no lossy compression".
    void setNotes(const QStringList& notes);
    /// The file's values, of which the pointed one stands beside its intensity.
    void setValueWindow(const ValueWindow& window) { m_values = window; }
    /// Normalised intensity and opacity under the cursor, both in [0,1]; no values if the cursor points at nothing.
    void setPointed(std::optional<double> intensity, std::optional<double> opacity);

    /// Shows that something runs, named by a word ("loading"). Its share is unknown until setProgress. A second call
    /// renames it.
    void beginProgress(const QString& activity);
    /// The share that is done, clamped into [0,1]. Ignored while nothing runs.
    void setProgress(double share);
    void endProgress();
    /// How long something must run before it is shown. Default 100 ms.
    void setProgressDelay(int milliseconds);

signals:
    void cancelRequested();

private:
    void tellCosts();
    void setProgressVisible(bool visible);

    bool m_running = false, m_detailed = false;
    QString m_rendererName, m_rendererToolTip, m_otfText;
    std::optional<double> m_milliseconds;  ///< of the renderer's last picture
    QTimer m_delay;
    QLabel* m_renderer;
    QLabel* m_otf;
    QLabel* m_notes;
    ValueWindow m_values;
    QLabel* m_pointed;
    QLabel* m_activity;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
};

}  // namespace echolucent
