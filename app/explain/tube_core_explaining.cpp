#include "app/explain/tube_core_explaining.h"

#include <QElapsedTimer>
#include <algorithm>
#include <new>
#include <utility>

#include "processing/document/panes.h"
#include "processing/explanation/explanation_plots.h"
#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/tube_cores/tube_core_panel.h"

namespace echolucent {

namespace {

constexpr const char* topic = "tube core";

/// Empty if the work was cancelled.
std::shared_ptr<const ShownExplanation> explanationOf(const ComputedOtf& otf, int number, const Progress& progress) {
    const OtfRequest& asked = otf.asked;
    const QuietVoxels shown =
        asked.reduction == SpeckleReduction::off ? QuietVoxels{} : QuietVoxels{asked.shown.get(), asked.reduction};
    const AdaptiveOtf& run = *otf.design.tubeCores;
    auto explanation = explainTube(*asked.raw, shown, run, number, progress);
    if (!explanation) return nullptr;
    ShownExplanation made;
    made.run = otf.design.tubeCores;
    made.sentence = explanationSentence(*explanation);
    made.facts = explanationFacts(*explanation);
    made.profile = intensityProfilePlot(*explanation);
    made.interfaceFunction = interfaceFunctionPlot(*explanation);
    made.ranks = rankPlots(*explanation);
    const std::vector<TubeFactor> factors = allFactors(run);
    made.factors = factorsPlot(*explanation, factors);
    made.curves = curvesPlot(*explanation);
    made.change = curveChangePlot(*explanation);
    made.weighing = static_cast<int>(heaviestFirst(run).size());
    made.explanation = std::make_shared<const TubeExplanation>(std::move(*explanation));
    return std::make_shared<const ShownExplanation>(std::move(made));
}

}  // namespace

TubeCoreExplaining::TubeCoreExplaining(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_pictures(parts.model, parts.openStudy, parts.works, parts.otfs, parts.panel),
      m_thread(parts.works, QStringLiteral("tube core"), {.urgency = Urgency::comparing}) {
    TubeCorePanel& panel = m_parts.panel;
    connect(&panel, &TubeCorePanel::chosen, &m_parts.choice, [this](int number) { m_parts.choice.choose(number); });
    connect(&panel, &TubeCorePanel::shownToggled, &m_parts.choice, &TubeCoreChoice::setShown);
    connect(&panel, &TubeCorePanel::configChanged, this, &TubeCoreExplaining::setMethod);
    connect(&panel, &TubeCorePanel::compareRequested, this, &TubeCoreExplaining::compare);
    connect(&m_parts.choice, &TubeCoreChoice::shownChanged, &panel, &TubeCorePanel::setShown);
    connect(&m_parts.choice, &TubeCoreChoice::chosen, this, [this] {
        m_parts.panel.setChosen(m_parts.choice.number());
        follow();
    });
    connect(&m_parts.otfs, &PaneOtfs::followed, this, &TubeCoreExplaining::follow);
    connect(&m_parts.model, &DocumentModel::changed, this, &TubeCoreExplaining::tellWhatThePictureShows);
    m_parts.model.bind(&DocumentModel::methodChanged, this,
                       [this](const Document& document) { m_parts.panel.setConfig(configOf(document)); });
    tellWhatThePictureShows();
    follow();
}

void TubeCoreExplaining::setSeen(bool seen) {
    if (std::exchange(m_seen, seen) == seen) return;
    m_pictures.setSeen(seen);
    follow();
}

void TubeCoreExplaining::follow() {
    const auto otf = m_parts.otfs.of(PaneOtfs::adaptiveOfScene);
    const auto run = otf ? otf->design.tubeCores : nullptr;
    const auto number = m_parts.choice.number();
    // Also if nobody sees the panel: what it showed may be of a study that is gone.
    if ((m_seen || !run) && m_inPanel != run) {
        m_inPanel = run;
        m_parts.panel.setRun(run);
    }
    if (!run || !number) show(nullptr);
    const auto wanted = m_seen && run && number ? std::optional(Asked{otf, *number}) : std::nullopt;
    if (wanted == m_asked) return;
    m_asked = wanted;
    if (wanted) return explain(*wanted);
    m_thread.cancel();
}

void TubeCoreExplaining::explain(const Asked& asked) {
    QElapsedTimer clock;
    clock.start();
    m_thread.submit([this, asked, clock](const Progress& progress) -> NewestWinsThread::Deliver {
        std::shared_ptr<const ShownExplanation> made;
        try {
            made = explanationOf(*asked.otf, asked.number, {{}, progress.cancel});
        } catch (const std::bad_alloc&) {
            return [this] {
                m_parts.messages.showMessage(MessageKind::error,
                                             tr("Explaining a tube core needs more memory than this machine has."),
                                             MessageEnd::withStudy(topic));
            };
        }
        if (!made) return {};
        return [this, made, clock] {
            m_parts.messages.takeBack(topic);
            show(made);
            m_milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        };
    });
}

void TubeCoreExplaining::show(std::shared_ptr<const ShownExplanation> explanation) {
    if (m_explanation == explanation) return;
    m_explanation = std::move(explanation);
    m_parts.panel.setExplanation(m_explanation);
    m_pictures.setExplanation(m_explanation);
    emit explained();
}

void TubeCoreExplaining::tellWhatThePictureShows() {
    const Document& document = m_parts.model.document();
    const Pane& pane = document.panes.at(firstPane);
    QString sentence;
    if (document.scene.look.mode != RenderMode::direct)
        sentence = tr("The picture is rendered without a curve. The panel explains the adaptive one.");
    else if (isAdaptive(pane))
        sentence.clear();
    else if (pane.designer)
        sentence = tr("The picture shows a designer's OTF. The panel explains the adaptive one.");
    else
        sentence =
            tr("The picture shows the %1 curve. The panel explains the adaptive one.").arg(curveName(pane.curve));
    m_parts.panel.setNote(sentence);
}

void TubeCoreExplaining::setMethod(const AdaptiveOtfConfig& config) {
    m_parts.model.change(tr("method"), [&config](Document& next) {
        const OpacityCurve initial = next.method.config.initial;  // its kind and scale stand beside the config
        next.method.config = config;
        next.method.config.initial = initial;
    });
}

void TubeCoreExplaining::compare() {
    const auto number = m_parts.choice.number();
    if (!number) return;
    Document next = m_parts.model.document();
    Pane all = next.panes.at(firstPane);
    all.curve = CurveKind::adaptive;
    all.designer.reset();
    std::erase(all.withoutTubes, *number);
    Pane without = all;
    without.withoutTubes.push_back(*number);
    std::ranges::sort(without.withoutTubes);
    next = withPanes(std::move(next), {all, without});
    next.comparison.layout = ComparisonLayout::sideBySide;
    m_parts.model.edit(next, tr("compare without tube core %1").arg(*number));
    emit comparisonRequested();
}

}  // namespace echolucent
