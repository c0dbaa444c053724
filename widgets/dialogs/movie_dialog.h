// Asks how to write a movie or a series of pictures.
#pragma once

#include <QDialog>
#include <QDir>
#include <QSize>
#include <QString>
#include <functional>
#include <optional>

#include "processing/motion/motion_choice.h"
#include "processing/motion/movie_length.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace echolucent {

/// What the frames of a motion become.
enum class FrameOutput {
    movie,   ///< one file
    series,  ///< a PNG file a frame
};

/// What a person chose.
struct MovieChoice {
    QString path{};  ///< of the movie; of a series "NAME.png": its files are NAME-0001.png and so on
    QSize size{512, 512};
    double framesPerSecond = 25.0;  ///< of a movie
    MovieLength length{};           ///< of a movie
    bool labels = true;
    bool replace = false;  ///< files that are there already may be replaced
};

/// What prevents a choice from being saved.
struct MovieHindrance {
    QString sentence{};     ///< empty if nothing does
    bool replaces = false;  ///< files exist that a person may replace; the sentence says so
};

/// Objects: movieDialog (this), movieDialog.plays, .preset (of sizes), .width, .height, .rate, .length, .lengthUnit
/// (these three of a movie), .labels,
/// .path, .choosePath, .sentence (the hindrance, or how long the movie is), .replace (seen if the files exist), .note
/// (if there is one), .save, .cancel. Save is enabled if there is no hindrance, or if the person ticks .replace. Movies
/// count their pixels in twos: odd sizes are rounded down.
class MovieDialog : public QDialog {
    Q_OBJECT

public:
    struct Facts {
        QString plays{};       ///< what the frames show, a few words
        HeldFrames held{};     ///< the frames of one loop, and how long a movie holds each of them
        QSize ofView{};        ///< pixels of the view, offered as a size too
        MovieChoice choice{};  ///< what is proposed
        QString note{};        ///< a sentence to read before saving; empty if there is none
        /// If false, movieDialog.path shows the file's name alone.
        bool folderShown = true;
        /// Says what prevents a choice from being saved. Called while the person makes the choice.
        std::function<MovieHindrance(const MovieChoice&)> hindrance;
        /// Lets the person choose a file; empty if they cancel.
        std::function<QString(const QString& present)> choosePath;
    };
    MovieDialog(FrameOutput output, Facts facts, QWidget* parent = nullptr);
    /// Hides the dialog first: a number that is being typed then is looked at while all members are there.
    ~MovieDialog() override { hide(); }

    [[nodiscard]] MovieChoice choice() const;

    static constexpr double leastRate = 0.5, largestRate = 120.0;
    /// Of a movie's length.
    static constexpr double mostLoops = 99, leastSeconds = 0.1, mostSeconds = 600;

private:
    void createControls();
    void arrange();
    void showChoice(const MovieChoice& choice);
    void showPath(const QString& path);
    void takePreset(int index);
    void takeLengthUnit();
    void showLength(const MovieLength& length);
    [[nodiscard]] MovieLength length() const;
    [[nodiscard]] double loopSeconds() const;
    [[nodiscard]] QString lengthWords(const MovieChoice& chosen) const;
    void look();

    FrameOutput m_output;
    Facts m_facts;
    QDir m_folder;  ///< used if a person types a name without a folder
    QComboBox* m_preset = nullptr;
    QSpinBox *m_width = nullptr, *m_height = nullptr;
    QDoubleSpinBox *m_rate = nullptr, *m_length = nullptr;
    QComboBox* m_lengthUnit = nullptr;
    MovieLengthUnit m_unit = MovieLengthUnit::loops;  ///< that the number in m_length has
    QCheckBox *m_labels = nullptr, *m_replace = nullptr;
    QLineEdit* m_path = nullptr;
    QPushButton *m_choosePath = nullptr, *m_save = nullptr, *m_cancel = nullptr;
    QLabel* m_sentence = nullptr;
};

}  // namespace echolucent
