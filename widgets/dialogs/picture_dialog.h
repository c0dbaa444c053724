// Asks what a saved picture shows, and how large it is.
#pragma once

#include <QDialog>
#include <QSize>
#include <QString>

class QComboBox;
class QLabel;
class QRadioButton;

namespace echolucent {

/// What a person wants in a picture.
struct PictureChoice {
    bool allPanes = false;  ///< else the 3D view alone
    int width = 0;          ///< pixels
    friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};

/// Objects: pictureDialog (this), pictureDialog.only3d, .allPanes, .size, .pixels, .save, .cancel.
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    struct Facts {
        QSize of3d{};     ///< of the 3D view on the screen, pixels; null if it is hidden
        QSize ofPanes{};  ///< of all panes on the screen, pixels
        bool planesAreShown = true;
    };
    explicit PictureDialog(const Facts& facts, QWidget* parent = nullptr);

    [[nodiscard]] PictureChoice choice() const;

    /// Width of the text of a page (170 mm) at 300 dots per inch.
    static constexpr int pageWidth = 2008;

private:
    [[nodiscard]] QSize onScreen() const;
    [[nodiscard]] QSize chosenSize() const;
    void showPixels();

    Facts m_facts;
    QRadioButton *m_only3d, *m_allPanes;
    QComboBox* m_size;
    QLabel* m_pixels;
};

}  // namespace echolucent
