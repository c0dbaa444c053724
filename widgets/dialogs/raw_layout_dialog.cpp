#include "widgets/dialogs/raw_layout_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <limits>

#include "widgets/controls/number_box.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/short_spin_box.h"
#include "widgets/dialogs/polar_controls.h"

namespace echolucent {
namespace {

constexpr std::array<char, 3> axisLetters{'X', 'Y', 'Z'};
constexpr int cartesian = -1;                         // entry of the choice of grids; the others are kinds of probes
constexpr double largestHeader = 9007199254740992.0;  // 2^53: a double holds whole numbers up to here exactly

QString grouped(std::int64_t bytes) { return QLocale(QLocale::English).toString(static_cast<qlonglong>(bytes)); }

template <typename SpinBox>
SpinBox* createSpinBox(SpinBox* spinBox, const QString& name, const QString& accessibleName) {
    named(spinBox, "rawLayout." + name, accessibleName);
    wheelNeedsFocus(spinBox);
    return spinBox;
}

}  // namespace

RawLayoutDialog::RawLayoutDialog(const QString& fileName, std::int64_t fileBytes, QWidget* parent)
    : QDialog(parent), m_fileBytes(fileBytes) {
    setObjectName("rawLayout");
    setAccessibleName(tr("Layout of a file without header"));
    setWindowTitle(tr("File without header"));
    createControls();
    arrange(fileName);
    setValues({});
}

void RawLayoutDialog::createControls() {
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QString(QChar(axisLetters[i]));
        m_size[i] =
            createSpinBox<QSpinBox>(new WholeNumberBox, "size" + letter, tr("Voxels along %1").arg(letter.toLower()));
        m_size[i]->setRange(0, std::numeric_limits<int>::max());
        m_spacing[i] = createSpinBox<QDoubleSpinBox>(new ShortSpinBox, "spacing" + letter,
                                                     tr("Spacing along %1").arg(letter.toLower()));
        m_size[i]->setMinimumWidth(96);
        m_size[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        m_spacing[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        m_spacing[i]->setDecimals(9);
        m_spacing[i]->setRange(1e-9, 1000);
        m_spacing[i]->setSingleStep(0.1);
        connect(m_size[i], &QSpinBox::valueChanged, this, &RawLayoutDialog::showFit);
    }
    m_type = named(new QComboBox, "rawLayout.type", tr("Voxel type"));
    m_type->addItems(rawVoxelTypes());
    m_byteOrder = named(new QComboBox, "rawLayout.byteOrder", tr("Byte order"));
    m_byteOrder->addItem(tr("Little endian"), 0);
    m_byteOrder->addItem(tr("Big endian"), 1);
    auto* headerBytes = new NumberBox;
    headerBytes->takeWholeNumbersOnly();
    m_headerBytes = createSpinBox<QDoubleSpinBox>(headerBytes, "headerBytes", tr("Header bytes to skip"));
    m_headerBytes->setRange(0, largestHeader);
    m_headerBytes->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // not as wide as its largest value
    m_headerFit =
        named(new QPushButton(tr("Take the rest as header")), "rawLayout.headerFit", tr("Take the rest as header"),
              tr("The voxels are the last bytes of the file; what is before them is skipped"));
    m_headerFit->setAutoDefault(false);
    m_spacingUnknown = named(new QCheckBox(tr("Unknown")), "rawLayout.spacingUnknown", tr("Spacing unknown"),
                             tr("The picture will say that its spacing is a guess"));
    createPolarControls();
    m_fit = named(new QLabel, "rawLayout.fit", tr("Does this fit the file"));
    m_fit->setWordWrap(true);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    named(m_buttons->button(QDialogButtonBox::Ok), "rawLayout.ok", tr("Open with this layout"));
    named(m_buttons->button(QDialogButtonBox::Cancel), "rawLayout.cancel", tr("Cancel"));

    for (QAbstractButton* button : m_buttons->buttons()) button->setIcon({});

    connect(m_type, &QComboBox::currentIndexChanged, this, &RawLayoutDialog::showFit);
    connect(m_headerBytes, &QDoubleSpinBox::valueChanged, this, &RawLayoutDialog::showFit);
    connect(m_headerFit, &QPushButton::clicked, this, &RawLayoutDialog::fitHeader);
    connect(m_spacingUnknown, &QCheckBox::toggled, this, [this](bool unknown) {
        for (QDoubleSpinBox* spacing : m_spacing) spacing->setDisabled(unknown);
    });
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        if (fits()) accept();  // a number that was taken only now may not fit
    });
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void RawLayoutDialog::createPolarControls() {
    m_grid = named(new QComboBox, "rawLayout.grid", tr("Grid"),
                   tr("Whether voxels lie on a Cartesian grid, or along the beams of a probe"));
    m_grid->addItem(tr("Cartesian"), cartesian);
    m_grid->addItem(tr("Polar: linear"), static_cast<int>(PolarKind::linear));
    m_grid->addItem(tr("Polar: convex"), static_cast<int>(PolarKind::convex));
    m_grid->addItem(tr("Polar: linear wobbler"), static_cast<int>(PolarKind::linearWobbler));
    m_grid->addItem(tr("Polar: wobbler"), static_cast<int>(PolarKind::wobbler));
    wheelNeedsFocus(m_grid);
    m_polar = new PolarControls;
    connect(m_grid, &QComboBox::currentIndexChanged, this, &RawLayoutDialog::showGrid);
    connect(m_polar, &PolarControls::changed, this, &RawLayoutDialog::showFit);
}

void RawLayoutDialog::arrange(const QString& fileName) {
    auto* file = new QLabel(tr("%1 has no header that says how it is laid out.").arg(fileName));
    file->setTextFormat(Qt::PlainText);
    file->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->addWidget(file, 0, 0, 1, 5);
    m_sizeLabel = labelFor(m_size[0], {});
    m_spacingLabel = labelFor(m_spacing[0], tr("Spacing, mm"));
    grid->addWidget(m_sizeLabel, 1, 0);
    grid->addWidget(labelFor(m_type, tr("Voxel type")), 2, 0);
    grid->addWidget(m_type, 2, 1);
    grid->addWidget(m_byteOrder, 2, 2);
    grid->addWidget(labelFor(m_headerBytes, tr("Header bytes")), 3, 0);
    grid->addWidget(m_headerBytes, 3, 1);
    grid->addWidget(m_headerFit, 3, 2, 1, 2);
    grid->addWidget(labelFor(m_grid, tr("Grid")), 4, 0);
    grid->addWidget(m_grid, 4, 1, 1, 2);
    grid->addWidget(m_spacingLabel, 5, 0);
    for (int i = 0; i < 3; ++i) {
        grid->addWidget(m_size[static_cast<std::size_t>(i)], 1, i + 1);
        grid->addWidget(m_spacing[static_cast<std::size_t>(i)], 5, i + 1);
        grid->setColumnStretch(i + 1, 1);
    }
    grid->addWidget(m_spacingUnknown, 5, 4);
    grid->addWidget(m_polar, 6, 0, 1, 5);
    grid->addWidget(m_fit, 7, 0, 1, 5);
    grid->addWidget(m_buttons, 8, 0, 1, 5);
    for (QAbstractButton* button : {static_cast<QAbstractButton*>(m_headerFit),
                                    static_cast<QAbstractButton*>(m_buttons->button(QDialogButtonBox::Ok))})
        followTyping(*this, *button, [this] { showFit(); });
    showGrid();
}

bool RawLayoutDialog::isPolar() const { return m_grid->currentData().toInt() != cartesian; }

void RawLayoutDialog::showGrid() {
    const bool polar = isPolar();
    if (polar) m_polar->setKind(static_cast<PolarKind>(m_grid->currentData().toInt()));
    constexpr std::array<const char*, 3> cartesianNames{QT_TR_NOOP("Voxels along x"), QT_TR_NOOP("Voxels along y"),
                                                        QT_TR_NOOP("Voxels along z")};
    constexpr std::array<const char*, 3> polarNames{QT_TR_NOOP("Samples along a beam"), QT_TR_NOOP("Lines of a plane"),
                                                    QT_TR_NOOP("Planes")};
    for (std::size_t i = 0; i < 3; ++i) {
        m_size[i]->setAccessibleName(tr(polar ? polarNames[i] : cartesianNames[i]));
        m_spacing[i]->setVisible(!polar);
    }
    m_sizeLabel->setText(polar ? tr("Samples, lines, planes") : tr("Voxels (x fastest)"));
    m_spacingLabel->setVisible(!polar);
    m_spacingUnknown->setVisible(!polar);
    m_polar->setVisible(polar);
    showFit();
    adjustSize();
}

RawLayout RawLayoutDialog::values() const {
    RawLayout values;
    values.type = m_type->currentText().toStdString();
    values.bigEndian = m_byteOrder->currentData().toInt() == 1;
    values.headerBytes = static_cast<std::int64_t>(m_headerBytes->value());
    values.spacingKnown = !isPolar() && !m_spacingUnknown->isChecked();
    for (std::size_t i = 0; i < 3; ++i) {
        values.size[i] = m_size[i]->value();
        if (values.spacingKnown) values.spacing[static_cast<int>(i)] = m_spacing[i]->value();
    }
    if (isPolar()) values.polar = m_polar->geometry(values.size);
    return values;
}

void RawLayoutDialog::setValues(const RawLayout& values) {
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < 3; ++i) {
        m_size[i]->setValue(static_cast<int>(std::clamp<std::int64_t>(values.size[i], 0, largest)));
        m_spacing[i]->setValue(values.spacing[static_cast<int>(i)]);
    }
    m_type->setCurrentText(QString::fromStdString(values.type));
    selectData(m_byteOrder, values.bigEndian ? 1 : 0);
    m_headerBytes->setValue(static_cast<double>(values.headerBytes));
    m_spacingUnknown->setChecked(!values.spacingKnown && !values.polar);
    if (values.polar) m_polar->setGeometry(*values.polar);
    selectData(m_grid, values.polar ? static_cast<int>(kindOf(*values.polar)) : cartesian);
    showGrid();
}

bool RawLayoutDialog::fits() const {
    const auto needed = bytesNeeded(values());
    return needed && (isPacked() || *needed <= m_fileBytes) && polarSentence().isEmpty();
}

QString RawLayoutDialog::polarSentence() const {
    const RawLayout layout = values();
    if (!layout.polar) return {};
    if (layout.polar->size() != layout.size) return tr("No scanner has so many lines or planes.");
    const auto problem = problemOf(*layout.polar);
    if (!problem) return {};
    const QString words = textOf(problem->words);
    switch (problem->part) {
        case PolarPart::range: return tr("The range %1.").arg(words);
        case PolarPart::lines: return tr("The lines %1.").arg(words);
        case PolarPart::planes: break;
    }
    return tr("The planes %1.").arg(words);
}

void RawLayoutDialog::showFit() {
    m_fit->setText(fitSentence());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(fits());
    const auto voxelBytes = voxelBytesNeeded(values());
    m_headerFit->setEnabled(voxelBytes && *voxelBytes < m_fileBytes && bytesNeeded(values()) != m_fileBytes);
}

void RawLayoutDialog::fitHeader() {
    if (const auto voxelBytes = voxelBytesNeeded(values())) {
        m_headerBytes->setValue(static_cast<double>(m_fileBytes - *voxelBytes));
    }
}

QString RawLayoutDialog::fitSentence() const {
    const RawLayout layout = values();
    if (std::min({layout.size[0], layout.size[1], layout.size[2]}) < 1) {
        if (isPacked())
            return isPolar() ? tr("How many samples, lines and planes are there?")
                             : tr("How many voxels are there along x, y and z?");
        return isPolar()
                   ? tr("The file has %1 bytes. How many samples, lines and planes are there?")
                         .arg(grouped(m_fileBytes))
                   : tr("The file has %1 bytes. How many voxels are there along x, y and z?").arg(grouped(m_fileBytes));
    }
    if (const QString problem = polarSentence(); !problem.isEmpty()) return problem;
    const auto needed = bytesNeeded(layout);
    if (!needed) return tr("These settings need more than 2⁶³ bytes.");
    const QString beams = isPolar() ? m_polar->replacedSentence(layout.size) : QString();
    if (isPacked())
        return tr("These settings need %1 bytes. The file is packed; whether it holds them is seen when it is opened.")
                   .arg(grouped(*needed)) +
               beams;
    if (*needed == m_fileBytes) {
        return tr("✓ These settings need %1 bytes, and the file has as many.").arg(grouped(*needed)) + beams;
    }
    const QString sizes =
        tr("These settings need %1 bytes; the file has %2").arg(grouped(*needed), grouped(m_fileBytes));
    const qint64 rest = m_fileBytes - *needed;
    return (rest < 0 ? tr("%1: %2 are missing.").arg(sizes, grouped(-rest))
                     : tr("⚠ %1: the last %2 are left over and would be ignored.").arg(sizes, grouped(rest))) +
           beams;
}

}  // namespace echolucent
