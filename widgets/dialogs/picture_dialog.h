// Asks what a saved picture shows, and how large it is.
#pragma once

#include <QDialog>
#include <QSize>
#include <QString>

class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;

namespace echolucent {

/// What a person wants in a picture.
struct PictureChoice {
    bool allPanes = false;  ///< else the 3D view alone
    int width = 0;          ///< pixels
    int dotsPerInch = 0;    ///< of the paper it is made for; 0 if it is made for a screen
    friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};

/// It cannot be accepted for a picture without pixels, or with an edge above `longestEdge`. Objects: pictureDialog
/// (this), pictureDialog.only3d, .allPanes, .size, .pixels, .note (if there is one), .save, .cancel.
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    struct Facts {
        QSize of3d{};     ///< of the 3D view on the screen, pixels; null if it is hidden
        QSize ofPanes{};  ///< of all panes on the screen, pixels
        bool planesAreShown = true;
        QString note{};  ///< a sentence to read before saving; empty if there is none
    };
    explicit PictureDialog(const Facts& facts, QWidget* parent = nullptr);

    [[nodiscard]] PictureChoice choice() const;

    /// Width of the text of a page (170 mm) at 300 dots per inch.
    static constexpr int pageWidth = 2008;
    static constexpr int pageDotsPerInch = 300;
    /// The longest edge of a picture, pixels.
    static constexpr int longestEdge = 12000;

private:
    [[nodiscard]] QSize onScreen() const;
    [[nodiscard]] QSize chosenSize() const;
    void showPixels();

    Facts m_facts;
    QRadioButton *m_only3d, *m_allPanes;
    QComboBox* m_size;
    QLabel* m_pixels;
    QPushButton* m_save;
};

}  // namespace echolucent
