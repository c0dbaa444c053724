#include "widgets/controls/run_status.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/controls/panel_controls.h"
#include "widgets/controls/value_text.h"

namespace echolucent {
namespace {

/// "1.6 ms", "24 ms": two figures are enough.
QString millisecondsText(double milliseconds) {
    return QObject::tr("%1 ms").arg(QLocale::c().toString(milliseconds, 'f', milliseconds < 10.0 ? 1 : 0));
}

QLabel* createLabel(const QString& name, const QString& accessibleName) {
    auto* label = named(new QLabel, "status." + name, accessibleName);
    label->setTextFormat(Qt::PlainText);
    label->hide();
    return label;
}

void showText(QLabel* label, const QString& text) {
    label->setText(text);
    label->setVisible(!text.isEmpty());
}

}  // namespace

RunStatus::RunStatus(QWidget* parent)
    : QWidget(parent),
      m_renderer(createLabel("renderer", tr("Renderer and cost of the last picture"))),
      m_otf(createLabel("otf", tr("Time of the OTF, and tube cores of the adaptive one"))),
      m_notes(createLabel("notes", tr("About the data"))),
      m_pointed(createLabel("pointed", tr("Intensity and opacity under the cursor"))),
      m_activity(createLabel("activity", tr("What is running"))),
      m_progress(named(new QProgressBar, "status.progress", tr("Progress"))),
      m_cancel(named(new QToolButton, "status.cancel", tr("Cancel"), tr("Ends what is running"))) {
    setObjectName("status");
    setAccessibleName(tr("Run status"));
    m_delay.setSingleShot(true);
    m_delay.setInterval(100);
    connect(&m_delay, &QTimer::timeout, this, [this] { setProgressVisible(true); });
    m_notes->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // must not keep the window wide
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(140);
    m_progress->setMaximumHeight(12);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setFocusPolicy(Qt::StrongFocus);
    m_cancel->setAutoRaise(true);
    connect(m_cancel, &QToolButton::clicked, this, &RunStatus::cancelRequested);
    setProgressVisible(false);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(18);
    // The line keeps its height whether something runs or not. Otherwise all panes above it would change size and make
    // their pictures anew.
    m_cancel->ensurePolished();
    layout->addStrut(m_cancel->sizeHint().height());
    layout->addWidget(m_renderer);
    layout->addWidget(m_otf);
    layout->addWidget(m_notes, 1);
    layout->addStretch(0);
    layout->addWidget(m_pointed);
    layout->addWidget(m_activity);
    layout->addWidget(m_progress);
    layout->addWidget(m_cancel);
}

void RunStatus::setRenderer(const QString& name, std::optional<double> milliseconds, const QString& toolTip) {
    m_rendererName = name;
    m_milliseconds = milliseconds;
    m_rendererToolTip = toolTip;
    tellCosts();
}

void RunStatus::setOtf(double milliseconds, int tubesWithWeight, int tubesMeetingVolume) {
    m_otfText = tr("OTF %1, %2 of %3 tube cores")
                    .arg(millisecondsText(milliseconds))
                    .arg(tubesWithWeight)
                    .arg(tubesMeetingVolume);
    tellCosts();
}

void RunStatus::setDesign(const QString& designer, double milliseconds) {
    m_otfText = tr("%1 %2").arg(designer, millisecondsText(milliseconds));
    tellCosts();
}

void RunStatus::clearOtf() {
    m_otfText.clear();
    tellCosts();
}

void RunStatus::setDetailed(bool detailed) {
    m_detailed = detailed;
    tellCosts();
}

void RunStatus::tellCosts() {
    const QString time = m_milliseconds ? millisecondsText(*m_milliseconds) : QString();
    showText(m_renderer,
             m_detailed && !time.isEmpty() ? m_rendererName + QStringLiteral(" · ") + time : m_rendererName);
    m_otf->setText(m_otfText);
    m_otf->setVisible(m_detailed && !m_otfText.isEmpty());
    QStringList lines{time.isEmpty() ? QString() : tr("picture %1").arg(time), m_rendererToolTip, m_otfText};
    lines.removeAll(QString());
    m_renderer->setToolTip(lines.join(QLatin1Char('\n')));
}

void RunStatus::setNotes(const QStringList& notes) {
    const QString text = notes.join(QStringLiteral(" · "));
    showText(m_notes, text);
    m_notes->setToolTip(literalToolTip(text));
}

void RunStatus::setPointed(std::optional<double> intensity, std::optional<double> opacity) {
    const QLocale locale = QLocale::c();
    QStringList parts;
    if (intensity)
        parts << tr("intensity %1%2").arg(locale.toString(*intensity, 'f', 2), valueBeside(*intensity, m_values));
    if (opacity) parts << tr("opacity %1").arg(locale.toString(*opacity, 'f', 2));
    showText(m_pointed, parts.join(QStringLiteral("  ")));
}

void RunStatus::beginProgress(const QString& activity) {
    m_activity->setText(activity);
    if (m_running) return;
    m_running = true;
    m_progress->setRange(0, 0);  // busy, until the share is known
    m_delay.start();
}

void RunStatus::setProgress(double share) {
    if (m_running) showShare(m_progress, share);
}

void RunStatus::endProgress() {
    m_running = false;
    m_delay.stop();
    setProgressVisible(false);
}

void RunStatus::setProgressDelay(int milliseconds) { m_delay.setInterval(milliseconds); }

void RunStatus::setProgressVisible(bool visible) {
    m_activity->setVisible(visible);
    m_progress->setVisible(visible);
    m_cancel->setVisible(visible);
}

}  // namespace echolucent
