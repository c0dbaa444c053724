// Asks for the layout of a headerless file, and shows whether the answer fits the file.
#pragma once

#include <QDialog>
#include <QString>
#include <array>
#include <cstdint>

#include "widgets/dialogs/raw_layout.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace echolucent {

class PolarControls;

/// Objects: rawLayout (this), rawLayout.sizeX, .sizeY, .sizeZ, .type, .byteOrder, .headerBytes, .headerFit, .grid
/// (Cartesian, or a kind of probe), .spacingX, .spacingY, .spacingZ, .spacingUnknown, .polar with its fields
/// (PolarControls), .fit (the comparison), .ok, .cancel. OK is enabled if the file is long enough for the layout and
/// the geometry of beams makes sense. If bytes are left over, the dialog warns but does not refuse, as the reader does.
class RawLayoutDialog : public QDialog {
    Q_OBJECT

public:
    /// `fileBytes`: the file's length in bytes; below 0 if the file is packed, as its length is unknown until it is
    /// opened.
    RawLayoutDialog(const QString& fileName, std::int64_t fileBytes, QWidget* parent = nullptr);
    /// Hides the dialog first: a number that is being typed then is looked at while all members are there.
    ~RawLayoutDialog() override { hide(); }

    /// The spacing is 1, 1, 1 if it is unknown, and for voxels along beams, which have no spacing.
    [[nodiscard]] RawLayout values() const;
    void setValues(const RawLayout& values);
    /// True if the file is long enough for header and voxels, or packed, and the geometry of beams makes sense. The
    /// file may be longer.
    [[nodiscard]] bool fits() const;

private:
    void createControls();
    void arrange(const QString& fileName);
    void createPolarControls();
    void showGrid();
    void showFit();
    void fitHeader();
    [[nodiscard]] bool isPolar() const;
    [[nodiscard]] bool isPacked() const { return m_fileBytes < 0; }
    [[nodiscard]] QString fitSentence() const;
    /// What is wrong with the geometry of beams; empty if nothing is, or if there are no beams.
    [[nodiscard]] QString polarSentence() const;

    std::int64_t m_fileBytes;
    std::array<QSpinBox*, 3> m_size{};
    QComboBox* m_type = nullptr;
    QComboBox* m_byteOrder = nullptr;
    QDoubleSpinBox* m_headerBytes = nullptr;  // whole numbers, exact to 2^53
    QPushButton* m_headerFit = nullptr;
    std::array<QDoubleSpinBox*, 3> m_spacing{};
    QCheckBox* m_spacingUnknown = nullptr;
    QComboBox* m_grid = nullptr;
    PolarControls* m_polar = nullptr;
    QLabel *m_sizeLabel = nullptr, *m_spacingLabel = nullptr;
    QLabel* m_fit = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
};

}  // namespace echolucent
