// The panel *Tube cores*: which there are, and what one of them found and does to the curve.
#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "processing/explanation/tube_explanation.h"
#include "processing/plots/plot.h"
#include "widgets/tube_cores/shown_explanation.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace echolucent {

class FittedTable;
class PlotCanvas;
class ReadingParameters;
class TubeCoreList;
class TubeCoreMap;

/// Objects: tubeCores (this), tubeCores.shown, .sentence, .note, .map, .list (below .listShown), .facts, the sliders of
/// ReadingParameters (below .parameters), .plot.profile, .plot.interface, .plot.intensityRank, .plot.slopeRank,
/// .plot.factors, .plot.curves, .plot.change, .growth, .growthWords, .picture.all, .picture.without, .picture.third,
/// .compare, .savePage.
class TubeCorePanel : public QWidget {
    Q_OBJECT

public:
    explicit TubeCorePanel(QWidget* parent = nullptr);

    /// Whether tube cores are drawn in the pictures.
    void setShown(bool shown);
    /// The run whose tube cores are listed; null if there is none yet, which takes the explanation
    /// away.
    void setRun(std::shared_ptr<const AdaptiveOtf> run);
    /// Marks a tube core of the run as the chosen one. An explanation of another one stays until it is replaced.
    void setChosen(std::optional<int> number);
    /// Null takes it away.
    void setExplanation(std::shared_ptr<const ShownExplanation> explanation);
    /// A sentence on how the explanation and the picture belong together; empty for none.
    void setNote(const QString& sentence);
    /// The parameters as the document has them.
    void setConfig(const AdaptiveOtfConfig& config);

    /// Small pictures under three curves: the full run's, without the tube core, and thirdCurve().
    enum Picture { withAll, without, third, pictures };
    static constexpr int pictureWidth = 100, pictureHeight = 75;  ///< pixels
    /// Null while it is being made.
    void setPicture(Picture which, const QImage& image);
    /// How many tube cores, heaviest first, the growing curve is made of; no value until a person moves the slider.
    [[nodiscard]] std::optional<int> grown() const { return m_grown; }
    /// The growing curve or, before the slider was moved, that of the tube core alone.
    [[nodiscard]] SampledCurve thirdCurve() const;

signals:
    void shownToggled(bool shown);
    void chosen(int number);
    /// A person wants to compare the full run with the one without the chosen tube core.
    void compareRequested();
    /// A person wants to save the explanation as a page.
    void pageRequested();
    /// Another curve grows: thirdCurve() is another.
    void grownChanged();
    void configChanged(const echolucent::AdaptiveOtfConfig& config);

private:
    void createExplanation();
    QWidget* createPictures();
    void showWords();
    void enableCompare();
    void showFacts();
    void showGrown();
    void grow(int count);

    std::shared_ptr<const AdaptiveOtf> m_run;
    std::optional<int> m_chosen;
    std::shared_ptr<const ShownExplanation> m_explanation;
    std::optional<int> m_grown;

    QCheckBox* m_shown;
    QLabel* m_sentence;
    QLabel* m_note;
    TubeCoreMap* m_map;
    TubeCoreList* m_list;
    ReadingParameters* m_parameters;
    QWidget* m_below;  ///< all that belongs to one tube core
    FittedTable* m_facts = nullptr;
    PlotCanvas *m_profile = nullptr, *m_interface = nullptr, *m_intensityRank = nullptr, *m_slopeRank = nullptr,
               *m_factors = nullptr, *m_curves = nullptr, *m_change = nullptr;
    QSlider* m_growth = nullptr;
    QLabel* m_growthWords = nullptr;
    std::array<QLabel*, pictures> m_pictures{}, m_pictureWords{};
    QPushButton* m_compare = nullptr;
};

}  // namespace echolucent
