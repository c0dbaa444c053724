// What the window says of the picture: the caption in it, and the panel that explains it.
#include "app/compare/compare_room.h"
#include "app/compare/paper_figures.h"
#include "app/otf/editor_otfs.h"
#include "app/picture/explanation.h"
#include "app/picture/picture_caption.h"
#include "app/study/study_sides.h"
#include "app/window/full_screen.h"
#include "app/window/main_window.h"
#include "app/window/window_faces.h"
#include "widgets/compare/otf_inset.h"
#include "widgets/panels/explain_panel.h"
#include "widgets/theory/theory_panel.h"

namespace echolucent {

/// The panels that explain: what every picture shows and why, and what two intensities of the study say of curves.
void MainWindow::connectExplanation() {
    ExplainPanel* panel = m_widgets.explain;
    panel->setSource([this] { return explanationOfPane(); });
    connect(m_compare.get(), &CompareRoom::explainedPaneChanged, panel, &ExplainPanel::follow);
    connect(m_panes.get(), &ShownPanes::changed, panel, &ExplainPanel::follow);
    TheoryPanel* theory = m_widgets.theory;
    theory->setStudy([this] { return studyIntensities(m_otfs->adaptive().get(), m_document.document().curves); });
    connect(m_otfs.get(), &PaneOtfs::followed, theory, &TheoryPanel::followStudy);
    connect(m_otfs.get(), &PaneOtfs::computed, theory, &TheoryPanel::followStudy);
}

void MainWindow::connectCaption() {
    const auto tell = [this] {
        // A picture of the previous study keeps its own caption.
        if (!m_openStudy.volume() || m_view->held()) return;
        m_widgets.picture->setCaption(
            pictureCaption({.document = m_document.document(),
                            .speckle = shownSpeckle(),
                            .curveOfAnotherView = curveIsOfAnotherView(m_document.document(), m_otfs->adaptive().get()),
                            .curveIsTold = m_faces->face() == Face::teach,
                            .designIsShown = designIsShown(),
                            .sides = m_sides->finding().get(),
                            .remembered = rememberedSide(),
                            .lengthsKnown = m_openStudy.volume()->geometry().spacingKnown,
                            .reduction = m_openStudy.volume()->geometry().reduction}));
    };
    connect(m_panes.get(), &ShownPanes::changed, this, tell);
    connect(m_sides.get(), &StudySides::changed, this, tell);
    connect(m_faces.get(), &WindowFaces::chosen, this, tell);

    // On the full screen the curve editor is out of sight.
    auto* inset = new OtfInset(this);
    inset->lieOver(*m_widgets.picture);
    const auto showInset = [this, inset] {
        const Document& document = m_document.document();
        const bool shown = m_fullScreen->active() && m_faces->face() == Face::teach && !m_compare->shown() &&
                           m_openStudy.volume() && !m_view->held() && document.scene.look.mode == RenderMode::direct;
        if (shown) {
            PaneFace face = faceOf(document, firstPane);
            face.otf = m_panes->at(firstPane).classification;
            inset->setFace(face);
        }
        inset->setVisible(shown);
    };
    connect(m_panes.get(), &ShownPanes::changed, this, showInset);
    connect(m_faces.get(), &WindowFaces::chosen, this, showInset);
    connect(m_fullScreen, &FullScreen::changed, this, showInset);
    connect(m_compare.get(), &CompareRoom::shownChanged, this, showInset);
}

std::optional<std::size_t> MainWindow::rememberedSide() const {
    const auto& finds = m_openStudy.finds();
    const bool remembered =
        finds && !m_openStudy.saved() && finds->source == SideSource::remembered && finds->sides == m_sides->finding();
    return remembered ? finds->place : std::nullopt;
}

bool MainWindow::designIsShown() const {
    const DesignerConfig* config = designerConfigOf(m_document.document(), firstPane);
    const auto made = m_otfs->designOf(firstPane);
    return config != nullptr && made && made->asked.config.index() == config->index();
}

ShownSpeckle MainWindow::shownSpeckle() const {
    const std::shared_ptr<const Volume> shown = m_widgets.picture->volume();
    if (shown && shown != m_openStudy.volume()) return ShownSpeckle::reduced;
    return m_openStudy.quietPhases().busy() ? ShownSpeckle::beingReduced : ShownSpeckle::asRead;
}

QStringList MainWindow::explained(std::size_t pane, const QString& name,
                                  const std::function<QStringList(const PictureFacts&)>& explain) const {
    if (!m_openStudy.volume()) return {};
    const auto designed = m_otfs->designOf(pane);
    const auto made = pane == firstPane ? nullptr : m_otfs->of(pane);
    const auto otf = pane == firstPane ? m_otfs->adaptive() : made ? made->design.tubeCores : nullptr;
    return explain({.study = *m_openStudy.study(),
                    .volume = *m_openStudy.volume(),
                    .otf = otf.get(),
                    .document = m_document.document(),
                    .speckle = shownSpeckle(),
                    .design = designed.get(),
                    .designIsNewest = m_otfs->isNewest(pane),
                    .pane = pane,
                    .name = name});
}

QString MainWindow::explanation() const {
    if (!m_openStudy.volume()) return tr("Nothing is open yet. Open a volume with File > Open volume.");
    return explained(firstPane, {}, [](const PictureFacts& facts) { return QStringList{explainPicture(facts)}; })
        .join(QString());
}

QString MainWindow::explanationOfPane() const {
    if (!m_openStudy.volume() || !m_compare->shown()) return explanation();
    const std::size_t pane = m_compare->explainedPane();
    const QString name = QStringLiteral("%1: %2.").arg(pane + 1).arg(captionOfPane(m_document.document(), pane));
    return explained(pane, name, [](const PictureFacts& facts) { return QStringList{explainPicture(facts)}; })
        .join(QString());
}

}  // namespace echolucent
