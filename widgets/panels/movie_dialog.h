// Asks how a movie or a series of pictures is to be written.
#pragma once

#include <QDialog>
#include <QDir>
#include <QSize>
#include <QString>
#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace echolucent {

/// What becomes of the frames of a motion.
enum class FrameOutput {
    movie,   ///< one file
    series,  ///< a PNG file a frame
};

/// What a person chose.
struct MovieChoice {
    QString path{};  ///< of the movie; of a series "NAME.png", whose files are NAME-0001.png and so on
    QSize size{512, 512};
    double framesPerSecond = 25.0;  ///< of a movie
    bool labels = true;
    bool replace = false;  ///< files that are there already may be replaced
};

/// What stands in the way of a choice.
struct MovieHindrance {
    QString sentence{};     ///< empty where nothing does
    bool replaces = false;  ///< the sentence tells of files that are there, which a person may replace
};

/// Objects: movieDialog (this), movieDialog.plays, .preset (of sizes), .width, .height, .rate (of a movie), .labels,
/// .path, .choosePath, .sentence (what stands in the way, or how long the movie is), .replace (seen where files are
/// there already), .note (where there is one), .save, .cancel. Save is enabled only where nothing stands in the way.
/// Movies have even sizes, since their pixels are counted in twos: an odd one is rounded down.
class MovieDialog : public QDialog {
    Q_OBJECT

public:
    struct Facts {
        QString plays{};       ///< what the frames show, a few words
        int frames = 1;        ///< how many they are
        QSize ofView{};        ///< pixels of the view, which are offered too
        MovieChoice choice{};  ///< what is proposed
        QString note{};        ///< a sentence to be read before anything is saved; empty where there is none
        /// Whether folders may be seen: else movieDialog.path shows the file's name alone.
        bool folderShown = true;
        /// Says of a choice, while it is being made, what stands in its way.
        std::function<MovieHindrance(const MovieChoice&)> hindrance;
        /// Lets the person point at a file; an empty text where they do not want to.
        std::function<QString(const QString& present)> choosePath;
    };
    MovieDialog(FrameOutput output, Facts facts, QWidget* parent = nullptr);

    [[nodiscard]] MovieChoice choice() const;

    /// Frames a second that can be chosen.
    static constexpr double leastRate = 0.5, largestRate = 120.0;

private:
    void createControls();
    void arrange();
    void showChoice(const MovieChoice& choice);
    void showPath(const QString& path);
    void takePreset(int index);
    void look();

    FrameOutput m_output;
    Facts m_facts;
    QDir m_folder;  ///< of a file whose name is typed without one
    QComboBox* m_preset = nullptr;
    QSpinBox *m_width = nullptr, *m_height = nullptr;
    QDoubleSpinBox* m_rate = nullptr;
    QCheckBox *m_labels = nullptr, *m_replace = nullptr;
    QLineEdit* m_path = nullptr;
    QPushButton *m_choosePath = nullptr, *m_save = nullptr, *m_cancel = nullptr;
    QLabel* m_sentence = nullptr;
};

}  // namespace echolucent
